// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_WELDER_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_WELDER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/duplicate_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/places_of_points.h>

#include <algorithm>
#include <cstddef>
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

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_WELDER_H
