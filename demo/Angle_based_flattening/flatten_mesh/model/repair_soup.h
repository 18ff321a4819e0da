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
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

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

// CGAL keeps the orientation of the first polygon of each component. This keeps that of the majority.
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

// Keeps the polygons for which `is_kept` is true, with their origins.
template <class Is_kept>
void keep_polygons(Polygon_soup& soup, const Is_kept& is_kept)
{
  std::size_t kept = 0;
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    if(is_kept(p)) {
      soup.polygons[kept].swap(soup.polygons[p]);
      soup.origins[kept] = soup.origins[p];
      soup.is_turned[kept] = soup.is_turned[p];
      ++kept;
    }
  }
  soup.polygons.resize(kept);
  soup.origins.resize(kept);
  soup.is_turned.resize(kept);
}

inline bool has_repeated_vertex(Polygon polygon)
{
  std::sort(polygon.begin(), polygon.end());
  return std::adjacent_find(polygon.begin(), polygon.end()) != polygon.end();
}

// After equal points are merged, a triangle with two corners at the same place is only an edge.
inline void drop_collapsed_polygons(Polygon_soup& soup, Notes& notes)
{
  const std::size_t before = soup.polygons.size();
  keep_polygons(soup, [&soup](const std::size_t p) { return !has_repeated_vertex(soup.polygons[p]); });
  if(soup.polygons.empty()) {
    throw Input_error(
        "every face has two corners at the same place, so there is no surface; export the mesh again");
  }
  if(soup.polygons.size() < before) {
    notes.add(count_text(before - soup.polygons.size(), "face") +
              " with two corners at the same place removed; '--repair off' refuses them");
  }
}

} // namespace internal

// Merges equal points if no polygons share a vertex, as in a list of separate triangles.
inline void weld_soup(Polygon_soup& soup, Notes& notes)
{
  const std::vector<std::size_t> valences = internal::valences(soup);
  const std::size_t before = soup.points.size();
  if(!soup.is_welded && soup.polygons.size() > 1 &&
     *std::max_element(valences.begin(), valences.end()) == 1) {
    CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(soup.points, soup.polygons);
    soup.is_welded = soup.points.size() < before;
    if(soup.is_welded) {
      notes.add("no two faces share a vertex: vertices at the same place were merged, " +
                count_text(soup.points.size(), "vertex", "vertices") + " remain of " +
                std::to_string(before) + "; '--repair off' leaves them");
    }
  }
  if(soup.is_welded) {
    internal::drop_collapsed_polygons(soup, notes);
  }
}

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
