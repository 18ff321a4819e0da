// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHART_H
#define FLATTEN_MESH_CHART_H

#include "flatten_mesh/model/build_mesh.h"
#include "flatten_mesh/model/components.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;

// A connected component of a mesh.
struct Component
{
  std::vector<Face> faces;
  std::vector<Vertex> vertices; // by rising number
  std::size_t number;           // by falling number of faces, from 0
  std::size_t components;       // of the whole mesh
};

// The part of a mesh that is flattened: a connected component and its outer border.
struct Chart : public Component
{
  std::vector<Halfedge> borders; // one halfedge without a face on each border, the longest border first
  Halfedge border;               // the outer one of these

  // Only if the mesh is a surface that was cut open along seams:
  std::vector<Vertex> input_vertices; // of each vertex, in the mesh before
  std::vector<int> seams;             // of each edge: the number of its seam from 0, and -1 off the seams

  std::vector<Halfedge>
      seam_sides; // of each halfedge without a face: the one across the seam, if there is one

  // Only if angles are prescribed:
  std::optional<SMP::Vertex_angles<Mesh>> angles;
  std::vector<Vertex> corners;                    // those that are not inside of straight sides
  std::map<Vertex, double> marks;                 // corners, or the copies of cones, with their angles
  std::vector<SMP::Split_edge<Mesh>> split_edges; // which were in the way

  bool is_cut() const { return !input_vertices.empty(); }

  Vertex input_vertex(const Vertex v) const { return is_cut() ? input_vertices[v.idx()] : v; }

  int seam(const Edge e) const { return is_cut() ? seams[e.idx()] : -1; }
};

namespace internal {

inline std::vector<Vertex> vertices_of_faces(const Mesh& mesh, const std::vector<Face>& faces)
{
  std::vector<bool> is_used(mesh.number_of_vertices(), false);
  for(const Face f : faces) {
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      is_used[v.idx()] = true;
    }
  }
  std::vector<Vertex> vertices;
  for(const Vertex v : mesh.vertices()) {
    if(is_used[v.idx()]) {
      vertices.push_back(v);
    }
  }
  return vertices;
}

// One halfedge of each border of the component with these vertices, the longest border first.
inline std::vector<Halfedge> borders_by_length(const Mesh& mesh, const std::vector<Vertex>& vertices)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Halfedge> all;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(all));
  std::vector<std::pair<double, Halfedge>> borders;
  for(const Halfedge h : all) {
    if(std::binary_search(vertices.begin(), vertices.end(), mesh.target(h))) {
      borders.emplace_back(PMP::face_border_length(h, mesh), h);
    }
  }
  std::stable_sort(borders.begin(), borders.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Halfedge> result;
  for(const auto& border : borders) {
    result.push_back(border.second);
  }
  return result;
}

// "there is 1 border, number 0", "there are 3 borders, numbers 0 to 2".
inline std::string choice_text(const std::size_t count, const std::string& noun)
{
  return count == 1 ? "there is 1 " + noun + ", number 0"
                    : "there are " + std::to_string(count) + " " + noun + "s, numbers 0 to " +
                          std::to_string(count - 1);
}

} // namespace internal

// The component that `--component` chooses. Throws an `Input_error` if there is none.
inline Component choose_component(Mesh& mesh, const std::size_t component)
{
  std::vector<std::vector<Face>> components = components_by_size(mesh);
  if(component >= components.size()) {
    throw Input_error("no component " + std::to_string(component) + ": " +
                      internal::choice_text(components.size(), "component") + "; choose with --component");
  }
  const std::vector<Vertex> vertices = internal::vertices_of_faces(mesh, components[component]);
  return {std::move(components[component]), vertices, component, components.size()};
}

// A component with the outer border that `--border` chooses. Throws an `Input_error` if there is none.
inline Chart choose_border(Mesh& mesh, Component component, const std::size_t border)
{
  Chart chart;
  static_cast<Component&>(chart) = std::move(component);
  chart.borders = internal::borders_by_length(mesh, chart.vertices);
  if(chart.borders.empty()) {
    throw Input_error("the surface is closed" +
                      (chart.components == 1 ? std::string()
                                             : ", at least its component " + std::to_string(chart.number) +
                                                   " of " + std::to_string(chart.components)) +
                      ": it has no border to flatten it from; --cut auto cuts it open" +
                      other_component_text(mesh, chart.number));
  }
  if(border >= chart.borders.size()) {
    throw Input_error("no border " + std::to_string(border) + ": " +
                      internal::choice_text(chart.borders.size(), "border") + "; choose with --border");
  }
  chart.border = chart.borders[border];
  return chart;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHART_H
