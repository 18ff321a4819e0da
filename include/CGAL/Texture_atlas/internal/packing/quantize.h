// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves the vertices of packed charts to the grid of programs that store coordinates as integers of 8 to 16 bits, so
// that no triangle is turned over or loses its area there. `atlas/pack_atlas.h` calls it, and `pack_impl.h` for
// `pack_mesh.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_QUANTIZE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_QUANTIZE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_kernel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/box_intersection_d.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Vertices of triangles that find no place on the grid keep their coordinates. So do those of borders that would cross.
class Chart_quantizer
{
  typedef Exact_point_2 Point;
  typedef std::array<int, 2> Cell; // column and row
  static constexpr int most_rounds = 3;

public:
  // `vertex` holds the vertex of each corner. Triangles that are negatively oriented stay so, and those without area
  // are left alone.
  Chart_quantizer(const std::vector<int>& vertex, int bits, std::vector<Chart::Point_2>& uv)
      : m_grid(bits), m_uv(uv), m_start(exact_points(uv)), m_points(m_start), m_is_off(uv.size(), false),
        m_is_border(uv.size(), false)
  {
    for(std::size_t c = 0; c < vertex.size(); c += 3)
      protect({vertex[c], vertex[c + 1], vertex[c + 2]});
    find_border(vertex);
    protect_gaps();
  }

  // Keeps the orientation of three vertices, which need not be a triangle.
  void protect(std::array<int, 3> v)
  {
    const CGAL::Orientation side = CGAL::orientation(m_start[v[0]], m_start[v[1]], m_start[v[2]]);
    if(side == CGAL::RIGHT_TURN)
      std::swap(v[1], v[2]);
    if(side != CGAL::COLLINEAR)
      m_triangles.push_back(v);
  }

  void run()
  {
    for(const Point& p : m_start)
      m_cells.push_back({m_grid.nearest(p.x()), m_grid.nearest(p.y())});
    for(std::size_t v = 0; v < m_start.size(); ++v)
      m_points[v] = point_of(m_cells[v]);
    mend();
    for(int round = 0; round < most_rounds && protect_crossing_borders(); ++round)
      mend();
    release_bad_triangles();
    while(release_crossing_borders())
      release_bad_triangles();
    for(std::size_t v = 0; v < m_uv.size(); ++v)
      m_uv[v] = Chart::Point_2(m_points[v].x(), m_points[v].y());
  }

private:
  void find_border(const std::vector<int>& vertex)
  {
    std::vector<std::pair<int, int>> edges, opposite;
    for(int c = 0; c < static_cast<int>(vertex.size()); ++c) {
      const int p = vertex[c], q = vertex[next_corner(c)];
      edges.emplace_back(p, q);
      opposite.emplace_back(q, p);
    }
    std::sort(edges.begin(), edges.end());
    std::sort(opposite.begin(), opposite.end());
    std::vector<std::pair<int, int>> border;
    std::set_difference(edges.begin(), edges.end(), opposite.begin(), opposite.end(),
                        std::back_inserter(border));
    for(const auto& [p, q] : border) {
      m_border.push_back({p, q});
      m_is_border[p] = m_is_border[q] = true;
    }
  }

  // Both sides of a narrow slit stay apart.
  void protect_gaps()
  {
    std::vector<int> next(m_start.size(), -1);
    for(const Border_edge& e : m_border)
      next[e.source] = e.target;
    for(const Border_edge& e : m_border)
      if(const int w = next[e.target]; w >= 0 && w != e.source)
        if((m_start[e.source] - m_start[e.target]) * (m_start[w] - m_start[e.target]) > 0)
          protect({e.source, e.target, w});
  }

  // Keeps border edges apart that did not cross before. Returns whether there are any.
  bool protect_crossing_borders()
  {
    const std::size_t before = m_triangles.size();
    for(const auto& [i, j] : new_crossings())
      if(const Border_edge& e = m_border[i], &f = m_border[j]; !protect_side(e, f))
        protect_side(f, e);
    return m_triangles.size() > before;
  }

  // Keeps an edge on its side of the line through another one, if it is on one side.
  bool protect_side(const Border_edge& line, const Border_edge& edge)
  {
    const auto side = [&](int v) {
      return CGAL::orientation(m_start[line.source], m_start[line.target], m_start[v]);
    };
    if(side(edge.source) != side(edge.target))
      return false;
    protect({line.source, line.target, edge.source});
    protect({line.source, line.target, edge.target});
    return true;
  }

  // Of each vertex
  void list_triangles()
  {
    m_first.assign(m_start.size() + 1, 0);
    for(const std::array<int, 3>& triangle : m_triangles)
      for(int v : triangle)
        ++m_first[v];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_star.resize(3 * m_triangles.size());
    for(std::size_t t = m_triangles.size(); t-- > 0;)
      for(int v : m_triangles[t])
        m_star[--m_first[v]] = static_cast<int>(t);
  }

  Point point_of(const Cell& cell) const { return {m_grid.coordinate(cell[0]), m_grid.coordinate(cell[1])}; }

  // With the coordinates, and with the numbers of 16 bits that stand for them
  bool is_good(int t) const
  {
    const auto& [a, b, c] = m_triangles[t];
    return (m_is_off[a] || m_is_off[b] || m_is_off[c] || area_of_codes(m_triangles[t]) > 0) &&
           is_positively_oriented(m_points[a], m_points[b], m_points[c]);
  }

  std::int64_t area_of_codes(const std::array<int, 3>& v) const
  {
    const auto difference = [&](int i, int k) -> std::int64_t {
      return m_grid.code(m_cells[v[i]][k]) - m_grid.code(m_cells[v[0]][k]);
    };
    return difference(1, 0) * difference(2, 1) - difference(1, 1) * difference(2, 0);
  }

  int number_of_bad_triangles(int v) const
  {
    return static_cast<int>(std::count_if(m_star.begin() + m_first[v], m_star.begin() + m_first[v + 1],
                                          [this](int t) { return !is_good(t); }));
  }

  std::vector<int> bad_triangles() const
  {
    std::vector<int> result;
    for(int t = 0; t < static_cast<int>(m_triangles.size()); ++t)
      if(!is_good(t))
        result.push_back(t);
    return result;
  }

  // Moves vertices to other points of the grid nearby, as long as fewer triangles are bad then.
  void mend()
  {
    list_triangles();
    for(bool has_moved = true; has_moved;) {
      has_moved = false;
      for(int t : bad_triangles())
        for(int v : m_triangles[t])
          has_moved = (!is_good(t) && move(v)) || has_moved;
    }
  }

  // Moves a vertex to the nearest place with the fewest bad triangles. Returns whether there are fewer than before.
  bool move(int v)
  {
    const Cell before = m_cells[v];
    const double x = m_start[v].x() * m_grid.last(), y = m_start[v].y() * m_grid.last(),
                 reach = m_is_border[v] ? quantized_border_move : quantized_move;
    int least = number_of_bad_triangles(v);
    const int most = least;
    double nearest = 0;
    Cell best = before;
    for(int i = first_within(x, reach); i <= last_within(x, reach); ++i)
      for(int j = first_within(y, reach); j <= last_within(y, reach); ++j) {
        set_cell(v, {i, j});
        const int number = number_of_bad_triangles(v);
        const double distance = (i - x) * (i - x) + (j - y) * (j - y);
        if(number < least || (number == least && number < most && distance < nearest)) {
          least = number;
          nearest = distance;
          best = {i, j};
        }
      }
    set_cell(v, best);
    return least < most;
  }

  int first_within(double x, double reach) const
  {
    return (std::max)(0, static_cast<int>(std::ceil(x - reach)));
  }

  int last_within(double x, double reach) const
  {
    return (std::min)(m_grid.last(), static_cast<int>(std::floor(x + reach)));
  }

  void set_cell(int v, const Cell& cell)
  {
    m_cells[v] = cell;
    m_points[v] = point_of(cell);
  }

  void release(int v)
  {
    m_is_off[v] = true;
    m_points[v] = m_start[v];
  }

  // Triangles have their first orientation where all corners have their first coordinates.
  void release_bad_triangles()
  {
    for(std::vector<int> bad = bad_triangles(); !bad.empty(); bad = bad_triangles())
      for(int t : bad)
        for(int v : m_triangles[t])
          release(v);
  }

  // Returns whether there are such that did not cross before.
  bool release_crossing_borders()
  {
    bool has_changed = false;
    for(const auto& [i, j] : new_crossings())
      for(int v : {m_border[i].source, m_border[i].target, m_border[j].source, m_border[j].target})
        if(!m_is_off[v]) {
          release(v);
          has_changed = true;
        }
    return has_changed;
  }

  // The pairs of border edges that have a point in common, no vertex, and were apart at the beginning
  std::vector<std::pair<int, int>> new_crossings() const
  {
    typedef CGAL::Box_intersection_d::Box_with_info_d<double, 2, int> Box;
    std::vector<Box> boxes;
    for(std::size_t i = 0; i < m_border.size(); ++i)
      boxes.emplace_back(m_points[m_border[i].source].bbox() + m_points[m_border[i].target].bbox(),
                         static_cast<int>(i));
    std::vector<std::pair<int, int>> result;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      const Border_edge &e = m_border[a.info()], &f = m_border[b.info()];
      if(do_cross(m_points, e, f) && !do_cross(m_start, e, f))
        result.emplace_back(a.info(), b.info());
    });
    return result;
  }

  static bool do_cross(const std::vector<Point>& points, const Border_edge& e, const Border_edge& f)
  {
    typedef Planar_kernel::Segment_2 Segment;
    const bool have_common_vertex =
        e.source == f.source || e.source == f.target || e.target == f.source || e.target == f.target;
    return !have_common_vertex && CGAL::do_intersect(Segment(points[e.source], points[e.target]),
                                                     Segment(points[f.source], points[f.target]));
  }

  const Quantization_grid m_grid;
  std::vector<Chart::Point_2>& m_uv;
  const std::vector<Point> m_start;
  std::vector<Point> m_points;
  std::vector<char> m_is_off; // of each vertex: whether it keeps its coordinates
  std::vector<char> m_is_border;
  std::vector<Cell> m_cells;
  std::vector<Border_edge> m_border;
  std::vector<std::array<int, 3>> m_triangles; // that are to be positively oriented
  std::vector<std::ptrdiff_t> m_first;         // of each vertex, in `m_star`, and their number
  std::vector<int> m_star;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_QUANTIZE_H
