// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks whether prescribed angles at vertices of the surface before the cut, such as cones, are possible. Called by
// `set_angle_sums()` for charts with seams of equal sides; `check_angle_sums.h` is its counterpart for other borders.
//
// Takes prescribed angles into a chart: checks that they are possible, and corrects the largest one by the rounding
// error of the total. `chart/prescriptions.h` declares it. `run_parameterizer.h`, `cone_flattener.h` and
// `polygon_angles.h` include this body in programs without the compiled library, which has it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CHECK_SURFACE_SUMS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CHECK_SURFACE_SUMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_flow.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_nodes.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Whether planar angles with prescribed sums at the vertices of the surface before the cut exist. `Angle_sum_check` is
// the counterpart for a border.
class Surface_sum_check
{
public:
  explicit Surface_sum_check(const Chart& chart)
      : m_chart(chart), m_places(chart),
        m_sum(chart.points.size(), (std::numeric_limits<double>::quiet_NaN)()),
        m_corners(chart.points.size(), 0), m_place(m_places.of_vertices()),
        m_is_outer(chart.points.size(), false)
  {
    for(int c : chart.borders.front())
      m_is_outer[chart.edge_source(c)] = true;
    for(int c = 0; c < chart.number_of_corners(); ++c)
      ++m_corners[m_place[chart.vertex[c]]];
    for(int c : chart.borders.front()) {
      const int v = chart.edge_source(c);
      const double sum = chart.surface_sums[v];
      m_sum[m_place[v]] = !std::isnan(sum) ? sum : m_places.is_inside(m_place[v]) ? 2 * pi : sum;
    }
    for(double& sum : m_sum)
      if(std::isinf(sum))
        sum = (std::numeric_limits<double>::quiet_NaN)();
    find_total();
  }

  Chart_defect run() const
  {
    if(Chart_defect defect = find_wrong_sum())
      return defect;
    if(Chart_defect defect = find_wrong_total())
      return defect;
    return find_misplaced_sums();
  }

  // If all sums are prescribed: by how much their total is too small
  double missing_angle() const { return m_free.empty() ? m_left : 0; }

private:
  static Chart_defect defect(Diagnosis diagnosis, const std::string& message,
                             const std::vector<int>& vertices)
  {
    return {diagnosis, message, vertices, {}};
  }

  bool is_given(int v) const { return !std::isnan(m_chart.surface_sums[v]); }

  // The rest of the total, for the vertices of the outer border without a prescribed sum
  void find_total()
  {
    m_left = pi * m_chart.number_of_triangles() - 2 * pi * m_chart.number_of_interior_vertices;
    for(int k = 0; k < m_chart.number_of_holes(); ++k) // around a hole the border turns by - 2 pi
      m_left -= pi * (static_cast<double>(m_chart.hole(k).size()) + 2);
    for(int v = 0; v < m_chart.number_of_vertices(); ++v)
      if(m_is_outer[v] && m_place[v] == v) {
        if(std::isnan(m_sum[v])) {
          m_free.push_back(v);
          m_corners_of_free += m_corners[v];
        } else {
          m_left -= m_sum[v];
        }
      }
  }

  Chart_defect find_wrong_sum() const
  {
    for(int v = 0; v < m_chart.number_of_vertices(); ++v) {
      if(!is_given(v) && !(m_is_outer[v] && is_given(m_place[v])))
        continue;
      const double sum = m_chart.surface_sums[v];
      const int place = m_place[v];
      std::ostringstream message;
      message << "the prescribed angle sum at " << vertex_text(m_chart, v);
      if(!m_is_outer[v])
        message << " is neither on a seam nor at the outer border";
      else if(!(sum == m_chart.surface_sums[place]))
        message << " is not the same at all its copies";
      else if(std::isinf(sum) && sum > 0 && m_places.is_inside(place))
        continue;
      else if(!(sum > 0 && std::isfinite(sum)))
        message << " is not a positive number";
      else if(sum >= m_corners[place] * pi - least_angle_of_flow)
        message << ", " << sum << ", is too large: the vertex has only " << m_corners[place]
                << " triangle(s)";
      else
        continue;
      return defect(Diagnosis::WRONG_ANGLE_SUM, message.str(), {v});
    }
    return {};
  }

  Chart_defect find_wrong_total() const
  {
    std::ostringstream message;
    message.precision(10);
    if(m_free.empty()) {
      if(std::abs(m_left) <= largest_rounding_of_angles)
        return {};
      message << "the prescribed angle sums are too " << (m_left > 0 ? "small" : "large") << " by "
              << std::abs(m_left)
              << " together: the sums of all vertices must be pi times the number of triangles";
      return defect(Diagnosis::WRONG_ANGLE_TOTAL, message.str(), given());
    }
    if(m_left > 0 && m_left < m_corners_of_free * pi)
      return {};
    message << "the prescribed angle sums leave a sum of " << m_left << " to the " << m_free.size()
            << " vertices whose sums are free, which must be above 0 and below " << m_corners_of_free
            << " pi";
    return defect(Diagnosis::WRONG_ANGLE_TOTAL, message.str(), m_free);
  }

  // The vertices with a sum that was given, one copy of each
  std::vector<int> given() const
  {
    std::vector<int> vertices;
    for(int v = 0; v < m_chart.number_of_vertices(); ++v)
      if(m_is_outer[v] && m_place[v] == v && is_given(v))
        vertices.push_back(v);
    return vertices;
  }

  Chart_defect find_misplaced_sums() const
  {
    const Angle_flow flow(m_chart, m_place, m_sum);
    if(flow.is_feasible())
      return {};
    std::vector<int> vertices;
    for(int v : given())
      if(flow.is_in_conflict(v))
        vertices.push_back(v);
    std::ostringstream message;
    message << "the angle sums prescribed at " << vertices.size() << " vertices";
    if(!vertices.empty())
      message << ", such as the one at " << vertex_text(m_chart, vertices.front()) << ",";
    message << (flow.is_too_large() ? " are too large" : " are too small")
            << " together for the triangles near these vertices";
    return defect(Diagnosis::INFEASIBLE_ANGLE_SUMS, message.str(), vertices);
  }

  const Chart& m_chart;
  const Seam_places m_places;
  std::vector<double> m_sum;  // of each place: what is prescribed, or NaN
  std::vector<int> m_corners; // of each place: how many there are
  const std::vector<int>& m_place;
  std::vector<char> m_is_outer; // of each vertex
  std::vector<int> m_free;      // places of the outer border without a prescribed sum
  int m_corners_of_free = 0;
  double m_left = 0;
};

// Adds an angle to all copies of the largest sum.
inline void add_to_largest(double angle, const Seam_places& places, std::vector<double>& sums)
{
  const auto rank = [](double sum) { return std::isfinite(sum) ? sum : -1; };
  const auto largest =
      std::max_element(sums.begin(), sums.end(), [&](double a, double b) { return rank(a) < rank(b); });
  const int place = places.of(static_cast<int>(largest - sums.begin()));
  for(std::size_t v = 0; v < sums.size(); ++v)
    if(std::isfinite(sums[v]) && places.of(static_cast<int>(v)) == place)
      sums[v] += angle;
}

// The largest angle is corrected by the rounding error of the total; otherwise, the equations could not be satisfied.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect set_angle_sums(std::vector<double> sums, Chart& chart)
{
  const Seam_places places(chart);
  (chart.equal_seams ? chart.surface_sums : chart.angle_sums) = std::move(sums);
  if(chart.equal_seams) {
    const Surface_sum_check check(chart);
    if(Chart_defect defect = check.run())
      return defect;
    add_to_largest(check.missing_angle(), places, chart.surface_sums);
  } else {
    const Angle_sum_check check(chart);
    if(Chart_defect defect = check.run())
      return defect;
    if(is_whole_border_prescribed(chart))
      add_to_largest(check.missing_angle(), places, chart.angle_sums);
  }
  find_nodes(chart);
  return {};
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CHECK_SURFACE_SUMS_H
