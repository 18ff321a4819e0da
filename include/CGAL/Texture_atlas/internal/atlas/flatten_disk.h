// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Decides which map a chart of an atlas gets: that of ABF++, direct or hierarchical, or an injective one if that
// overlaps itself. `flatten_part.h` calls it for each disk that the seams leave.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_DISK_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_DISK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
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
#include <variant>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_directly.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_hierarchically.h>
#endif

namespace CGAL::Texture_atlas::internal {

// A map of a disk, in the units of the surface
struct Disk_map
{
  std::vector<Chart::Point_2> uv; // of each vertex
  Atlas_report::Chart made;       // how it was made
  bool overlaps = false;          // parts of the disk in the plane

  std::shared_ptr<const Disk_map> overlapping; // that of ABF++, if this one is injective instead

  // As far as possible, rather than conformal
  bool is_isometric() const { return made.strategy == Atlas_report::LARGER_AREA_WEIGHT; }
};

// Why a disk has no map
struct No_map
{
  enum Reason
  {
    FAILED,           // the computation failed
    OVERLAP_FORESEEN, // a map of a coarse copy overlaps itself, and so would this one
    HOPELESS          // and no other weight of areas is worth a try
  };

  Reason reason = FAILED;
  Diagnosis status = Diagnosis::OVERLAPPING;
  std::string message;
};

typedef std::variant<No_map, Disk_map> Chart_map;

inline bool has_map(const Chart_map& map)
{
  return std::holds_alternative<Disk_map>(map);
}

// Around handles, equal lengths can cost much. A map keeps them if its energy is at most this many times that of free
// lengths.
inline constexpr double largest_price_of_equal_seams = 1.1;

// Around more handles, equal lengths take most of the time. If the map with free lengths overlaps itself, the map with
// equal lengths nearly always does too.
inline constexpr int many_loops = 32;

// Flattens disks in the way that is best for an atlas.
class Disk_flattener
{
  typedef std::vector<Chart::Point_2> Points;

public:
  Disk_flattener(const Chart_options& options, const Linear_solvers& solvers, Flattening_visitor* visitor)
      : m_options(options), m_direct(direct_options(options)), m_solvers(solvers), m_visitor(visitor)
  {
    m_direct.visitor = visitor;
  }

  // The map of ABF++ if it does not overlap itself and was not predicted to, and otherwise an injective map. If there
  // is no injective map, the overlapping one.
  Chart_map run(const Chart& chart) const
  {
    if(m_options.keeps_distance)
      return injective_map(chart);
    const bool is_predicted = overlap_is_predicted(chart);
    Chart_map map = is_predicted ? No_map{No_map::OVERLAP_FORESEEN, Diagnosis::OVERLAPPING, ""}
                                 : abf_plus_plus(chart, m_options.separate_overlaps);
    if(const Disk_map* found = std::get_if<Disk_map>(&map);
       found != nullptr && (!found->overlaps || m_options.separate_overlaps))
      return map;
    const bool is_locked = is_hopeless(chart);
    if(is_locked && chart.number_of_triangles() > largest_isometric_chart)
      return No_map{No_map::HOPELESS, Diagnosis::OVERLAPPING,
                    "the map overlaps itself, and its border has too many bends for an injective map"};
    Chart_map injective = is_locked || m_options.is_isometric ? isometric_map(chart) : injective_map(chart);
    if(Disk_map* found = std::get_if<Disk_map>(&injective)) {
      found->made.overlap_is_predicted = is_predicted;
      if(has_map(map))
        found->overlapping = std::make_shared<const Disk_map>(std::get<Disk_map>(std::move(map)));
      return injective;
    }
    if(const No_map* none = std::get_if<No_map>(&map); none && none->reason == No_map::OVERLAP_FORESEEN)
      map = abf_plus_plus(chart, true);
    return has_map(map) ? map : injective;
  }

  // If the map must not overlap, a large chart is given up as soon as the map of its coarse chart overlaps: the fine
  // one rarely differs.
  Chart_map abf_plus_plus(const Chart& chart, bool may_overlap) const
  {
    if(chart.number_of_triangles() > largest_direct_chart)
      return hierarchical_map(chart, may_overlap);
    if(m_options.equal_seam_lengths)
      return direct_map_with_equal_seams(chart);
    return result(flatten_chart(chart, m_direct, m_solvers, &leave_as_it_is), Atlas_report::ABF_PLUS_PLUS,
                  Atlas_report::NOT_WANTED);
  }

  // Injective, and as isometric as possible; from an injective map, if one is given
  Chart_map isometric_map(const Chart& chart, const Points* start = nullptr) const
  {
    Chart_map map = injective_map(chart, isometric_weight, start);
    if(Disk_map* found = std::get_if<Disk_map>(&map))
      found->made.strategy = Atlas_report::LARGER_AREA_WEIGHT;
    else
      std::get<No_map>(map).reason = No_map::HOPELESS;
    return map;
  }

  bool keeps_areas() const { return m_options.is_isometric || m_options.area_weight >= isometric_weight; }

private:
  // Several charts take less time than a larger one whose border has so many bends, and fill a page better.
  static constexpr int largest_isometric_chart = 100000;

  Chart_map injective_map(const Chart& chart) const { return injective_map(chart, m_options.area_weight); }

  Chart_map injective_map(const Chart& chart, double area_weight, const Points* start = nullptr) const
  {
    Hierarchical_options options = hierarchical_options(m_options, true);
    options.area_weight = area_weight;
    options.visitor = m_visitor;
    const auto no_solver = [](const Chart&) { return std::optional<Points>(); };
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
    return !has_map(map) || map_stretch(coarse, std::get<Disk_map>(map).uv).is_mendable(bound);
  }

  // Whether the map of a coarse copy overlaps itself. The map of the chart rarely differs, and takes several times as
  // long.
  bool overlap_is_predicted(const Chart& chart) const
  {
    const int vertices_of_copy = 600, least_vertices = 4 * vertices_of_copy;
    if(m_options.separate_overlaps || chart.number_of_vertices() < least_vertices ||
       chart.number_of_triangles() > largest_direct_chart)
      return false;
    const auto map =
        flatten_chart(coarse_copy(chart, vertices_of_copy), m_direct, m_solvers, &leave_as_it_is);
    return map.succeeded() && !map.report.border_is_simple;
  }

  Chart coarse_copy(const Chart& chart, int number_of_vertices) const
  {
    Chart fine = chart;
    Coarsening coarsening(fine);
    coarsening.coarsen(number_of_vertices, Hierarchical_options().extreme_angle, m_visitor);
    return coarsening.coarse_chart().chart;
  }

  // Without equal lengths if they cannot be reached
  Chart_map direct_map_with_equal_seams(const Chart& chart) const
  {
    Chart equal = chart;
    if(equalize_seams(equal))
      return result(flatten_chart(chart, m_direct, m_solvers, &leave_as_it_is), Atlas_report::ABF_PLUS_PLUS,
                    Atlas_report::NO_EQUATIONS);
    if(!equal.equal_seams)
      return result(flatten_chart(chart, m_direct, m_solvers, &leave_as_it_is), Atlas_report::ABF_PLUS_PLUS,
                    Atlas_report::NO_SEAMS);
    std::optional<Flattening<ABF_plus_plus_report>> free;
    if(equal.number_of_loops > many_loops && !m_options.separate_overlaps) {
      free = flatten_chart(chart, m_direct, m_solvers, &leave_as_it_is);
      if(!free->succeeded() || !free->report.border_is_simple)
        return result(*std::move(free), Atlas_report::ABF_PLUS_PLUS, Atlas_report::NOT_TRIED);
    }
    ABF_plus_plus_options options = m_direct;
    options.fallbacks = false; // they are for charts without any other map
    Flattening<ABF_plus_plus_report> map = flatten_chart(equal, options, m_solvers, &leave_as_it_is);
    const bool is_found = map.succeeded() && map.report.converged;
    if(!free &&
       (!is_found || equal.number_of_loops > 0)) // without loops, equal lengths change the energy little
      free = flatten_chart(chart, m_direct, m_solvers, &leave_as_it_is);
    if(!is_found)
      return result(*std::move(free), Atlas_report::ABF_PLUS_PLUS, Atlas_report::NOT_CONVERGED);
    if(free && free->succeeded() && map.report.energy > largest_price_of_equal_seams * free->report.energy)
      return result(*std::move(free), Atlas_report::ABF_PLUS_PLUS, Atlas_report::TOO_MUCH_DISTORTION);
    return result(std::move(map), Atlas_report::ABF_PLUS_PLUS, Atlas_report::EQUAL_LENGTHS);
  }

  Chart_map hierarchical_map(const Chart& chart, bool may_overlap) const
  {
    const ABF_plus_plus_options direct = direct_options(m_options);
    Hierarchical_options options = hierarchical_options(m_options, false);
    options.visitor = m_visitor;
    const auto flatten_coarse = [&](const Chart& coarse) -> Coarse_map {
      Flattening<ABF_plus_plus_report> map = flatten_chart(coarse, direct, m_solvers, &leave_as_it_is);
      if(!map.succeeded()) {
        Coarse_map none(std::nullopt);
        none.message = std::move(map.report.message);
        return none;
      }
      if(!map.report.border_is_simple && !may_overlap)
        return {std::nullopt, Diagnosis::OVERLAPPING};
      return {std::move(map.uv)};
    };
    Chart_map map =
        result(flatten_chart_hierarchically(chart, options, flatten_coarse, m_solvers, &leave_as_it_is),
               Atlas_report::HIERARCHICAL, other_lengths());
    if(No_map* none = std::get_if<No_map>(&map); none && none->status == Diagnosis::OVERLAPPING)
      none->reason = No_map::OVERLAP_FORESEEN;
    return map;
  }

  Atlas_report::Seam_lengths other_lengths() const
  {
    return m_options.equal_seam_lengths ? Atlas_report::OTHER_METHOD : Atlas_report::NOT_WANTED;
  }

  template <typename Report>
  static Chart_map result(Flattening<Report> flattening, Atlas_report::Method method,
                          Atlas_report::Seam_lengths seam_lengths)
  {
    if(!flattening.succeeded())
      return No_map{No_map::FAILED, flattening.report.status, std::move(flattening.report.message)};
    Disk_map map;
    map.uv = std::move(flattening.uv);
    map.made.method = method;
    map.made.seam_lengths = seam_lengths;
    map.made.contact = flattening.report.contact;
    map.overlaps = !flattening.report.border_is_simple;
    return map;
  }

  // The final coordinates are rounded and certified later, when they are packed.
  static void leave_as_it_is(Points&) {}

  const Chart_options& m_options;
  ABF_plus_plus_options m_direct; // of the direct method
  const Linear_solvers& m_solvers;
  Flattening_visitor* m_visitor;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FLATTEN_DISK_H
