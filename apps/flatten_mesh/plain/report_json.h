// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_JSON_H
#define FLATTEN_MESH_REPORT_JSON_H

#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/batch/add_run.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"

#include <string>

namespace flatten_mesh {

namespace internal {

inline void add_certificates(Json& json, const Flattening& flattening)
{
  const bool known = flattening.succeeded();
  const bool simple = known ? flattening.measures.border_is_simple : flattening.report.border_is_simple;
  json["flipped_triangles"] =
      known ? flattening.measures.flipped_triangles : flattening.report.flipped_triangles;
  json["border"] = simple ? "simple" : "not simple";
}

inline Json seams_json(const Seam_record& seams)
{
  return {{"cut", seams.cut},
          {"terminals", json_optional(seams.terminals)},
          {"length", seams.length},
          {"stretch_bound", seams.stretch_bound},
          {"predicted_stretch", seams.predicted_stretch},
          {"scale_stretch", seams.scale_stretch},
          {"bound_reached", json_optional(seams.bound_reached)},
          {"rounds", seams.rounds},
          {"disks", seams.disks}};
}

inline void add_injectivity(Json& json, const SMP::Flattening_report& report)
{
  json["injective"] = report.injective;
  json["contact"] = report.injective ? Json(report.contact) : Json();
  json["least_clearance"] = report.injective ? Json(report.least_clearance) : Json();
  json["border_rejections"] = report.border_rejections;
}

// Vertices count from 1, as in OBJ files.
inline Json angles_json(const Run_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const auto number = [](const std::size_t v) { return v + 1; };
  return {{"angles", report.prescribed_angles},
          {"corners", json_array(record.corners, number)},
          {"split_edges", record.split_edges},
          {"largest_angle_error", report.largest_angle_error},
          {"side_deviation", report.side_deviation}};
}

// Angles are in radians, but for those named otherwise. Vertices count from 1.
inline Json cones_json(const Run_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const Cone_record& cones = *record.cones;
  const auto cone_json = [](const std::pair<std::size_t, double>& cone) -> Json {
    return {{"vertex", cone.first + 1}, {"angle", cone.second}, {"degrees", cone.second * 180. / CGAL_PI}};
  };
  return {{"wanted", cones.wanted},
          {"cones", json_array(cones.cones, cone_json)},
          {"angle_multiple", cones.multiple > 0 ? Json(cones.multiple) : Json()},
          {"predicted_stretch", cones.predicted_stretch},
          {"largest_angle_error", report.largest_angle_error},
          {"largest_seam_turn", report.largest_seam_turn}};
}

inline Json split_json(const Split_record& split)
{
  return {{"pieces", split.pieces},
          {"overlapping_triangles", split.overlapping_triangles},
          {"added_seam_length", split.added_length},
          {"extra_seam", split.extra_seam}};
}

} // namespace internal

// The report for programs. What is unknown after a failure is `null`.
inline std::string report_json(const Run_record& record, const Batch_options& batch)
{
  const Flattening& flattening = record.flattening;
  const SMP::ABF_plus_plus_report& report = flattening.report;
  const bool has_skipped = flattening.succeeded() && !record.skipped.empty();
  Json json = {{"status", has_skipped ? "SOMETHING_SKIPPED" : status_name(report)},
               {"message", has_skipped ? record.skipped.front().message : report.message + flattening.place},
               {"notes", record.notes},
               {"input", record.input}};
  internal::add_run(json, exit_status(record), batch.recorded);
  json.update({{"vertices", record.vertices},
               {"triangles", record.triangles},
               {"borders", record.borders},
               {"components", record.components},
               {"skipped", internal::skipped_json(record.skipped)},
               {"seams", record.seams ? internal::seams_json(*record.seams) : Json()},
               {"method", flattening.method},
               {"levels", flattening.levels},
               {"relaxed_angles", flattening.has_relaxed_angles},
               {"iterations", report.iterations},
               {"constraint_residual", report.constraint_residual},
               {"energy", report.energy},
               {"layout", layout_name(report)},
               {"strategy", strategy_name(report.strategy)},
               {"scale_range", report.scale_range},
               {"predicted_scale_range", report.predicted_scale_range}});
  internal::add_measures(json, flattening.succeeded() ? &flattening.measures : nullptr);
  internal::add_certificates(json, flattening);
  internal::add_injectivity(json, report);
  json.update(
      {{"equal_seams", record.seams ? Json(flattening.has_equal_seams) : Json()},
       {"largest_seam_jump", record.seams ? Json(report.largest_seam_jump) : Json()},
       {"prescribed", report.prescribed_angles > 0 && !record.cones ? internal::angles_json(record) : Json()},
       {"cones", record.cones ? internal::cones_json(record) : Json()},
       {"split", record.split ? internal::split_json(*record.split) : Json()}});
  for(const auto& [stage, time] : seconds_of_stages(record)) {
    json["seconds"][stage] = time;
  }
  json["peak_memory_mb"] = record.peak_memory_mb > 0 ? Json(record.peak_memory_mb) : Json();
  return json_report_text(json);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_JSON_H
