// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Searches the corners of a rectangle with a given ratio of its sides. Included by `rectangle_corners.h`, or by the
// source file of the compiled library.

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
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Looks at rectangles whose first and third corner are half the length of the border apart. As the second corner moves
// away from the first and the fourth from the third, the rectangle becomes wider. Ratios are predicted to about a
// hundredth. Of all rectangles that are as near to the wanted ratio, the search takes one where the border is fine at
// the corners, so that angles change little.
class Rectangle_search
{
  static constexpr double small_deviation = 0.01; // of logarithms
  static constexpr int most_first_corners = 64;

public:
  Rectangle_search(const Chart& chart, double aspect_ratio, const Linear_solvers& solvers)
      : m_chart(chart), m_aspect_ratio(aspect_ratio), m_size(static_cast<int>(chart.borders.front().size()))
  {
    m_arc.push_back(0); // edges without length have a little, so that there is nothing to divide by 0
    for(int c : chart.borders.front())
      m_arc.push_back(m_arc.back() + edge_length(chart, c) + 1e-9);
    Corners quarters = {0, 0, 0, 0};
    for(int i = 1; i < 4; ++i)
      quarters[i] =
          (std::min)((std::max)(rank_at(i * m_arc.back() / 4), quarters[i - 1] + 1), m_size - 4 + i);
    m_ratio = Rectangle_ratio::make(chart, quarters, solvers);
    m_last_first_corner = quarters[2];
  }

  Rectangle_corners run()
  {
    Rectangle_corners result;
    if(!m_ratio) {
      result.defect = {Diagnosis::LINEAR_SYSTEM_FAILED, "the linear solver failed", {}, {}};
      return result;
    }
    const int step = (std::max)(m_last_first_corner / most_first_corners, 1);
    for(int first = 0; first < m_last_first_corner; first += step)
      search(first);
    if(m_aspect_ratio < m_lowest * std::exp(-small_deviation) ||
       m_aspect_ratio > m_widest * std::exp(small_deviation)) {
      result.defect = out_of_reach();
      return result;
    }
    // The third corner could as well be the first one: it is the one that comes first on the border.
    if(m_best[2] < m_best[0])
      std::rotate(m_best.begin(), m_best.begin() + 2, m_best.end());
    for(int i = 0; i < 4; ++i)
      result.vertices[i] = m_chart.edge_source(m_chart.borders.front()[m_best[i]]);
    result.aspect_ratio = m_best_ratio;
    return result;
  }

private:
  typedef Rectangle_ratio::Corners Corners;

  // The rank of the vertex nearest to a position on the border
  int rank_at(double arc) const
  {
    arc = std::fmod(arc, m_arc.back());
    const auto next = std::upper_bound(m_arc.begin() + 1, m_arc.end() - 1, arc);
    const int rank = static_cast<int>(next - m_arc.begin());
    return (arc - *(next - 1) < *next - arc ? rank - 1 : rank) % m_size;
  }

  void search(int first)
  {
    const double half = m_arc.back() / 2;
    const int third = rank_at(m_arc[first] + half);
    try_corners({first, first + 1, third, third + 1});
    try_corners({first, third - 1, third, first - 1});
    double lower = 0, upper = 1;
    Corners corners = {first, 0, third, 0};
    for(double width = m_arc.back(); width > m_arc.back() / m_size / 2; width /= 2) {
      const double part = (lower + upper) / 2;
      corners[1] = rank_at(m_arc[first] + part * half);
      corners[3] = rank_at(m_arc[first] + (1 + part) * half);
      const std::optional<double> ratio = try_corners(corners);
      const bool is_low = ratio ? *ratio < m_aspect_ratio : part < 0.5;
      (is_low ? lower : upper) = part;
    }
    for(int i = -2; i <= 2; ++i)
      for(int j = -1; j <= 1; ++j)
        for(int k = -2; k <= 2; ++k)
          try_corners({first, corners[1] + i, corners[2] + j, corners[3] + k});
  }

  // Returns the ratio of a rectangle, and keeps the best one. Returns nothing if these are not corners of a rectangle.
  std::optional<double> try_corners(Corners corners)
  {
    for(int& c : corners)
      c = (c + m_size) % m_size;
    const auto steps = [&](int i) { return (corners[i] - corners[0] + m_size) % m_size; };
    if(!(0 < steps(1) && steps(1) < steps(2) && steps(2) < steps(3)))
      return std::nullopt;
    const double ratio = (*m_ratio)(corners);
    m_lowest = (std::min)(m_lowest, ratio);
    m_widest = (std::max)(m_widest, ratio);
    const double deviation =
        (std::max)(std::abs(std::log(ratio) - std::log(m_aspect_ratio)), small_deviation);
    if(deviation > m_best_deviation)
      return ratio;
    double coarseness = 0;
    for(int i = 0; i < 4; ++i)
      coarseness += m_ratio->coarseness(corners[(i + 3) % 4], corners[i], corners[(i + 1) % 4]);
    if(deviation < m_best_deviation || coarseness < m_best_coarseness) {
      m_best = corners;
      m_best_ratio = ratio;
      m_best_deviation = deviation;
      m_best_coarseness = coarseness;
    }
    return ratio;
  }

  Chart_defect out_of_reach() const
  {
    std::ostringstream message;
    message << "no rectangle has a ratio of sides of " << m_aspect_ratio << ": ratios from " << m_lowest
            << " to " << m_widest << " are possible on this border";
    return {Diagnosis::WRONG_OPTION, message.str(), {}, {}};
  }

  const Chart& m_chart;
  const double m_aspect_ratio;
  const int m_size;
  std::vector<double> m_arc; // from the first vertex of the border to each of them
  std::optional<Rectangle_ratio> m_ratio;
  int m_last_first_corner = 0;
  double m_lowest = (std::numeric_limits<double>::infinity)(), m_widest = 0;
  Corners m_best = {0, 0, 0, 0};
  double m_best_ratio = 0;
  double m_best_deviation = (std::numeric_limits<double>::infinity)();
  double m_best_coarseness = 0;
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
