// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RUN_RECORD_H
#define FLATTEN_MESH_RUN_RECORD_H

#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/plain/Sheet.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Texture_atlas/Atlas_report.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace SMP = CGAL::Surface_mesh_parameterization;

using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

// The result of the parameterizer.
struct Flattening
{
  UV_map uv;
  Mesh::Property_map<Face, double> distortion; // change of the angles of each face, in degrees
  SMP::ABF_plus_plus_report report; // for the hierarchical method, the part that both methods have in common
  std::string method;               // direct or hierarchical
  bool has_equal_seams = false;     // both sides of each seam have the same lengths
  int levels = 0;                   // of the hierarchical method
  int coarse_triangles = 0;
  bool has_relaxed_angles = false;
  bool is_polished = false;
  std::vector<std::pair<std::string, double>> stages; // of the parameterizer, with their seconds
  SMP::Flattening_measures measures;                  // only if it succeeded
  double scale_stretch = 1; // how much areas vary in the plane, as a stretch of lengths; 1 is perfect
  std::string place;        // the vertices and faces at fault, if it failed
  std::string note;         // what else there is to say
  double parameterize_seconds = 0;
  double measure_seconds = 0;

  bool succeeded() const { return report.status == SMP::Diagnosis::NOTHING_WRONG; }

  // Counts the time of another one that this one replaced, or that was worse.
  void add_attempt(const Flattening& other)
  {
    if(stages.empty() || stages.front().first != "attempt") {
      stages.insert(stages.begin(), {"attempt", 0.});
    }
    stages.front().second += other.parameterize_seconds;
    parameterize_seconds += other.parameterize_seconds;
    measure_seconds += other.measure_seconds;
  }
};

// The seams of a surface that is cut open.
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

// The cones through which a surface is cut.
struct Cone_record
{
  std::size_t wanted = 0;
  double multiple = 0;                               // of which all angles are multiples, in radians; or 0
  std::vector<std::pair<std::size_t, double>> cones; // vertices from 0, and their angles in radians
  double predicted_stretch = 1;
};

// The pieces of a chart that was split because its map overlapped itself.
struct Split_record
{
  std::size_t pieces = 1;
  std::size_t overlapping_triangles = 0;
  double added_length = 0; // of seams
  double extra_seam = 0;   // by which share the border became longer
  double seconds = 0;
};

// The data of the reports for people and for programs.
struct Run_record
{
  std::string input;
  std::size_t vertices = 0; // these three are of the chart
  std::size_t triangles = 0;
  std::size_t borders = 0;
  std::size_t components = 0; // of the whole mesh
  double read_seconds = 0;
  double write_seconds = 0;
  double peak_memory_mb = 0; // until the map was computed; 0 if unknown
  std::optional<Seam_record> seams;
  std::optional<Cone_record> cones;
  Flattening flattening;
  std::optional<Split_record> split;
  std::vector<std::size_t> corners; // of the prescribed border: vertices from 0
  std::size_t split_edges = 0;      // which were in the way of that border
  std::vector<std::string> written;
  std::vector<std::string> notes;
  std::vector<CGAL::Texture_atlas::Atlas_report::Skipped> skipped; // faces of the file that are left out
};

// The name of a diagnosis, "OK" for none.
inline std::string status_name(const SMP::ABF_plus_plus_report& report)
{
  return report.status == SMP::Diagnosis::NOTHING_WRONG ? "OK" : to_string(report.status);
}

inline std::string strategy_name(const SMP::ABF_plus_plus_report::Strategy strategy)
{
  using Report = SMP::ABF_plus_plus_report;
  switch(strategy) {
  case Report::FROM_TARGET_ANGLES:
    return "from target angles";
  case Report::RAISED_BARRIER:
    return "raised barrier";
  case Report::FROM_SOFT_PATCHES:
    return "from soft patches over holes";
  case Report::SOFT_PATCHES:
    return "soft patches over holes";
  case Report::STIFF_PATCHES:
    return "stiff patches over holes";
  case Report::FROM_PROGRESSIVE_EMBEDDING:
    return "from a progressive embedding";
  case Report::FROM_LAST_ANGLES:
    return "from last angles";
  case Report::INJECTIVE_DESCENT:
    return "injective descent";
  default:
    return "progressive embedding";
  }
}

inline std::string layout_name(const SMP::ABF_plus_plus_report& report)
{
  using Report = SMP::ABF_plus_plus_report;
  return report.layout == Report::EXACT           ? "exact"
         : report.layout == Report::LEAST_SQUARES ? "least-squares"
                                                  : "none";
}

// Whether the computation failed rather than the input.
inline bool is_failure_of_computation(const SMP::ABF_plus_plus_report& report)
{
  switch(report.status) {
  case SMP::Diagnosis::NOTHING_WRONG:
  case SMP::Diagnosis::LINEAR_SYSTEM_FAILED:
  case SMP::Diagnosis::NO_CONVERGENCE:
  case SMP::Diagnosis::FLIPPED_TRIANGLES:
  case SMP::Diagnosis::OVERLAPPING:
  case SMP::Diagnosis::PRECISION_EXCEEDED:
    return true;
  default:
    return false;
  }
}

inline Exit_status exit_status(const Run_record& record)
{
  if(!record.flattening.succeeded()) {
    // What no number type holds is asked for by the input.
    const SMP::ABF_plus_plus_report& report = record.flattening.report;
    const bool is_too_precise = report.status == SMP::Diagnosis::PRECISION_EXCEEDED;
    return is_failure_of_computation(report) && !is_too_precise ? COMPUTATION_FAILED : WRONG_INPUT;
  }
  return record.skipped.empty() ? SUCCESS : WRONG_INPUT;
}

// The stages, with the time of each. The chart's reading and writing are `chart` and `uv`; files have `read` and
// `write`. `parameterize` is the whole call of the parameterizer, that is, the sum of its stages.
inline std::vector<std::pair<std::string, double>> seconds_of_stages(const Run_record& record)
{
  std::vector<std::pair<std::string, double>> result{{"read", record.read_seconds}};
  if(record.seams) {
    result.emplace_back("seams", record.seams->seconds);
  }
  result.insert(result.end(), record.flattening.stages.begin(), record.flattening.stages.end());
  result.emplace_back("parameterize", record.flattening.parameterize_seconds);
  result.emplace_back("measure", record.flattening.measure_seconds);
  if(record.split) {
    result.emplace_back("split", record.split->seconds);
  }
  result.emplace_back("write", record.write_seconds);
  return result;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RUN_RECORD_H
