// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The atlas of a connected surface: in one piece if that is good enough, otherwise of regions, whose atlases are joined
// here. `build_atlas_impl.h` calls it for each part. `divide_surface.h` finds the regions, and `part_atlas_builder.h`
// flattens them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDED_PART_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDED_PART_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/atlas_options.h>
#include <CGAL/Texture_atlas/internal/atlas/atlas_progress.h>
#include <CGAL/Texture_atlas/internal/atlas/divide_surface.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Texture_atlas/internal/atlas/part_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/part_atlas_builder.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/overlaps/minimum_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The triangles of each region
inline std::vector<std::vector<int>> triangles_of_regions(const std::vector<int>& region)
{
  std::vector<std::vector<int>> triangles(*std::max_element(region.begin(), region.end()) + 1);
  for(std::size_t t = 0; t < region.size(); ++t)
    triangles[region[t]].push_back(static_cast<int>(t));
  return triangles;
}

// Joins the atlases of all regions of a surface, in their order, to one of the surface. `triangles` are those of each
// region.
inline Part_atlas joined_atlas(const Chart& surface, const std::vector<double>& cost,
                               const std::vector<std::vector<int>>& triangles,
                               std::vector<Part_atlas> regions)
{
  Part_atlas whole;
  std::vector<char> is_seam(surface.vertex.size(), false);
  std::vector<Chart::Point_2> uv(surface.vertex.size()); // of each corner
  whole.piece.resize(surface.number_of_triangles());
  for(std::size_t r = 0; r < regions.size(); ++r) {
    const Part_atlas& region = regions[r];
    for(int c = 0; c < region.chart.number_of_corners(); ++c) {
      const int corner = 3 * triangles[r][c / 3] + c % 3;
      is_seam[corner] = region.chart.opposite[c] < 0 && surface.opposite[corner] >= 0;
      uv[corner] = region.uv[region.chart.vertex[c]];
      whole.piece[corner / 3] = static_cast<int>(whole.pieces.size()) + region.piece[c / 3];
    }
    whole.pieces.insert(whole.pieces.end(), region.pieces.begin(), region.pieces.end());
    whole.number_of_terminals += region.number_of_terminals;
  }
  std::vector<int> all(whole.piece.size());
  std::iota(all.begin(), all.end(), 0);
  whole.chart = Patch_cutter(surface, cost).cut_out(std::move(all), is_seam).chart;
  whole.uv.resize(whole.chart.points.size());
  for(int c = 0; c < whole.chart.number_of_corners(); ++c)
    whole.uv[whole.chart.vertex[c]] = uv[c];
  renumber_pieces(whole);
  return whole;
}

// Makes the atlas of a connected surface: in one piece if that is good, and else of several regions.
class Divided_part_atlas
{
public:
  // How a piece of an atlas should be divided
  struct Division
  {
    int number_of_regions = 8; // 1 if it is good
    bool is_isometric = true;  // conformal maps stretch it too much
  };

  // `cost` is that of the edge that each corner of the surface faces.
  Divided_part_atlas(const Chart& surface, const std::vector<double>& cost, const Atlas_settings& options,
                     const Linear_solvers& solvers, const Part_progress& progress)
      : m_surface(surface), m_cost(cost), m_options(options), m_solvers(solvers), m_progress(progress)
  {}

  Part_atlas run() const
  {
    Part_atlas atlas = Part_atlas_builder(m_surface, m_cost, m_options, m_solvers, m_progress).run();
    if(!atlas.succeeded()) {
      if(!is_failure_of_computation(atlas.status))
        return atlas;
      const int regions =
          (std::max)(Division().number_of_regions, m_surface.number_of_triangles() / size_of_region);
      Part_atlas divided = this->divided({regions, true});
      return divided.succeeded() ? divided : atlas;
    }
    const std::vector<Division> divisions = wanted_divisions(atlas);
    const auto is_kept = [](const Division& division) { return division.number_of_regions == 1; };
    return std::all_of(divisions.begin(), divisions.end(), is_kept) ? atlas
                                                                    : with_divided_pieces(atlas, divisions);
  }

  // Of several regions at once
  Part_atlas divided(const Division& division) const
  {
    const std::vector<std::vector<int>> triangles =
        triangles_of_regions(Surface_division(m_surface, m_cost).run(division.number_of_regions));
    if(triangles.size() < 2) {
      Part_atlas failure;
      failure.status = Diagnosis::PRECISION_EXCEEDED;
      failure.message =
          "the part of the surface with the vertex at " + position_text(m_surface, 0) + " cannot be divided";
      return failure;
    }
    Atlas_settings options = m_options;
    options.is_isometric = options.is_isometric || division.is_isometric;
    Part_atlas atlas = joined(triangles, [&](int, const Dual_patch& region) {
      return Divided_part_atlas(region.chart, region.cost, options, m_solvers, m_progress).run();
    });
    for(Atlas_piece& piece : atlas.pieces)
      piece.strategy = Atlas_report::MORE_CHARTS;
    return atlas;
  }

private:
  static constexpr int size_of_region = 50000; // at most so many triangles, if there is no map of the whole

  std::vector<Division> wanted_divisions(const Part_atlas& atlas) const
  {
    const double most = m_options.longest_chart / m_surface.scale;
    std::vector<Division> result;
    for(const Stretch_sums& sums : stretch_of_pieces(atlas)) {
      const Map_stretch stretch = sums.stretch();
      if(stretch.length > most)
        result.push_back({static_cast<int>((std::min)(std::ceil(3 * stretch.length / most), 64.)), false});
      else if(stretch.is_mendable(m_options.stretch_bound))
        result.push_back(Division());
      else
        result.push_back({1, false});
    }
    return result;
  }

  // Good pieces, and pieces that cannot be divided, stay as they are.
  Part_atlas with_divided_pieces(const Part_atlas& atlas, const std::vector<Division>& divisions) const
  {
    Part_atlas result = joined(triangles_of_regions(atlas.piece), [&](int piece, const Dual_patch& region) {
      if(divisions[piece].number_of_regions > 1) {
        Part_atlas divided = Divided_part_atlas(region.chart, region.cost, m_options, m_solvers, m_progress)
                                 .divided(divisions[piece]);
        if(divided.succeeded())
          return divided;
      }
      return piece_of_atlas(atlas, piece, region.triangles);
    });
    result.number_of_terminals += atlas.number_of_terminals;
    return result;
  }

  Part_atlas piece_of_atlas(const Part_atlas& atlas, int piece, const std::vector<int>& triangles) const
  {
    Dual_patch patch =
        Patch_cutter(atlas.chart, m_cost).cut_out(triangles, std::vector<char>(m_cost.size(), false));
    Part_atlas result;
    for(int v : patch.origin)
      result.uv.push_back(atlas.uv[v]);
    result.chart = std::move(patch.chart);
    result.piece.assign(triangles.size(), 0);
    result.pieces = {atlas.pieces[piece]};
    return result;
  }

  // Calls `make(number, region)` for all regions in parallel, and joins their atlases. If one has failed, returns its
  // failure.
  template <typename Make>
  Part_atlas joined(const std::vector<std::vector<int>>& triangles, const Make& make) const
  {
    std::vector<Part_atlas> regions(triangles.size());
    const auto make_region = [&](int r) {
      regions[r] = make(
          r, Patch_cutter(m_surface, m_cost).cut_out(triangles[r], std::vector<char>(m_cost.size(), false)));
    };
    parallel_for(static_cast<int>(regions.size()), make_region);
    for(Part_atlas& region : regions)
      if(!region.succeeded())
        return std::move(region);
    return joined_atlas(m_surface, m_cost, triangles, std::move(regions));
  }

  const Chart& m_surface;
  const std::vector<double>& m_cost;
  const Atlas_settings& m_options;
  const Linear_solvers& m_solvers;
  Part_progress m_progress;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDED_PART_ATLAS_H
