// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ATLAS_RECORD_H
#define FLATTEN_MESH_ATLAS_RECORD_H

#include "flatten_mesh/bake/Baking_record.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Run_record.h"

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/Soup_report.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// The data of the reports on an atlas, for people and for programs
struct Atlas_record : Run_record
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

  std::vector<Model> models; // empty if there is only the input
  Atlas_command options;
  TA::Soup_report report;
  std::vector<double> share_of_area; // of each chart
  double simplify_seconds = 0;       // 0 if nothing was simplified
  Baking_record baking;
};

// The parts that one of several models lacks
inline std::vector<TA::Atlas_report::Skipped> skipped_of_model(const Atlas_record& record,
                                                               const std::size_t model)
{
  std::vector<TA::Atlas_report::Skipped> parts;
  std::copy_if(record.report.skipped.begin(), record.report.skipped.end(), std::back_inserter(parts),
               [model](const TA::Atlas_report::Skipped& part) { return part.mesh == model; });
  return parts;
}

inline std::string status_name(const Atlas_record& record)
{
  return record.report ? "OK" : to_string(record.report.status);
}

inline Exit_status exit_status(const Atlas_record& record)
{
  if(record.report.has_atlas()) {
    return record.report.skipped.empty() ? SUCCESS : WRONG_INPUT;
  }
  const bool is_computed = !record.options.keeps_all_charts();
  return is_computed && std::any_of(record.report.skipped.begin(), record.report.skipped.end(),
                                    [](const TA::Atlas_report::Skipped& part) {
                                      return is_failure_of_computation(part.status);
                                    })
             ? COMPUTATION_FAILED
             : WRONG_INPUT;
}

// The stages, with the time of each
inline Stages seconds_of_stages(const Atlas_record& record)
{
  const TA::Atlas_report::Seconds& seconds = record.report.seconds;
  Stages stages = {{"read", record.read_seconds + seconds.read}};
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
