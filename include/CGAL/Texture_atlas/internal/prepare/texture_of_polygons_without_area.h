// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TEXTURE_OF_POLYGONS_WITHOUT_AREA_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TEXTURE_OF_POLYGONS_WITHOUT_AREA_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Surface_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

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

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TEXTURE_OF_POLYGONS_WITHOUT_AREA_H
