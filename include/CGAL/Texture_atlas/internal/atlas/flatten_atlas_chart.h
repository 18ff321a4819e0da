// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Decides which map a chart of an atlas gets: that of ABF++, direct or hierarchical, or an injective one if that
// overlaps itself. `part_atlas_builder.h` calls it for each disk that the seams leave.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_ATLAS_CHART_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_ATLAS_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/atlas_options.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_directly.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_hierarchically.h>
#endif

namespace CGAL::Texture_atlas::internal {

// A map of a disk, in the units of the surface
struct Chart_map
{
  std::vector<Chart::Point_2> uv; // of each vertex; empty if there is none
  Atlas_report::Method method = Atlas_report::ABF_PLUS_PLUS;
  bool overlaps = false;     // parts of the disk in the plane
  bool is_isometric = false; // as far as possible, rather than conformal
  bool is_hopeless = false;  // no map is worth the time: the surface should be divided
  bool overlap_is_predicted = false;
  Atlas_report::Seam_lengths seam_lengths = Atlas_report::OTHER_METHOD;
  double contact = 0;
  Diagnosis status = Diagnosis::NOTHING_WRONG;
  std::string message;

  std::shared_ptr<const Chart_map> overlapping; // that of ABF++, if this one is injective instead

  bool is_valid() const { return !uv.empty(); }
};

// Around handles, equal lengths can cost much. A map keeps them if its energy is at most this many times that of free
// lengths.
inline constexpr double largest_price_of_equal_seams = 1.1;

// Around more handles, equal lengths take most of the time. If the map with free lengths overlaps itself, the map with
// equal lengths nearly always does too.
inline constexpr int many_loops = 32;

// Flattens disks in the way that is best for an atlas.
class Atlas_chart_flattener
{
  struct Coarse_map_overlaps
  {};

public:
  Atlas_chart_flattener(const Atlas_settings& options, const Linear_solvers& solvers,
                        Flattening_visitor* visitor)
      : m_options(options), m_solvers(solvers), m_visitor(visitor)
  {}

  // The map of ABF++ if it does not overlap itself and was not predicted to, and otherwise an injective map. If there
  // is no injective map, the overlapping one.
  Chart_map run(const Chart& chart) const
  {
    if(m_options.keeps_distance)
      return injective_map(chart);
    const bool is_predicted = overlap_is_predicted(chart);
    Chart_map map = is_predicted ? overlap_without_map() : abf_plus_plus(chart, m_options.separate_overlaps);
    if(map.is_valid() && (!map.overlaps || m_options.separate_overlaps))
      return map;
    const bool is_locked = is_hopeless(chart);
    if(is_locked && chart.number_of_triangles() > largest_isometric_chart)
      return hopeless_map();
    Chart_map injective = is_locked || m_options.is_isometric ? isometric_map(chart) : injective_map(chart);
    if(injective.is_valid()) {
      injective.overlap_is_predicted = is_predicted;
      if(map.is_valid())
        injective.overlapping = std::make_shared<const Chart_map>(std::move(map));
      return injective;
    }
    if(!map.is_valid() && map.overlaps)
      map = abf_plus_plus(chart, true);
    return map.is_valid() ? map : injective;
  }

  // If the map must not overlap, a large chart is given up as soon as the map of its coarse chart overlaps: the fine
  // one rarely differs.
  Chart_map abf_plus_plus(const Chart& chart, bool may_overlap) const
  {
    if(chart.number_of_triangles() > largest_direct_chart)
      return hierarchical_map(chart, may_overlap);
    return m_options.equal_seam_lengths ? direct_map_with_equal_seams(chart)
                                        : direct_map(chart, Atlas_report::NOT_WANTED);
  }

  Chart_map injective_map(const Chart& chart) const { return injective_map(chart, m_options.area_weight); }

  // Injective, and as isometric as possible; from an injective map, if one is given
  Chart_map isometric_map(const Chart& chart, const std::vector<Chart::Point_2>* start = nullptr) const
  {
    Chart_map map = injective_map(chart, isometric_weight, start);
    map.is_isometric = true;
    return map;
  }

  bool keeps_areas() const { return m_options.is_isometric || m_options.area_weight >= isometric_weight; }

private:
  // Several charts take less time than a larger one whose border has so many bends, and fill a page better.
  static constexpr int largest_isometric_chart = 100000;

  Chart_map injective_map(const Chart& chart, double area_weight,
                          const std::vector<Chart::Point_2>* start = nullptr) const
  {
    Hierarchical_options options = hierarchical_options(m_options, true);
    options.area_weight = area_weight;
    options.visitor = m_visitor;
    const auto no_solver = [](const Chart&) { return std::optional<std::vector<Chart::Point_2>>(); };
    return result(flatten_chart_hierarchically(chart, options, no_solver, m_solvers, &leave_as_it_is, start),
                  Atlas_report::INJECTIVE, other_lengths());
  }

  // Whether the injective map of a coarse copy of a large chart is already bad. On surfaces with many handles, the
  // border gets stuck everywhere.
  bool is_hopeless(const Chart& chart) const
  {
    const int least_triangles = 20000;
    const double bound = m_options.stretch_bound;
    if(chart.number_of_triangles() < least_triangles || m_options.separate_overlaps || keeps_areas() ||
       !std::isfinite(bound))
      return false;
    const Chart coarse = coarse_copy(chart, chart.number_of_vertices() / 15);
    const Chart_map map = injective_map(coarse);
    return !map.is_valid() || map_stretch(coarse, map.uv).is_mendable(bound);
  }

  // Whether the map of a coarse copy overlaps itself. The map of the chart rarely differs, and takes several times as
  // long.
  bool overlap_is_predicted(const Chart& chart) const
  {
    const int vertices_of_copy = 600, least_vertices = 4 * vertices_of_copy;
    if(m_options.separate_overlaps || chart.number_of_vertices() < least_vertices ||
       chart.number_of_triangles() > largest_direct_chart)
      return false;
    const Flattening<ABF_plus_plus_report> map = direct_flattening(coarse_copy(chart, vertices_of_copy));
    return map.succeeded() && !map.report.border_is_simple;
  }

  Chart coarse_copy(const Chart& chart, int number_of_vertices) const
  {
    Chart fine = chart;
    Coarsening coarsening(fine);
    coarsening.coarsen(number_of_vertices, Hierarchical_options().extreme_angle, m_visitor);
    return coarsening.coarse_chart().chart;
  }

  // Of a chart whose coarse copy overlaps itself
  static Chart_map overlap_without_map()
  {
    Chart_map map;
    map.overlaps = true;
    return map;
  }

  static Chart_map hopeless_map()
  {
    Chart_map map;
    map.is_hopeless = true;
    map.status = Diagnosis::OVERLAPPING;
    map.message = "the map overlaps itself, and its border has too many bends for an injective map";
    return map;
  }

  // Without equal lengths if they cannot be reached
  Chart_map direct_map_with_equal_seams(const Chart& chart) const
  {
    Chart equal = chart;
    if(equalize_seams(equal))
      return direct_map(chart, Atlas_report::NO_EQUATIONS);
    if(!equal.equal_seams)
      return direct_map(chart, Atlas_report::NO_SEAMS);
    std::optional<Flattening<ABF_plus_plus_report>> free;
    if(equal.number_of_loops > many_loops && !m_options.separate_overlaps) {
      free = direct_flattening(chart);
      if(!free->succeeded() || !free->report.border_is_simple)
        return result(*std::move(free), Atlas_report::ABF_PLUS_PLUS, Atlas_report::NOT_TRIED);
    }
    ABF_plus_plus_options options = direct_options(m_options);
    options.visitor = m_visitor;
    options.fallbacks = false; // they are for charts without any other map
    Flattening<ABF_plus_plus_report> map = flatten_chart(equal, options, m_solvers, &leave_as_it_is);
    const bool is_found = map.succeeded() && map.report.converged;
    if(!free &&
       (!is_found || equal.number_of_loops > 0)) // without loops, equal lengths change the energy little
      free = direct_flattening(chart);
    if(!is_found)
      return result(*std::move(free), Atlas_report::ABF_PLUS_PLUS, Atlas_report::NOT_CONVERGED);
    if(free && free->succeeded() && map.report.energy > largest_price_of_equal_seams * free->report.energy)
      return result(*std::move(free), Atlas_report::ABF_PLUS_PLUS, Atlas_report::TOO_MUCH_DISTORTION);
    return result(std::move(map), Atlas_report::ABF_PLUS_PLUS, Atlas_report::EQUAL_LENGTHS);
  }

  Chart_map direct_map(const Chart& chart, Atlas_report::Seam_lengths seam_lengths) const
  {
    return result(direct_flattening(chart), Atlas_report::ABF_PLUS_PLUS, seam_lengths);
  }

  Flattening<ABF_plus_plus_report> direct_flattening(const Chart& chart) const
  {
    ABF_plus_plus_options options = direct_options(m_options);
    options.visitor = m_visitor;
    return flatten_chart(chart, options, m_solvers, &leave_as_it_is);
  }

  Chart_map hierarchical_map(const Chart& chart, bool may_overlap) const
  {
    ABF_plus_plus_options direct = direct_options(m_options);
    Hierarchical_options options = hierarchical_options(m_options, false);
    options.visitor = m_visitor;
    const Coarse_flattening flatten_coarse =
        [&](const Chart& coarse) -> std::optional<std::vector<Chart::Point_2>> {
      Flattening<ABF_plus_plus_report> map = flatten_chart(coarse, direct, m_solvers, &leave_as_it_is);
      if(!map.succeeded())
        return std::nullopt;
      if(!map.report.border_is_simple && !may_overlap)
        throw Coarse_map_overlaps();
      return std::move(map.uv);
    };
    try {
      return result(flatten_chart_hierarchically(chart, options, flatten_coarse, m_solvers, &leave_as_it_is),
                    Atlas_report::HIERARCHICAL, other_lengths());
    } catch(const Coarse_map_overlaps&) {
      return overlap_without_map();
    }
  }

  Atlas_report::Seam_lengths other_lengths() const
  {
    return m_options.equal_seam_lengths ? Atlas_report::OTHER_METHOD : Atlas_report::NOT_WANTED;
  }

  template <typename Report>
  static Chart_map result(Flattening<Report> flattening, Atlas_report::Method method,
                          Atlas_report::Seam_lengths seam_lengths)
  {
    Chart_map map;
    map.method = method;
    map.seam_lengths = seam_lengths;
    map.status = flattening.report.status;
    map.message = std::move(flattening.report.message);
    map.contact = flattening.report.contact;
    if(flattening.succeeded()) {
      map.overlaps = !flattening.report.border_is_simple;
      map.uv = std::move(flattening.uv);
    }
    return map;
  }

  // The final coordinates are rounded and certified later, when they are packed.
  static void leave_as_it_is(std::vector<Chart::Point_2>&) {}

  const Atlas_settings& m_options;
  const Linear_solvers& m_solvers;
  Flattening_visitor* m_visitor;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_ATLAS_CHART_H
