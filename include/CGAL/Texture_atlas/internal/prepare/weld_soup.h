// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELD_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELD_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/Soup_welder.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/duplicate_polygons.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

inline bool has_repeated_point(const Polygon_soup& soup, const Polygon& polygon)
{
  std::vector<Kernel::Point_3> points;
  for(const std::size_t v : polygon) {
    points.push_back(soup.points[v]);
  }
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

// Leaves out faces with two corners at the same place, which are only edges, unless they hang together with others.
inline void leave_out_collapsed(Polygon_soup& soup)
{
  const std::vector<std::size_t> valence = valences(soup);
  std::vector<Index> part_of(soup.polygons.size(), no_index);
  std::vector<Skipped_part> parts;
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const Polygon& polygon = soup.polygons[p];
    const bool is_separate = std::all_of(polygon.begin(), polygon.end(),
                                         [&valence](const std::size_t v) { return valence[v] == 1; });
    if(has_repeated_vertex(polygon) || (is_separate && has_repeated_point(soup, polygon))) {
      part_of[p] = 0;
      if(parts.empty()) {
        parts.push_back(skipped_part(Diagnosis::DEGENERATE_FACE,
                                     face_name(soup.origins[p]) +
                                         " has two corners at the same place; remove such faces"));
      }
    }
  }
  if(!parts.empty()) {
    leave_out(soup, part_of, parts);
  }
}

// Polygons with their vertices before some were joined
struct Joined_polygons
{
  std::vector<std::size_t> numbers;
  std::vector<Polygon> before;
};

// Those that joined vertices made equal to others, or have one twice, get vertices of their own back.
inline void separate_spoilt_polygons(const Joined_polygons& joined, Polygon_soup& soup)
{
  std::vector<Polygon> after;
  for(const std::size_t p : joined.numbers) {
    after.push_back(soup.polygons[p]);
  }
  const std::vector<std::size_t> first = first_equal_polygons(after);
  for(std::size_t i = 0; i < first.size(); ++i) {
    const Polygon& before = joined.before[i];
    const bool is_new = first[i] != i && canonical(before) != canonical(joined.before[first[i]]);
    if(is_new || (after[i] != before && has_repeated_vertex(after[i]))) {
      for(std::size_t k = 0; k < before.size(); ++k) {
        soup.polygons[joined.numbers[i]][k] = soup.points.size();
        soup.points.push_back(Kernel::Point_3(soup.points[before[k]]));
      }
    }
  }
}

// Joins sides of polygons at the same places. Returns how many pairs of places have more sides than can be joined.
inline std::size_t join_sides(std::vector<Index> places, const double tolerance, Polygon_soup& soup)
{
  const Soup_welder welder(soup, tolerance, places);
  std::vector<bool> is_shared(places.size(), false);
  for(std::size_t v = 0; v < places.size(); ++v) {
    if(places[v] != v) {
      is_shared[places[v]] = true;
    }
  }
  Joined_polygons joined;
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    Polygon& polygon = soup.polygons[p];
    if(std::any_of(polygon.begin(), polygon.end(),
                   [&](const std::size_t v) { return is_shared[places[v]]; })) {
      joined.numbers.push_back(p);
      joined.before.push_back(polygon);
      for(std::size_t& v : polygon) {
        v = places[v];
      }
    }
  }
  separate_spoilt_polygons(joined, soup);
  return welder.number_of_crowded_edges();
}

inline bool are_all_different(const std::vector<Index>& places)
{
  return std::all_of(places.begin(), places.end(),
                     [&places](const Index& place) { return &place == &places[place]; });
}

inline std::size_t number_of_used_points(const Polygon_soup& soup)
{
  const std::vector<std::size_t> valence = valences(soup);
  return valence.size() - static_cast<std::size_t>(std::count(valence.begin(), valence.end(), 0u));
}

inline void tell_welding(const std::size_t before, const std::size_t after, const std::size_t crowded,
                         const bool has_tolerance, Notes& notes)
{
  const std::string away = has_tolerance ? "nearly the same place" : "the same place";
  if(after < before) {
    notes.add("vertices at " + away + " were merged: " + count_text(after, "vertex", "vertices") +
              " remain of " + std::to_string(before));
  }
  if(crowded > 0) {
    notes.add("at " + count_text(crowded, "edge") +
              ", more than two faces with vertices of their own meet at " + away +
              ": they stay separate there");
  }
}

// Joins faces with vertices of their own that meet at the same place. All points remain; some are no longer used.
inline void weld_soup(const Welding& welding, Polygon_soup& soup, Notes& notes)
{
  if(welding.extent == Welding::NONE || soup.polygons.size() < 2) {
    return;
  }
  const std::vector<std::size_t> valence = valences(soup);
  if(welding.extent == Welding::SEPARATE_FACES && *std::max_element(valence.begin(), valence.end()) > 1) {
    return;
  }
  std::vector<Index> places = places_of_points(soup, welding.tolerance);
  if(are_all_different(places)) {
    return;
  }
  leave_out_collapsed(soup);
  const std::size_t before = number_of_used_points(soup),
                    crowded = join_sides(std::move(places), welding.tolerance, soup);
  tell_welding(before, number_of_used_points(soup), crowded, welding.tolerance > 0, notes);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELD_SOUP_H
