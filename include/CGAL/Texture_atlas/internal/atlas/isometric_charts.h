// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Gives the charts of an atlas maps that are as isometric as possible, in place of those that keep angles.
// `build_atlas_impl.h` runs it on all charts, when no further seams come. Maps come from `flatten_disk.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ISOMETRIC_CHARTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ISOMETRIC_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/atlas_progress.h>
#include <CGAL/Texture_atlas/internal/atlas/flatten_disk.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Gives the pieces of atlases maps that are as isometric as possible.
class Isometric_charts
{
  struct Task
  {
    std::size_t part;
    int number; // in its part
    std::vector<int> triangles;
  };

public:
  // The work on part `i` is number `parts.size() + i` of the progress.
  Isometric_charts(const std::vector<Surface_part>& parts, const Chart_options& options,
                   const Linear_solvers& solvers, Atlas_progress& progress, std::vector<Part_atlas>& atlases)
      : m_parts(parts), m_options(options), m_solvers(solvers), m_progress(progress), m_atlases(atlases),
        m_finished(parts.size())
  {}

  // In parallel, the largest pieces first
  void run()
  {
    std::vector<Task> pieces;
    for(std::size_t i = 0; i < m_parts.size(); ++i) {
      int number = 0;
      if(m_atlases[i].succeeded())
        for(std::vector<int>& triangles : triangles_by_piece(m_atlases[i].piece))
          pieces.push_back({i, number++, std::move(triangles)});
      else
        progress_of(i, 1);
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Task& p, const Task& q) { return p.triangles.size() > q.triangles.size(); });
    parallel_for(static_cast<int>(pieces.size()), [&](int k) { map(pieces[k]); });
  }

private:
  // A map that stretches less than this counts as isometric.
  static constexpr double isometric_stretch = 1.001;

  Part_progress progress_of(std::size_t part, double share)
  {
    Part_progress progress(m_progress, m_parts.size() + part);
    progress.set_stage(share, share);
    return progress;
  }

  void map(Task& piece)
  {
    const int all = m_parts[piece.part].chart.number_of_triangles();
    const int size = static_cast<int>(piece.triangles.size());
    Part_progress progress = progress_of(piece.part, static_cast<double>(m_finished[piece.part]) / all);
    map(piece, Disk_flattener(m_options, m_solvers, &progress));
    progress_of(piece.part, static_cast<double>(m_finished[piece.part] += size) / all);
  }

  // Takes the isometric map if it stretches the piece less than the map that it starts from.
  void map(Task& piece, const Disk_flattener& flattener)
  {
    Part_atlas& atlas = m_atlases[piece.part];
    if(atlas.pieces[piece.number].method == Atlas_report::GIVEN)
      return;
    const std::vector<double>& cost = m_parts[piece.part].cost;
    const Piece disk = cut_out(atlas.chart, cost, std::move(piece.triangles));
    const std::vector<Chart::Point_2> uv = disk.map_from(atlas.uv);
    const double before = map_stretch(disk.chart, uv).l2;
    if(before < isometric_stretch || diagnose(disk.chart, false))
      return;
    const Chart_map result = flattener.isometric_map(disk.chart, &uv);
    const Disk_map* const map = std::get_if<Disk_map>(&result);
    if(map == nullptr || map->overlaps || map_stretch(disk.chart, map->uv).l2 >= before)
      return;
    for(std::size_t v = 0; v < map->uv.size(); ++v)
      atlas.uv[disk.origin[v]] = map->uv[v];
    Atlas_report::Chart& made = atlas.pieces[piece.number];
    made.method = map->made.method;
    made.seam_lengths = map->made.seam_lengths;
    made.contact = map->made.contact;
  }

  const std::vector<Surface_part>& m_parts;
  const Chart_options& m_options;
  const Linear_solvers& m_solvers;
  Atlas_progress& m_progress;
  std::vector<Part_atlas>& m_atlases;
  std::vector<std::atomic<int>> m_finished; // of each part: the triangles of its finished pieces
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_ISOMETRIC_CHARTS_H
