// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPAIR_SOUP_H
#define FLATTEN_MESH_REPAIR_SOUP_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/model/check_polygons.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Records what CGAL does to the polygons while it orients them.
struct Orientation_visitor : public CGAL::Polygon_mesh_processing::Default_orientation_visitor
{
  std::vector<bool>* is_turned = nullptr; // of each polygon
  std::vector<std::size_t>* duplicated = nullptr;

  void non_manifold_edge(const std::size_t v, const std::size_t w, const std::size_t faces)
  {
    refuse_edge(v, w, faces);
  }

  void polygon_orientation_reversed(const std::size_t p) { (*is_turned)[p] = !(*is_turned)[p]; }

  void duplicated_vertex(const std::size_t v, std::size_t) { duplicated->push_back(v); }
};

// Throws if two polygons run along an edge in the same direction even after CGAL turned some.
inline void check_two_sided(const std::vector<Polygon>& polygons, const std::vector<bool>& is_turned)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(std::size_t p = 0; p < polygons.size(); ++p) {
    for(std::size_t i = 0; i < polygons[p].size(); ++i) {
      const std::size_t v = polygons[p][i], w = polygons[p][(i + 1) % polygons[p].size()];
      edges.emplace_back(is_turned[p] ? w : v, is_turned[p] ? v : w);
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto edge = std::adjacent_find(edges.begin(), edges.end());
  if(edge != edges.end()) {
    throw Input_error(
        "the surface is one-sided, like a Moebius strip: its faces cannot be oriented consistently, "
        "for example at " +
        edge_name(edge->first, edge->second) + "; cut it open across the strip");
  }
}

// CGAL keeps the orientation of the first polygon of each component. This function keeps the orientation of the
// majority.
inline void keep_majority(Polygon_soup& soup, std::vector<bool>& is_turned)
{
  CGAL::Surface_mesh_parameterization::internal::ABF::Disjoint_sets components(soup.points.size());
  for(const Polygon& polygon : soup.polygons) {
    for(const std::size_t v : polygon) {
      components.union_set(polygon[0], v);
    }
  }
  std::vector<std::size_t> all(soup.points.size(), 0), turned(soup.points.size(), 0);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const std::size_t component = components.find_set(soup.polygons[p][0]);
    ++all[component];
    turned[component] += is_turned[p];
  }
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const std::size_t component = components.find_set(soup.polygons[p][0]);
    if(turned[component] > all[component] - turned[component]) {
      std::reverse(soup.polygons[p].begin(), soup.polygons[p].end());
      is_turned[p] = !is_turned[p];
    }
  }
}

} // namespace internal

// Orients the polygons consistently, and duplicates vertices at which parts touch. Throws an `Input_error` if the
// result is not a manifold.
inline void orient_soup(Polygon_soup& soup, Notes& notes)
{
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    internal::check_polygon(soup, p);
  }
  const std::vector<Polygon> original = soup.polygons;
  std::vector<bool> is_turned(original.size(), false);
  std::vector<std::size_t> duplicated;
  internal::Orientation_visitor visitor;
  visitor.is_turned = &is_turned;
  visitor.duplicated = &duplicated;
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.polygons,
                                                     CGAL::parameters::visitor(visitor));
  internal::check_two_sided(original, is_turned);
  internal::keep_majority(soup, is_turned);
  for(std::size_t p = 0; p < is_turned.size(); ++p) {
    soup.is_turned[p] = soup.is_turned[p] != is_turned[p];
  }
  const auto turned = std::find(is_turned.begin(), is_turned.end(), true);
  if(turned != is_turned.end()) {
    notes.add("faces were oriented inconsistently: " +
              count_text(static_cast<std::size_t>(std::count(turned, is_turned.end(), true)), "face") +
              " turned; the first is " + face_name(static_cast<std::size_t>(turned - is_turned.begin())) +
              "; '--repair off' refuses them");
  }
  if(!duplicated.empty()) {
    notes.add("parts of the surface touch at a vertex, for example at " + vertex_name(duplicated.front()) +
              ": " + count_text(duplicated.size(), "vertex", "vertices") +
              " added at the end, one for each further part; '--repair off' refuses them");
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPAIR_SOUP_H
