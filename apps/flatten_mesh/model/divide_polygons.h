// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DIVIDE_POLYGONS_H
#define FLATTEN_MESH_DIVIDE_POLYGONS_H

#include "flatten_mesh/model/Model.h"

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Flat_polygon.h>
#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>
#include <CGAL/Texture_atlas/internal/prepare/triangulate.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// Takes the polygons of a model, one after the other.
class Polygon_division
{
public:
  explicit Polygon_division(const Model& before) : m_before(before)
  {
    m_after.points = before.points;
    m_after.colors = before.colors;
    m_after.normals = before.normals;
    m_after.texture = before.texture;
    m_after.has_point_normals = before.has_point_normals;
    m_after.has_point_texture = before.has_point_texture;
    m_after.statements = before.statements;
    m_after.material_names = before.material_names;
    m_after.material_colors = before.material_colors;
    m_after.name = before.name;
    m_after.is_welded = before.is_welded;
  }

  // Returns the corner's new number.
  Index add_corner(const Index c)
  {
    m_after.vertices.push_back(m_before.vertices[c]);
    if(!m_before.corner_normals.empty()) {
      m_after.corner_normals.push_back(m_before.corner_normals[c]);
    }
    if(!m_before.corner_texture.empty()) {
      m_after.corner_texture.push_back(m_before.corner_texture[c]);
    }
    return static_cast<Index>(m_after.vertices.size() - 1);
  }

  void end_polygon(const Index p)
  {
    if(!m_before.materials.empty()) {
      m_after.materials.push_back(m_before.materials[p]);
    }
    m_after.end_polygon();
  }

  // Polygon p and those after it begin here.
  void begin(const Index p)
  {
    for(; m_statement < m_after.statements.size() && m_before.statements[m_statement].polygon <= p;
        ++m_statement) {
      m_after.statements[m_statement].polygon = static_cast<Index>(m_after.number_of_polygons());
    }
  }

  Model&& result() { return std::move(m_after); }

private:
  const Model& m_before;
  Model m_after;
  std::size_t m_statement = 0;
};

} // namespace internal

// Of each polygon: whether its triangles differ, at a corner or in their charts. An atlas whose seams run along
// diagonals of polygons does that. For `uv` and `chart` see `model_texture()`.
template <class Uv, class Chart_number>
std::vector<bool> torn_polygons(const Model& model, const Mesh& mesh, const Corner_origins& origins,
                                const Uv& uv, const Chart_number& chart)
{
  std::vector<bool> is_torn(model.number_of_polygons(), false);
  for(const Edge e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e), o = mesh.opposite(h);
    if(mesh.is_border(e)) {
      continue;
    }
    const Index p = model.polygon_of_corner(origins.corners[h.idx()]);
    if(p == model.polygon_of_corner(origins.corners[o.idx()])) {
      const Index number = chart(mesh.face(h));
      const bool is_same = number == chart(mesh.face(o)) &&
                           (number == no_index || (uv(h) == uv(mesh.prev(o)) && uv(o) == uv(mesh.prev(h))));
      is_torn[p] = is_torn[p] || !is_same;
    }
  }
  return is_torn;
}

// Replaces polygons of a model by their triangles.
inline void divide_polygons(Model& model, const Mesh& mesh, Corner_origins& origins,
                            const std::vector<bool>& is_divided)
{
  std::vector<std::pair<Index, Face>> triangles; // of these polygons
  for(const Face f : mesh.faces()) {
    const Index p = model.polygon_of_corner(origins.corners[mesh.halfedge(f).idx()]);
    if(is_divided[p]) {
      triangles.push_back({p, f});
    }
  }
  std::sort(triangles.begin(), triangles.end());
  auto triangle = triangles.begin();
  internal::Polygon_division division(model);
  Corner_origins after;
  after.corners.assign(origins.corners.size(), no_index);
  std::vector<Index> numbers(model.number_of_corners(), no_index);
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    division.begin(p);
    for(; triangle != triangles.end() && triangle->first == p; ++triangle) {
      Halfedge h = mesh.halfedge(triangle->second);
      for(int i = 0; i < 3; ++i) {
        after.corners[h.idx()] = division.add_corner(origins.corners[h.idx()]);
        h = origins.is_turned[p] ? mesh.prev(h) : mesh.next(h);
      }
      division.end_polygon(p);
      after.is_turned.push_back(origins.is_turned[p]);
      after.has_no_area.push_back(false);
    }
    if(!is_divided[p]) {
      for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
        numbers[c] = division.add_corner(c);
      }
      division.end_polygon(p);
      after.is_turned.push_back(origins.is_turned[p]);
      after.has_no_area.push_back(!origins.has_no_area.empty() && origins.has_no_area[p]);
    }
  }
  division.begin(no_index);
  for(std::size_t h = 0; h < after.corners.size(); ++h) {
    if(after.corners[h] == no_index && origins.corners[h] != no_index) {
      after.corners[h] = numbers[origins.corners[h]];
    }
  }
  origins = std::move(after);
  model = division.result();
}

namespace internal {

inline std::vector<Kernel::Point_3> points_of_polygon(const Model& model, const Index polygon)
{
  std::vector<Kernel::Point_3> points;
  for(Index c = model.first_corners[polygon]; c < model.first_corners[polygon + 1]; ++c) {
    points.push_back(model.points[model.vertices[c]]);
  }
  return points;
}

// The corners of triangles in a polygon that has no chart, and so none that are positive in the plane: those that are
// in space
inline std::vector<std::array<Index, 3>> triangles_in_space(const Model& model, const Index polygon)
{
  const std::vector<Kernel::Point_3> points = points_of_polygon(model, polygon);
  const Index first = model.first_corners[polygon];
  std::vector<std::array<Index, 3>> result;
  if(!std::all_of(points.begin(), points.end(), is_finite)) {
    for(Index c = first + 2; c < model.first_corners[polygon + 1]; ++c) {
      result.push_back({first, c - 1, c});
    }
    return result;
  }
  const Polygon_triangles triangles = triangulate_polygon(points, [](Index, Index) { return false; });
  for(Index t = 0; t < triangles.size(); ++t) {
    const Index* const corner = &triangles.corners[3 * t];
    result.push_back({first + corner[0], first + corner[1], first + corner[2]});
  }
  return result;
}

} // namespace internal

// Makes triangles of all larger polygons: those of the mesh, which are positive in the plane and in space.
inline void take_triangles(Model& model, Model_texture& texture)
{
  std::stable_sort(texture.triangles.begin(), texture.triangles.end(),
                   [](const Model_triangle& a, const Model_triangle& b) { return a.polygon < b.polygon; });
  internal::Polygon_division division(model);
  Model_texture after;
  after.is_second_set = texture.is_second_set;
  const auto add_corner = [&](const Index c) {
    division.add_corner(c);
    after.uv.push_back(texture.uv[c]);
  };
  const auto end_polygon = [&](const Index p, const bool is_turned) {
    division.end_polygon(p);
    after.is_turned.push_back(is_turned);
    if(!texture.charts.empty()) {
      after.charts.push_back(texture.charts[p]);
    }
  };
  auto triangle = texture.triangles.begin();
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    division.begin(p);
    std::vector<std::array<Index, 3>> triangles;
    for(; triangle != texture.triangles.end() && triangle->polygon == p; ++triangle) {
      triangles.push_back(triangle->corners);
    }
    if(model.size(p) <= 3) {
      for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
        add_corner(c);
      }
      end_polygon(p, texture.is_turned[p]);
      continue;
    }
    const bool has_chart = texture.chart(p) != no_index;
    if(!has_chart) {
      triangles = internal::triangles_in_space(model, p);
    }
    for(const std::array<Index, 3>& corners : triangles) {
      std::for_each(corners.begin(), corners.end(), add_corner);
      end_polygon(p, !has_chart && texture.is_turned[p]); // those of the mesh are turned
    }
  }
  division.begin(no_index);
  model = division.result();
  texture = std::move(after);
}

// Whether a fan of triangles from some corner, as many programs draw it, has one that is turned over in space
inline bool has_bad_fan(const Model& model, const Index polygon)
{
  const std::vector<Kernel::Point_3> points = internal::points_of_polygon(model, polygon);
  if(points.size() <= 3 || !std::all_of(points.begin(), points.end(), is_finite)) {
    return false;
  }
  const Flat_polygon flat(points);
  Kernel::Vector_3 normal(0, 0, 0);
  for(Index i = 2; i < flat.size(); ++i) {
    normal = normal + flat.area(0, i - 1, i);
  }
  const double squared = normal.squared_length(); // the largest coordinate is from 1 to 2
  if(squared < 1e-24) {
    return false; // without area, nothing is turned
  }
  const auto is_turned = [&](const Index i, const Index j, const Index k) { // by more than rounding
    return flat.area(i, j, k) * normal < -1e-9 * squared;
  };
  bool is_bad = false;
  for(Index i = 0; i < flat.size(); ++i) {
    is_bad = is_bad || is_turned(i, (i + 1) % flat.size(), (i + 2) % flat.size()) ||
             (i >= 2 && is_turned(0, i - 1, i));
  }
  return is_bad;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DIVIDE_POLYGONS_H
