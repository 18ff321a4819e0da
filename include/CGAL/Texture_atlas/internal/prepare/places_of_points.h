// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PLACES_OF_POINTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PLACES_OF_POINTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

using Point_sets = CGAL::Surface_mesh_parameterization::internal::ABF::Disjoint_sets;

// Unites equal points.
inline void unite_equal_points(const Polygon_soup& soup, std::vector<Index> used, Point_sets& sets)
{
  const auto before = [&soup](const Index v, const Index w) {
    return soup.points[v] != soup.points[w] ? soup.points[v] < soup.points[w] : v < w;
  };
  std::sort(used.begin(), used.end(), before);
  for(std::size_t i = 1; i < used.size(); ++i) {
    if(soup.points[used[i]] == soup.points[used[i - 1]]) {
      sets.union_set(used[i - 1], used[i]);
    }
  }
}

// Unites points that are at most this far apart, and all points that are connected through them. Points in one cell of
// a grid are near enough; the cells around are searched. Points whose coordinates are too large for the grid are
// rounded more.
inline void unite_near_points(const Polygon_soup& soup, const std::vector<Index>& used, const double distance,
                              Point_sets& sets)
{
  using Cell = std::array<double, 3>;
  const double side = distance / std::sqrt(3.), squared = distance * distance, largest = 1e15;
  std::unordered_map<Cell, std::vector<Index>, boost::hash<Cell>> cells;
  std::vector<std::pair<Index, Cell>> places;
  for(const Index v : used) {
    Cell cell;
    for(int i = 0; i < 3; ++i) {
      cell[static_cast<std::size_t>(i)] = std::floor(soup.points[v][i] / side) + 0.; // not -0
    }
    if(std::all_of(cell.begin(), cell.end(), [&](const double i) { return std::abs(i) < largest; })) {
      cells[cell].push_back(v);
      sets.union_set(cells[cell].front(), v);
      places.emplace_back(v, cell);
    }
  }
  for(const auto& [v, cell] : places) {
    for(int i = 0; i < 125; ++i) { // two cells to each side
      const auto other = cells.find({cell[0] + i % 5 - 2, cell[1] + i / 5 % 5 - 2, cell[2] + i / 25 - 2});
      if(other == cells.end() || sets.find_set(other->second.front()) == sets.find_set(v)) {
        continue;
      }
      const Kernel::Point_3& point = soup.points[v];
      if(std::any_of(other->second.begin(), other->second.end(), [&](const Index w) {
           return CGAL::squared_distance(point, soup.points[w]) <= squared;
         })) {
        sets.union_set(v, other->second.front());
      }
    }
  }
}

// Of each point, the number of its place: points at the same place have the same one. Those that no polygon uses have
// places of their own.
inline std::vector<Index> places_of_points(const Polygon_soup& soup, const double tolerance)
{
  const std::vector<std::size_t> valence = valences(soup);
  std::vector<Index> used;
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    if(valence[v] > 0) {
      used.push_back(static_cast<Index>(v));
    }
  }
  Point_sets sets(soup.points.size());
  unite_equal_points(soup, used, sets);
  if(tolerance > 0) {
    unite_near_points(soup, used, tolerance, sets);
  }
  std::vector<Index> first(soup.points.size(), no_index), places(soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v) { // the smallest vertex of each set
    Index& place = first[sets.find_set(v)];
    place = place == no_index ? static_cast<Index>(v) : place;
    places[v] = place;
  }
  return places;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PLACES_OF_POINTS_H
