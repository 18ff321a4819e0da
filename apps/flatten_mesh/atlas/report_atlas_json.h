// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_ATLAS_JSON_H
#define FLATTEN_MESH_REPORT_ATLAS_JSON_H

#include "flatten_mesh/atlas/Atlas_record.h"
#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline Json models_json(const Atlas_record& record)
{
  Json models = Json::array();
  for(std::size_t i = 0; i < record.models.size(); ++i) {
    const Atlas_record::Model& model = record.models[i];
    models.push_back({{"input", model.input},
                      {"output", model.output.empty() ? Json() : Json(model.output)},
                      {"vertices", model.vertices},
                      {"triangles", model.triangles},
                      {"first_chart", model.first_chart},
                      {"charts", model.charts},
                      {"skipped", skipped_json(skipped_of_model(record, i))}});
  }
  return models;
}

inline std::vector<std::string> names_of_models(const Atlas_record& record)
{
  std::vector<std::string> names;
  for(const Atlas_record::Model& model : record.models) {
    names.push_back(model.input);
  }
  return names;
}

} // namespace internal

// The report for programs. Without an atlas, `atlas` is `null`. Faces are counted from 1, charts and parts from 0.
inline std::string report_json(const Atlas_record& record, const Batch_options& batch)
{
  Json json =
      internal::run_json(record, status_name(record), record.report.message, exit_status(record), batch);
  if(!record.models.empty()) {
    json["models"] = internal::models_json(record);
  }
  json["vertices"] = record.report.number_of_vertices;
  json["triangles"] = record.report.number_of_triangles;
  json["components"] = record.report.number_of_components;
  json["left_out"] = record.report.number_of_ignored;
  json["skipped"] = internal::skipped_json(record.report.skipped, internal::names_of_models(record));
  json["atlas"] = record.report.has_atlas()
                      ? CGAL::Texture_atlas::internal::atlas_json(
                            record.report, record.options, record.options.purpose, record.options.units)
                      : Json();
  json["baking"] = record.baking.from.empty() ? Json() : baking_json(record.baking);
  internal::add_end_of_run(json, record, seconds_of_stages(record));
  return json_report_text(json);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_ATLAS_JSON_H
