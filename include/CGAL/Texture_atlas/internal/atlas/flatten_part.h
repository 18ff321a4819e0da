// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a connected surface to disks and flattens them. Adds seams, or weight for areas, until the map stretches little
// enough. `divide_part.h` calls it for the whole surface, and for each piece that it divides it into. Maps come from
// `flatten_disk.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_PART_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_PART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/atlas_progress.h>
#include <CGAL/Texture_atlas/internal/atlas/flatten_disk.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/reduce_stretch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/patch_layouts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>
#include <CGAL/Texture_atlas/internal/overlaps/separate_overlaps.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Whether a part has no charts because a computation failed, rather than because it cannot be cut to a disk
inline bool is_failure_of_computation(Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Diagnosis::LINEAR_SYSTEM_FAILED:
  case Diagnosis::NO_CONVERGENCE:
  case Diagnosis::FLIPPED_TRIANGLES:
  case Diagnosis::OVERLAPPING:
  case Diagnosis::SCALE_TOO_LARGE:
  case Diagnosis::PRECISION_EXCEEDED:
    return true;
  default:
    return false;
  }
}

// Cuts a connected surface open and flattens it, with more seams as long as the map stretches too much. If there is no
// map, or the chart is not good, areas get a larger weight.
class Part_flattener
{
public:
  // `cost` is that of the edge that each corner of the surface faces.
  Part_flattener(const Chart& surface, const std::vector<double>& cost, const Chart_options& options,
                 const Linear_solvers& solvers, const Part_progress& progress)
      : m_surface(surface), m_cost(cost), m_options(options), m_solvers(solvers), m_progress(progress),
        m_flattener(options, solvers, &m_progress)
  {}

  Part_atlas run()
  {
    if(has_no_area())
      return failure(Diagnosis::NO_AREA,
                     "the part of the surface with " + vertex_text(m_surface, 0) + " has no area");
    if(take_flat_surface())
      return result();
    m_progress.set_stage(0, 0.1);
    Seams seams = find_seams(m_surface, m_cost, m_options, m_solvers);
    if(seams.status != Seams::DONE)
      return failure(seams.status);
    m_best.is_seam = std::move(seams.is_seam);
    m_terminals = seams.terminals.size();
    m_progress.set_stage(0.1, 0.5);
    flatten(m_best);
    keep_areas();
    if(const No_map* none = std::get_if<No_map>(&m_best.map))
      return failure(none->status, none->message);
    m_progress.set_stage(0.5, 0.9);
    if(!best_map().is_isometric())
      add_seams();
    avoid_stretch();
    m_progress.set_stage(0.9, 1);
    return best_map().overlaps ? separated() : result();
  }

private:
  struct Attempt
  {
    std::vector<char> is_seam; // of each corner of the surface: whether the edge that it faces is a seam
    Piece disk;                // the surface, opened there
    Chart_map map;
    Map_stretch stretch; // if there is a map
  };

  Disk_map& best_map() { return std::get<Disk_map>(m_best.map); }

  bool has_no_area() const
  {
    for(int t = 0; t < m_surface.number_of_triangles(); ++t)
      if(surface_area(m_surface, t) > 0)
        return false;
    return true;
  }

  // A flat surface keeps its holes: as it lies in its plane, it is a map of its own. Returns whether it is flat, has
  // holes, and does not overlap itself.
  bool take_flat_surface()
  {
    if(m_surface.number_of_holes() == 0 || m_options.keeps_distance)
      return false;
    std::vector<int> all(m_surface.number_of_triangles());
    std::iota(all.begin(), all.end(), 0);
    const Flat_layout layout(m_surface, all);
    if(!layout.is_flat())
      return false;
    Piece whole = cut_out(m_surface, m_cost, std::move(all));
    const Chart& chart = whole.chart;
    Disk_map map;
    map.made.seam_lengths = Atlas_report::OTHER_METHOD;
    for(const Chart::Point_3& p : chart.points)
      map.uv.push_back(layout(p));
    scale_to_surface_area(chart, map.uv);
    const std::vector<Exact_point_2> uv = exact_points(map.uv);
    if(!flipped_triangles(chart.vertex, uv).empty() || !bounds_region(border_edges(chart), uv))
      return false;
    m_best.disk = std::move(whole);
    m_best.map = std::move(map);
    return true;
  }

  void flatten(Attempt& attempt) const
  {
    attempt.disk = opened_along_seams(m_surface, m_cost, attempt.is_seam);
    const Chart& chart = attempt.disk.chart;
    if(const Chart_defect defect = diagnose(chart, false))
      attempt.map = No_map{No_map::FAILED, defect.status, defect.message};
    else
      take(m_flattener.run(chart), attempt);
  }

  static void take(Chart_map map, Attempt& attempt)
  {
    attempt.map = std::move(map);
    if(const Disk_map* found = std::get_if<Disk_map>(&attempt.map))
      attempt.stretch = map_stretch(attempt.disk.chart, found->uv);
  }

  // Whether another map of the disk might be better if areas count as much as angles
  bool wants_areas() const
  {
    if(m_options.separate_overlaps || m_flattener.keeps_areas())
      return false;
    if(const No_map* none = std::get_if<No_map>(&m_best.map))
      return none->reason != No_map::HOPELESS && is_failure_of_computation(none->status);
    return !std::get<Disk_map>(m_best.map).is_isometric() &&
           m_best.stretch.is_mendable(m_options.stretch_bound);
  }

  // Pieces of maps of ABF++ keep their angles.
  void keep_areas()
  {
    if(!wants_areas())
      return;
    Chart_map map = m_flattener.isometric_map(m_best.disk.chart);
    Disk_map* const found = std::get_if<Disk_map>(&map);
    if(found == nullptr)
      return;
    if(const Disk_map* before = std::get_if<Disk_map>(&m_best.map)) {
      if(map_stretch(m_best.disk.chart, found->uv).l2 >= m_best.stretch.l2)
        return;
      found->overlapping = before->overlapping;
    }
    take(std::move(map), m_best);
  }

  bool misses_bound(double stretch) const { return misses_stretch_bound(stretch, m_options.stretch_bound); }

  void add_seams()
  {
    m_rounds = add_seams_in_rounds(
                   m_options.stretch_bound,
                   m_surface.number_of_triangles() > largest_direct_chart
                       ? first_round(m_options.stretch_bound, m_best.stretch.scale)
                       : 0,
                   [&] { return m_best.stretch.scale; },
                   [&](Stretch_criterion criterion, std::size_t count) { improve(criterion, count); })
                   .successful;
  }

  // Takes the map with more seams if it stretches less.
  void improve(Stretch_criterion criterion, std::size_t count)
  {
    const std::size_t most = static_cast<std::size_t>(m_options.maximum_number_of_terminals);
    count = (std::min)(count, most - (std::min)(most, m_terminals));
    Terminal_adder adder(m_surface, m_cost, m_best.is_seam);
    const int added = adder.add(
        vertex_scales(m_best.disk.chart, best_map().uv, m_best.disk.origin, m_surface.number_of_vertices()),
        criterion, count);
    if(added == 0)
      return;
    Attempt next;
    next.is_seam = adder.seams();
    flatten(next);
    if(!has_map(next.map) || next.stretch.scale >= m_best.stretch.scale)
      return;
    m_best = std::move(next);
    m_terminals += static_cast<std::size_t>(added);
  }

  // In an injective map, branches that get stuck between others shrink. If the map of ABF++ shrinks nothing, it is
  // separated instead.
  void avoid_stretch()
  {
    const double bound = m_options.stretch_bound;
    const auto is_wanted = [&](const Map_stretch& stretch) {
      return !stretch.is_mendable(bound) && (best_map().is_isometric() || !misses_bound(stretch.scale));
    };
    if(best_map().made.method != Atlas_report::INJECTIVE || is_wanted(m_best.stretch))
      return;
    Chart_map map =
        best_map().overlapping ? *best_map().overlapping : m_flattener.abf_plus_plus(m_best.disk.chart, true);
    if(!has_map(map) || !is_wanted(map_stretch(m_best.disk.chart, std::get<Disk_map>(map).uv)))
      return;
    m_injective = std::move(best_map());
    m_best.map = std::move(map);
  }

  Part_atlas result()
  {
    Part_atlas atlas;
    atlas.piece.assign(m_surface.number_of_triangles(), 0);
    atlas.chart = std::move(m_best.disk.chart);
    atlas.uv = std::move(best_map().uv);
    atlas.pieces = {best_map().made};
    atlas.pieces.front().rounds = m_rounds;
    atlas.number_of_terminals = m_terminals;
    return atlas;
  }

  // Cuts the map into pieces that do not overlap themselves.
  Part_atlas separated()
  {
    const Chart& chart = m_best.disk.chart;
    const Separation separation = separate_overlaps(chart, m_cost, exact_points(best_map().uv));
    if(separation.status != Separation::DONE && m_injective) {
      m_best.map = *std::move(m_injective);
      return result();
    }
    if(separation.status != Separation::DONE)
      return failure(Diagnosis::OVERLAPPING, "the map of the part of the surface with " +
                                                 vertex_text(m_surface, 0) +
                                                 " overlaps itself, and could not be separated");
    Part_atlas atlas = result();
    if(separation.number_of_pieces > 1) {
      atlas.pieces.front().method = Atlas_report::SEPARATED;
      open_along(separation.is_seam, m_cost, atlas);
    }
    return atlas;
  }

  static Part_atlas failure(Diagnosis diagnosis, const std::string& message)
  {
    Part_atlas atlas;
    atlas.status = diagnosis;
    atlas.message = message;
    return atlas;
  }

  Part_atlas failure(Seams::Status status) const
  {
    const std::string where = "the part of the surface with " + vertex_text(m_surface, 0);
    return status == Seams::NO_CUT
               ? failure(Diagnosis::NO_CUT_ALLOWED,
                         where + " cannot be cut to a disk along the edges that may become seams")
               : failure(Diagnosis::LINEAR_SYSTEM_FAILED,
                         "the linear system that predicts the scale could not be solved for " + where);
  }

  const Chart& m_surface;
  const std::vector<double>& m_cost;
  const Chart_options& m_options;
  const Linear_solvers& m_solvers;
  Part_progress m_progress;
  Disk_flattener m_flattener;
  Attempt m_best;
  std::optional<Disk_map> m_injective; // of `m_best`, if it stretches too much
  std::size_t m_terminals = 0;
  int m_rounds = 0;
};

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/seams/find_seams_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_PART_H
