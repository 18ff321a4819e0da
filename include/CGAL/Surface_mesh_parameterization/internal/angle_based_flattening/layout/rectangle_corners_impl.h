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
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Looks at rectangles whose first and third corner are half the length of the border apart. As the second corner moves
// away from the first and the fourth from the third, the rectangle becomes wider. Of all rectangles that are estimated
// to be as near to the wanted ratio, the search takes one where the border is fine at the corners, so that angles change
// little. Harmonic functions then predict its ratio, and the search is repeated with the estimate corrected.
class Rectangle_search
{
  static constexpr double small_deviation = 0.01; // of logarithms
  static constexpr int most_first_corners = 64, most_corrections = 6;

public:
  Rectangle_search(const Chart& chart, double aspect_ratio, const Linear_solvers& solvers)
      : m_wanted(aspect_ratio), m_size(static_cast<int>(chart.borders.front().size())),
        m_harmonic(chart, solvers)
  {
    m_arc.push_back(0); // edges without length have a little, so that there is nothing to divide by 0
    for(int c : chart.borders.front())
      m_arc.push_back(m_arc.back() + edge_length(chart, c) + 1e-9);
    m_opposite = (std::min)((std::max)(rank_at(m_arc.back() / 2), 2), m_size - 2);
    m_estimate = Ratio_estimate::make(m_harmonic, m_opposite);
  }

  Rectangle_corners run()
  {
    Rectangle_corners result;
    if(!m_estimate)
      return failure(Diagnosis::LINEAR_SYSTEM_FAILED, "the linear solver failed");
    const double aspect_ratio = m_wanted;
    const auto deviation = [&](double ratio) { return std::abs(std::log(ratio) - std::log(aspect_ratio)); };
    for(int i = 0; i <= most_corrections && (i == 0 || deviation(result.aspect_ratio) > small_deviation);
        ++i) {
      search();
      const std::optional<double> ratio = m_harmonic.ratio(m_best);
      if(!ratio)
        return failure(Diagnosis::LINEAR_SYSTEM_FAILED, "the linear solver failed");
      if(i == 0 || deviation(*ratio) < deviation(result.aspect_ratio)) {
        for(int k = 0; k < 4; ++k)
          result.vertices[k] = m_harmonic.border_vertex(m_best[k]);
        result.aspect_ratio = *ratio;
      }
      m_wanted *= std::sqrt(aspect_ratio / *ratio); // half of the way, since neighbours differ by more
    }
    if(deviation(result.aspect_ratio) > small_deviation &&
       (m_wanted < m_lowest || m_wanted > m_widest)) // no other rectangle is nearer
      return out_of_reach(aspect_ratio, result.aspect_ratio);
    return result;
  }

private:
  void search()
  {
    m_best_deviation = (std::numeric_limits<double>::infinity)();
    const int step = (std::max)(m_opposite / most_first_corners, 1);
    for(int first = 0; first < m_opposite; first += step)
      search_with(first);
    // The third corner could as well be the first one: it is the one that comes first on the border.
    if(m_best[2] < m_best[0])
      std::rotate(m_best.begin(), m_best.begin() + 2, m_best.end());
  }

  // The rank of the vertex nearest to a position on the border
  int rank_at(double arc) const
  {
    arc = std::fmod(arc, m_arc.back());
    const auto next = std::upper_bound(m_arc.begin() + 1, m_arc.end() - 1, arc);
    const int rank = static_cast<int>(next - m_arc.begin());
    return (arc - *(next - 1) < *next - arc ? rank - 1 : rank) % m_size;
  }

  void search_with(int first)
  {
    const double half = m_arc.back() / 2;
    const int third = rank_at(m_arc[first] + half);
    try_corners({first, first + 1, third, third + 1});
    try_corners({first, third - 1, third, first - 1});
    double lower = 0, upper = 1;
    Rectangle_ranks corners = {first, 0, third, 0};
    for(double width = m_arc.back(); width > m_arc.back() / m_size / 2; width /= 2) {
      const double part = (lower + upper) / 2;
      corners[1] = rank_at(m_arc[first] + part * half);
      corners[3] = rank_at(m_arc[first] + (1 + part) * half);
      const std::optional<double> ratio = try_corners(corners);
      const bool is_low = ratio ? *ratio < m_wanted : part < 0.5;
      (is_low ? lower : upper) = part;
    }
    for(int i = -2; i <= 2; ++i)
      for(int j = -1; j <= 1; ++j)
        for(int k = -2; k <= 2; ++k)
          try_corners({first, corners[1] + i, corners[2] + j, corners[3] + k});
  }

  // Returns the ratio of a rectangle, and keeps the best one. Returns nothing if these are not corners of a rectangle.
  std::optional<double> try_corners(Rectangle_ranks corners)
  {
    for(int& c : corners)
      c = (c + m_size) % m_size;
    const auto steps = [&](int i) { return (corners[i] - corners[0] + m_size) % m_size; };
    if(!(0 < steps(1) && steps(1) < steps(2) && steps(2) < steps(3)))
      return std::nullopt;
    const double ratio = (*m_estimate)(corners);
    m_lowest = (std::min)(m_lowest, ratio);
    m_widest = (std::max)(m_widest, ratio);
    const double deviation = (std::max)(std::abs(std::log(ratio) - std::log(m_wanted)), small_deviation);
    if(deviation > m_best_deviation)
      return ratio;
    const double coarseness = m_estimate->coarseness(corners);
    if(deviation < m_best_deviation || coarseness < m_best_coarseness) {
      m_best = corners;
      m_best_deviation = deviation;
      m_best_coarseness = coarseness;
    }
    return ratio;
  }

  static Rectangle_corners failure(Diagnosis diagnosis, const std::string& message)
  {
    Rectangle_corners result;
    result.defect = {diagnosis, message, {}, {}};
    return result;
  }

  static Rectangle_corners out_of_reach(double wanted, double nearest)
  {
    std::ostringstream message;
    message << "no rectangle on this border has a ratio of sides of " << wanted
            << ": the nearest one found has " << nearest;
    return failure(Diagnosis::WRONG_OPTION, message.str());
  }

  double m_wanted; // estimate
  const int m_size;
  const Harmonic_functions m_harmonic;
  std::vector<double> m_arc; // from the first vertex of the border to each of them
  int m_opposite = 0;        // the rank of the vertex opposite of the first one
  std::optional<Ratio_estimate> m_estimate;
  double m_lowest = (std::numeric_limits<double>::infinity)(), m_widest = 0; // estimates
  Rectangle_ranks m_best = {0, 0, 0, 0};
  double m_best_deviation = 0;
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
