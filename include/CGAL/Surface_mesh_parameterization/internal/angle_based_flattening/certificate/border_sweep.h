// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Decides exactly whether border edges touch, and whether they bound a region, by the sweep of Shamos and Hoey (1976),
// and finds the pairs that touch. Certificates and measures ask it whether the border of a map is simple, and so do
// injective maps while their border moves (`planar_border.h`).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SWEEP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SWEEP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>

#include <CGAL/box_intersection_d.h>
#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Whether two border edges have a point in common, other than a vertex of both. Their points are finite. An edge
// without length touches its neighbours.
template <typename Point>
bool touch(const Border_edge& e, const Border_edge& f, const std::vector<Point>& uv)
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel::Segment_2 Segment_2;
  const bool at_source = e.source == f.source || e.source == f.target;
  const bool at_target = e.target == f.source || e.target == f.target;
  if(at_source && at_target)
    return true;
  if(at_source || at_target) {
    const int common = at_source ? e.source : e.target;
    const Point& p = uv[at_source ? e.target : e.source];
    const Point& q = uv[f.source == common ? f.target : f.source];
    return CGAL::collinear(p, uv[common], q) &&
           !CGAL::collinear_are_strictly_ordered_along_line(p, uv[common], q);
  }
  const Segment_2 s(uv[e.source], uv[e.target]), t(uv[f.source], uv[f.target]);
  if(s.is_degenerate() || t.is_degenerate())
    return s.is_degenerate() ? t.has_on(s.source()) : s.has_on(t.source());
  return CGAL::do_intersect(s, t);
}

// Decides whether any two of the edges touch (Shamos and Hoey's sweep, with no construction but comparisons), and
// whether they bound a region: in `O(b log b)` time, for any number of closed borders. Loops and edges with points that
// are not finite are left out, and then there is no region.
template <typename Point>
class Border_sweep
{
  static_assert(std::is_same<typename Exact_point<Point>::type, Point>::value, "predicates must be exact");

  // The order along the sweep line of edges that do not touch. Collinear edges count as touching.
  struct Is_below
  {
    Border_sweep* sweep;

    bool operator()(int e, int f) const
    {
      if(e == f)
        return false;
      const int e_left = sweep->m_left[e], f_left = sweep->m_left[f];
      if(e_left == f_left)
        return sweep->turn(e, sweep->m_right[f]) == CGAL::LEFT_TURN;
      return e_left < f_left ? sweep->turn(e, f_left) == CGAL::LEFT_TURN
                             : sweep->turn(f, e_left) == CGAL::RIGHT_TURN;
    }
  };
  typedef std::set<int, Is_below> Line;

public:
  Border_sweep(const std::vector<Border_edge>& edges, const std::vector<Point>& uv) : m_uv(uv)
  {
    for(const Border_edge& e : edges)
      if(e.source != e.target && is_finite_point(uv[e.source]) && is_finite_point(uv[e.target]))
        m_edges.push_back(e);
    sort_vertices();
    for(const Border_edge& e : m_edges) {
      m_left.push_back((std::min)(m_rank[e.source], m_rank[e.target]));
      m_right.push_back((std::max)(m_rank[e.source], m_rank[e.target]));
    }
    m_bounds_region = m_edges.size() == edges.size();
    sweep();
  }

  bool finds_touching_edges() const { return m_touching; }

  // Whether no two edges touch, and all have the same region of the plane on their left, or all on their right: all
  // winding numbers are 0 or 1, or all are 0 or -1.
  bool bounds_region() const { return !m_touching && m_bounds_region; }

private:
  // The winding number changes by one at each edge on the sweep line. So edges bound a region exactly if neighbours
  // have opposite directions, and the lowest one always has the same. As many edges lead to a vertex as from it: if
  // those that begin there differ from the ones below, the next one above does too.
  void sweep()
  {
    for(std::size_t i = 1; i < m_vertices.size(); ++i)
      m_touching = m_touching || m_uv[m_vertices[i - 1]] == m_uv[m_vertices[i]];
    const std::vector<int> by_left = sorted_by(m_left), by_right = sorted_by(m_right);
    Line line(Is_below{this});
    std::vector<typename Line::iterator> position(m_edges.size(), line.end());
    std::size_t inserted = 0, removed = 0;
    for(int rank = 0; rank < static_cast<int>(m_vertices.size()) && !m_touching; ++rank) {
      Deadline::ask();
      for(; removed < by_right.size() && m_right[by_right[removed]] == rank && !m_touching; ++removed)
        remove(line, position[by_right[removed]]);
      const std::size_t first = inserted;
      for(; inserted < by_left.size() && m_left[by_left[inserted]] == rank && !m_touching; ++inserted)
        position[by_left[inserted]] = insert(line, by_left[inserted]);
      if(rank == 0)
        m_lowest_goes_right = goes_right(*line.begin());
      for(std::size_t i = first; i < inserted; ++i)
        m_bounds_region = m_bounds_region && is_opposite_to_below(line, position[by_left[i]]);
    }
  }

  // Sets the vertices in the order in which they are swept, and the rank of each.
  void sort_vertices()
  {
    for(const Border_edge& e : m_edges) {
      m_vertices.push_back(e.source);
      m_vertices.push_back(e.target);
    }
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
    std::sort(m_vertices.begin(), m_vertices.end(),
              [this](int v, int w) { return CGAL::compare_xy(m_uv[v], m_uv[w]) == CGAL::SMALLER; });
    m_rank.resize(m_uv.size());
    for(std::size_t i = 0; i < m_vertices.size(); ++i)
      m_rank[m_vertices[i]] = static_cast<int>(i);
  }

  std::vector<int> sorted_by(const std::vector<int>& end) const
  {
    std::vector<int> order(m_edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int e, int f) { return end[e] < end[f]; });
    return order;
  }

  CGAL::Orientation turn(int edge, int rank)
  {
    const CGAL::Orientation result = CGAL::orientation(
        m_uv[m_vertices[m_left[edge]]], m_uv[m_vertices[m_right[edge]]], m_uv[m_vertices[rank]]);
    m_touching = m_touching || result == CGAL::COLLINEAR;
    return result;
  }

  void test(int e, int f) { m_touching = m_touching || touch(m_edges[e], m_edges[f], m_uv); }

  typename Line::iterator insert(Line& line, int edge)
  {
    const auto position = line.insert(edge).first;
    if(position != line.begin())
      test(*std::prev(position), edge);
    if(std::next(position) != line.end())
      test(edge, *std::next(position));
    return position;
  }

  void remove(Line& line, typename Line::iterator position)
  {
    const auto above = line.erase(position);
    if(above != line.begin() && above != line.end())
      test(*std::prev(above), *above);
  }

  bool goes_right(int edge) const { return m_rank[m_edges[edge].source] == m_left[edge]; }

  bool is_opposite_to_below(const Line& line, typename Line::iterator edge) const
  {
    return goes_right(*edge) == (edge == line.begin() ? m_lowest_goes_right : !goes_right(*std::prev(edge)));
  }

  const std::vector<Point>& m_uv;
  std::vector<Border_edge> m_edges;
  std::vector<int> m_vertices;      // in the order of the sweep
  std::vector<int> m_rank;          // of each vertex in that order
  std::vector<int> m_left, m_right; // of each edge: the ranks of its ends
  bool m_touching = false, m_bounds_region = true, m_lowest_goes_right = true;
};

// Whether no two edges touch, and all have the same region of the plane on the same side (see `Border_sweep`)
template <typename Point>
bool bounds_region(const std::vector<Border_edge>& edges, const std::vector<Point>& uv)
{
  return Border_sweep<Point>(edges, uv).bounds_region();
}

#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
extern template bool bounds_region(const std::vector<Border_edge>&, const std::vector<Exact_point_2>&);
#endif

typedef CGAL::Box_intersection_d::Box_with_info_d<double, 2, int> Indexed_box;

// The bounding boxes of those edges whose points are finite.
template <typename Point>
std::vector<Indexed_box> edge_boxes(const std::vector<Border_edge>& edges, const std::vector<Point>& uv)
{
  std::vector<Indexed_box> boxes;
  for(std::size_t i = 0; i < edges.size(); ++i) {
    const Point &p = uv[edges[i].source], &q = uv[edges[i].target];
    if(is_finite_point(p) && is_finite_point(q))
      boxes.emplace_back(p.bbox() + q.bbox(), static_cast<int>(i));
  }
  return boxes;
}

// The pairs of border edges that touch, as sorted pairs of their indices in `edges`. It takes `O(b log b)` time to see
// that there is none; else the pairs of edges whose bounding boxes intersect are looked at.
template <typename Point>
std::vector<std::pair<int, int>> touching_edges(const std::vector<Border_edge>& edges,
                                                const std::vector<Point>& uv)
{
  std::vector<std::pair<int, int>> pairs;
  if(!Border_sweep<Point>(edges, uv).finds_touching_edges())
    return pairs;
  std::vector<Indexed_box> boxes = edge_boxes(edges, uv);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Indexed_box& a, const Indexed_box& b) {
    if(touch(edges[a.info()], edges[b.info()], uv))
      pairs.push_back(std::minmax({a.info(), b.info()}));
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// The pairs of border edges that touch, as the corners that face them.
inline std::vector<std::pair<int, int>> border_crossings(const Corner_table& chart,
                                                         const std::vector<Corner_table::Point_2>& uv)
{
  std::vector<int> corners;
  for(const std::vector<int>& border : chart.borders)
    corners.insert(corners.end(), border.begin(), border.end());
  std::vector<std::pair<int, int>> pairs = touching_edges(border_edges(chart), exact_points(uv));
  for(std::pair<int, int>& pair : pairs)
    pair = {corners[pair.first], corners[pair.second]};
  return pairs;
}

// Whether the borders are simple polygons that do not touch one another, the holes are within the outer one and beside
// one another, and turn the other way. With no flipped triangle, the map is then injective: see
// `Planar_map::is_injective()`.
inline bool is_border_simple(const Corner_table& chart, const std::vector<Exact_point_2>& uv)
{
  return bounds_region(border_edges(chart), uv);
}

inline bool is_border_simple(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  return is_border_simple(chart, exact_points(uv));
}

#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
extern template std::vector<std::pair<int, int>> touching_edges(const std::vector<Border_edge>&,
                                                                const std::vector<Exact_point_2>&);
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SWEEP_H
