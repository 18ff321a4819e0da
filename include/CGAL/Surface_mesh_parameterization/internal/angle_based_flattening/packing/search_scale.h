// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SEARCH_SCALE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SEARCH_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/place_charts.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Searches the largest scale with places for all charts. That is not monotone: the largest of those that were tried counts.
class Scale_search
{
public:
  // The areas of the charts that the placer places are 1 together.
  Scale_search(const Chart_placer& placer, int number_of_charts, double largest_length, int resolution)
      : m_placer(placer), m_charts(number_of_charts), m_resolution(resolution),
        m_least(least_extent / largest_length)
  {}

  // Returns whether there is one.
  bool run()
  {
    double scale = (std::max)(scale_of_needed_share(0.8), m_least);
    double above = scale;
    if(attempt(scale))
      for(double step = first_step; above <= m_scale; step *= 2) {
        above = (std::min)((1 + step) * m_scale, 1. * m_resolution);
        if(above <= m_scale || attempt(above))
          above = m_scale;
        if(m_scale >= m_resolution)
          return true;
      }
    else
      for(double step = first_step; m_places.empty(); step *= 2) {
        if(scale == m_least)
          return false;
        above = scale;
        scale = (std::max)(scale / (1 + step), m_least);
        attempt(scale);
      }
    while(above > precision * m_scale)
      if(const double middle = std::sqrt(above * m_scale); !attempt(middle))
        above = middle;
    return true;
  }

  double scale() const { return m_scale; } // the texels of the length 1
  int number_of_attempts() const { return m_attempts; }
  const std::vector<Chart_place>& places() const { return m_places; }

private:
  static constexpr double precision = 1.002, first_step = 0.06;

  bool attempt(double scale)
  {
    ++m_attempts;
    std::optional<std::vector<Chart_place>> places = m_placer.place(scale);
    if(!places)
      return false;
    m_places = std::move(*places);
    m_scale = scale;
    return true;
  }

  // The scale of which the charts need about that share of the texels; near to 0 if they always need more
  double scale_of_needed_share(double share) const
  {
    double lower = 0, upper = m_resolution;
    for(int i = 0; i < 40; ++i) {
      const double scale = (lower + upper) / 2;
      double texels = 0;
      for(int c = 0; c < m_charts; ++c)
        texels += m_placer.needed_texels(c, scale);
      (texels < share * m_resolution * m_resolution ? lower : upper) = scale;
    }
    return lower;
  }

  const Chart_placer& m_placer;
  const int m_charts, m_resolution;
  const double m_least; // of which no chart is larger than the least extent
  double m_scale = 0;
  int m_attempts = 0;
  std::vector<Chart_place> m_places;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SEARCH_SCALE_H
