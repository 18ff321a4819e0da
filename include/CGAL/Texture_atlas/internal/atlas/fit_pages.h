// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts charts in two until each fits on a page, where the number of texels per unit of length is given.
// `build_atlas_impl.h` runs it on each part; the cuts come from `cut_along_chords.h`. The maps stay as they are.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FIT_PAGES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FIT_PAGES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/internal/atlas/cut_along_chords.h>
#include <CGAL/Texture_atlas/internal/atlas/part_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/overlaps/minimum_cut.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Cuts the charts of a part that a page cannot hold. What cannot be cut stays too large.
class Page_fitter
{
public:
  // `weight` multiplies the lengths of each triangle of the surface; empty if all are 1.
  Page_fitter(const Surface_part& part, const std::vector<double>& weight, const Packing_options& options,
              Part_atlas& atlas)
      : m_part(part), m_weight(weight), m_options(options), m_atlas(atlas)
  {}

  // The charts must be injective. Returns whether a page can hold each of them then.
  bool run()
  {
    for(;;) {
      const std::vector<int> too_large = too_large_pieces();
      if(too_large.empty())
        return true;
      const std::vector<std::vector<int>> triangles = triangles_of_pieces(m_atlas);
      Patch_cutter cutter(m_atlas.chart, m_part.cost);
      std::vector<char> is_seam(m_atlas.chart.vertex.size(), false);
      for(int piece : too_large)
        cut_in_two(cutter.cut_out(triangles[piece], std::vector<char>(is_seam.size(), false)), is_seam);
      if(std::find(is_seam.begin(), is_seam.end(), true) == is_seam.end())
        return false;
      open_along(is_seam, m_part.cost, m_atlas);
    }
  }

private:
  std::vector<int> too_large_pieces() const
  {
    std::vector<Planar_point> corners;
    std::vector<double> areas;
    for(int t = 0; t < m_atlas.chart.number_of_triangles(); ++t) {
      for(int c = 3 * t; c < 3 * t + 3; ++c) {
        const Chart::Point_2& p = m_atlas.uv[m_atlas.chart.vertex[c]];
        corners.emplace_back(p.x(), p.y());
      }
      const double weight = m_weight.empty() ? 1 : m_weight[m_part.first_triangle + t];
      areas.push_back(surface_area(m_atlas.chart, t) * weight * weight);
    }
    return charts_too_large(corners, m_atlas.piece, areas, static_cast<int>(m_atlas.pieces.size()),
                            m_options);
  }

  // Along a short chord that leaves much on both sides, or else, as around holes, from one side to the other. Marks the
  // seams of the whole chart.
  void cut_in_two(const Dual_patch& patch, std::vector<char>& is_seam) const
  {
    std::vector<Chart::Point_2> uv;
    for(int v : patch.origin)
      uv.push_back(m_atlas.uv[v]);
    double area = 0;
    for(int t = 0; t < patch.chart.number_of_triangles(); ++t)
      area += std::abs(planar_area(patch.chart, uv, t));
    std::vector<char> cut;
    Chord_cutter chords(patch.chart, uv, patch.cost, least_share * area);
    if(std::isfinite(chords.next_score())) {
      chords.cut();
      cut = chords.seams();
    } else
      cut = seams_across(patch, uv);
    for(int c = 0; c < patch.chart.number_of_corners(); ++c)
      if(cut[c] && patch.chart.opposite[c] >= 0)
        is_seam[patch.whole_corner(c)] = true;
  }

  // Between the two halves of the triangles along the longer side of their box
  static std::vector<char> seams_across(const Dual_patch& patch, const std::vector<Chart::Point_2>& uv)
  {
    const std::vector<int> group = inseparable_triangles(patch);
    const int groups = 1 + *std::max_element(group.begin(), group.end());
    Bbox_2 box;
    for(const Chart::Point_2& p : uv)
      box += p.bbox();
    const int axis = box.x_span() >= box.y_span() ? 0 : 1;
    std::vector<double> area(groups, 0), position(groups, 0);
    for(int t = 0; t < patch.chart.number_of_triangles(); ++t) {
      const double a = std::abs(planar_area(patch.chart, uv, t));
      area[group[t]] += a;
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        position[group[t]] += a * uv[patch.chart.vertex[c]][axis];
    }
    std::vector<int> order(groups);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return position[a] * area[b] < position[b] * area[a]; });
    std::vector<char> is_low(groups, false);
    double rest = std::accumulate(area.begin(), area.end(), 0.) / 2;
    for(int i = 0; i + 1 < groups && (i == 0 || rest > 0); ++i) {
      is_low[order[i]] = true;
      rest -= area[order[i]];
    }
    std::vector<char> is_seam;
    for(int c = 0; c < patch.chart.number_of_corners(); ++c) {
      const int across = patch.chart.opposite[c];
      is_seam.push_back(across >= 0 && is_low[group[c / 3]] != is_low[group[across / 3]]);
    }
    return is_seam;
  }

  static constexpr double least_share = 0.3; // of the area that a chord cuts off

  const Surface_part& m_part;
  const std::vector<double>& m_weight;
  const Packing_options& m_options;
  Part_atlas& m_atlas;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FIT_PAGES_H
