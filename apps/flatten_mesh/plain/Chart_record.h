// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHART_RECORD_H
#define FLATTEN_MESH_CHART_RECORD_H

#include "flatten_mesh/Run_record.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/Seam_report.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace TA = CGAL::Texture_atlas;

using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

// The result of the parameterizer
struct Flattening
{
  UV_map uv;
  Mesh::Property_map<Face, double> distortion; // change of the angles of each face, in degrees
  SMP::ABF_plus_plus_report report; // for the hierarchical method, the part that both methods have in common
  SMP::Hierarchical_report hierarchical;
  std::string method;                // direct or hierarchical
  bool has_equal_seams = false;      // both sides of each seam have the same lengths
  SMP::Flattening_measures measures; // only if it succeeded
  double scale_stretch = 1;        // how much areas vary in the plane, as a stretch of lengths; 1 is perfect
  std::string place;               // the vertices and faces at fault, if it failed
  std::string note;                // what else there is to say
  double attempt_seconds = 0;      // of runs that others replaced, or that were worse
  double parameterize_seconds = 0; // of all runs
  double measure_seconds = 0;

  bool succeeded() const { return bool(report); }

  void add_attempt(const Flattening& other)
  {
    attempt_seconds += other.parameterize_seconds;
    parameterize_seconds += other.parameterize_seconds;
    measure_seconds += other.measure_seconds;
  }
};

// The seams of a surface that is cut open
struct Seam_record
{
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::string cut;                      // the value of --cut, or "cones"
  std::optional<std::size_t> terminals; // if the seams were chosen for little stretch
  std::size_t disks = 1;                // the largest one is flattened
  int rounds = 0;                       // in which seams were added to a map that missed the bound
  double length = 0;                    // in units of the square root of the area
  double stretch_bound = unknown;
  double predicted_stretch = unknown;
  double scale_stretch = unknown;    // of the map
  std::optional<bool> bound_reached; // by the map, if a bound was asked for
  double seconds = 0;                // of their choice
};

// The cones through which a surface is cut
struct Cone_record
{
  std::size_t wanted = 0;
  double multiple = 0;                               // of which all angles are multiples, in radians; or 0
  std::vector<std::pair<std::size_t, double>> cones; // vertices from 0, and their angles in radians
  double predicted_stretch = 1;
};

// The pieces of a chart that was split because its map overlapped itself
struct Split_record : TA::Overlap_split_report
{
  double seconds = 0;
};

// The data of the reports on one chart, for people and for programs
struct Chart_record : Run_record
{
  std::size_t vertices = 0; // these three are of the chart
  std::size_t triangles = 0;
  std::size_t borders = 0;
  std::size_t components = 0; // of the whole mesh
  std::optional<Seam_record> seams;
  std::optional<Cone_record> cones;
  Flattening flattening;
  std::optional<Split_record> split;
  std::vector<std::size_t> corners;               // of the prescribed border: vertices from 0
  std::size_t split_edges = 0;                    // which were in the way of that border
  std::vector<TA::Atlas_report::Skipped> skipped; // faces of the file that are left out
};

// The name of a diagnosis, "OK" for none
inline std::string status_name(const SMP::Report& report)
{
  return report ? "OK" : to_string(report.status);
}

inline std::string layout_name(const SMP::ABF_plus_plus_report& report)
{
  return std::vector<std::string>{"none", "exact", "least-squares"}.at(report.layout);
}

inline Exit_status exit_status(const Chart_record& record)
{
  if(!record.flattening.succeeded()) {
    return is_failure_of_computation(record.flattening.report.status) ? COMPUTATION_FAILED : WRONG_INPUT;
  }
  return record.skipped.empty() ? SUCCESS : WRONG_INPUT;
}

// The stages of the parameterizer
inline Stages stages_of_map(const Flattening& flattening)
{
  const SMP::Flattening_report::Seconds& seconds = flattening.report.seconds;
  const bool is_direct = flattening.method == "direct";
  Stages stages;
  if(flattening.attempt_seconds > 0) {
    stages = {{"attempt", flattening.attempt_seconds}};
  }
  stages.emplace_back("chart", seconds.read);
  if(is_direct) {
    stages.insert(stages.end(),
                  {{"targets", seconds.targets}, {"angles", seconds.angles}, {"layout", seconds.layout}});
  }
  if(!is_direct || flattening.report.strategy == SMP::ABF_plus_plus_report::INJECTIVE_DESCENT) {
    stages.insert(stages.end(), {{"coarsen", seconds.coarsen},
                                 {"solve", seconds.coarse_chart},
                                 {"refine", seconds.refine},
                                 {"polish", seconds.polish}});
  }
  stages.insert(stages.end(), {{"certify", seconds.certify}, {"uv", seconds.write}});
  return stages;
}

// All stages. The chart's reading and writing are `chart` and `uv`; files have `read` and `write`. `parameterize` is
// the whole call of the parameterizer, that is, the sum of its stages.
inline Stages seconds_of_stages(const Chart_record& record)
{
  Stages result{{"read", record.read_seconds}};
  if(record.seams) {
    result.emplace_back("seams", record.seams->seconds);
  }
  const Stages of_map = stages_of_map(record.flattening);
  result.insert(result.end(), of_map.begin(), of_map.end());
  result.insert(result.end(), {{"parameterize", record.flattening.parameterize_seconds},
                               {"measure", record.flattening.measure_seconds}});
  if(record.split) {
    result.emplace_back("split", record.split->seconds);
  }
  result.emplace_back("write", record.write_seconds);
  return result;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHART_RECORD_H
