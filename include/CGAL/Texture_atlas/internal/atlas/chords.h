// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Chords between places on the borders of a piece of a map: what they cut off, the paths of edges along them, and pairs
// of them that cut a ring in two. `cut_along_chords.h` cuts along them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CHORDS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CHORDS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline double distance(const Chart::Point_2& p, const Chart::Point_2& q)
{
  return std::hypot(p.x() - q.x(), p.y() - q.y());
}

// A border of a piece of a map: counterclockwise, unless it is that of a hole
class Border_of_piece
{
  typedef Chart::Point_2 Point_2;

public:
  // The border that a corner faces
  Border_of_piece(const Sector_graph& graph, const std::vector<Point_2>& uv, int start)
  {
    int c = start;
    do {
      m_corners.push_back(c);
      m_points.push_back(uv[graph.surface().edge_source(c)]);
      c = graph.next_open(c);
    } while(c != start);
    m_area.push_back(0);
    for(std::size_t i = 0; i < size(); ++i) {
      m_area.push_back(m_area.back() + cross_product(point(i), next_point(i)));
      m_length += distance(point(i), next_point(i));
    }
  }

  std::size_t size() const { return m_corners.size(); }
  int corner(std::size_t i) const { return m_corners[i]; }          // that faces an edge
  const Point_2& point(std::size_t i) const { return m_points[i]; } // the source of an edge
  double length() const { return m_length; }
  double area() const { return m_area.back() / 2; } // negative if it is that of a hole

  // What the border from one place to a later one encloses with the origin
  double area_of_sector(std::size_t from, std::size_t to) const { return (m_area[to] - m_area[from]) / 2; }

  // At even distances, and at most so many
  std::vector<std::size_t> sampled_places(std::size_t most) const
  {
    std::vector<std::size_t> places;
    double since = m_length; // the last place
    for(std::size_t i = 0; i < size(); ++i) {
      if(since >= m_length / static_cast<double>(most)) {
        places.push_back(i);
        since = 0;
      }
      since += distance(point(i), next_point(i));
    }
    return places;
  }

  // By the parity of the edges below it
  bool encloses(const Point_2& p) const
  {
    bool is_inside = false;
    for(std::size_t i = 0; i < size(); ++i) {
      const Point_2 &r = point(i), &s = next_point(i);
      is_inside ^= (r.x() <= p.x()) != (s.x() <= p.x()) &&
                   (CGAL::orientation(r, s, p) == CGAL::LEFT_TURN) == (r.x() < s.x());
    }
    return is_inside;
  }

  // Whether a chord meets edges that do not share an end with it
  bool crosses(const Point_2& p, const Point_2& q) const
  {
    for(std::size_t i = 0; i < size(); ++i) {
      const Point_2 &r = point(i), &s = next_point(i);
      if(r != p && r != q && s != p && s != q && CGAL::orientation(p, q, r) != CGAL::orientation(p, q, s) &&
         CGAL::orientation(r, s, p) != CGAL::orientation(r, s, q))
        return true;
    }
    return false;
  }

  static double cross_product(const Point_2& p, const Point_2& q) { return p.x() * q.y() - p.y() * q.x(); }

private:
  const Point_2& next_point(std::size_t i) const { return m_points[i + 1 < size() ? i + 1 : 0]; }

  std::vector<int> m_corners;
  std::vector<Point_2> m_points;
  std::vector<double> m_area; // twice what the edges before enclose with the origin
  double m_length = 0;
};

// Finds paths that are at most half as long again as their chords.
class Chord_paths
{
  typedef Chart::Point_2 Point_2;

public:
  // `graph` is the chart, opened along seams, and `cost` is that of the edge that each corner faces.
  Chord_paths(const Sector_graph& graph, const std::vector<Point_2>& uv, const std::vector<double>& cost)
      : m_graph(graph), m_uv(uv), m_cheapest(graph, cost), m_shortest(graph, m_length)
  {
    for(std::size_t c = 0; c < cost.size(); ++c)
      m_length.push_back(std::isinf(cost[c]) ? forbidden : edge_length(graph.surface(), static_cast<int>(c)));
    if(m_length == cost)
      m_length.clear();
  }

  // The places on two borders that edges inside the piece join. In a strip, there may be no other paths.
  std::vector<std::pair<std::size_t, std::size_t>> edges_between(const Border_of_piece& a,
                                                                 const Border_of_piece& b) const
  {
    std::unordered_map<int, std::size_t> place; // of each node of the second border
    for(std::size_t j = 0; j < b.size(); ++j)
      place[m_graph.source_node(b.corner(j))] = j;
    std::vector<std::pair<std::size_t, std::size_t>> result;
    for(std::size_t i = 0; i < a.size(); ++i)
      for(auto [edge, end] = out_edges(m_graph.source_node(a.corner(i)), m_graph); edge != end; ++edge)
        if(const auto found = place.find(m_graph.target_node(*edge)); found != place.end())
          result.emplace_back(i, found->second);
    return result;
  }

  // The cheapest path between the ends of a chord, or else the shortest one; empty if both are much longer than the
  // chord
  std::vector<int> path_along(const Border_of_piece& a, std::size_t from, const Border_of_piece& b,
                              std::size_t to)
  {
    const int source = m_graph.source_node(a.corner(from)), target = m_graph.source_node(b.corner(to));
    const double longest = most_detour * distance(a.point(from), b.point(to));
    std::vector<int> path = path_between(source, target, m_cheapest);
    if(length_in_plane(path) > longest && !m_length.empty())
      path = path_between(source, target, m_shortest);
    if(length_in_plane(path) > longest)
      path.clear();
    return path;
  }

  // Whether a chord is inside of a piece
  static bool is_within(const std::vector<Border_of_piece>& borders, const Point_2& p, const Point_2& q)
  {
    const Point_2 middle = CGAL::midpoint(p, q);
    return borders.front().encloses(middle) &&
           std::none_of(borders.begin(), borders.end(), [&](const auto& border) {
             return border.crosses(p, q) || (border.area() < 0 && border.encloses(middle));
           });
  }

private:
  // Through the inside of the piece
  std::vector<int> path_between(int source, int target, Shortest_paths& paths) const
  {
    const int end = paths.find(
        {source}, forbidden, [&](int x) { return x == target; },
        [&](int x) { return x == target || !m_graph.is_on_border(x); });
    return end < 0 ? std::vector<int>() : paths.path(target);
  }

  double length_in_plane(const std::vector<int>& path) const
  {
    return std::accumulate(path.begin(), path.end(), 0., [&](double sum, int c) {
      return sum + distance(m_uv[m_graph.surface().edge_source(c)], m_uv[m_graph.surface().edge_target(c)]);
    });
  }

  static constexpr double most_detour = 1.5;

  const Sector_graph& m_graph;
  const std::vector<Point_2>& m_uv;
  std::vector<double> m_length; // of edges; infinite where the cost is; empty if it is the same
  Shortest_paths m_cheapest, m_shortest;
};

// A chord from the outer border of a piece to the border of a hole
struct Ring_chord
{
  std::size_t outer, inner; // places on the borders
  double score;             // the less, the better
};

// The chords between two borders of a piece. A ring that is only cut open would cover no more of the page than before.
class Ring_chords
{
public:
  // `edges` are pairs of places that an edge joins.
  Ring_chords(const Border_of_piece& outer, const Border_of_piece& hole,
              const std::vector<std::pair<std::size_t, std::size_t>>& edges)
      : m_outer(outer), m_hole(hole)
  {
    for(std::size_t i : outer.sampled_places(most_places))
      for(std::size_t j : hole.sampled_places(most_places))
        m_chords.push_back({i, j, 0});
    for(const auto& [i, j] : edges)
      m_chords.push_back({i, j, 0});
  }

  // The shortest ones first
  std::vector<Ring_chord> first_chords() const
  {
    return sorted([&](const Ring_chord& chord) { return length(chord); });
  }

  // The chords that cut the ring in two with another one. The score of both is their length divided by the square root
  // of the smaller area, which is at least `least_area`; it is at most `largest_score`.
  std::vector<Ring_chord> second_chords(const Ring_chord& first, double least_area,
                                        double largest_score) const
  {
    const double whole = m_outer.area() + m_hole.area();
    std::vector<Ring_chord> chords = sorted([&](const Ring_chord& second) {
      const double part = area_between(first, second), area = (std::min)(part, whole - part);
      return area >= least_area && second.outer != first.outer && second.inner != first.inner
                 ? (length(first) + length(second)) / std::sqrt(area)
                 : 2 * largest_score;
    });
    const auto is_good = [&](const Ring_chord& chord) { return chord.score <= largest_score; };
    chords.erase(std::partition_point(chords.begin(), chords.end(), is_good), chords.end());
    return chords;
  }

private:
  static constexpr std::size_t most_places = 64;

  template <typename Score>
  std::vector<Ring_chord> sorted(const Score& score) const
  {
    std::vector<Ring_chord> chords = m_chords;
    for(Ring_chord& chord : chords)
      chord.score = score(chord);
    std::sort(chords.begin(), chords.end(), [](const Ring_chord& p, const Ring_chord& q) {
      return std::tie(p.score, p.outer, p.inner) < std::tie(q.score, q.outer, q.inner);
    });
    return chords;
  }

  double length(const Ring_chord& chord) const
  {
    return distance(m_outer.point(chord.outer), m_hole.point(chord.inner));
  }

  static double sector(const Border_of_piece& border, std::size_t from, std::size_t to)
  {
    return border.area_of_sector(from, to) + (from <= to ? 0 : border.area());
  }

  // Along the outer border to the second chord, and back along the hole
  double area_between(const Ring_chord& first, const Ring_chord& second) const
  {
    const auto across = [&](const auto& p, const auto& q) {
      return Border_of_piece::cross_product(p, q) / 2;
    };
    return sector(m_outer, first.outer, second.outer) +
           across(m_outer.point(second.outer), m_hole.point(second.inner)) +
           sector(m_hole, second.inner, first.inner) +
           across(m_hole.point(first.inner), m_outer.point(first.outer));
  }

  const Border_of_piece &m_outer, &m_hole;
  std::vector<Ring_chord> m_chords;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CHORDS_H
