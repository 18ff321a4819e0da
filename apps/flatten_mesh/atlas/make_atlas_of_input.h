// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MAKE_ATLAS_OF_INPUT_H
#define FLATTEN_MESH_MAKE_ATLAS_OF_INPUT_H

#include "flatten_mesh/atlas/Atlas.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/atlas/Atlas_record.h"
#include "flatten_mesh/model/components.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/crease_option.h"
#include "flatten_mesh/model/Cut_mesh.h"
#include "flatten_mesh/atlas/join_models.h"
#include "flatten_mesh/atlas/keep_seams.h"
#include "flatten_mesh/atlas/prepare_edges.h"
#include "flatten_mesh/atlas/symmetric_atlas.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace flatten_mesh {

inline TA::Atlas_options options_of_atlas(const Command_line& command)
{
  TA::Atlas_options options = command.atlas;
  options.float_coordinates = !command.atlas.is_in_world_units() && writes_floats(command);
  options.threads = command.options.threads;
  return options;
}

namespace internal {

// No seam divides a polygon of the input. Edges are prepared.
inline Report_on_atlas call_make_atlas(const Command_line& command, Mesh& mesh, const Atlas& atlas,
                                       const Seam_way& way, TA::Atlas_visitor& visitor)
{
  namespace np = CGAL::parameters;
  const Edge_marks is_diagonal = diagonals(mesh);
  const auto is_side =
      boost::make_function_property_map<Edge>([is_diagonal](const Edge e) { return !is_diagonal[e]; });
  auto polygon = mesh.add_property_map<Face, std::size_t>().first;
  CGAL::Polygon_mesh_processing::connected_components(mesh, polygon, np::edge_is_constrained_map(is_side));
  TA::Atlas_options options = options_of_atlas(command);
  options.visitor = &visitor;
  const auto make = [&](const auto& parameters) -> Report_on_atlas {
    return TA::make_atlas(mesh, atlas.seams, atlas.uv, atlas.chart, options, parameters);
  };
  Report_on_atlas report;
  if(has_weights(way)) {
    auto weight = edge_weights(mesh);
    report = make(np::edge_weight_map(weight).edge_is_constrained_map(is_diagonal).face_patch_map(polygon));
    mesh.remove_property_map(weight);
  } else {
    report = make(np::edge_is_constrained_map(is_diagonal).face_patch_map(polygon));
  }
  mesh.remove_property_map(polygon);
  return report;
}

inline void weigh_by_length(const Mesh& mesh, const Mesh::Property_map<Edge, double>& weight)
{
  for(const Edge e : mesh.edges()) {
    weight[e] = CGAL::Polygon_mesh_processing::edge_length(e, mesh);
  }
}

// The same, with symmetric seams if they are asked for and possible
inline Report_on_atlas make_charts(const Command_line& command, Mesh& mesh, const Atlas& atlas, Seam_way& way,
                                   TA::Atlas_visitor& visitor)
{
  if(!command.atlas.is_symmetric) {
    return call_make_atlas(command, mesh, atlas, way, visitor);
  }
  Command_line uncut = command;
  uncut.atlas.seam_price = std::numeric_limits<double>::infinity();
  Seam_way weighted = way;
  weighted.name = "weighted";
  const auto make = [&](const Atlas& result, const bool cuts_charts) {
    return call_make_atlas(cuts_charts ? command : uncut, mesh, result, weighted, visitor);
  };
  if(!has_weights(way)) {
    weigh_by_length(mesh, edge_weights(mesh));
  }
  return Symmetric_atlas_maker(mesh, make).run(atlas, way.symmetry.emplace());
}

// A component as a mesh of its own
struct Separate_component
{
  Cut_mesh part;
  std::vector<Face> faces; // of the whole mesh, of each face

  // The halfedge of the whole mesh
  Halfedge origin(const Mesh& mesh, const Halfedge h) const
  {
    const Vertex target = part.origins[part.mesh.target(h).idx()];
    Halfedge result = mesh.halfedge(faces[part.mesh.face(h).idx()]);
    while(mesh.target(result) != target) {
      result = mesh.next(result);
    }
    return result;
  }
};

inline Separate_component separate_component(Mesh& mesh, const std::size_t number)
{
  const Component component = choose_component(mesh, number);
  const CGAL::Constant_property_map<Edge, bool> uncut(false);
  return {cut_open(mesh, component.faces, component.vertices, uncut), component.faces};
}

// The elements of the report are those of the whole mesh.
inline Report_on_atlas make_atlas_of_component(const Command_line& command, Mesh& mesh, const Atlas& atlas,
                                               Seam_way& way, TA::Atlas_visitor& visitor)
{
  Separate_component component = separate_component(mesh, static_cast<std::size_t>(command.component));
  Mesh& part = component.part.mesh;
  const Atlas atlas_of_part = empty_atlas(part);
  const Edge_marks is_diagonal = diagonals(mesh), is_diagonal_of_part = diagonals(part);
  for(const Edge e : part.edges()) {
    atlas_of_part.seams[e] = atlas.seams[component.part.edge_origins[e.idx()]];
    is_diagonal_of_part[e] = is_diagonal[component.part.edge_origins[e.idx()]];
  }
  way = prepare_edges(command.atlas, part, atlas_of_part.seams);
  Report_on_atlas report = make_charts(command, part, atlas_of_part, way, visitor);
  for(const Edge e : part.edges()) {
    atlas.seams[component.part.edge_origins[e.idx()]] = atlas_of_part.seams[e];
  }
  for(const Halfedge h : part.halfedges()) {
    if(!part.is_border(h)) {
      const Halfedge origin = component.origin(mesh, h);
      atlas.uv[origin] = atlas_of_part.uv[h];
      atlas.chart[mesh.face(origin)] = atlas_of_part.chart[part.face(h)];
    }
  }
  for(TA::Atlas_report::Skipped& skipped : report.skipped) {
    skipped.first_face = component.faces[skipped.first_face].idx();
  }
  for(Face& f : report.offending_faces) {
    f = component.faces[f.idx()];
  }
  for(Vertex& v : report.offending_vertices) {
    v = component.part.origins[v.idx()];
  }
  for(Edge& e : report.offending_edges) {
    e = component.part.edge_origins[e.idx()];
  }
  return report;
}

// Each model by itself: another one neither hides its edges nor has its seams.
inline Seam_way prepare_model(Joined_model& model, const Atlas& whole,
                              const Mesh::Property_map<Edge, double>& weights)
{
  Mesh& mesh = model.input.mesh;
  const Edge_marks is_seam = seam_marks(mesh);
  keep_seams(model.command.atlas, model.input, is_seam);
  Mirrored_charts mirrored;
  if(model.command.atlas.repacks) {
    const auto uv = [&](const Halfedge h) -> Kernel::Point_2& { return whole.uv[in_common_mesh(model, h)]; };
    mirrored = take_texture(model.command.atlas.repairs_charts, model.input, is_seam, uv);
  }
  Seam_way way = prepare_edges(model.command.atlas, mesh, is_seam);
  way.mirrored = mirrored;
  const auto weight = edge_weights(mesh);
  if(!has_weights(way)) {
    weigh_by_length(mesh, weight);
  }
  for(const Edge e : mesh.edges()) {
    whole.seams[in_common_mesh(model, e)] = is_seam[e];
    weights[in_common_mesh(model, e)] = weight[e];
  }
  return way;
}

inline Seam_way prepare_joined_models(Atlas_input& input, const Atlas& atlas)
{
  const auto weights = edge_weights(input.mesh);
  std::vector<Seam_way> ways;
  for(Joined_model& model : input.joined) {
    try {
      if(!model.input.mesh.is_empty()) {
        ways.push_back(prepare_model(model, atlas, weights));
      }
    } catch(const Input_error& error) {
      throw Input_error(model.command.title + ": " + error.what());
    }
  }
  return way_in_common(ways);
}

inline Report_on_atlas make_atlas_of_model(const Command_line& command, Atlas_input& input,
                                           const Atlas& atlas, Seam_way& way, TA::Atlas_visitor& visitor)
{
  keep_seams(command.atlas, input, atlas.seams);
  Mirrored_charts mirrored;
  if(command.atlas.repacks) {
    const auto uv = [&atlas](const Halfedge h) -> Kernel::Point_2& { return atlas.uv[h]; };
    mirrored = take_texture(command.atlas.repairs_charts, input, atlas.seams, uv);
  }
  Report_on_atlas report;
  if(command.asks_for_component) {
    report = make_atlas_of_component(command, input.mesh, atlas, way, visitor);
  } else {
    way = prepare_edges(command.atlas, input.mesh, atlas.seams);
    report = make_charts(command, input.mesh, atlas, way, visitor);
  }
  way.mirrored = mirrored;
  return report;
}

} // namespace internal

// Makes charts of the mesh or of the component that is asked for, and says where seams run.
inline Report_on_atlas make_atlas_of_input(const Command_line& command, Atlas_input& input,
                                           const Atlas& atlas, Seam_way& way, TA::Atlas_visitor& visitor)
{
  if(!input.joined.empty()) {
    way = internal::prepare_joined_models(input, atlas);
    return internal::call_make_atlas(command, input.mesh, atlas, way, visitor);
  }
  try {
    return internal::make_atlas_of_model(command, input, atlas, way, visitor);
  } catch(const Input_error& error) {
    throw Input_error(command.title + ": " + error.what());
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MAKE_ATLAS_OF_INPUT_H
