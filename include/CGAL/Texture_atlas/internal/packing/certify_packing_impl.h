// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The check that no two charts of an atlas come nearer than the gutter: it draws all of them again, texel by texel,
// page by page. `pack_impl.h` includes it. `pack_mesh.h` and `atlas/build_atlas_impl.h` call `certify_packing()` on the
// coordinates as they are written.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CERTIFY_PACKING_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CERTIFY_PACKING_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/packing/read_outlines.h>
#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>
#include <CGAL/Texture_atlas/internal/packing/visit_texels.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Draws the charts of a page one after the other, and tests whether each is far enough from all earlier charts.
class Page_certifier
{
public:
  // The texels are those of the options, which have no blocks.
  Page_certifier(const std::vector<Planar_point>& corners, int page, const Packing_options& options)
      : m_corners(corners), m_page(corner_of_page(page)),
        m_size(options.resolution, options.number_of_rows()), m_gutter(options.number_of_gutter_texels()),
        m_border((m_gutter + 1) / 2),
        m_taken(options.resolution + 2 * m_gutter, options.number_of_rows() + 2 * m_gutter)
  {}

  // The first triangle of a chart that is outside of the page, or -1
  int triangle_outside(const int* begin, const int* end) const
  {
    for(const int* t = begin; t != end; ++t)
      for(const Planar_point& p : texels(*t))
        if(!(p.minCoeff() >= m_border + 4 * rounding_tolerance &&
             (m_size - p).minCoeff() >= m_border + 4 * rounding_tolerance))
          return *t;
    return -1;
  }

  // The first triangle of a chart that is too near to earlier charts, or -1
  int add(const int* begin, const int* end)
  {
    Planar_point lower = m_size, upper(0, 0);
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
  // The corner of the page is subtracted without rounding.
  std::array<Planar_point, 3> texels(int t) const
  {
    const auto texel = [&](int c) -> Planar_point { return (m_corners[c] - m_page).cwiseProduct(m_size); };
    return {texel(3 * t), texel(3 * t + 1), texel(3 * t + 2)};
  }

  const std::vector<Planar_point>& m_corners;
  const Planar_point m_page, m_size; // the corner, and the texels along the sides
  const int m_gutter, m_border;
  Texel_mask m_taken; // with the gutter, by which it is larger on all sides
};

CGAL_ANGLE_BASED_FLATTENING_INLINE Packing_check certify_packing(const std::vector<Planar_point>& corners,
                                                                 const std::vector<int>& chart,
                                                                 const std::vector<int>& page_of_chart,
                                                                 const Packing_options& options)
{
  const Packing_options blocks = in_blocks(options);
  const Triangles_of_charts triangles(chart, static_cast<int>(page_of_chart.size()));
  std::vector<int> order(page_of_chart.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return page_of_chart[a] < page_of_chart[b]; });
  std::optional<Page_certifier> certifier;
  int page = -1;
  for(int c : order) {
    if(page_of_chart[c] != page)
      certifier.emplace(corners, page = page_of_chart[c], blocks);
    if(const int t = certifier->triangle_outside(triangles.begin(c), triangles.end(c)); t >= 0)
      return {Packing_check::OUTSIDE, t};
    if(const int t = certifier->add(triangles.begin(c), triangles.end(c)); t >= 0)
      return {Packing_check::SHARED_TEXEL, t};
  }
  return {};
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CERTIFY_PACKING_IMPL_H
