// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_JSON_H
#define FLATTEN_MESH_REPORT_JSON_H

#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/batch/add_run.h"
#include "flatten_mesh/json.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"

#include <string>

namespace flatten_mesh {

namespace internal {

inline void add_certificates(Json_object& json, const Flattening& flattening)
{
  const bool known = flattening.succeeded();
  json.add("flipped_triangles",
           json_number(known ? flattening.measures.flipped_triangles : flattening.report.flipped_triangles));
  const bool simple = known ? flattening.measures.border_is_simple : flattening.report.border_is_simple;
  json.add("border", json_text(simple ? "simple" : "not simple"));
}

inline std::string seams_json(const Seam_record& seams)
{
  Json_object json;
  json.add("cut", json_text(seams.cut));
  json.add("terminals", seams.terminals ? json_number(*seams.terminals) : "null");
  json.add("length", json_number(seams.length));
  json.add("stretch_bound", json_number(seams.stretch_bound));
  json.add("predicted_stretch", json_number(seams.predicted_stretch));
  json.add("scale_stretch", json_number(seams.scale_stretch));
  json.add("bound_reached", !seams.bound_reached ? "null" : *seams.bound_reached ? "true" : "false");
  json.add("rounds", json_number(seams.rounds));
  json.add("disks", json_number(seams.disks));
  return json.text();
}

inline void add_injectivity(Json_object& json, const SMP::Flattening_report& report)
{
  json.add("injective", report.injective ? "true" : "false");
  json.add("contact", report.injective ? json_number(report.contact) : "null");
  json.add("least_clearance", report.injective ? json_number(report.least_clearance) : "null");
  json.add("border_rejections", json_number(report.border_rejections));
}

// Vertices count from 1, as in OBJ files.
inline std::string angles_json(const Run_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  std::string corners;
  for(const std::size_t v : record.corners) {
    corners += (corners.empty() ? "" : ", ") + std::to_string(v + 1);
  }
  Json_object json;
  json.add("angles", json_number(report.prescribed_angles));
  json.add("corners", "[" + corners + "]");
  json.add("split_edges", json_number(record.split_edges));
  json.add("largest_angle_error", json_number(report.largest_angle_error));
  json.add("side_deviation", json_number(report.side_deviation));
  return json.text();
}

// Angles are in radians, but for those named otherwise. Vertices count from 1.
inline std::string cones_json(const Run_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const Cone_record& cones = *record.cones;
  const auto cone_json = [&cones](const std::size_t i) {
    Json_object json;
    json.add("vertex", json_number(cones.cones[i].first + 1));
    json.add("angle", json_number(cones.cones[i].second));
    json.add("degrees", json_number(cones.cones[i].second * 180. / CGAL_PI));
    return json.text();
  };
  Json_object json;
  json.add("wanted", json_number(cones.wanted));
  json.add("cones", json_array(cones.cones, cone_json));
  json.add("angle_multiple", cones.multiple > 0 ? json_number(cones.multiple) : "null");
  json.add("predicted_stretch", json_number(cones.predicted_stretch));
  json.add("largest_angle_error", json_number(report.largest_angle_error));
  json.add("largest_seam_turn", json_number(report.largest_seam_turn));
  return json.text();
}

inline std::string split_json(const Split_record& split)
{
  Json_object json;
  json.add("pieces", json_number(split.pieces));
  json.add("overlapping_triangles", json_number(split.overlapping_triangles));
  json.add("added_seam_length", json_number(split.added_length));
  json.add("extra_seam", json_number(split.extra_seam));
  return json.text();
}

} // namespace internal

// The report for programs. What is unknown after a failure is `null`.
inline std::string report_json(const Run_record& record, const Batch_options& batch)
{
  using internal::json_number;
  using internal::json_text;
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const bool has_skipped = record.flattening.succeeded() && !record.skipped.empty();
  internal::Json_object json;
  json.add("status", json_text(has_skipped ? "SOMETHING_SKIPPED" : status_name(report)));
  json.add("message", json_text(has_skipped ? record.skipped.front().message
                                            : report.message + record.flattening.place));
  json.add("notes", internal::json_texts(record.notes));
  json.add("input", json_text(record.input));
  internal::add_run(json, exit_status(record), batch.recorded);
  json.add("vertices", json_number(record.vertices));
  json.add("triangles", json_number(record.triangles));
  json.add("borders", json_number(record.borders));
  json.add("components", json_number(record.components));
  json.add("skipped", internal::skipped_json(record.skipped));
  json.add("seams", record.seams ? internal::seams_json(*record.seams) : "null");
  json.add("method", json_text(record.flattening.method));
  json.add("levels", json_number(record.flattening.levels));
  json.add("relaxed_angles", internal::json_bool(record.flattening.has_relaxed_angles));
  json.add("iterations", json_number(report.iterations));
  json.add("constraint_residual", json_number(report.constraint_residual));
  json.add("energy", json_number(report.energy));
  json.add("layout", json_text(layout_name(report)));
  json.add("strategy", json_text(strategy_name(report.strategy)));
  json.add("scale_range", json_number(report.scale_range));
  json.add("predicted_scale_range", json_number(report.predicted_scale_range));
  internal::add_measures(json, record.flattening.succeeded() ? &record.flattening.measures : nullptr);
  internal::add_certificates(json, record.flattening);
  internal::add_injectivity(json, report);
  json.add("equal_seams", record.seams ? internal::json_bool(record.flattening.has_equal_seams) : "null");
  json.add("largest_seam_jump", record.seams ? json_number(report.largest_seam_jump) : "null");
  json.add("prescribed",
           report.prescribed_angles > 0 && !record.cones ? internal::angles_json(record) : "null");
  json.add("cones", record.cones ? internal::cones_json(record) : "null");
  json.add("split", record.split ? internal::split_json(*record.split) : "null");
  internal::Json_object seconds;
  for(const auto& stage : seconds_of_stages(record)) {
    seconds.add(stage.first, json_number(stage.second));
  }
  json.add("seconds", seconds.text());
  json.add("peak_memory_mb", record.peak_memory_mb > 0 ? json_number(record.peak_memory_mb) : "null");
  return json.text() + "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_JSON_H
