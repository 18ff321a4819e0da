// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELD_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELD_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/places_of_points.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Joins polygons at those of their sides that are at the same place, where no other polygon is yet. Closed surfaces
// that touch have no such sides, and stay apart; so do the two sides of a sheet, whose polygons would have the same
// corners.
class Soup_welder
{
public:
  // `places` are those of the points, and become the vertices into which they are joined.
  Soup_welder(const Polygon_soup& soup, const double tolerance, std::vector<Index>& places)
      : m_soup(soup), m_places(places), m_tolerance(tolerance), m_sets(soup.points.size())
  {
    m_is_shared.assign(places.size(), false);
    for(std::size_t v = 0; v < places.size(); ++v) {
      if(places[v] != v) {
        m_is_shared[places[v]] = true;
      }
    }
    visit_places();
    std::vector<Index> first(places.size(), no_index);
    for(std::size_t v = 0; v < places.size(); ++v) { // the smallest vertex of each set
      Index& vertex = first[m_sets.find_set(v)];
      vertex = vertex == no_index ? static_cast<Index>(v) : vertex;
      places[v] = vertex;
    }
  }

  // Between how many pairs of places there are more sides than can be joined
  std::size_t number_of_crowded_edges() const { return m_crowded; }

private:
  // From one corner of a polygon to the next
  struct Side
  {
    std::size_t from, to;
    Index polygon;
    Index other; // the larger one of the places
    bool is_forward;

    std::size_t start() const { return is_forward ? from : to; } // at the smaller place
    std::size_t end() const { return is_forward ? to : from; }
  };

  // Goes through the sides by the smaller ones of their places, at those that several points have and beside them.
  void visit_places()
  {
    std::vector<std::size_t> first(m_places.size() + 1, 0);
    for_each_side([&first](const Index place, const Side&) { ++first[place + 1]; });
    for(std::size_t v = 1; v < first.size(); ++v) {
      first[v] += first[v - 1];
    }
    std::vector<Side> sides(first.back());
    std::vector<std::size_t> next(first);
    for_each_side([&](const Index place, const Side& side) { sides[next[place]++] = side; });
    for(std::size_t v = 0; v < m_places.size(); ++v) {
      const auto begin = sides.begin() + static_cast<std::ptrdiff_t>(first[v]),
                 end = sides.begin() + static_cast<std::ptrdiff_t>(first[v + 1]);
      std::stable_sort(begin, end, [](const Side& a, const Side& b) { return a.other < b.other; });
      for(auto i = begin; i != end;) {
        const auto after = std::find_if(i, end, [&i](const Side& side) { return side.other != i->other; });
        visit_edge({i, after});
        i = after;
      }
    }
  }

  template <class Function>
  void for_each_side(const Function& f) const
  {
    for(std::size_t p = 0; p < m_soup.polygons.size(); ++p) {
      const Polygon& polygon = m_soup.polygons[p];
      for(std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t v = polygon[i], w = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const Index a = m_places[v], b = m_places[w];
        if(a != b && (m_is_shared[a] || m_is_shared[b])) {
          f((std::min)(a, b), Side{v, w, static_cast<Index>(p), (std::max)(a, b), a < b});
        }
      }
    }
  }

  // Sides between the same two places
  void visit_edge(std::vector<Side> sides)
  {
    const auto vertices = [](const Side& side) { return std::minmax(side.from, side.to); };
    const auto is_less = [&](const Side& a, const Side& b) { return vertices(a) < vertices(b); };
    std::stable_sort(sides.begin(), sides.end(), is_less);
    std::vector<Side> free; // without another polygon, the forward ones first
    for(std::size_t i = 0; i < sides.size(); ++i) {
      if((i == 0 || is_less(sides[i - 1], sides[i])) &&
         (i + 1 == sides.size() || is_less(sides[i], sides[i + 1]))) {
        free.push_back(sides[i]);
      }
    }
    std::stable_partition(free.begin(), free.end(), [](const Side& side) { return side.is_forward; });
    if(free.size() == 2 && can_be_joined(free[0], free[1])) {
      join(free[0], free[1]);
    } else if(free.size() == 4 && free[1].is_forward && !free[2].is_forward) {
      join_pairs(free);
    } else {
      m_crowded += free.size() > 2;
    }
  }

  // Two forward and two backward sides: there may be one way only to join them.
  void join_pairs(const std::vector<Side>& free)
  {
    const bool is_straight = can_be_joined(free[0], free[2]) && can_be_joined(free[1], free[3]);
    const bool is_crossed = can_be_joined(free[0], free[3]) && can_be_joined(free[1], free[2]);
    if(is_straight != is_crossed) {
      join(free[0], free[is_straight ? 2 : 3]);
      join(free[1], free[is_straight ? 3 : 2]);
    } else {
      ++m_crowded;
    }
  }

  // Not if the polygons would have the same corners, or if only points in between make it the same place.
  bool can_be_joined(const Side& s, const Side& t) const
  {
    return s.polygon != t.polygon && is_near(s.start(), t.start()) && is_near(s.end(), t.end()) &&
           places_of(s.polygon) != places_of(t.polygon);
  }

  bool is_near(const std::size_t v, const std::size_t w) const
  {
    return CGAL::squared_distance(m_soup.points[v], m_soup.points[w]) <= m_tolerance * m_tolerance;
  }

  Polygon places_of(const Index p) const
  {
    Polygon polygon = m_soup.polygons[p];
    for(std::size_t& v : polygon) {
      v = m_places[v];
    }
    return canonical(std::move(polygon));
  }

  void join(const Side& s, const Side& t)
  {
    m_sets.union_set(s.start(), t.start());
    m_sets.union_set(s.end(), t.end());
  }

  const Polygon_soup& m_soup;
  std::vector<Index>& m_places;
  double m_tolerance;
  std::vector<bool> m_is_shared; // of each place
  Point_sets m_sets;
  std::size_t m_crowded = 0;
};

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
