// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/mesh_atlas_builder.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/components.h>
#include <CGAL/Texture_atlas/internal/prepare/given_seams.h>
#include <CGAL/Texture_atlas/internal/prepare/Given_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/place_in_rows.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_edges.h>
#include <CGAL/Texture_atlas/internal/prepare/report_on_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/symmetric_atlas.h>
#include <CGAL/Texture_atlas/Soup_options.h>
#include <CGAL/Texture_atlas/Soup_report.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// The options, and the solvers of linear systems
struct Soup_settings : public Soup_options
{
  Linear_solvers solvers;

  Soup_settings(const Soup_options& options, const Linear_solvers& linear_solvers)
      : Soup_options(options), solvers(linear_solvers)
  {}
};

// No seam divides a polygon of the input. Edges are prepared.
inline Report_on_atlas call_make_atlas(const Soup_settings& options, Mesh& mesh, const Atlas& atlas,
                                       const Soup_report::Seams& way)
{
  namespace np = parameters;
  const Edge_marks is_diagonal = diagonals(mesh);
  const auto is_side =
      boost::make_function_property_map<Edge>([is_diagonal](const Edge e) { return !is_diagonal[e]; });
  auto polygon = mesh.add_property_map<Face, std::size_t>().first;
  Polygon_mesh_processing::connected_components(mesh, polygon, np::edge_is_constrained_map(is_side));
  const Soup_numbers numbers = soup_numbers(mesh);
  const auto make = [&](const auto& first_parameters) -> Report_on_atlas {
    const auto parameters = first_parameters.edge_is_constrained_map(is_diagonal)
                                .vertex_index_map(numbers.points)
                                .face_index_map(numbers.polygons);
    Mesh_atlas_builder<Mesh, Edge_marks, decltype(atlas.uv), decltype(atlas.chart),
                       std::decay_t<decltype(parameters)>>
        builder(options, options.solvers);
    builder.add(mesh, atlas.seams, atlas.uv, atlas.chart, parameters);
    return builder.run();
  };
  Report_on_atlas report;
  if(has_weights(way)) {
    auto weight = edge_weights(mesh);
    report = make(np::edge_weight_map(weight).face_patch_map(polygon));
    mesh.remove_property_map(weight);
  } else {
    report = make(np::face_patch_map(polygon));
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
inline Report_on_atlas make_charts(const Soup_settings& options, Mesh& mesh, const Atlas& atlas,
                                   Soup_report::Seams& way)
{
  if(!options.symmetric) {
    return call_make_atlas(options, mesh, atlas, way);
  }
  Soup_settings uncut = options;
  uncut.seam_price = std::numeric_limits<double>::infinity();
  Soup_report::Seams weighted = way;
  weighted.name = "weighted";
  const auto make = [&](const Atlas& result, const bool cuts_charts) {
    return call_make_atlas(cuts_charts ? options : uncut, mesh, result, weighted);
  };
  if(!has_weights(way)) {
    weigh_by_length(mesh, edge_weights(mesh));
  }
  Soup_report::Symmetry symmetry;
  Report_on_atlas report = Symmetric_atlas_maker(mesh, make).run(atlas, symmetry);
  way.symmetry = std::move(symmetry);
  return report;
}

inline bool keeps_charts(const Atlas_options& options)
{
  return options.given_charts != Atlas_options::REPLACE;
}

// Prepares edges for new seams. Charts that are kept have their seams.
inline void prepare_edges_of(const Soup_options& options, Mesh& mesh, const Edge_marks& is_seam,
                             Soup_report::Seams& way)
{
  if(keeps_charts(options)) {
    way.name = "given";
  } else {
    prepare_edges(options, mesh, is_seam, way);
  }
}

// Marks the seams that are given. If charts are kept, their texture coordinates become those of the atlas.
template <class Uv>
void take_given(const Soup_options& options, Given_surface& given, const Edge_marks& is_seam, const Uv& uv,
                Soup_report::Seams& way)
{
  mark_seams_of_soup(given.soup, given.surface, is_seam);
  if(options.texture_seams) {
    keep_seams_of_texture(given.soup, given.surface, is_seam);
  }
  if(options.material_seams) {
    keep_seams_of_materials(given.soup, given.surface, is_seam);
  }
  if(keeps_charts(options)) {
    const bool repairs = options.given_charts == Atlas_options::REPAIR;
    take_texture(repairs, given.soup, given.surface, is_seam, uv, way);
  }
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
inline Report_on_atlas make_atlas_of_component(const Soup_settings& options, Mesh& mesh, const Atlas& atlas,
                                               Soup_report::Seams& way)
{
  Separate_component component = separate_component(mesh, *options.component);
  Mesh& part = component.part.mesh;
  const Atlas atlas_of_part = empty_atlas(part);
  const Edge_marks is_diagonal = diagonals(mesh), is_diagonal_of_part = diagonals(part);
  for(const Edge e : part.edges()) {
    atlas_of_part.seams[e] = atlas.seams[component.part.edge_origins[e.idx()]];
    is_diagonal_of_part[e] = is_diagonal[component.part.edge_origins[e.idx()]];
  }
  const Soup_numbers numbers = soup_numbers(mesh), numbers_in_part = soup_numbers(part);
  for(const Vertex v : part.vertices()) {
    numbers_in_part.points[v] = numbers.points[component.part.origins[v.idx()]];
  }
  for(const Face f : part.faces()) {
    numbers_in_part.polygons[f] = numbers.polygons[component.faces[f.idx()]];
  }
  prepare_edges_of(options, part, atlas_of_part.seams, way);
  Report_on_atlas report = make_charts(options, part, atlas_of_part, way);
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
    for(std::size_t& v : skipped.vertices) {
      v = component.part.origins[v].idx();
    }
  }
  for(std::size_t& f : report.faces_off_grid) {
    f = component.faces[f].idx();
  }
  const auto face_of_mesh = [&component](const Face f) { return component.faces[f.idx()]; };
  const auto vertex_of_mesh = [&component](const Vertex v) { return component.part.origins[v.idx()]; };
  const auto translate = [](auto& elements, const auto& element_of_mesh) {
    std::transform(elements.begin(), elements.end(), elements.begin(), element_of_mesh);
  };
  for(Report_on_atlas::Part_elements& elements : report.skipped_elements) {
    translate(elements.faces, face_of_mesh);
    translate(elements.vertices, vertex_of_mesh);
  }
  translate(report.offending_faces, face_of_mesh);
  translate(report.offending_vertices, vertex_of_mesh);
  for(Edge& e : report.offending_edges) {
    e = component.part.edge_origins[e.idx()];
  }
  return report;
}

// Each surface by itself: another one neither hides its edges nor has its seams.
inline Soup_report::Seams prepare_given_surface(const Soup_options& options, Given_surface& given,
                                                const Atlas& whole,
                                                const Mesh::Property_map<Edge, double>& weights)
{
  Soup_report::Seams way;
  Mesh& mesh = given.surface.mesh;
  const Edge_marks is_seam = seam_marks(mesh);
  const auto uv = [&](const Halfedge h) -> Kernel::Point_2& { return whole.uv[given.in_common_mesh(h)]; };
  take_given(options, given, is_seam, uv, way);
  prepare_edges_of(options, mesh, is_seam, way);
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

// Makes charts of one surface, or of one component of it, and says where seams run. Seams that are given otherwise than
// by the soup are marked in the mesh. Throws an `Input_error`.
inline Report_on_atlas make_surface_atlas(const Soup_settings& options, Given_surface& given,
                                          const Atlas& atlas, Soup_report::Seams& way)
{
  Mesh& mesh = given.surface.mesh;
  const auto uv = [&atlas](const Halfedge h) -> Kernel::Point_2& { return atlas.uv[h]; };
  take_given(options, given, atlas.seams, uv, way);
  if(options.component) {
    return make_atlas_of_component(options, mesh, atlas, way);
  }
  prepare_edges_of(options, mesh, atlas.seams, way);
  return make_charts(options, mesh, atlas, way);
}

// Makes one atlas of several surfaces, which follow one another in the mesh `whole`, as above. Throws an `Input_error`
// that begins with the name of a surface.
inline Report_on_atlas make_common_surface_atlas(const Soup_settings& options,
                                                 std::vector<Given_surface>& given, Mesh& whole,
                                                 const Atlas& atlas, Soup_report::Seams& way)
{
  const auto weights = edge_weights(whole);
  std::vector<Soup_report::Seams> ways;
  for(Given_surface& each : given) {
    try {
      if(!each.surface.mesh.is_empty()) {
        ways.push_back(prepare_given_surface(options, each, atlas, weights));
      }
    } catch(const Input_error& error) {
      throw error.about(each.name, static_cast<std::size_t>(&each - given.data()));
    }
  }
  way = seams_in_common(ways);
  return call_make_atlas(options, whole, atlas, way);
}

// Of those that faces use
inline std::size_t number_of_used_vertices(const Mesh& mesh)
{
  const auto vertices = mesh.vertices();
  return static_cast<std::size_t>(std::count_if(vertices.begin(), vertices.end(),
                                                [&mesh](const Vertex v) { return !mesh.is_isolated(v); }));
}

// Makes an atlas of one surface, whose mesh `mesh` is, or of several, as above. Charts that are not packed lie in rows.
inline Soup_report make_atlas_of_surfaces(const Soup_settings& options, std::vector<Given_surface>& given,
                                          Mesh& mesh, const Atlas& atlas, Notes& notes)
{
  Report_on_atlas of_mesh;
  Soup_report::Seams seams;
  std::size_t components = 0;
  if(mesh.is_empty()) {
    of_mesh.status = Diagnosis::EMPTY_MESH;
    of_mesh.message = "no face is left to be flattened";
  } else {
    number_as_in_soups(given, mesh);
    components = components_by_size(mesh).size();
    if(options.component && *options.component >= components) {
      throw Input_error("component is " + std::to_string(*options.component) + ", and there are only " +
                            std::to_string(components),
                        {}, {}, Diagnosis::WRONG_OPTION);
    }
    of_mesh = &given.front().surface.mesh == &mesh
                  ? make_surface_atlas(options, given.front(), atlas, seams)
                  : make_common_surface_atlas(options, given, mesh, atlas, seams);
    if(of_mesh.has_atlas() && !options.pack_into_square) {
      place_in_rows(mesh, atlas, of_mesh.charts.size());
    }
  }
  Soup_report report = report_on_soups(options, given, mesh, atlas, std::move(of_mesh), seams, notes);
  report.number_of_components = components;
  report.number_of_vertices = number_of_used_vertices(mesh);
  report.number_of_triangles = mesh.number_of_faces();
  return report;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_ATLAS_H
