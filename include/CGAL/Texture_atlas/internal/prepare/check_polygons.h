// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CHECK_POLYGONS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CHECK_POLYGONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// The polygons do not fit together. Turning some of them or duplicating vertices may help.
struct Not_a_mesh : public Input_error
{
  using Input_error::Input_error;
};

inline std::string edge_name(const std::size_t v, const std::size_t w)
{
  return "the edge between vertices " + std::to_string((std::min)(v, w) + 1) + " and " +
         std::to_string((std::max)(v, w) + 1);
}

[[noreturn]] inline void refuse_vertex(const std::size_t v)
{
  throw Not_a_mesh("at " + vertex_name(v) +
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
    throw Not_a_mesh(edge_name(v, w) + " has " + std::to_string(count) +
                         " faces, so the surface is not a manifold; remove or separate the surplus ones",
                     {}, {v, w});
  }
  if(other != p) {
    throw Not_a_mesh("faces " + std::to_string((std::min)(p, other) + 1) + " and " +
                         std::to_string((std::max)(p, other) + 1) +
                         " are oriented differently: both run along " + edge_name(v, w) +
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
    throw Input_error(face_name(p) + " names " + vertex_name(*twice) + " twice; remove degenerate faces", {p},
                      {*twice});
  }
}

inline void check_points(const Polygon_soup& soup)
{
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const Kernel::Point_3& point = soup.points[v];
    if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z())) {
      throw Input_error(vertex_name(v) +
                            " has a coordinate that is not a finite number; remove it or repair the scan",
                        {}, {v});
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
