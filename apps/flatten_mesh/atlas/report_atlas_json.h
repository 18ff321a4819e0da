// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_ATLAS_JSON_H
#define FLATTEN_MESH_REPORT_ATLAS_JSON_H

#include "flatten_mesh/atlas/Atlas_record.h"
#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/batch/add_run.h"
#include "flatten_mesh/json.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline std::string chart_json(const TA::Atlas_report::Chart& chart, const double share)
{
  Json_object json;
  json.add("part", json_number(chart.part));
  json.add("page", json_number(chart.page));
  json.add("triangles", json_number(chart.number_of_faces));
  json.add("share_of_area", json_number(share));
  json.add("method", json_text(to_string(chart.method)));
  json.add("overlap_is_predicted", json_bool(chart.overlap_is_predicted));
  json.add("strategy", json_text(to_string(chart.strategy)));
  json.add("scale_stretch", json_number(chart.scale_stretch));
  json.add("l2_stretch", json_number(chart.l2_stretch));
  json.add("crushed_faces", json_number(chart.crushed_faces));
  json.add("skewed_share", json_number(chart.skewed_share));
  json.add("bound_reached", json_bool(chart.bound_reached));
  json.add("is_good", json_bool(chart.is_good));
  json.add("contact", json_number(chart.contact));
  json.add("border_length", json_number(chart.border_length));
  json.add("rounds", json_number(chart.rounds));
  json.add("seam_lengths", json_text(to_string(chart.seam_lengths)));
  json.add("has_equal_seams", json_bool(chart.has_equal_seams));
  json.add("largest_seam_jump", json_number(chart.largest_seam_jump));
  return json.text();
}

inline std::string packing_json(const Atlas_record& record)
{
  Json_object json;
  json.add("resolution", json_number(record.options.resolution));
  json.add("height", json_number(record.options.height));
  json.add("block", json_number(record.options.block));
  json.add("gutter", json_number(record.options.gutter));
  json.add("pages", json_number(record.report.number_of_pages));
  json.add("texels_per_unit", json_number(record.report.scale * record.options.resolution));
  json.add("covered_share", json_number(record.report.covered_share));
  json.add("texel_density", json_number(record.report.texel_density));
  json.add("low_texel_density", json_number(record.report.low_texel_density));
  return json.text();
}

inline std::string symmetry_json(const Symmetry& symmetry)
{
  const auto& [x, y, z] = symmetry.plane.normal;
  Json_object json;
  json.add("plane", "[" + json_number(x) + ", " + json_number(y) + ", " + json_number(z) + ", " +
                        json_number(-symmetry.plane.offset) + "]");
  json.add("deviation", json_number(symmetry.plane.deviation));
  json.add("has_symmetric_surface", json_bool(symmetry.has_symmetric_surface));
  json.add("has_symmetric_seams", json_bool(symmetry.has_symmetric_seams));
  json.add("asymmetry", json_number(symmetry.asymmetry));
  json.add("extra_length", json_number(symmetry.extra_length));
  return json.text();
}

inline std::string atlas_json(const Atlas_record& record)
{
  const TA::Atlas_report& report = record.report;
  Json_object seams, json;
  const Seam_way& way = record.seam_way;
  seams.add("way", json_text(way.name));
  seams.add("crease_angle", way.crease_angle ? json_number(*way.crease_angle) : "null");
  seams.add("is_hard_surface", way.is_hard_surface ? json_bool(*way.is_hard_surface) : "null");
  seams.add("symmetry", way.symmetry ? symmetry_json(*way.symmetry) : "null");
  seams.add("length", json_number(report.seam_length));
  seams.add("relative_length", json_number(report.relative_seam_length));
  seams.add("terminals", json_number(report.number_of_terminals));
  seams.add("stretch_bound", json_number(record.stretch_bound));
  seams.add("largest_equal_jump", json_number(report.largest_equal_seam_jump));
  json.add("parts", json_number(report.number_of_parts));
  json.add("charts", json_array(report.charts, [&record](const std::size_t i) {
             return chart_json(record.report.charts[i], record.share_of_area[i]);
           }));
  json.add("seams", seams.text());
  json.add("purpose", record.options.keeps_all_charts() ? "null" : json_text(record.options.purpose));
  json.add("repacked", json_bool(record.options.repacks));
  json.add("units", json_text(record.options.units));
  json.add("packing", record.options.is_packed ? packing_json(record) : "null");
  json.add("flipped_triangles", json_number(report.measures.flipped_triangles));
  json.add("injective", json_bool(report.measures.border_is_simple));
  add_measures(json, &report.measures);
  return json.text();
}

inline std::string models_json(const Atlas_record& record)
{
  return json_array(record.models, [&record](const std::size_t i) {
    const Atlas_record::Model& model = record.models[i];
    Json_object json;
    json.add("input", json_text(model.input));
    json.add("output", model.output.empty() ? "null" : json_text(model.output));
    json.add("vertices", json_number(model.vertices));
    json.add("triangles", json_number(model.triangles));
    json.add("first_chart", json_number(model.first_chart));
    json.add("charts", json_number(model.charts));
    json.add("skipped", skipped_json(skipped_of_model(record, i)));
    return json.text();
  });
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
  using internal::json_number;
  using internal::json_text;
  internal::Json_object json, seconds;
  const std::string& message =
      record.skipped.empty() ? record.report.message : record.skipped.front().message;
  json.add("status", json_text(status_name(record)));
  json.add("message", json_text(message));
  json.add("notes", internal::json_texts(record.notes));
  json.add("input", json_text(record.input));
  internal::add_run(json, exit_status(record), batch.recorded);
  if(!record.models.empty()) {
    json.add("models", internal::models_json(record));
  }
  json.add("vertices", json_number(record.vertices));
  json.add("triangles", json_number(record.triangles));
  json.add("components", json_number(record.components));
  json.add("left_out", json_number(record.left_out));
  json.add("skipped", internal::skipped_json(record.skipped, internal::names_of_models(record)));
  json.add("atlas", record.report.has_atlas() ? internal::atlas_json(record) : "null");
  json.add("baking", record.baking.from.empty() ? "null" : baking_json(record.baking));
  for(const auto& [stage, time] : seconds_of_stages(record)) {
    seconds.add(stage, json_number(time));
  }
  json.add("seconds", seconds.text());
  json.add("peak_memory_mb", record.peak_memory_mb > 0 ? json_number(record.peak_memory_mb) : "null");
  return json.text() + "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_ATLAS_JSON_H
