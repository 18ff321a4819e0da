// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CHECK_POLYGONS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CHECK_POLYGONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

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

// Whether two polygons have the same corners in reverse order
inline bool is_back_of(Polygon front, Polygon back)
{
  std::reverse(back.begin(), back.end());
  for(Polygon* const polygon : {&front, &back}) {
    std::rotate(polygon->begin(), std::min_element(polygon->begin(), polygon->end()), polygon->end());
  }
  return front == back;
}

// Polygons with the same corners as another one before, where they make edges of more than two polygons
struct Duplicate_polygons
{
  std::vector<std::size_t> first; // of each polygon: the one before; itself if there is none, or no such edge
  std::vector<bool> is_back;      // of each polygon: the first one that is in reverse order
};

inline Duplicate_polygons duplicate_polygons(const std::vector<Polygon>& polygons)
{
  Duplicate_polygons result{first_equal_polygons(polygons), std::vector<bool>(polygons.size(), false)};
  std::vector<Vertex_pair> edges; // of duplicates
  for(std::size_t p = 0; p < polygons.size(); ++p) {
    for(std::size_t i = 0; i < polygons[p].size() && result.first[p] != p; ++i) {
      edges.push_back(side_of(polygons[p], i));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const std::vector<bool> is_surplus = have_more_than_two(polygons, edges);
  std::vector<bool> has_back(polygons.size(), false);
  for(std::size_t p = 0; p < polygons.size(); ++p) {
    std::size_t& first = result.first[p];
    bool is_duplicate = false;
    for(std::size_t i = 0; i < polygons[p].size() && first != p; ++i) {
      const auto edge = std::lower_bound(edges.begin(), edges.end(), side_of(polygons[p], i));
      is_duplicate = is_duplicate || is_surplus[static_cast<std::size_t>(edge - edges.begin())];
    }
    first = is_duplicate ? first : p;
    result.is_back[p] = is_duplicate && !has_back[first] && is_back_of(polygons[first], polygons[p]);
    has_back[first] = has_back[first] || result.is_back[p];
  }
  return result;
}

// Leaves out duplicates, but for backs. Two polygons at whose edges there are no others are the sides of a thin closed
// surface, and remain.
inline void leave_out_duplicates(Polygon_soup& soup)
{
  const auto [first, is_back] = duplicate_polygons(soup.polygons);
  std::vector<Index> part_of(first.size(), no_index);
  std::vector<Skipped_part> parts;
  for(std::size_t p = 0; p < first.size(); ++p) {
    if(first[p] != p && !is_back[p]) {
      part_of[p] = 0;
      if(parts.empty()) {
        parts.push_back(skipped_part(Diagnosis::DUPLICATE_FACE,
                                     face_name(soup.origins[p]) + " has the same corners as " +
                                         face_name(soup.origins[first[p]]) + "; remove one of them"));
      }
    }
  }
  if(!parts.empty()) {
    leave_out(soup, part_of, parts);
  }
}

// Gives the backs of polygons, as double-sided cloth has them, vertices of their own, so that they are a sheet of their
// own.
inline void separate_backs(Polygon_soup& soup, Notes& notes)
{
  const auto [first, is_back] = duplicate_polygons(soup.polygons);
  const auto backs = static_cast<std::size_t>(std::count(is_back.begin(), is_back.end(), true));
  if(backs == 0) {
    return;
  }
  std::vector<std::size_t> copies(soup.points.size(), no_index);
  for(std::size_t p = 0; p < is_back.size(); ++p) {
    for(std::size_t i = 0; i < soup.polygons[p].size() && is_back[p]; ++i) {
      std::size_t& v = soup.polygons[p][i];
      if(copies[v] == no_index) {
        copies[v] = soup.points.size();
        soup.points.push_back(Kernel::Point_3(soup.points[v]));
      }
      v = copies[v];
    }
  }
  const auto back =
      static_cast<std::size_t>(std::find(is_back.begin(), is_back.end(), true) - is_back.begin());
  notes.add(count_text(backs, "face is the back of another", "faces are the backs of others") + ", as " +
            face_name(soup.origins[back]) + " is of " + face_name(soup.origins[first[back]]) +
            ": they are sheets of their own");
}

// The polygons do not fit together. Turning some of them or duplicating vertices may help.
struct Not_a_mesh : public Input_error
{
  using Input_error::Input_error;
};

inline std::string edge_name(const Polygon_soup& soup, const std::size_t v, const std::size_t w)
{
  return "the edge between " + vertex_name(soup, (std::min)(v, w)) + " and " +
         vertex_name(soup, (std::max)(v, w));
}

[[noreturn]] inline void refuse_vertex(const Polygon_soup& soup, const std::size_t v)
{
  throw Not_a_mesh("at " + vertex_name(soup, v) +
                       " parts of the surface touch at one vertex, so it is not a manifold; give each part "
                       "its own vertex",
                   {}, {v});
}

// Throws if another polygon runs along an edge of the polygon in the same direction: either too many polygons share
// that edge, or the two are oriented differently.
inline void check_edge(const Polygon_soup& soup, const std::size_t p, const std::size_t v,
                       const std::size_t w)
{
  std::size_t count = 0, other = p;
  for(std::size_t q = 0; q < soup.polygons.size(); ++q) {
    const Polygon& polygon = soup.polygons[q];
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t from = polygon[i], to = polygon[(i + 1) % polygon.size()];
      const bool is_same = from == v && to == w;
      count += is_same || (from == w && to == v);
      other = is_same && other == p ? q : other;
    }
  }
  if(count > 2) {
    throw Not_a_mesh(edge_name(soup, v, w) + " has " + std::to_string(count) +
                         " faces, so the surface is not a manifold; remove or separate the surplus ones",
                     {}, {v, w});
  }
  if(other != p) {
    throw Not_a_mesh("faces " + std::to_string((std::min)(p, other) + 1) + " and " +
                         std::to_string((std::max)(p, other) + 1) +
                         " are oriented differently: both run along " + edge_name(soup, v, w) +
                         " in the same direction; orient all faces alike",
                     {p, other}, {v, w});
  }
}

// Throws unless the polygon has three vertices or more, all different.
inline void check_polygon(const Polygon_soup& soup, const std::size_t p)
{
  const Polygon& polygon = soup.polygons[p];
  if(polygon.size() < 3) {
    throw Input_error(face_name(p) + " has fewer than three vertices; remove it", {p});
  }
  Polygon sorted(polygon);
  std::sort(sorted.begin(), sorted.end());
  const Polygon::const_iterator twice = std::adjacent_find(sorted.begin(), sorted.end());
  if(twice != sorted.end()) {
    throw Input_error(face_name(p) + " names " + vertex_name(soup, *twice) +
                          " twice; remove degenerate faces",
                      {p}, {*twice});
  }
}

inline void check_points(const Polygon_soup& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const Kernel::Point_3& point = soup.points[v];
    if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z())) {
      throw Input_error(vertex_name(soup, v) + non_finite_text + "; remove it or repair the scan", {}, {v});
    }
  }
}

// The number of polygons at each vertex. Throws if a polygon names a vertex that does not exist.
inline std::vector<std::size_t> valences(const Polygon_soup& soup)
{
  std::vector<std::size_t> result(soup.points.size(), 0);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    for(const std::size_t v : soup.polygons[p]) {
      if(v >= soup.points.size()) {
        throw Input_error(face_name(p) + " names a vertex that does not exist: there are only " +
                              std::to_string(soup.points.size()) + "; export the mesh again",
                          {p}, {}, Diagnosis::NUMBER_OUT_OF_RANGE);
      }
      ++result[v];
    }
  }
  return result;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CHECK_POLYGONS_H
