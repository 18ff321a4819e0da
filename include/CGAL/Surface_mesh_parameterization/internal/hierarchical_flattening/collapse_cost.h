// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_COLLAPSE_COST_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_COLLAPSE_COST_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/edge_collapses.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

struct Collapse_candidate
{
  double cost = (std::numeric_limits<double>::infinity)();
  Edge_collapses::Record record = 0;

  explicit operator bool() const { return std::isfinite(cost); }
};

// Ranks and vetoes the collapses of one vertex after the other.
class Collapse_cost
{
  typedef Eigen::Vector3d Vector;

  // Of the collapses of a vertex of large degree only the cheapest ones are looked at.
  static constexpr std::size_t max_candidates = 32;

public:
  // No angle shall be smaller than `extreme_angle` (in radians), or larger than pi less that, unless there is one as
  // bad around the vertex already. If `extreme_angle` is 0, shapes do not matter at all, only the connectivity does.
  Collapse_cost(const Edge_collapses& mesh, double extreme_angle)
      : m_mesh(mesh), m_any_shape(extreme_angle == 0), m_least_cotangent(1 / std::tan(extreme_angle))
  {}

  // The cheapest collapse of vertex `v` that is allowed.
  //
  // The cost is the sum of the squared volumes between the old star and the new one, d' A d with A = sum n n' over the
  // normals of the star, along the way d of the vertex. A little of the trace of A is added, so that flat places are
  // not free, and triangles keep their shapes.
  Collapse_candidate best(int v)
  {
    gather_star(v);
    const double shape = 1e-2 * m_quadric.trace();
    m_candidates.clear();
    for(std::size_t i = 0; i < m_ring.size(); ++i) {
      if(!is_collapsible(i))
        continue;
      const Vector d = point(m_ring[i]) - m_centre;
      m_candidates.push_back({d.dot(m_quadric * d) + shape * d.squaredNorm(), static_cast<int>(i)});
    }
    for(std::size_t looked_at = 0; looked_at < max_candidates && !m_candidates.empty(); ++looked_at) {
      const auto next = std::min_element(m_candidates.begin(), m_candidates.end(), is_cheaper);
      if((m_any_shape || keeps_shape(next->record)) && fulfils_link_condition(next->record))
        return {next->cost, record(next->record)};
      *next = m_candidates.back();
      m_candidates.pop_back();
    }
    return {};
  }

  // Whether a collapse that was allowed still is after others, none of which changed the star of `v`.
  bool is_still_allowed(int v, Edge_collapses::Record wanted)
  {
    gather_ring(v);
    for(std::size_t i = 0; i < m_ring.size(); ++i)
      if(is_collapsible(i) && record(static_cast<int>(i)) == wanted)
        return fulfils_link_condition(static_cast<int>(i));
    return false;
  }

private:
  static bool is_cheaper(const Collapse_candidate& a, const Collapse_candidate& b)
  {
    return a.cost < b.cost || (a.cost == b.cost && a.record < b.record);
  }

  Vector point(int v) const
  {
    const Chart::Point_3& p = m_mesh.chart().points[v];
    return Vector(p.x(), p.y(), p.z());
  }

  // Triangle i of the star has its corners at the vertex, at ring vertices i + 1 and i.
  void gather_ring(int v)
  {
    const Chart& chart = m_mesh.chart();
    m_corners.clear();
    m_ring.clear();
    m_sorted_ring.clear();
    m_mesh.for_each_corner(v, [&](int c) {
      m_corners.push_back(c);
      m_ring.push_back(chart.vertex[previous_corner(c)]);
    });
    m_on_border = chart.interior[v] < 0;
    if(m_on_border)
      m_ring.push_back(chart.vertex[next_corner(m_corners.back())]);
  }

  void gather_star(int v)
  {
    gather_ring(v);
    m_centre = point(v);
    m_quadric.setZero();
    m_normals.clear();
    m_areas.clear();
    m_worst_cotangent = m_least_cotangent;
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const Vector a = point(after(i)) - m_centre, b = point(m_ring[i]) - m_centre;
      const Vector normal = a.cross(b);
      m_normals.push_back(normal);
      m_areas.push_back(normal.norm());
      m_quadric += normal * normal.transpose();
      m_worst_cotangent = (std::max)(m_worst_cotangent, largest_dot_product(a, b) / m_areas.back());
    }
    if(m_on_border)
      for(int w : {m_ring.front(), m_ring.back()}) {
        const Vector e = point(w) - m_centre;
        m_quadric += e.squaredNorm() * (e.squaredNorm() * Eigen::Matrix3d::Identity() - e * e.transpose());
      }
  }

  // The ring vertex before ring vertex i in counterclockwise order, that is the next one clockwise.
  int after(std::size_t i) const { return m_ring[i + 1 < m_ring.size() ? i + 1 : 0]; }

  // For the triangle with edges `a` and `b` from a vertex: this divided by twice its area is its largest absolute cotangent.
  static double largest_dot_product(const Vector& a, const Vector& b)
  {
    const double ab = a.dot(b), aa = a.squaredNorm(), bb = b.squaredNorm();
    return (std::max)({std::abs(ab), std::abs(aa - ab), std::abs(bb - ab)});
  }

  // Border vertices go along the border only, and not if the triangle that vanishes is all that holds its other two
  // edges together.
  bool is_collapsible(std::size_t i) const
  {
    if(!m_on_border)
      return true;
    const bool is_first = i == 0;
    if(!is_first && i + 1 != m_ring.size())
      return false;
    const int c = is_first ? m_corners.front() : m_corners.back();
    const int kept = is_first ? previous_corner(c) : next_corner(c);
    return m_mesh.chart().opposite[c] >= 0 || m_mesh.chart().opposite[kept] >= 0;
  }

  // Whether the triangles that stay keep their sides and are no worse than allowed once the vertex is at ring vertex i.
  bool keeps_shape(int i) const
  {
    const Vector target = point(m_ring[i]);
    for(std::size_t t = 0; t < m_corners.size(); ++t) {
      const int p = after(t), q = m_ring[t];
      if(p == m_ring[i] || q == m_ring[i])
        continue;
      const Vector a = point(p) - target, b = point(q) - target;
      const Vector normal = a.cross(b);
      const double twice_area = normal.norm();
      if(!(normal.dot(m_normals[t]) > 0.2 * twice_area * m_areas[t]) ||
         largest_dot_product(a, b) > m_worst_cotangent * twice_area)
        return false;
    }
    return true;
  }

  // The neighbours that the two vertices of the edge have in common are those in the triangles at the edge.
  bool fulfils_link_condition(int i)
  {
    if(m_sorted_ring.empty()) {
      m_sorted_ring = m_ring;
      std::sort(m_sorted_ring.begin(), m_sorted_ring.end());
    }
    const Chart& chart = m_mesh.chart();
    int common = 0;
    const auto count = [&](int u) {
      common += std::binary_search(m_sorted_ring.begin(), m_sorted_ring.end(), u);
    };
    m_mesh.for_each_corner(m_ring[i], [&](int c) {
      count(chart.vertex[previous_corner(c)]);
      if(chart.rotate(c) < 0)
        count(chart.vertex[next_corner(c)]);
    });
    return common == (m_on_border ? 1 : 2);
  }

  // In clockwise order the triangle before ring vertex i has it next to the vertex's corner.
  Edge_collapses::Record record(int i) const
  {
    if(!m_on_border)
      return m_corners[i == 0 ? m_corners.size() - 1 : i - 1];
    return i == 0 ? ~m_corners.front() : m_corners.back();
  }

  const Edge_collapses& m_mesh;
  bool m_any_shape;
  double m_least_cotangent;

  std::vector<int> m_corners, m_ring, m_sorted_ring;
  std::vector<Vector> m_normals; // of the triangles, as long as
  std::vector<double> m_areas;   // twice their areas
  std::vector<Collapse_candidate> m_candidates;
  Eigen::Matrix3d m_quadric;
  Vector m_centre;
  double m_worst_cotangent = 0;
  bool m_on_border = false;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_COLLAPSE_COST_H
