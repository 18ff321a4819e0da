// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Texture_atlas/internal/prepare/Atlas.h>
#include <CGAL/Texture_atlas/internal/prepare/components.h>
#include <CGAL/Texture_atlas/internal/prepare/Cut_mesh.h>
#include <CGAL/Texture_atlas/internal/prepare/Edge_marks.h>
#include <CGAL/Texture_atlas/internal/prepare/given_seams.h>
#include <CGAL/Texture_atlas/internal/prepare/Given_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_edges.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Seam_way.h>
#include <CGAL/Texture_atlas/internal/prepare/Soup_options.h>
#include <CGAL/Texture_atlas/internal/prepare/symmetric_atlas.h>
#include <CGAL/Texture_atlas/make_atlas.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// No seam divides a polygon of the input. Edges are prepared.
inline Report_on_atlas call_make_atlas(const Soup_options& given, Mesh& mesh, const Atlas& atlas,
                                       const Seam_way& way, Atlas_visitor& visitor)
{
  namespace np = parameters;
  const Edge_marks is_diagonal = diagonals(mesh);
  const auto is_side =
      boost::make_function_property_map<Edge>([is_diagonal](const Edge e) { return !is_diagonal[e]; });
  auto polygon = mesh.add_property_map<Face, std::size_t>().first;
  Polygon_mesh_processing::connected_components(mesh, polygon, np::edge_is_constrained_map(is_side));
  Atlas_options options = given;
  options.visitor = &visitor;
  const auto make = [&](const auto& parameters) -> Report_on_atlas {
    return make_atlas(mesh, atlas.seams, atlas.uv, atlas.chart, options, parameters);
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
    weight[e] = Polygon_mesh_processing::edge_length(e, mesh);
  }
}

// The same, with symmetric seams if they are asked for and possible
inline Report_on_atlas make_charts(const Soup_options& options, Mesh& mesh, const Atlas& atlas, Seam_way& way,
                                   Atlas_visitor& visitor)
{
  if(!options.is_symmetric) {
    return call_make_atlas(options, mesh, atlas, way, visitor);
  }
  Soup_options uncut = options;
  uncut.seam_price = std::numeric_limits<double>::infinity();
  Seam_way weighted = way;
  weighted.name = "weighted";
  const auto make = [&](const Atlas& result, const bool cuts_charts) {
    return call_make_atlas(cuts_charts ? options : uncut, mesh, result, weighted, visitor);
  };
  if(!has_weights(way)) {
    weigh_by_length(mesh, edge_weights(mesh));
  }
  return Symmetric_atlas_maker(mesh, make).run(atlas, way.symmetry.emplace());
}

inline bool keeps_charts(const Atlas_options& options)
{
  return options.given_charts != Atlas_options::REPLACE;
}

// Seams of charts that are kept are given.
inline Seam_way prepare_edges_of(const Soup_options& options, Mesh& mesh, const Edge_marks& is_seam)
{
  if(keeps_charts(options)) {
    return {"given", std::nullopt, false, std::nullopt};
  }
  return prepare_edges(options.seams, mesh, is_seam);
}

// Makes the charts of texture coordinates those of the atlas, if they are to be kept.
template <class Uv>
Mirrored_charts take_charts(const Soup_options& options, Given_surface& given, const Edge_marks& is_seam,
                            const Uv& uv)
{
  const bool repairs = options.given_charts == Atlas_options::REPAIR;
  return keeps_charts(options) ? take_texture(repairs, given.soup, given.surface, is_seam, uv)
                               : Mirrored_charts();
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
  const std::vector<Face> faces = components_by_size(mesh)[number];
  const Constant_property_map<Edge, bool> uncut(false);
  return {cut_open(mesh, faces, vertices_of_faces(mesh, faces), uncut), faces};
}

// The elements of the report are those of the whole mesh.
inline Report_on_atlas make_atlas_of_component(const Soup_options& options, Mesh& mesh, const Atlas& atlas,
                                               Seam_way& way, Atlas_visitor& visitor)
{
  Separate_component component = separate_component(mesh, *options.component);
  Mesh& part = component.part.mesh;
  const Atlas atlas_of_part = empty_atlas(part);
  const Edge_marks is_diagonal = diagonals(mesh), is_diagonal_of_part = diagonals(part);
  for(const Edge e : part.edges()) {
    atlas_of_part.seams[e] = atlas.seams[component.part.edge_origins[e.idx()]];
    is_diagonal_of_part[e] = is_diagonal[component.part.edge_origins[e.idx()]];
  }
  way = prepare_edges_of(options, part, atlas_of_part.seams);
  Report_on_atlas report = make_charts(options, part, atlas_of_part, way, visitor);
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
  for(Atlas_report::Skipped& skipped : report.skipped) {
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

// Each surface by itself: another one neither hides its edges nor has its seams.
inline Seam_way prepare_given_surface(const Soup_options& options, Given_surface& given, const Atlas& whole,
                                      const Mesh::Property_map<Edge, double>& weights)
{
  Mesh& mesh = given.surface.mesh;
  const Edge_marks is_seam = seam_marks(mesh);
  const auto uv = [&](const Halfedge h) -> Kernel::Point_2& { return whole.uv[given.in_common_mesh(h)]; };
  const Mirrored_charts mirrored = take_charts(options, given, is_seam, uv);
  Seam_way way = prepare_edges_of(options, mesh, is_seam);
  way.mirrored = mirrored;
  const auto weight = edge_weights(mesh);
  if(!has_weights(way)) {
    weigh_by_length(mesh, weight);
  }
  for(const Edge e : mesh.edges()) {
    whole.seams[given.in_common_mesh(e)] = is_seam[e];
    weights[given.in_common_mesh(e)] = weight[e];
  }
  return way;
}

// Makes charts of one surface, or of one component of it, and says where seams run. Seams that are given are marked in
// `atlas`. Throws an `Input_error`.
inline Report_on_atlas make_surface_atlas(const Soup_options& options, Given_surface given,
                                          const Atlas& atlas, Seam_way& way, Atlas_visitor& visitor)
{
  Mesh& mesh = given.surface.mesh;
  const auto uv = [&atlas](const Halfedge h) -> Kernel::Point_2& { return atlas.uv[h]; };
  const Mirrored_charts mirrored = take_charts(options, given, atlas.seams, uv);
  Report_on_atlas report;
  if(options.component) {
    report = make_atlas_of_component(options, mesh, atlas, way, visitor);
  } else {
    way = prepare_edges_of(options, mesh, atlas.seams);
    report = make_charts(options, mesh, atlas, way, visitor);
  }
  way.mirrored = mirrored;
  return report;
}

// Makes one atlas of several surfaces, which follow one another in the mesh `whole`. Seams that are given are marked in
// the mesh of each. Throws an `Input_error` that begins with the name of a surface.
inline Report_on_atlas make_common_surface_atlas(const Soup_options& options,
                                                 std::vector<Given_surface>& given, Mesh& whole,
                                                 const Atlas& atlas, Seam_way& way, Atlas_visitor& visitor)
{
  const auto weights = edge_weights(whole);
  std::vector<Seam_way> ways;
  for(Given_surface& each : given) {
    try {
      if(!each.surface.mesh.is_empty()) {
        ways.push_back(prepare_given_surface(options, each, atlas, weights));
      }
    } catch(const Input_error& error) {
      throw Input_error(each.name + ": " + error.what());
    }
  }
  way = way_in_common(ways);
  return call_make_atlas(options, whole, atlas, way, visitor);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_ATLAS_H
