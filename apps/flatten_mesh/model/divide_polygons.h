// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DIVIDE_POLYGONS_H
#define FLATTEN_MESH_DIVIDE_POLYGONS_H

#include "flatten_mesh/model/Model.h"

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

#include <algorithm>
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

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DIVIDE_POLYGONS_H
