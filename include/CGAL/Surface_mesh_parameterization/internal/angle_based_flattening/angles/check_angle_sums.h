// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks whether prescribed angles along the outer border are possible, so that Newton's method is not asked for the
// impossible. Called by `set_angle_sums()`. Circle packings show that the test suffices (Thurston 1978, Chow and Luo
// 2003).
//
// The edges of a border in the plane, as the angles alone determine them: by turns at the vertices, and the sine rule.
// Holes and seams need it for their equations (`hole_equations.h`, `loop_equations.h`), and the layout to place the
// border.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CHECK_ANGLE_SUMS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CHECK_ANGLE_SUMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_flow.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A directed edge in the plane
struct Planar_edge
{
  double direction = 0, log_length = 0;
};

// The edges of a planar border, that the angles alone determine up to a similarity. The last one is the first one
// again, after a turn around the border.
typedef std::vector<Planar_edge> Border_walk;

// At a vertex the border turns by pi less the angles there, and its edges' lengths are related by the sine rule through
// the fan.
inline Border_walk walk_along_border(const Chart& chart, const std::vector<double>& alpha,
                                     const std::vector<int>& border, Planar_edge edge = {})
{
  Border_walk walk;
  walk.reserve(border.size() + 1);
  walk.push_back(edge);
  for(int first : border) {
    edge.direction += pi;
    for(int c = previous_corner(first); c >= 0; c = chart.rotate(c)) {
      edge.direction -= alpha[c];
      edge.log_length += std::log(std::sin(alpha[previous_corner(c)]) / std::sin(alpha[next_corner(c)]));
    }
    walk.push_back(edge);
  }
  return walk;
}

// Prescribed angles may miss their total by this much; the largest one is then corrected.
inline constexpr double largest_rounding_of_angles = 1e-6;

// Whether planar angles with prescribed sums at vertices of the outer border exist. If each triangle can distribute pi
// over its corners, and each corner gets a positive part, then edges exist that fit together: a packing of touching
// circles has such angles. (Thurston 1978, Chapter 13; Chow and Luo 2003.)
class Angle_sum_check
{
public:
  explicit Angle_sum_check(const Chart& chart)
      : m_chart(chart), m_border(chart.borders.front()), m_rank(chart.points.size(), -1),
        m_turning(m_border.size() + 1, 0.), m_free(m_border.size() + 1, 0)
  {
    for(int i = 0; i < size(); ++i) {
      m_rank[vertex(i)] = i;
      const bool is_free = !chart.is_angle_prescribed(vertex(i));
      m_turning[i + 1] = m_turning[i] + (is_free ? 0 : pi - chart.angle_sums[vertex(i)]);
      m_free[i + 1] = m_free[i] + is_free;
    }
  }

  Chart_defect run() const
  {
    if(Chart_defect defect = find_wrong_angle())
      return defect;
    if(Chart_defect defect = find_wrong_total())
      return defect;
    if(Chart_defect defect = find_flat_chords())
      return defect;
    if(Chart_defect defect = find_too_large_angle())
      return defect;
    return find_misplaced_angles();
  }

  // If all border angles are prescribed: by how much their sum is too small
  double missing_angle() const { return m_turning.back() - 2 * pi; }

private:
  int size() const { return static_cast<int>(m_border.size()); }
  int vertex(int i) const { return m_chart.edge_source(m_border[i]); }

  // Of a corner at the vertex
  int corner(int i) const { return next_corner(m_border[i]); }

  static Chart_defect defect(Diagnosis diagnosis, const std::ostringstream& message,
                             std::vector<int> vertices)
  {
    return {diagnosis, message.str(), std::move(vertices), {}};
  }

  Chart_defect find_wrong_angle() const
  {
    std::vector<int> vertices;
    for(int v = 0; v < m_chart.number_of_vertices(); ++v)
      if(m_chart.is_angle_prescribed(v) &&
         (m_rank[v] < 0 || !std::isfinite(m_chart.angle_sums[v]) || m_chart.angle_sums[v] <= 0))
        vertices.push_back(v);
    if(vertices.empty())
      return {};
    std::ostringstream message;
    message << "the prescribed angle at " << vertex_text(m_chart, vertices.front())
            << (m_rank[vertices.front()] < 0 ? " is not at the outer border" : " is not a positive number");
    return defect(Diagnosis::WRONG_ANGLE_SUM, message, vertices);
  }

  Chart_defect find_wrong_total() const
  {
    const double left = missing_angle();
    std::ostringstream message;
    message.precision(10);
    if(m_free.back() == 0) {
      if(std::abs(left) <= largest_rounding_of_angles)
        return {};
      message << "the prescribed angles of all " << size() << " border vertices sum to "
              << (size() - 2) * pi - left << ", but must sum to " << size() - 2
              << " pi = " << (size() - 2) * pi;
      return defect(Diagnosis::WRONG_ANGLE_TOTAL, message, {});
    }
    // What is left for the others counts their turning as zero.
    const double sum = left + m_free.back() * pi;
    std::vector<int> others;
    std::size_t triangles = 0;
    for(int i = 0; i < size(); ++i)
      if(!m_chart.is_angle_prescribed(vertex(i))) {
        others.push_back(vertex(i));
        triangles += corners_around(m_chart, corner(i)).size();
      }
    if(sum > 0 && sum < static_cast<double>(triangles) * pi)
      return {};
    message << "the prescribed angles leave a sum of " << sum << " to the " << others.size()
            << " other border vertices, which must be above 0 and below " << triangles << " pi";
    return defect(Diagnosis::WRONG_ANGLE_TOTAL, message, others);
  }

  // An edge between two border vertices cuts off a part of the plane on each side, if the border turns towards it
  // between them.
  Chart_defect find_flat_chords() const
  {
    std::vector<int> ends;
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      if(m_chart.opposite[c] > c) {
        const int i = m_rank[m_chart.edge_source(c)], j = m_rank[m_chart.edge_target(c)];
        if(i >= 0 && j >= 0 &&
           (is_flat((std::min)(i, j), (std::max)(i, j), false) ||
            is_flat((std::min)(i, j), (std::max)(i, j), true))) {
          ends.push_back(vertex(i));
          ends.push_back(vertex(j));
        }
      }
    if(ends.empty())
      return {};
    std::ostringstream message;
    message << "an edge joins " << vertex_text(m_chart, ends[0]) << " and " << vertex_text(m_chart, ends[1])
            << " of the border, but the prescribed angles between them leave no room beside it";
    if(ends.size() > 2)
      message << ", nor beside " << ends.size() / 2 - 1 << " other edge(s)";
    message << ": split it, for example by split_flat_chords()";
    return defect(Diagnosis::FLAT_CHORD, message, ends);
  }

  // Whether all vertices between those of ranks i < j, or all others, are prescribed and do not turn to the left in
  // total
  bool is_flat(int i, int j, bool others) const
  {
    const auto sum = [&](const auto& sums) {
      return others ? sums.back() - (sums[j + 1] - sums[i]) : sums[j] - sums[i + 1];
    };
    return sum(m_free) == 0 && sum(m_turning) <= least_angle_of_flow;
  }

  Chart_defect find_too_large_angle() const
  {
    std::vector<int> vertices;
    std::size_t triangles = 0;
    for(int i = size() - 1; i >= 0; --i)
      if(m_chart.is_angle_prescribed(vertex(i))) {
        const std::size_t number = corners_around(m_chart, corner(i)).size();
        if(m_chart.angle_sums[vertex(i)] >= static_cast<double>(number) * pi - least_angle_of_flow) {
          vertices.insert(vertices.begin(), vertex(i));
          triangles = number;
        }
      }
    if(vertices.empty())
      return {};
    std::ostringstream message;
    message << "the prescribed angle " << m_chart.angle_sums[vertices.front()] << " at "
            << vertex_text(m_chart, vertices.front()) << " is too large: the vertex has only " << triangles
            << " triangle(s)";
    return defect(Diagnosis::WRONG_ANGLE_SUM, message, vertices);
  }

  // Without angles above pi, only chords can make the angles impossible.
  Chart_defect find_misplaced_angles() const
  {
    bool is_convex = true;
    for(int i = 0; i < size(); ++i)
      if(m_chart.is_angle_prescribed(vertex(i)))
        is_convex = is_convex && m_chart.angle_sums[vertex(i)] <= pi + largest_rounding_of_angles;
    if(is_convex)
      return {};
    std::vector<int> itself(m_chart.points.size());
    std::iota(itself.begin(), itself.end(), 0);
    const Angle_flow flow(m_chart, itself, m_chart.angle_sums);
    if(flow.is_feasible())
      return {};
    std::vector<int> vertices;
    for(int i = 0; i < size(); ++i)
      if(m_chart.is_angle_prescribed(vertex(i)) && flow.is_in_conflict(vertex(i)))
        vertices.push_back(vertex(i));
    std::ostringstream message;
    message << "the angles prescribed at " << vertices.size() << " border vertices";
    if(!vertices.empty())
      message << ", such as the one at " << vertex_text(m_chart, vertices.front()) << ",";
    message << (flow.is_too_large() ? " are too large" : " are too small")
            << " together for the triangles near these vertices";
    return defect(Diagnosis::INFEASIBLE_ANGLE_SUMS, message, vertices);
  }

  const Chart& m_chart;
  const std::vector<int>& m_border;
  std::vector<int> m_rank;       // of each vertex along the outer border, or -1
  std::vector<double> m_turning; // of the prescribed vertices before each rank
  std::vector<int> m_free;       // number of vertices before each rank without a prescribed angle
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CHECK_ANGLE_SUMS_H
