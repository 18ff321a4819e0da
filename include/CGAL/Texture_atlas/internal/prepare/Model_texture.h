// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_TEXTURE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_TEXTURE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// New texture coordinates for a model.
struct Model_texture
{
  std::vector<Kernel::Point_2> uv; // of each corner; NaN where there are none
  std::vector<Index> charts;   // of each polygon: the chart that it is in, or `no_index`; empty: one chart
  bool is_second_set = false;  // after the coordinates of the model, which are then written as well
  std::vector<bool> is_turned; // of each polygon: to be written with its corners in reverse order
  std::vector<std::array<double, 4>> tangents; // of each corner, as in glTF, or empty
  std::string normal_picture, color_picture;   // PNG files that fit the coordinates, or empty
  std::vector<Model_triangle> triangles; // into which the polygons are divided where a format asks for it

  bool has_uv(const Index corner) const { return std::isfinite(uv[corner].x()); }

  bool has_pictures() const { return !normal_picture.empty() || !color_picture.empty(); }

  Index chart(const Index polygon) const { return charts.empty() ? 0 : charts[polygon]; }
};

// The first of two sets. Where a corner of the model has none, they are 0 in glTF.
inline Kernel::Point_2 first_of_two_uv(const Surface_soup& model, const Index corner)
{
  const Index point = model.texture_point(corner);
  return point == no_index || !std::isfinite(model.texture[point].x()) ||
                 !std::isfinite(model.texture[point].y())
             ? Kernel::Point_2(0, 1)
             : model.texture[point];
}

// Adds the triangles of the polygons that no face of the mesh is in. Polygons with a coordinate that is no number
// have none.
inline void add_left_out_triangles(const Surface_soup& model, Model_texture& texture)
{
  std::vector<bool> is_in_mesh(model.number_of_polygons(), false);
  for(const Model_triangle& triangle : texture.triangles) {
    is_in_mesh[triangle.polygon] = true;
  }
  const auto is_finite = [&model](const Index c) {
    const Kernel::Point_3& point = model.points[model.vertices[c]];
    return std::isfinite(point.x()) && std::isfinite(point.y()) && std::isfinite(point.z());
  };
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    const Index first = model.first_corners[p], end = model.first_corners[p + 1];
    bool is_left_out = !is_in_mesh[p];
    for(Index c = first; c < end && is_left_out; ++c) {
      is_left_out = is_finite(c);
    }
    for(Index c = first + 2; c < end && is_left_out; ++c) {
      texture.triangles.push_back({p, {first, c - 1, c}});
    }
  }
}

// Corners that repeat the vertex before get its coordinates.
inline void fill_repetitions(const Surface_soup& model, Model_texture& texture)
{
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    const Index first = model.first_corners[p], size = model.size(p);
    for(Index i = 1; texture.charts[p] != no_index && i < 2 * size; ++i) {
      const Index c = first + i % size, before = first + (i - 1) % size;
      if(!texture.has_uv(c) && model.vertices[c] == model.vertices[before]) {
        texture.uv[c] = texture.uv[before];
      }
    }
  }
}

// A texture without any coordinates, for the polygons of a mesh and those that were left out of it.
inline Model_texture empty_texture(const Surface_soup& model, const Mesh& mesh, const Corner_origins& origins)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  Model_texture texture;
  texture.uv.assign(model.number_of_corners(), {none, none});
  texture.is_turned = origins.is_turned;
  texture.triangles.reserve(mesh.number_of_faces());
  for(const Face f : mesh.faces()) {
    texture.triangles.push_back(origins.triangle(model, mesh, f));
  }
  add_left_out_triangles(model, texture);
  return texture;
}

// The texture of a model from an atlas of the mesh that was made of it: `uv(h)` is that of the halfedge's target in
// its face, `chart(f)` the number of the face's chart, and `no_index` for a face without. All triangles of a polygon
// have to agree at its corners: see `torn_polygons()`.
template <class Uv, class Chart_number>
Model_texture model_texture(const Surface_soup& model, const Mesh& mesh, const Corner_origins& origins,
                            const Uv& uv, const Chart_number& chart)
{
  Model_texture texture = empty_texture(model, mesh, origins);
  texture.charts.assign(model.number_of_polygons(), no_index);
  for(const Face f : mesh.faces()) {
    const Index number = chart(f);
    if(number != no_index) {
      texture.charts[model.polygon_of_corner(origins.corners[mesh.halfedge(f).idx()])] = number;
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        texture.uv[origins.corners[h.idx()]] = uv(h);
      }
    }
  }
  fill_repetitions(model, texture);
  return texture;
}

// Gives polygons without area the coordinates of an edge of a neighbor, and the neighbor's chart.
class Texture_of_polygons_without_area
{
public:
  Texture_of_polygons_without_area(const Surface_soup& model, Model_texture& texture)
      : m_model(model), m_texture(texture)
  {}

  void fill(std::vector<Index> polygons)
  {
    for(const Index p : polygons) {
      for_each_side(p, [this](const Index c, const Index d) { m_sides.emplace(key(c, d), std::nullopt); });
    }
    for(Index p = 0; p < m_model.number_of_polygons(); ++p) {
      add_sides(p);
    }
    // A neighbor may be one of them, which gets its coordinates first.
    for(std::size_t rest = polygons.size() + 1; polygons.size() < rest;) {
      rest = polygons.size();
      const auto is_filled = [this](const Index p) { return fill_polygon(p); };
      polygons.erase(std::remove_if(polygons.begin(), polygons.end(), is_filled), polygons.end());
    }
  }

private:
  using Side = std::pair<Index, Index>; // corners of a polygon, one after the other

  const Kernel::Point_3& point(const Index corner) const { return m_model.points[m_model.vertices[corner]]; }

  // Points that are equal are one, as vertices may be welded.
  std::pair<Kernel::Point_3, Kernel::Point_3> key(const Index c, const Index d) const
  {
    return (std::minmax)(point(c), point(d));
  }

  template <class Function>
  void for_each_side(const Index p, const Function& f) const
  {
    const Index first = m_model.first_corners[p], size = m_model.size(p);
    for(Index i = 0; i < size; ++i) {
      f(first + i, first + (i + 1) % size);
    }
  }

  void add_sides(const Index p)
  {
    if(m_texture.charts[p] != no_index) {
      for_each_side(p, [this](const Index c, const Index d) {
        if(const auto side = m_sides.find(key(c, d)); side != m_sides.end() && !side->second) {
          side->second = Side(c, d);
        }
      });
    }
  }

  // On the longest side that a neighbor has, each corner at the nearer end: between both, `float` would move it off the
  // side. Returns whether there is one.
  bool fill_polygon(const Index p)
  {
    std::optional<Side> longest;
    double length = -1;
    for_each_side(p, [&](const Index c, const Index d) {
      const std::optional<Side>& side = m_sides.at(key(c, d));
      if(const double squared = CGAL::squared_distance(point(c), point(d)); side && squared > length) {
        longest = side;
        length = squared;
      }
    });
    if(!longest) {
      return false;
    }
    const auto [from, to] = *longest;
    const Kernel::Vector_3 side = point(to) - point(from);
    const Kernel::Point_2 uv_from = m_texture.uv[from], uv_to = m_texture.uv[to];
    const Index chart = m_texture.charts[m_model.polygon_of_corner(from)];
    for(Index c = m_model.first_corners[p]; c < m_model.first_corners[p + 1]; ++c) {
      m_texture.uv[c] = 2 * ((point(c) - point(from)) * side) < length ? uv_from : uv_to;
    }
    m_texture.charts[p] = chart;
    add_sides(p);
    return true;
  }

  const Surface_soup& m_model;
  Model_texture& m_texture;
  std::map<std::pair<Kernel::Point_3, Kernel::Point_3>, std::optional<Side>>
      m_sides; // of polygons without area
};

// Gives the polygons that have no area, and are therefore not part of the mesh, coordinates on an edge of a neighbor.
// Those without neighbors get none.
inline void fill_polygons_without_area(const Surface_soup& model, const std::vector<bool>& has_no_area,
                                       Model_texture& texture)
{
  std::vector<Index> polygons;
  for(Index p = 0; p < has_no_area.size(); ++p) {
    if(has_no_area[p]) {
      polygons.push_back(p);
    }
  }
  if(!polygons.empty()) {
    Texture_of_polygons_without_area(model, texture).fill(std::move(polygons));
  }
}

// `no_index` without chart
inline Index chart_number(const Atlas& atlas, const Face f)
{
  return atlas.chart[f] < 0 ? no_index : static_cast<Index>(atlas.chart[f]);
}

inline Model_texture texture_of(const Surface_soup& model, const Mesh& mesh, const Corner_origins& origins,
                                const Atlas& atlas)
{
  const auto uv = [&atlas](const Halfedge h) { return atlas.uv[h]; };
  const auto chart = [&atlas](const Face f) { return chart_number(atlas, f); };
  Model_texture texture = model_texture(model, mesh, origins, uv, chart);
  fill_polygons_without_area(model, origins.has_no_area, texture);
  return texture;
}

// Polygons that are left out keep their coordinates. `is_left_out` may be empty.
inline void keep_given_texture(const Surface_soup& soup, const std::vector<bool>& is_left_out,
                               Model_texture& texture)
{
  for(std::size_t p = 0; p < is_left_out.size(); ++p) {
    for(Index c = soup.first_corners[p]; c < soup.first_corners[p + 1] && is_left_out[p]; ++c) {
      if(const Index point = soup.texture_point(c); point != no_index) {
        texture.uv[c] = soup.texture[point];
      }
    }
  }
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_TEXTURE_H
