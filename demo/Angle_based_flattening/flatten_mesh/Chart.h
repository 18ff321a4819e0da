// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHART_H
#define FLATTEN_MESH_CHART_H

#include "build_mesh.h"
#include "components.h"
#include "texts.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// The part of a mesh that is flattened: a connected component and its outer border.
struct Chart
{
  std::vector<Face> faces;
  std::vector<Vertex> vertices;  // by rising number
  std::vector<Halfedge> borders; // one halfedge without a face on each border, the longest border first
  Halfedge border;               // the outer one of these
  std::size_t components;        // of the whole mesh
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

// The chart that `--component` and `--border` choose. Throws an `Input_error` if there is none.
inline Chart choose_chart(Mesh& mesh, const std::size_t component, const std::size_t border)
{
  std::vector<std::vector<Face>> components = components_by_size(mesh);
  if(component >= components.size()) {
    throw Input_error("no component " + std::to_string(component) + ": " +
                      internal::choice_text(components.size(), "component") + "; choose with --component");
  }
  Chart chart;
  chart.components = components.size();
  chart.faces = std::move(components[component]);
  chart.vertices = internal::vertices_of_faces(mesh, chart.faces);
  chart.borders = internal::borders_by_length(mesh, chart.vertices);
  if(chart.borders.empty()) {
    throw Input_error(
        "the surface is closed" +
        (components.size() == 1 ? std::string()
                                : ", at least its component " + std::to_string(component) + " of " +
                                      std::to_string(components.size())) +
        ": it has no border to flatten it from; cut it open along a path of edges, or remove a face" +
        other_component_text(mesh, component));
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
