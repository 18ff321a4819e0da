// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The ratio of the sides of a rectangle grows as the second corner moves away from the first one and the fourth away
// from the third, so that a bisection finds these two. Included by `rectangle_corners.h`, or by the source file of the
// compiled library.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_CORNERS_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_CORNERS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/rectangle_corners.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/rectangle_ratio.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Finds the rectangle whose predicted ratio is nearest to the one that is asked for.
class Rectangle_search
{
  static constexpr double small_deviation = 0.005; // of logarithms; as well as ratios are predicted

public:
  Rectangle_search(const Chart& chart, double aspect_ratio, const Linear_solvers& solvers)
      : m_chart(chart), m_aspect_ratio(aspect_ratio), m_ratio(chart, solvers), m_family(chart)
  {}

  Rectangle_corners run()
  {
    int lower = -1, upper = m_family.size();
    while(upper - lower > 1) {
      const int middle = (lower + upper) / 2;
      const std::optional<double> ratio = try_corners(m_family[middle]);
      if(!ratio)
        return failure(Diagnosis::LINEAR_SYSTEM_FAILED, "the linear solver failed");
      (*ratio < m_aspect_ratio ? lower : upper) = middle;
    }
    if((lower < 0 || upper == m_family.size()) && deviation(m_best_ratio) > small_deviation)
      return out_of_reach();
    if(!walk())
      return failure(Diagnosis::LINEAR_SYSTEM_FAILED, "the linear solver failed");
    Rectangle_corners result;
    for(int i = 0; i < 4; ++i)
      result.vertices[i] = vertex(m_best[i]);
    result.aspect_ratio = m_best_ratio;
    return result;
  }

private:
  int vertex(int rank) const { return m_chart.edge_source(m_chart.borders.front()[rank]); }
  double deviation(double ratio) const { return std::abs(std::log(ratio) - std::log(m_aspect_ratio)); }

  // Returns the ratio of a rectangle, and keeps the best one.
  std::optional<double> try_corners(const std::array<int, 4>& corners)
  {
    const std::optional<double> ratio = m_ratio(corners);
    if(ratio && deviation(*ratio) < deviation(m_best_ratio)) {
      m_best = corners;
      m_best_ratio = *ratio;
    }
    return ratio;
  }

  // Moves the second and the fourth corner by a few vertices in opposite directions, along rectangles whose ratios are
  // near the one that is asked for. Their two numbers of vertices meet the ratio better than one number does.
  bool walk()
  {
    const int size = static_cast<int>(m_chart.borders.front().size()), most_steps = (std::min)(size / 20, 12);
    std::array<int, 4> corners = m_best;
    bool is_too_wide = m_best_ratio > m_aspect_ratio;
    for(int step = 0; step < most_steps && deviation(m_best_ratio) > small_deviation; ++step) {
      corners[is_too_wide ? 1 : 3] += is_too_wide ? -1 : 1;
      if(corners[1] == 0 || corners[3] == size)
        return true;
      const std::optional<double> ratio = try_corners(corners);
      if(!ratio)
        return false;
      is_too_wide = *ratio > m_aspect_ratio;
    }
    return true;
  }

  static Rectangle_corners failure(Diagnosis diagnosis, const std::string& message)
  {
    Rectangle_corners result;
    result.defect = {diagnosis, message, {}, {}};
    return result;
  }

  Rectangle_corners out_of_reach() const
  {
    std::ostringstream message;
    message << "no rectangle with its first corner there has a ratio of sides of " << m_aspect_ratio
            << ": the nearest one is " << m_best_ratio;
    Rectangle_corners result = failure(Diagnosis::WRONG_OPTION, message.str());
    result.defect.vertices = {vertex(0)};
    return result;
  }

  const Chart& m_chart;
  const double m_aspect_ratio;
  const Rectangle_ratio m_ratio;
  const Rectangle_family m_family;
  std::array<int, 4> m_best = {0, 0, 0, 0};
  double m_best_ratio = (std::numeric_limits<double>::infinity)();
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Rectangle_corners choose_rectangle_corners(const Chart& chart,
                                                                              double aspect_ratio,
                                                                              const Linear_solvers& solvers)
{
  Rectangle_corners result;
  if(!(aspect_ratio > 0 && std::isfinite(aspect_ratio)))
    result.defect = {
        Diagnosis::WRONG_OPTION, "the ratio of the sides of a rectangle must be positive and finite", {}, {}};
  else
    result.defect = diagnose(chart, true);
  if(!result.defect && chart.borders.front().size() < 4)
    result.defect = {Diagnosis::SHORT_BORDER,
                     "a rectangle needs a border with four vertices",
                     border_cycles(chart).front(),
                     {}};
  return result.defect ? result : Rectangle_search(chart, aspect_ratio, solvers).run();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_CORNERS_IMPL_H
