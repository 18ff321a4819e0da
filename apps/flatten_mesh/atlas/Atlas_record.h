// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ATLAS_RECORD_H
#define FLATTEN_MESH_ATLAS_RECORD_H

#include "flatten_mesh/bake/Baking_record.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/prepare/Atlas.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Seam_way.h>
#include <CGAL/Texture_atlas/internal/prepare/Skipped_part.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// The data of the reports on an atlas, for people and for programs
struct Atlas_record
{
  // One of several models that share the atlas
  struct Model
  {
    std::string input, output; // the output is empty if none is written
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t first_chart = 0; // its charts follow one another
    std::size_t charts = 0;
  };

  std::string input;
  std::vector<Model> models; // empty if there is only the input
  Atlas_command options;
  double stretch_bound = 0;
  std::size_t vertices = 0; // these three are of the surface that the atlas is made of
  std::size_t triangles = 0;
  std::size_t components = 0;
  std::size_t left_out = 0; // faces that were not to be flattened
  Seam_way seam_way;
  Report_on_atlas report;
  std::vector<Skipped_part> skipped; // also those that were set aside before
  std::vector<double> share_of_area; // of each chart
  double read_seconds = 0;
  double simplify_seconds = 0; // 0 if nothing was simplified
  double write_seconds = 0;
  double peak_memory_mb = 0; // 0 if unknown
  Baking_record baking;
  std::vector<std::string> written;
  std::vector<std::string> notes;
};

// The parts that one of several models lacks
inline std::vector<Skipped_part> skipped_of_model(const Atlas_record& record, const std::size_t model)
{
  std::vector<Skipped_part> parts;
  std::copy_if(record.skipped.begin(), record.skipped.end(), std::back_inserter(parts),
               [model](const Skipped_part& part) { return part.model == model; });
  return parts;
}

inline std::string status_name(const Atlas_record& record)
{
  if(record.report.has_atlas() && !record.skipped.empty()) {
    return to_string(SMP::Diagnosis::SOMETHING_SKIPPED);
  }
  return record.report ? "OK" : to_string(record.report.status);
}

inline Exit_status exit_status(const Atlas_record& record)
{
  if(record.report.has_atlas()) {
    return record.skipped.empty() ? SUCCESS : WRONG_INPUT;
  }
  const bool is_computed = !record.options.keeps_all_charts();
  return is_computed && std::any_of(record.skipped.begin(), record.skipped.end(), is_failure_of_computation)
             ? COMPUTATION_FAILED
             : WRONG_INPUT;
}

// The stages, with the time of each
inline std::vector<std::pair<std::string, double>> seconds_of_stages(const Atlas_record& record)
{
  const TA::Atlas_report::Seconds& seconds = record.report.seconds;
  std::vector<std::pair<std::string, double>> stages = {{"read", record.read_seconds + seconds.read}};
  if(record.simplify_seconds > 0) {
    stages.emplace_back("simplify", record.simplify_seconds);
  }
  stages.insert(stages.end(), {{"charts", seconds.charts},
                               {"pack", seconds.pack},
                               {"certify", seconds.certify},
                               {"measure", seconds.measure}});
  if(!record.baking.from.empty()) {
    stages.emplace_back("bake", record.baking.seconds);
  }
  stages.emplace_back("write", seconds.write + record.write_seconds);
  return stages;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ATLAS_RECORD_H
