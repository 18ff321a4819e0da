// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_POLYGON_SOUP_H
#define FLATTEN_MESH_CHECK_POLYGON_SOUP_H

#include "Input_error.h"
#include "Polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// A polygon's corner, seen from its vertex: the polygon comes from `previous` and goes to `next`.
struct Corner
{
  std::size_t previous;
  std::size_t next;
  std::size_t polygon;
};

// All corners, sorted by vertex: those of vertex `v` are `corners[begin[v]]` up to `corners[begin[v + 1]]`.
struct Corners_of_vertices
{
  std::vector<std::size_t> begin;
  std::vector<Corner> corners;
};

inline Corners_of_vertices corners_of_vertices(const Polygon_soup& soup)
{
  Corners_of_vertices result;
  result.begin.assign(soup.points.size() + 1, 0);
  for(const Polygon& polygon : soup.polygons) {
    for(const std::size_t v : polygon) {
      ++result.begin[v + 1];
    }
  }
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    result.begin[v + 1] += result.begin[v];
  }
  result.corners.resize(result.begin.back());
  std::vector<std::size_t> position(result.begin.begin(), result.begin.end() - 1);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const Polygon& polygon = soup.polygons[p];
    const std::size_t n = polygon.size();
    for(std::size_t i = 0; i < n; ++i) {
      result.corners[position[polygon[i]]++] = {polygon[(i + n - 1) % n], polygon[(i + 1) % n], p};
    }
  }
  return result;
}

inline void check_points(const Polygon_soup& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const Kernel::Point_3& point = soup.points[v];
    if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z())) {
      throw Input_error(vertex_name(v) +
                        " has a coordinate that is not a finite number; remove it or repair the scan");
    }
  }
}

inline void check_polygon(const Polygon_soup& soup, const std::size_t p)
{
  const Polygon& polygon = soup.polygons[p];
  if(polygon.size() < 3) {
    throw Input_error(face_name(p) + " has fewer than three vertices; remove it");
  }
  for(const std::size_t v : polygon) {
    if(v >= soup.points.size()) {
      throw Input_error(face_name(p) + " has a vertex that is not there: the file has only " +
                        std::to_string(soup.points.size()) + "; export the mesh again");
    }
  }
  Polygon sorted(polygon);
  std::sort(sorted.begin(), sorted.end());
  const Polygon::const_iterator twice = std::adjacent_find(sorted.begin(), sorted.end());
  if(twice != sorted.end()) {
    throw Input_error(face_name(p) + " has " + vertex_name(*twice) + " twice; remove degenerate faces");
  }
}

// The edge from `v` that two polygons have in the same direction is not manifold, or they are oriented
// differently.
[[noreturn]] inline void refuse_edge(const std::size_t v, const Corner* begin, const Corner* end,
                                     const Corner& a, const Corner& b)
{
  const auto count = std::count_if(begin, end, [&a](const Corner& c) { return c.next == a.next; }) +
                     std::count_if(begin, end, [&a](const Corner& c) { return c.previous == a.next; });
  const std::pair<std::size_t, std::size_t> ends = std::minmax(v, a.next);
  const std::string edge = "the edge between vertices " + std::to_string(ends.first + 1) + " and " +
                           std::to_string(ends.second + 1);
  if(count > 2) {
    throw Input_error(edge + " has " + std::to_string(count) +
                      " faces, so the surface is not a manifold; remove or separate the surplus ones");
  }
  throw Input_error("faces " + std::to_string(a.polygon + 1) + " and " + std::to_string(b.polygon + 1) +
                    " are oriented differently: both run along " + edge +
                    " in the same direction; orient all faces alike");
}

// Whether the polygons of a vertex form one fan. Every edge is known to have at most one polygon on each
// side, and the corners are sorted by `next`.
inline bool is_one_fan(const Corner* begin, const Corner* end)
{
  const auto find = [begin, end](const std::size_t next) {
    const auto less = [](const Corner& corner, const std::size_t value) { return corner.next < value; };
    const Corner* corner = std::lower_bound(begin, end, next, less);
    return corner != end && corner->next == next ? corner : end;
  };
  std::vector<std::size_t> previous(static_cast<std::size_t>(end - begin));
  std::transform(begin, end, previous.begin(), [](const Corner& corner) { return corner.previous; });
  std::sort(previous.begin(), previous.end());

  // Start at the polygon that nothing comes before, if there is one, and walk around the vertex.
  const Corner* corner = std::find_if(begin, end, [&previous](const Corner& c) {
    return !std::binary_search(previous.begin(), previous.end(), c.next);
  });
  if(corner == end) {
    corner = begin;
  }
  const Corner* const start = corner;
  std::size_t visited = 0;
  do {
    ++visited;
    corner = find(corner->previous);
  } while(corner != end && corner != start);
  return visited == previous.size();
}

inline void check_vertices(const Polygon_soup& soup)
{
  Corners_of_vertices all = corners_of_vertices(soup);
  const auto by_next = [](const Corner& a, const Corner& b) { return a.next < b.next; };
  const auto same_next = [](const Corner& a, const Corner& b) { return a.next == b.next; };
  const auto corners = [&all](const std::size_t v) { return all.corners.data() + all.begin[v]; };
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    std::sort(corners(v), corners(v + 1), by_next);
    const Corner* twice = std::adjacent_find(corners(v), corners(v + 1), same_next);
    if(twice != corners(v + 1)) {
      refuse_edge(v, corners(v), corners(v + 1), twice[0], twice[1]);
    }
  }
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    if(corners(v) != corners(v + 1) && !is_one_fan(corners(v), corners(v + 1))) {
      throw Input_error("at " + vertex_name(v) +
                        " parts of the surface touch in a point, so it is not a manifold; give each part a "
                        "vertex of its own");
    }
  }
}

} // namespace internal

// Throws an `Input_error` that names the place unless the polygons form an oriented manifold with finite
// coordinates.
inline void check_polygon_soup(const Polygon_soup& soup)
{
  if(soup.points.empty() || soup.polygons.empty()) {
    throw Input_error(
        soup.points.empty()
            ? "the file has no vertices; export the mesh again"
            : "the file has vertices but no faces; a point cloud has to be made into a surface first");
  }
  internal::check_points(soup);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    internal::check_polygon(soup, p);
  }
  internal::check_vertices(soup);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_POLYGON_SOUP_H
