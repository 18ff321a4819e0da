// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The rank of a half-edge collapse, and whether it is allowed (Section 5.1): the volume it sweeps, by a quadratic form,
// link condition, and angles that may result. `coarsening_stage.h` asks it for the cheapest collapse of each vertex.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COLLAPSE_COST_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COLLAPSE_COST_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A quadratic form in space. Its six coefficients are separate members, so that they stay in registers during
// summation.
struct Quadric
{
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  // Adds `factor` times the square of the dot product with `n`.
  void add(const Eigen::Vector3d& n, double factor)
  {
    const double x = factor * n.x(), y = factor * n.y();
    xx += x * n.x();
    yy += y * n.y();
    zz += factor * n.z() * n.z();
    xy += x * n.y();
    xz += x * n.z();
    yz += y * n.z();
  }

  void add_identity(double factor)
  {
    xx += factor;
    yy += factor;
    zz += factor;
  }

  double trace() const { return xx + yy + zz; }

  double operator()(const Eigen::Vector3d& d) const
  {
    return d.x() * (xx * d.x() + 2 * (xy * d.y() + xz * d.z())) + d.y() * (yy * d.y() + 2 * yz * d.z()) +
           zz * d.z() * d.z();
  }
};

struct Collapse_candidate
{
  double cost = (std::numeric_limits<double>::infinity)();
  Edge_collapses::Record record = 0;

  explicit operator bool() const { return std::isfinite(cost); }
};

// Computes the costs of the collapses of one vertex after the other, and rejects some.
class Collapse_cost
{
  typedef Eigen::Vector3d Vector;

  // For a vertex of large degree, only the cheapest collapses are examined.
  static constexpr std::size_t max_candidates = 32;

  // A border vertex with a larger angle is not removed. It could not be inserted again where its planar angle is
  // about a full turn too.
  static constexpr double largest_border_turn = 1.9 * pi;

public:
  // No angle may become smaller than `extreme_angle` (in radians) or larger than pi minus that, unless an angle
  // around the vertex is already as bad. If `extreme_angle` is 0, only the connectivity matters.
  Collapse_cost(const Edge_collapses& mesh, double extreme_angle)
      : m_mesh(mesh), m_any_shape(extreme_angle == 0), m_least_cotangent(1 / std::tan(extreme_angle))
  {}

  // The cheapest allowed collapse of vertex `v`.
  //
  // The cost is the sum of the squared volumes between the old star and the new one, d' A d with A = sum n n' over
  // the normals of the star, for the displacement d of the vertex. A small multiple of the trace of A is added.
  // Collapses in flat places then have a cost too, and triangles keep their shapes.
  Collapse_candidate best(int v)
  {
    gather_star(v);
    if(m_on_border && !m_any_shape && surface_turn() > largest_border_turn)
      return {};
    const double shape = 1e-2 * m_quadric.trace();
    m_candidates.clear();
    for(std::size_t i = 0; i < m_ring.size(); ++i)
      if(is_collapsible(i))
        m_candidates.push_back({m_quadric(m_edges[i]) + shape * m_squares[i], static_cast<int>(i)});
    for(std::size_t looked_at = 0; looked_at < max_candidates && !m_candidates.empty(); ++looked_at) {
      const auto next = std::min_element(m_candidates.begin(), m_candidates.end(), is_cheaper);
      if((m_any_shape || keeps_shape(next->record)) && fulfils_link_condition(next->record))
        return {next->cost, record(next->record)};
      *next = m_candidates.back();
      m_candidates.pop_back();
    }
    return {};
  }

  // Whether a collapse is still allowed after other collapses that did not change the star of `v`.
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
    m_ring_bits = 0;
    for(int w : m_ring)
      m_ring_bits |= std::uint64_t(1) << (w % 64);
  }

  void gather_star(int v)
  {
    gather_ring(v);
    const Vector centre = point(v);
    m_edges.clear();
    m_squares.clear();
    m_normals.clear();
    for(int w : m_ring) {
      m_edges.push_back(point(w) - centre);
      m_squares.push_back(m_edges.back().squaredNorm());
    }
    Quadric quadric;
    m_worst_cotangent = CGAL::square(m_least_cotangent);
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const std::size_t j = after(i);
      const Vector normal = m_edges[j].cross(m_edges[i]);
      const double squared_norm = normal.squaredNorm();
      m_normals.push_back(normal);
      quadric.add(normal, 1);
      const double dot = largest_dot_product(m_edges[j].dot(m_edges[i]), m_squares[j], m_squares[i]);
      if(dot * dot > m_worst_cotangent * squared_norm)
        m_worst_cotangent = dot * dot / squared_norm;
    }
    if(m_on_border)
      for(std::size_t end : {std::size_t(0), m_ring.size() - 1}) {
        quadric.add(m_edges[end], -m_squares[end]);
        quadric.add_identity(CGAL::square(m_squares[end]));
      }
    m_quadric = quadric;
  }

  // The sum of the angles at the vertex
  double surface_turn() const
  {
    double turn = 0;
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      turn += std::atan2(m_normals[i].norm(), m_edges[after(i)].dot(m_edges[i]));
    return turn;
  }

  // The index of the ring vertex before vertex i in counterclockwise order.
  std::size_t after(std::size_t i) const { return i + 1 < m_ring.size() ? i + 1 : 0; }

  // For the triangle with edges a and b: its largest absolute cotangent times twice its area.
  static double largest_dot_product(double ab, double aa, double bb)
  {
    return (std::max)({std::abs(ab), std::abs(aa - ab), std::abs(bb - ab)});
  }

  // Border vertices are merged along the border only, and only if the surface does not fall apart when the triangle
  // vanishes.
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

  // Whether the remaining triangles keep their orientation and have allowed shapes when the vertex is at ring vertex
  // i.
  bool keeps_shape(std::size_t i) const
  {
    for(std::size_t t = 0; t < m_corners.size(); ++t) {
      if(t == i || after(t) == i)
        continue;
      const Vector a = m_edges[after(t)] - m_edges[i], b = m_edges[t] - m_edges[i];
      const Vector normal = a.cross(b);
      const double turn = normal.dot(m_normals[t]), squared_norm = normal.squaredNorm();
      if(!(turn > 0 && turn * turn > 0.04 * squared_norm * m_normals[t].squaredNorm()) ||
         CGAL::square(largest_dot_product(a.dot(b), a.squaredNorm(), b.squaredNorm())) >
             m_worst_cotangent * squared_norm)
        return false;
    }
    return true;
  }

  // Whether the only common neighbours of the two vertices of the edge are those in the triangles at the edge.
  bool fulfils_link_condition(int i)
  {
    const Chart& chart = m_mesh.chart();
    int common = 0;
    const auto count = [&](int u) { common += is_in_ring(u); };
    m_mesh.for_each_corner(m_ring[i], [&](int c) {
      count(chart.vertex[previous_corner(c)]);
      if(chart.opposite[previous_corner(c)] < 0)
        count(chart.vertex[next_corner(c)]);
    });
    return common == (m_on_border ? 1 : 2);
  }

  // One bit nearly always decides.
  bool is_in_ring(int u)
  {
    if(!(m_ring_bits >> (u % 64) & 1))
      return false;
    if(m_ring.size() <= 32)
      return std::find(m_ring.begin(), m_ring.end(), u) != m_ring.end();
    if(m_sorted_ring.empty()) {
      m_sorted_ring = m_ring;
      std::sort(m_sorted_ring.begin(), m_sorted_ring.end());
    }
    return std::binary_search(m_sorted_ring.begin(), m_sorted_ring.end(), u);
  }

  // In clockwise order, ring vertex i is next to the vertex's corner in the triangle before it.
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
  std::vector<Vector> m_edges;   // from the vertex to those of the ring
  std::vector<double> m_squares; // of their lengths
  std::vector<Vector> m_normals; // of the triangles, as long as twice their areas
  std::vector<Collapse_candidate> m_candidates;
  Quadric m_quadric;
  double m_worst_cotangent = 0;  // squared
  std::uint64_t m_ring_bits = 0; // one bit for each ring vertex: its number modulo 64
  bool m_on_border = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COLLAPSE_COST_H
