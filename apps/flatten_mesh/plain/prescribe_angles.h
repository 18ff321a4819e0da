// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PRESCRIBE_ANGLES_H
#define FLATTEN_MESH_PRESCRIBE_ANGLES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/model/Corner_origins.h"
#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/model/Edge_marks.h"
#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/border_angles.h"
#include "flatten_mesh/plain/choose_corners.h"
#include "flatten_mesh/plain/flatten_chart.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

inline bool prescribes_angles(const Command_line& command)
{
  return !command.rectangle.empty() || !command.border_angles.empty();
}

namespace internal {

// The corners that are asked for. A map without prescribed angles tells where to put them otherwise; if there is none,
// returns nothing, and why in `attempt`.
inline std::optional<std::array<Vertex, 4>> corners(Mesh& mesh, const Chart& chart, Command_line command,
                                                    Progress& progress, std::optional<Flattening>& attempt)
{
  const std::vector<Vertex> border = outer_border(mesh, chart);
  if(const auto numbers = corner_numbers(command.rectangle)) {
    std::array<Vertex, 4> result;
    for(std::size_t i = 0; i < result.size(); ++i) {
      result[i] = border_vertex((*numbers)[i], border, "--rectangle");
    }
    return result;
  }
  if(border.size() < 4) {
    throw Input_error("--rectangle: the outer border has only " +
                      count_text(border.size(), "vertex", "vertices"));
  }
  command.options.injective = false;
  attempt = flatten_chart(mesh, chart, command, progress);
  if(!attempt->succeeded()) {
    return std::nullopt;
  }
  return choose_corners(border, attempt->uv);
}

// Splits edges that are in the way. The new edges are no sides of polygons, as far as seams are concerned.
inline void split_edges(Mesh& mesh, Chart& chart)
{
  const auto is_diagonal = diagonals(mesh);
  const auto old_faces = mesh.number_of_faces();
  chart.split_edges = SMP::split_flat_chords(mesh, chart.border, *chart.angles).edges;
  for(const auto& split : chart.split_edges) {
    chart.vertices.push_back(split.middle);
    for(const Halfedge h : CGAL::halfedges_around_target(split.middle, mesh)) {
      is_diagonal[mesh.edge(h)] = true;
    }
  }
  for(auto f = old_faces; f < mesh.number_of_faces(); ++f) {
    chart.faces.push_back(Face(f));
  }
}

} // namespace internal

// Sets the angles of a chart that are asked for, and splits edges that would make triangles flat. Returns why that is
// not possible, or nothing.
inline std::optional<Flattening> prescribe_angles(Mesh& mesh, Chart& chart, const Command_line& command,
                                                  Progress& progress)
{
  if(command.rectangle.empty()) {
    chart.angles = read_border_angles(command.border_angles, outer_border(mesh, chart));
  } else {
    std::optional<Flattening> attempt;
    const auto corners = internal::corners(mesh, chart, command, progress, attempt);
    if(!corners) {
      return attempt;
    }
    chart.angles = SMP::rectangle_angles(mesh, *corners).angles;
  }
  chart.corners = corners_of(*chart.angles, outer_border(mesh, chart));
  for(const Vertex v : chart.corners) {
    chart.marks[v] = *(*chart.angles)[v];
  }
  internal::split_edges(mesh, chart);
  return std::nullopt;
}

// The polygons of the faces, after edges were split. The parts of a triangle lie side by side at the halves of its
// sides, and one of them has its number.
inline std::vector<Index> polygons_of_parts(std::vector<Index> polygons, const Mesh& mesh, const Chart& chart)
{
  CGAL::Surface_mesh_parameterization::internal::ABF::Disjoint_sets triangles(mesh.number_of_faces());
  for(const auto& split : chart.split_edges) {
    const Halfedge first = mesh.halfedge(split.source, split.middle),
                   second = mesh.halfedge(split.middle, split.target);
    triangles.union_set(mesh.face(first).idx(), mesh.face(second).idx());
    triangles.union_set(mesh.face(mesh.opposite(first)).idx(), mesh.face(mesh.opposite(second)).idx());
  }
  std::vector<Index> of_triangle(mesh.number_of_faces());
  for(std::size_t f = 0; f < polygons.size(); ++f) {
    of_triangle[triangles.find_set(f)] = polygons[f];
  }
  for(std::size_t f = polygons.size(); f < mesh.number_of_faces(); ++f) {
    polygons.push_back(of_triangle[triangles.find_set(f)]);
  }
  return polygons;
}

// The soup with the new vertices of the chart, each as a corner of the polygons whose side was split there
inline Polygon_soup with_split_sides(Polygon_soup soup, const Mesh& mesh, const Chart& chart)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  for(const auto& split : chart.split_edges) {
    soup.points.push_back(mesh.point(split.middle));
    middles[{split.source.idx(), split.target.idx()}] = split.middle.idx();
    middles[{split.target.idx(), split.source.idx()}] = split.middle.idx();
  }
  for(Polygon& polygon : soup.polygons) {
    Polygon divided;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      divided.push_back(polygon[i]);
      const auto middle = middles.find({polygon[i], polygon[(i + 1) % polygon.size()]});
      if(middle != middles.end()) {
        divided.push_back(middle->second);
      }
    }
    polygon = std::move(divided);
  }
  return soup;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PRESCRIBE_ANGLES_H
