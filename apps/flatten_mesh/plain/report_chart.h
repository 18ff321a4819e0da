// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_CHART_H
#define FLATTEN_MESH_REPORT_CHART_H

#include "flatten_mesh/plain/Chart_record.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_skipped.h"

#include <CGAL/Texture_atlas/internal/json/report_json.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

using Cone = std::pair<std::size_t, double>; // the number of a vertex, and the sum of the angles there

inline std::string strategy_name(const SMP::ABF_plus_plus_report::Strategy strategy)
{
  static const char* const names[] = {"from last angles",
                                      "from target angles",
                                      "raised barrier",
                                      "from soft patches over holes",
                                      "soft patches over holes",
                                      "stiff patches over holes",
                                      "from a progressive embedding",
                                      "progressive embedding",
                                      "injective descent"};
  return names[strategy];
}

// The first few of many elements, as in "3, 17, ..."
template <class Values, class Text>
std::string list_text(const Values& values, const Text& text_of)
{
  std::string text;
  for(std::size_t i = 0; i < (std::min)(values.size(), std::size_t(8)); ++i) {
    text += (i == 0 ? "" : ", ") + text_of(values[i]);
  }
  return text + (values.size() > 8 ? ", ..." : "");
}

inline Report_rows method_rows(const Flattening& flattening)
{
  const SMP::ABF_plus_plus_report& report = flattening.report;
  const SMP::Hierarchical_report& hierarchical = flattening.hierarchical;
  Report_rows rows;
  if(flattening.method == "hierarchical") {
    rows.push_back({"method", flattening.method,
                    count_text(static_cast<std::size_t>(hierarchical.levels), "level") + ", " +
                        count_text(static_cast<std::size_t>(hierarchical.coarse_triangles), "triangle") +
                        " in the coarsest" + (report.injective ? "; injective on each level" : "") +
                        (hierarchical.relaxed_angles ? "; relaxed by angles" : "") +
                        (hierarchical.polished   ? "; polished"
                         : report.iterations > 0 ? "; polished, but not to convergence"
                                                 : "")});
  }
  if(!report.failed_strategies.empty()) {
    const SMP::ABF_plus_plus_report::Failed_strategy& before = report.failed_strategies.back();
    rows.push_back({"strategy", strategy_name(report.strategy),
                    strategy_name(before.strategy) + " failed: " + before.message});
  }
  if(report.iterations > 0) {
    const double residual = report.constraint_residual; // 0 if the steps moved vertices instead of angles
    rows.push_back(
        {"iterations", std::to_string(report.iterations),
         "Newton steps" + (residual > 0 ? "; constraints hold within " + format_number("%.1e", residual)
                                        : std::string())});
  }
  if(flattening.method == "direct") {
    rows.push_back({"layout", layout_name(report)});
  }
  return rows;
}

inline Report_rows contact_rows(const SMP::Flattening_report& report)
{
  const double least = report.least_clearance;
  return {{"contact", format_number("%.3g %%", 100 * report.contact),
           "of the border is near another part of it; " +
               count_text(static_cast<std::size_t>(report.border_rejections), "move") +
               " refused that would have made it touch itself"},
          {"least clearance", std::isfinite(least) ? format_number("%.3g", least) : "1 or more",
           "distance between parts of the border, in lengths of their edges"}};
}

inline Report_rows angle_rows(const Chart_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  return {
      {"corners", std::to_string(record.corners.size()),
       "vertices " + list_text(record.corners, [](const std::size_t v) { return std::to_string(v + 1); })},
      {"border angles", std::to_string(report.prescribed_angles),
       "prescribed; they hold within " + format_number("%.1e", report.largest_angle_error) +
           ", and sides are straight within " + format_number("%.1e", report.side_deviation) +
           " of their length"}};
}

inline Report_rows cone_rows(const Chart_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const auto text_of = [](const Cone& cone) {
    return vertex_name(cone.first) + ": " + degrees_text(cone.second);
  };
  Report_rows rows = {
      {"cones", std::to_string(record.cones->cones.size()), list_text(record.cones->cones, text_of)}};
  if(record.seams) {
    rows.push_back({"cone angles", "prescribed",
                    "they hold within " + format_number("%.1e", report.largest_angle_error) +
                        ", and both sides of seams turn alike within " +
                        format_number("%.1e", report.largest_seam_turn)});
  }
  return rows;
}

inline Report_row seam_jump_row(const Flattening& flattening)
{
  return {"seam jump", format_number("%.4g", std::exp(flattening.report.largest_seam_jump)),
          std::string("largest ratio of the lengths of both sides of an edge on a seam; ") +
              (flattening.method == "hierarchical"
                   ? "the hierarchical method leaves them free, --equal-seams on takes the direct one"
                   : "best 1")};
}

inline Report_rows seams_rows(const Seam_record& seams)
{
  std::string remark = "of lengths, by changes of area; ";
  if(std::isfinite(seams.predicted_stretch)) {
    remark += format_number("predicted %.4g; ", seams.predicted_stretch);
  }
  if(seams.terminals) {
    remark += format_number("bound %.4g; ", seams.stretch_bound);
  }
  if(seams.rounds > 0) {
    remark += "seams added in " + count_text(static_cast<std::size_t>(seams.rounds), "round") + "; ";
  }
  return {{"seams", format_number("%.4g", seams.length),
           "length in units of the square root of the area" +
               (seams.terminals ? "; " + count_text(*seams.terminals, "terminal") : "")},
          {"scale stretch", format_number("%.4g", seams.scale_stretch), remark + "best 1"}};
}

inline Report_row split_row(const Split_record& split)
{
  return {"pieces", std::to_string(split.number_of_pieces),
          split.number_of_pieces == 1
              ? "nothing overlaps"
              : "the map of each is injective; " + count_text(split.number_of_overlapping_faces, "triangle") +
                    " overlapped; new seams make borders " +
                    format_number("%.3g %%", 100 * split.extra_seam) + " longer"};
}

inline Report_rows stage_rows(const Chart_record& record)
{
  Report_rows rows;
  for(const auto& [stage, seconds] : seconds_of_stages(record)) {
    rows.push_back({"  " + stage, format_number("%9.3f", seconds)});
    if(stage == "parameterize") {
      rows.back().remark = "the stages above";
    } else if(stage != "read" && stage != "measure" && stage != "split" && stage != "write") {
      rows.back().label = "    " + stage;
    }
  }
  return rows;
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

// Vertices count from 1, as in OBJ files.
inline Json angles_json(const Chart_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  return {{"angles", report.prescribed_angles},
          {"corners", json_array(record.corners, [](const std::size_t v) { return v + 1; })},
          {"split_edges", record.split_edges},
          {"largest_angle_error", report.largest_angle_error},
          {"side_deviation", report.side_deviation}};
}

// Angles are in radians, but for those named otherwise. Vertices count from 1.
inline Json cones_json(const Chart_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const Cone_record& cones = *record.cones;
  const auto cone_json = [](const Cone& cone) -> Json {
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
  return {{"pieces", split.number_of_pieces},
          {"overlapping_triangles", split.number_of_overlapping_faces},
          {"added_seam_length", split.added_seam_length},
          {"extra_seam", split.extra_seam}};
}

} // namespace internal

// The report for people, as far as it is on the surface and its map
inline Report_rows surface_rows(const Chart_record& record)
{
  const Flattening& flattening = record.flattening;
  Report_rows rows = {
      {"input", record.input,
       record.components > 1 ? count_text(record.components, "component") + ", one of them flattened" : ""},
      {"vertices", std::to_string(record.vertices)},
      {"triangles", std::to_string(record.triangles)},
      {"borders", std::to_string(record.borders),
       record.borders > 1 ? "the outer one and " + count_text(record.borders - 1, "hole") : ""}};
  append(rows, internal::skipped_rows(record.skipped));
  if(record.seams) {
    append(rows, internal::seams_rows(*record.seams));
  }
  if(record.cones) {
    append(rows, internal::cone_rows(record));
  }
  if(record.seams) {
    rows.push_back(internal::seam_jump_row(flattening));
  }
  append(rows, internal::method_rows(flattening));
  append(rows, internal::quality_rows(flattening.measures));
  if(flattening.report.prescribed_angles > 0 && !record.cones) {
    append(rows, internal::angle_rows(record));
  }
  if(flattening.report.injective) {
    append(rows, internal::contact_rows(flattening.report));
  }
  if(record.split) {
    rows.push_back(internal::split_row(*record.split));
  }
  return rows;
}

inline std::string report_text(const Chart_record& record)
{
  return rows_text(surface_rows(record)) +
         rows_text(internal::run_rows(record, internal::stage_rows(record),
                                      "--output FILE.obj keeps the result, --svg FILE.svg draws it"));
}

// The report for programs. What is unknown after a failure is `null`.
inline std::string report_json(const Chart_record& record, const Batch_options& batch)
{
  const Flattening& flattening = record.flattening;
  const SMP::ABF_plus_plus_report& report = flattening.report;
  const bool is_known = flattening.succeeded(), has_skipped = is_known && !record.skipped.empty();
  Json json =
      internal::run_json(record, has_skipped ? "SOMETHING_SKIPPED" : status_name(report),
                         has_skipped ? record.skipped.front().message : report.message + flattening.place,
                         exit_status(record), batch);
  json.update({{"vertices", record.vertices},
               {"triangles", record.triangles},
               {"borders", record.borders},
               {"components", record.components},
               {"skipped", internal::skipped_json(record.skipped)},
               {"seams", record.seams ? internal::seams_json(*record.seams) : Json()},
               {"method", flattening.method},
               {"levels", flattening.hierarchical.levels},
               {"relaxed_angles", flattening.hierarchical.relaxed_angles}});
  TA::internal::add_coarse_charts(json, flattening.hierarchical);
  if(flattening.method != "hierarchical") {
    json["start"] = Json();
  }
  json.update({{"iterations", report.iterations},
               {"constraint_residual", report.constraint_residual},
               {"energy", report.energy},
               {"layout", layout_name(report)},
               {"strategy", internal::strategy_name(report.strategy)},
               {"scale_range", report.scale_range},
               {"predicted_scale_range", report.predicted_scale_range}});
  internal::add_measures(json, is_known ? &flattening.measures : nullptr);
  const bool is_simple = is_known ? flattening.measures.border_is_simple : report.border_is_simple;
  json.update(
      {{"flipped_triangles", is_known ? flattening.measures.flipped_triangles : report.flipped_triangles},
       {"border", is_simple ? "simple" : "not simple"},
       {"injective", report.injective},
       {"contact", report.injective ? Json(report.contact) : Json()},
       {"least_clearance", report.injective ? Json(report.least_clearance) : Json()},
       {"border_rejections", report.border_rejections},
       {"equal_seams", record.seams ? Json(flattening.has_equal_seams) : Json()},
       {"largest_seam_jump", record.seams ? Json(report.largest_seam_jump) : Json()},
       {"prescribed", report.prescribed_angles > 0 && !record.cones ? internal::angles_json(record) : Json()},
       {"cones", record.cones ? internal::cones_json(record) : Json()},
       {"split", record.split ? internal::split_json(*record.split) : Json()}});
  internal::add_end_of_run(json, record, seconds_of_stages(record));
  return json_report_text(json);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_CHART_H
