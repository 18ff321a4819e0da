// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds seams across the maps of charts: along chords that are short compared with what they cut off, the best first.
// `cover_page.h` decides how many of them are worth their length. The maps stay as they are.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_CUT_ALONG_CHORDS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_CUT_ALONG_CHORDS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/sector_graph.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/shortest_paths.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Cuts the maps of disks along chords of their borders. The score of a chord is its length divided by the square root of
// the area that it cuts off. The map stays as it is.
class Chord_cutter
{
  typedef Chart::Point_2 Point_2;

  // The border of a piece, counterclockwise
  struct Border
  {
    std::vector<int> corners;    // that face its edges
    std::vector<Point_2> points; // the sources of the edges
    std::vector<double> area;    // twice what the edges before enclose with the origin
    double total_area = 0;       // twice that of the piece
  };

  struct Chord
  {
    std::size_t from, to; // on the border
    double score;
  };

  struct Cut
  {
    std::vector<int> path; // the corners that face its edges
    double score;
  };

public:
  // `chart` consists of disks, and flat pieces with holes, whose maps are injective, and `cost` is that of the edge that each corner faces. Pieces get
  // at least the given area in the plane.
  Chord_cutter(const Chart& chart, const std::vector<Point_2>& uv, const std::vector<double>& cost,
               double least_area)
      : m_chart(chart), m_uv(uv), m_cost(cost), m_least_area(2 * least_area), m_graph(chart)
  {
    for(const std::vector<int>& border : chart.borders)
      find_cut(border.front());
  }

  // That of the next cut; infinity if there is none
  double next_score() const
  {
    return m_cuts.empty() ? (std::numeric_limits<double>::infinity)() : m_cuts.front().score;
  }

  // Makes the next cut, and returns its length on the surface.
  double cut()
  {
    std::pop_heap(m_cuts.begin(), m_cuts.end(), is_worse);
    const std::vector<int> path = std::move(m_cuts.back().path);
    m_cuts.pop_back();
    double length = 0;
    for(int c : path) {
      m_graph.set_seam(c, true);
      length += edge_length(m_chart, c);
    }
    find_cut(path.front());
    find_cut(m_chart.opposite[path.front()]);
    return length;
  }

  // Returns of each corner whether the edge that it faces is a new seam.
  std::vector<char> seams() const
  {
    std::vector<char> is_seam;
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      is_seam.push_back(m_graph.is_seam(c));
    return is_seam;
  }

private:
  static bool is_worse(const Cut& a, const Cut& b) { return a.score > b.score; }

  Border border_of(int start) const
  {
    Border border;
    int c = start;
    do {
      border.corners.push_back(c);
      border.points.push_back(m_uv[m_chart.edge_source(c)]);
      c = m_graph.next_open(c);
    } while(c != start);
    const std::size_t n = border.points.size();
    border.area.assign(n + 1, 0.);
    for(std::size_t i = 0; i < n; ++i)
      border.area[i + 1] = border.area[i] + cross_product(border.points[i], border.points[(i + 1) % n]);
    border.total_area = border.area.back();
    return border;
  }

  static double cross_product(const Point_2& p, const Point_2& q) { return p.x() * q.y() - p.y() * q.x(); }

  static double distance(const Point_2& p, const Point_2& q)
  {
    return std::hypot(p.x() - q.x(), p.y() - q.y());
  }

  // Twice the smaller of the areas to both sides of a chord
  static double smaller_area(const Border& border, std::size_t i, std::size_t j)
  {
    const double area = border.area[j] - border.area[i] + cross_product(border.points[j], border.points[i]);
    return (std::min)(area, border.total_area - area);
  }

  // Finds the best cut of a piece. `corner` faces its border.
  void find_cut(int corner)
  {
    const Border border = border_of(corner);
    std::size_t tried = 0;
    for(const Chord& chord : good_chords(border)) {
      if(!is_within(border, chord))
        continue;
      std::vector<int> path = path_along(border, chord);
      if(!path.empty()) {
        m_cuts.push_back({std::move(path), chord.score});
        std::push_heap(m_cuts.begin(), m_cuts.end(), is_worse);
        return;
      }
      if(++tried == most_paths)
        return;
    }
  }

  // The best chords come first. On a border with many vertices, only some places are tried, at even distances.
  std::vector<Chord> good_chords(const Border& border) const
  {
    std::vector<Chord> chords;
    if(border.total_area < 2 * m_least_area)
      return chords;
    const std::vector<std::size_t> places = sampled_places(border);
    for(std::size_t a = 0; a < places.size(); ++a)
      for(std::size_t b = a + 1; b < places.size(); ++b) {
        const double area = smaller_area(border, places[a], places[b]);
        if(area < m_least_area)
          continue;
        const double score =
            distance(border.points[places[a]], border.points[places[b]]) / std::sqrt(area / 2);
        if(score < largest_score)
          chords.push_back({places[a], places[b], score});
      }
    std::sort(chords.begin(), chords.end(), [](const Chord& p, const Chord& q) {
      return p.score != q.score ? p.score < q.score : p.from != q.from ? p.from < q.from : p.to < q.to;
    });
    return chords;
  }

  static std::vector<std::size_t> sampled_places(const Border& border)
  {
    const std::size_t n = border.points.size();
    double length = 0;
    for(std::size_t i = 0; i < n; ++i)
      length += distance(border.points[i], border.points[(i + 1) % n]);
    std::vector<std::size_t> places;
    double since = length; // the last place
    for(std::size_t i = 0; i < n; ++i) {
      if(since >= length / most_places) {
        places.push_back(i);
        since = 0;
      }
      since += distance(border.points[i], border.points[(i + 1) % n]);
    }
    return places;
  }

  // Whether the chord is inside of the piece
  bool is_within(const Border& border, const Chord& chord) const
  {
    const std::size_t n = border.points.size();
    const Point_2 &p = border.points[chord.from], &q = border.points[chord.to], middle = CGAL::midpoint(p, q);
    bool is_inside = false; // the middle, by the parity of the edges below it
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const Point_2 &r = border.points[i], &s = border.points[j];
      if((r.x() <= middle.x()) != (s.x() <= middle.x()) &&
         (CGAL::orientation(r, s, middle) == CGAL::LEFT_TURN) == (r.x() < s.x()))
        is_inside = !is_inside;
      if(i != chord.from && j != chord.from && i != chord.to && j != chord.to &&
         CGAL::orientation(p, q, r) != CGAL::orientation(p, q, s) &&
         CGAL::orientation(r, s, p) != CGAL::orientation(r, s, q))
        return false;
    }
    return is_inside;
  }

  // The shortest path between the ends of a chord; empty if it is much longer than the chord
  std::vector<int> path_along(const Border& border, const Chord& chord) const
  {
    const int source = m_graph.source_node(border.corners[chord.from]),
              target = m_graph.source_node(border.corners[chord.to]);
    std::vector<char> is_allowed(static_cast<std::size_t>(m_graph.number_of_nodes()));
    for(int x = 0; x < m_graph.number_of_nodes(); ++x)
      is_allowed[x] = x == target || (m_graph.is_node(x) && !m_graph.is_on_border(x));
    Shortest_paths paths(m_graph, m_cost);
    paths.restrict_to(std::move(is_allowed));
    if(paths.find({source}, forbidden, [&](int x) { return x == target; }) < 0)
      return {};
    std::vector<int> path = paths.path(target);
    double length = 0;
    for(int c : path)
      length += distance(m_uv[m_chart.edge_source(c)], m_uv[m_chart.edge_target(c)]);
    if(length > most_detour * distance(border.points[chord.from], border.points[chord.to]))
      path.clear();
    return path;
  }

  static constexpr double largest_score = 1.8, most_detour = 1.5;
  static constexpr std::size_t most_places = 128, most_paths = 8;

  const Chart& m_chart;
  const std::vector<Point_2>& m_uv;
  const std::vector<double>& m_cost;
  const double m_least_area; // twice that of a piece
  Sector_graph m_graph;
  std::vector<Cut> m_cuts; // a heap
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_CUT_ALONG_CHORDS_H
