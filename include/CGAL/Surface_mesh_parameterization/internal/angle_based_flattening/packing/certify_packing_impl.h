// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The check that no two charts of an atlas come nearer than the gutter: it draws all of them again, texel by texel.
// `pack_impl.h` includes it. `pack_mesh.h` and `atlas/build_atlas_impl.h` call `certify_packing()` on the coordinates
// as they are written.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_CERTIFY_PACKING_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_CERTIFY_PACKING_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/pack.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/packing.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/read_outlines.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/texel_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/visit_texels.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Draws chart after chart, and tests whether each is far enough from all earlier charts.
class Packing_certifier
{
public:
  Packing_certifier(const std::vector<Planar_point>& corners, int resolution, int gutter)
      : m_corners(corners), m_resolution(resolution), m_gutter(gutter), m_border((gutter + 1) / 2),
        m_taken(resolution + 2 * gutter, resolution + 2 * gutter)
  {}

  // The first triangle that is outside of the square, or -1
  int triangle_outside() const
  {
    for(int t = 0; t < static_cast<int>(m_corners.size()) / 3; ++t)
      for(const Planar_point& p : texels(t))
        if(!(p.minCoeff() >= m_border + 4 * rounding_tolerance &&
             p.maxCoeff() <= m_resolution - m_border - 4 * rounding_tolerance))
          return t;
    return -1;
  }

  // The first triangle of a chart that is too near to earlier charts, or -1
  int add(const int* begin, const int* end)
  {
    Planar_point lower(m_resolution, m_resolution), upper(0, 0);
    for(const int* t = begin; t != end; ++t)
      for(const Planar_point& p : texels(*t)) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
      }
    if(begin == end)
      return -1;
    const int x = static_cast<int>(lower.x() - 3 * rounding_tolerance),
              y = static_cast<int>(lower.y() - 3 * rounding_tolerance);
    Texel_mask mask(static_cast<int>(upper.x() + 3 * rounding_tolerance) + 1 - x,
                    static_cast<int>(upper.y() + 3 * rounding_tolerance) + 1 - y);
    for(const int* t = begin; t != end; ++t) {
      bool is_free = true;
      visit_texels(texels(*t), rounding_tolerance, [&](int row, int first, int last) {
        mask.add(first - x, last + 1 - x, row - y);
        is_free = is_free && !m_taken.has_any(first + m_gutter, last + 1 + m_gutter, row + m_gutter);
      });
      if(!is_free)
        return *t;
    }
    m_taken.add(dilated(mask, m_gutter), x, y);
    return -1;
  }

private:
  std::array<Planar_point, 3> texels(int t) const
  {
    return {m_corners[3 * t] * m_resolution, m_corners[3 * t + 1] * m_resolution,
            m_corners[3 * t + 2] * m_resolution};
  }

  const std::vector<Planar_point>& m_corners;
  const int m_resolution, m_gutter, m_border;
  Texel_mask m_taken; // with the gutter, by which it is larger on all sides
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Packing_check certify_packing(const std::vector<Planar_point>& corners,
                                                                 const std::vector<int>& chart,
                                                                 int number_of_charts, int resolution,
                                                                 int gutter)
{
  Packing_certifier certifier(corners, resolution, gutter);
  if(const int t = certifier.triangle_outside(); t >= 0)
    return {Packing_check::OUTSIDE, t};
  const Triangles_of_charts triangles(chart, number_of_charts);
  for(int c = 0; c < number_of_charts; ++c)
    if(const int t = certifier.add(triangles.begin(c), triangles.end(c)); t >= 0)
      return {Packing_check::SHARED_TEXEL, t};
  return {};
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_CERTIFY_PACKING_IMPL_H
