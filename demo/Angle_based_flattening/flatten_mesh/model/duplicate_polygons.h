// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DUPLICATE_POLYGONS_H
#define FLATTEN_MESH_DUPLICATE_POLYGONS_H

#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/texts.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The vertices of a polygon in an order that does not depend on where it begins and how it is oriented
inline Polygon canonical(Polygon polygon)
{
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  if(polygon.size() > 2 && polygon.back() < polygon[1]) {
    std::reverse(polygon.begin() + 1, polygon.end());
  }
  return polygon;
}

// Of each polygon, the first one with the same corners, in either orientation: itself, if there is no other before.
inline std::vector<std::size_t> first_equal_polygons(const std::vector<Polygon>& polygons)
{
  std::vector<std::pair<std::size_t, std::size_t>>
      order; // a sum that depends on the vertices alone, and the polygon
  order.reserve(polygons.size());
  for(std::size_t p = 0; p < polygons.size(); ++p) {
    std::size_t sum = 0;
    for(const std::size_t v : polygons[p]) {
      std::size_t hash = 0;
      boost::hash_combine(hash, v);
      sum += hash;
    }
    order.emplace_back(sum, p);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> first(polygons.size());
  for(auto begin = order.begin(); begin != order.end();) {
    const auto end = std::find_if(begin, order.end(), [&](const auto& o) { return o.first != begin->first; });
    std::vector<std::pair<Polygon, std::size_t>> equal;
    for(auto i = begin; i != end && end - begin > 1; ++i) {
      equal.emplace_back(canonical(polygons[i->second]), i->second);
    }
    first[begin->second] = begin->second;
    std::sort(equal.begin(), equal.end());
    for(std::size_t i = 0; i < equal.size(); ++i) {
      const bool is_same = i > 0 && equal[i].first == equal[i - 1].first;
      first[equal[i].second] = is_same ? first[equal[i - 1].second] : equal[i].second;
    }
    begin = end;
  }
  return first;
}

using Vertex_pair = std::pair<std::size_t, std::size_t>;

inline Vertex_pair side_of(const Polygon& polygon, const std::size_t corner)
{
  return std::minmax(polygon[corner], polygon[corner + 1 < polygon.size() ? corner + 1 : 0]);
}

// The edges among these, sorted, that have more than two polygons
inline std::vector<bool> have_more_than_two(const std::vector<Polygon>& polygons,
                                            const std::vector<Vertex_pair>& edges)
{
  std::vector<std::size_t> counts(edges.size(), 0);
  for(const Polygon& polygon : polygons) {
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const Vertex_pair side = side_of(polygon, i);
      const auto edge = std::lower_bound(edges.begin(), edges.end(), side);
      if(edge != edges.end() && *edge == side) {
        ++counts[static_cast<std::size_t>(edge - edges.begin())];
      }
    }
  }
  std::vector<bool> result;
  for(const std::size_t count : counts) {
    result.push_back(count > 2);
  }
  return result;
}

} // namespace internal

// Leaves out polygons with the same corners as another one before, in either orientation, where they make edges of
// more than two polygons. Otherwise the two are the sides of a thin closed surface, and remain.
inline void leave_out_duplicates(Polygon_soup& soup)
{
  const std::vector<std::size_t> first = internal::first_equal_polygons(soup.polygons);
  std::vector<internal::Vertex_pair> edges; // of duplicates
  for(std::size_t p = 0; p < first.size(); ++p) {
    for(std::size_t i = 0; i < soup.polygons[p].size() && first[p] != p; ++i) {
      edges.push_back(internal::side_of(soup.polygons[p], i));
    }
  }
  if(edges.empty()) {
    return;
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const std::vector<bool> is_surplus = internal::have_more_than_two(soup.polygons, edges);
  std::vector<Index> part_of(first.size(), no_index);
  std::vector<Skipped_part> parts;
  for(std::size_t p = 0; p < first.size(); ++p) {
    bool is_duplicate = false;
    for(std::size_t i = 0; i < soup.polygons[p].size() && first[p] != p; ++i) {
      const auto edge = std::lower_bound(edges.begin(), edges.end(), internal::side_of(soup.polygons[p], i));
      is_duplicate = is_duplicate || is_surplus[static_cast<std::size_t>(edge - edges.begin())];
    }
    if(is_duplicate) {
      part_of[p] = 0;
      if(parts.empty()) {
        parts.push_back({0, 0, "DUPLICATE_FACE",
                         face_name(soup.origins[p]) + " has the same corners as " +
                             face_name(soup.origins[first[p]]) + "; remove one of them"});
      }
    }
  }
  if(!parts.empty()) {
    leave_out(soup, part_of, parts);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DUPLICATE_POLYGONS_H
