// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_TEXT_H
#define FLATTEN_MESH_REPORT_TEXT_H

#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline Report_rows method_rows(const Flattening& flattening)
{
  const SMP::ABF_plus_plus_report& report = flattening.report;
  Report_rows rows;
  if(flattening.method == "hierarchical") {
    rows.push_back({"method", flattening.method,
                    count_text(flattening.levels, "level") + ", " +
                        count_text(flattening.coarse_triangles, "triangle") + " in the coarsest" +
                        (report.injective ? "; injective on each level" : "") +
                        (flattening.has_relaxed_angles ? "; relaxed by angles" : "") +
                        (flattening.is_polished  ? "; polished"
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

inline Report_rows angle_rows(const Run_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  std::string corners;
  for(std::size_t i = 0; i < record.corners.size() && i < 8; ++i) {
    corners += (i == 0 ? "" : ", ") + std::to_string(record.corners[i] + 1);
  }
  return {{"corners", std::to_string(record.corners.size()),
           "vertices " + corners + (record.corners.size() > 8 ? ", ..." : "")},
          {"border angles", std::to_string(report.prescribed_angles),
           "prescribed; they hold within " + format_number("%.1e", report.largest_angle_error) +
               ", and sides are straight within " + format_number("%.1e", report.side_deviation) +
               " of their length"}};
}

inline Report_rows cone_rows(const Run_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const std::vector<std::pair<std::size_t, double>>& cones = record.cones->cones;
  std::string list;
  for(std::size_t i = 0; i < cones.size() && i < 8; ++i) {
    list += (i == 0 ? "" : ", ") + vertex_name(cones[i].first) + ": " + degrees_text(cones[i].second);
  }
  Report_rows rows = {{"cones", std::to_string(cones.size()), list + (cones.size() > 8 ? ", ..." : "")}};
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
  const std::string terminals = seams.terminals ? "; " + count_text(*seams.terminals, "terminal") : "";
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
           "length in units of the square root of the area" + terminals},
          {"scale stretch", format_number("%.4g", seams.scale_stretch), remark + "best 1"}};
}

inline Report_rows split_rows(const Split_record& split)
{
  return {{"pieces", std::to_string(split.pieces),
           split.pieces == 1
               ? "nothing overlaps"
               : "the map of each is injective; " + count_text(split.overlapping_triangles, "triangle") +
                     " overlapped; new seams make borders " +
                     format_number("%.3g %%", 100 * split.extra_seam) + " longer"}};
}

inline Report_rows time_rows(const Run_record& record)
{
  Report_rows rows = {{"seconds"}};
  for(const auto& stage : seconds_of_stages(record)) {
    const bool is_part = stage.first != "read" && stage.first != "parameterize" && stage.first != "measure" &&
                         stage.first != "split" && stage.first != "write";
    rows.push_back({(is_part ? "    " : "  ") + stage.first, format_number("%9.3f", stage.second),
                    stage.first == "parameterize" ? "the stages above" : ""});
  }
  return rows;
}

} // namespace internal

// The report for people, as far as it is on the surface and its map
inline Report_rows surface_rows(const Run_record& record)
{
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
    rows.push_back(internal::seam_jump_row(record.flattening));
  }
  append(rows, internal::method_rows(record.flattening));
  append(rows, internal::quality_rows(record.flattening.measures));
  if(record.flattening.report.prescribed_angles > 0 && !record.cones) {
    append(rows, internal::angle_rows(record));
  }
  if(record.flattening.report.injective) {
    append(rows, internal::contact_rows(record.flattening.report));
  }
  if(record.split) {
    append(rows, internal::split_rows(*record.split));
  }
  return rows;
}

// The rest of it, on the run of the program
inline Report_rows run_rows(const Run_record& record)
{
  Report_rows rows = internal::time_rows(record);
  if(record.peak_memory_mb > 0) {
    rows.push_back({"peak memory", format_number("%.0f MB", record.peak_memory_mb)});
  }
  for(const std::string& name : record.written) {
    rows.push_back({"written", name});
  }
  if(record.written.empty()) {
    rows.push_back({"written", "nothing", "--output FILE.obj keeps the result, --svg FILE.svg draws it"});
  }
  return rows;
}

inline std::string report_text(const Run_record& record)
{
  return rows_text(surface_rows(record)) + rows_text(run_rows(record));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_TEXT_H
