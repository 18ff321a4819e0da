// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a disk of a chart with holes: covers the holes with triangles of a chosen weight in Eq. 1. Patches come from
// `patch.h`. `strategies/flatten_chart.h` declares it; the compiled library has it, as it takes long to compile.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_HOLES_FILL_HOLES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_HOLES_FILL_HOLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/holes/patch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <CGAL/centroid.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The targets of patches are at least this large, even if the surface leaves no rest of the full turn.
inline constexpr double least_patch_angle = 0.02;

// Makes a disk of a chart with holes, by patches over all borders but the first one.
class Hole_filler
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Exact_point;

public:
  explicit Hole_filler(const Chart& chart) : m_chart(chart), m_filled(chart), m_rank(chart.points.size(), -1)
  {
    m_filled.weight.resize(chart.number_of_triangles(), 1.);
  }

  Chart run(double weight)
  {
    for(std::size_t i = 1; i < m_chart.borders.size(); ++i)
      fill(m_chart.borders[i], weight);
    find_borders(m_filled, m_chart.borders.front().front());
    set_targets();
    return std::move(m_filled);
  }

private:
  // The ring of a patch runs against the border of the hole. Its edge number i faces corner `facing[i]` of the surface.
  struct Ring
  {
    std::vector<int> facing, vertices;

    int size() const { return static_cast<int>(vertices.size()); }
    bool is_edge(int i, int j) const { return j == (i + 1) % size() && i < size(); }
  };

  void fill(const std::vector<int>& border, double weight)
  {
    Ring ring{{border.rbegin(), border.rend()}, {}};
    for(int c : ring.facing)
      ring.vertices.push_back(m_chart.edge_target(c));
    Patch patch = least_bent_patch(ring_points(ring), outer_points(ring));
    if(patch.empty() || repeats_an_edge(patch, ring)) {
      patch = fan(ring.size());
      add_centre(ring);
    }
    add(patch, ring, weight * mean_weight(ring));
  }

  Exact_point exact_point(int v) const
  {
    const Chart::Point_3& p = m_chart.points[v];
    return Exact_point(p.x(), p.y(), p.z());
  }

  std::vector<Exact_point> ring_points(const Ring& ring) const
  {
    std::vector<Exact_point> points;
    for(int v : ring.vertices)
      points.push_back(exact_point(v));
    return points;
  }

  std::vector<Exact_point> outer_points(const Ring& ring) const
  {
    std::vector<Exact_point> points;
    for(int c : ring.facing)
      points.push_back(exact_point(m_chart.vertex[c]));
    return points;
  }

  double mean_weight(const Ring& ring) const
  {
    double sum = 0;
    for(int c : ring.facing)
      sum += m_chart.weight_of_triangle(c / 3);
    return sum / ring.size();
  }

  // Whether the patch joins two vertices that an edge of the surface joins already: nothing could flatten that.
  bool repeats_an_edge(const Patch& patch, const Ring& ring)
  {
    const std::vector<std::pair<int, int>> present = inner_edges(ring);
    for(const auto& triangle : patch)
      for(int k = 0; k < 3; ++k) {
        const int i = triangle[k], j = triangle[(k + 1) % 3];
        const std::pair<int, int> edge = std::minmax(i, j);
        if(!ring.is_edge(i, j) && std::binary_search(present.begin(), present.end(), edge))
          return true;
      }
    return false;
  }

  // The edges of the surface between vertices of the ring
  std::vector<std::pair<int, int>> inner_edges(const Ring& ring)
  {
    for(int i = 0; i < ring.size(); ++i)
      m_rank[ring.vertices[i]] = i;
    std::vector<std::pair<int, int>> edges;
    for(int i = 0; i < ring.size(); ++i)
      for(int c = previous_corner(ring.facing[i]); c >= 0; c = m_chart.rotate(c))
        if(const int j = m_rank[m_chart.vertex[next_corner(c)]]; j >= 0)
          edges.push_back(std::minmax(i, j));
    for(int v : ring.vertices)
      m_rank[v] = -1;
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  // Appends the centre of a fan to the vertices of the ring.
  void add_centre(const Ring& ring)
  {
    std::vector<Chart::Point_3> points;
    for(int v : ring.vertices)
      points.push_back(m_chart.points[v]);
    m_filled.points.push_back(CGAL::centroid(points.begin(), points.end()));
  }

  void add(const Patch& patch, const Ring& ring, double weight)
  {
    const int n = ring.size(), centre = m_filled.number_of_vertices() - 1;
    std::map<std::pair<int, int>, int> facing; // corners of the patch at its inner edges
    for(const auto& triangle : patch) {
      const int first = m_filled.number_of_corners();
      for(int k = 0; k < 3; ++k) {
        const int i = triangle[(k + 1) % 3], j = triangle[(k + 2) % 3], c = first + k;
        m_filled.vertex.push_back(triangle[k] < n ? ring.vertices[triangle[k]] : centre);
        m_filled.opposite.push_back(-1);
        if(ring.is_edge(i, j))
          link(c, ring.facing[i]);
        else if(const auto across = facing.find({j, i}); across != facing.end())
          link(c, across->second);
        else
          facing[{i, j}] = c;
      }
      m_filled.weight.push_back(weight);
    }
  }

  void link(int c, int d)
  {
    m_filled.opposite[c] = d;
    m_filled.opposite[d] = c;
  }

  // The targets of the surface do not depend on the filling. The targets of patches share the rest of the full turn: in
  // proportion to their angles in space, or equally in fans, which have no shape of their own.
  void set_targets()
  {
    std::vector<double>& beta = m_filled.targets;
    beta = target_angles(m_chart);
    std::vector<double> left(m_filled.points.size(), 2 * pi), sum(m_filled.points.size(), 0.);
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      left[m_chart.vertex[c]] -= beta[c];
    for(int c = m_chart.number_of_corners(); c < m_filled.number_of_corners(); ++c) {
      beta.push_back(is_of_fan(c / 3) ? 1 : (std::max)(surface_angle(m_filled, c), least_target_angle));
      sum[m_filled.vertex[c]] += beta[c];
    }
    for(int c = m_chart.number_of_corners(); c < m_filled.number_of_corners(); ++c) {
      const int v = m_filled.vertex[c];
      const double least = is_centre(v) ? least_target_angle : least_patch_angle;
      beta[c] = (std::min)((std::max)(beta[c] * left[v] / sum[v], least), pi - least_target_angle);
    }
  }

  bool is_centre(int v) const { return v >= m_chart.number_of_vertices(); }

  bool is_of_fan(int t) const
  {
    return is_centre(m_filled.vertex[3 * t]) || is_centre(m_filled.vertex[3 * t + 1]) ||
           is_centre(m_filled.vertex[3 * t + 2]);
  }

  const Chart& m_chart;
  Chart m_filled;
  std::vector<int> m_rank; // of each vertex in the ring at hand
};

// A disk whose first vertices and triangles are those of a chart with holes that `diagnose()` found flawless. The
// weight of a patch is `weight` times the mean of that of the triangles around it.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart fill_holes(const Chart& chart, double weight)
{
  return Hole_filler(chart).run(weight);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_HOLES_FILL_HOLES_H
