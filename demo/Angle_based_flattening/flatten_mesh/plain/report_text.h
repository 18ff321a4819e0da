// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_TEXT_H
#define FLATTEN_MESH_REPORT_TEXT_H

#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/texts.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace flatten_mesh {

namespace internal {

inline std::string method_text(const Flattening& flattening)
{
  const SMP::ABF_plus_plus_report& report = flattening.report;
  std::string text;
  if(flattening.method == "hierarchical") {
    text += report_line("method", flattening.method,
                        count_text(flattening.levels, "level") + ", " +
                            count_text(flattening.coarse_triangles, "triangle") + " in the coarsest" +
                            (report.injective ? "; injective on each level" : "") +
                            (flattening.is_polished  ? "; polished"
                             : report.iterations > 0 ? "; polished, but not to convergence"
                                                     : ""));
  }
  if(!report.failed_strategies.empty()) {
    const SMP::ABF_plus_plus_report::Failed_strategy& before = report.failed_strategies.back();
    text += report_line("strategy", strategy_name(report.strategy),
                        strategy_name(before.strategy) + " failed: " + before.message);
  }
  if(report.iterations > 0) {
    const double residual = report.constraint_residual; // 0 if the steps moved vertices instead of angles
    text += report_line("iterations", std::to_string(report.iterations),
                        "Newton steps" + (residual > 0
                                              ? "; constraints hold within " + format_number("%.1e", residual)
                                              : std::string()));
  }
  if(flattening.method == "direct") {
    text += report_line("layout", layout_name(report));
  }
  return text;
}

inline std::string contact_text(const SMP::Flattening_report& report)
{
  const double least = report.least_clearance;
  return report_line("contact", format_number("%.3g %%", 100 * report.contact),
                     "of the border is near another part of it; " +
                         count_text(static_cast<std::size_t>(report.border_rejections), "move") +
                         " refused that would have made it touch itself") +
         report_line("least clearance", std::isfinite(least) ? format_number("%.3g", least) : "1 or more",
                     "distance between parts of the border, in lengths of their edges");
}

inline std::string seams_text(const Seam_record& seams)
{
  const std::string terminals = seams.terminals ? "; " + count_text(*seams.terminals, "terminal") : "";
  std::string remark = "of lengths, by changes of area; ";
  if(seams.terminals) {
    remark += format_number("predicted %.4g; ", seams.predicted_stretch) +
              format_number("bound %.4g; ", seams.stretch_bound);
  }
  if(seams.rounds > 0) {
    remark += "seams added in " + count_text(static_cast<std::size_t>(seams.rounds), "round") + "; ";
  }
  return report_line("seams", format_number("%.4g", seams.length),
                     "length in units of the square root of the area" + terminals) +
         report_line("scale stretch", format_number("%.4g", seams.scale_stretch), remark + "best 1");
}

inline std::string split_text(const Split_record& split)
{
  return report_line("pieces", std::to_string(split.pieces),
                     split.pieces == 1 ? "nothing overlaps"
                                       : "the map of each is injective; " +
                                             count_text(split.overlapping_triangles, "triangle") +
                                             " overlapped; new seams make borders " +
                                             format_number("%.3g %%", 100 * split.extra_seam) + " longer");
}

inline std::string time_text(const Run_record& record)
{
  std::string text;
  for(const auto& stage : seconds_of_stages(record)) {
    const bool is_part = stage.first != "read" && stage.first != "parameterize" && stage.first != "measure" &&
                         stage.first != "split" && stage.first != "write";
    const std::string label = (is_part ? "    " : "  ") + stage.first;
    text += report_line(label, format_number("%9.3f", stage.second),
                        stage.first == "parameterize" ? "the stages above" : "");
  }
  return "seconds\n" + text;
}

} // namespace internal

// The report for people.
inline std::string report_text(const Run_record& record)
{
  using internal::report_line;
  std::string text;
  text += report_line(
      "input", record.input,
      record.components > 1 ? count_text(record.components, "component") + ", one of them flattened" : "");
  text += report_line("vertices", std::to_string(record.vertices));
  text += report_line("triangles", std::to_string(record.triangles));
  text +=
      report_line("borders", std::to_string(record.borders),
                  record.borders > 1 ? "the outer one and " + count_text(record.borders - 1, "hole") : "");
  if(record.seams) {
    text += internal::seams_text(*record.seams);
  }
  text += internal::method_text(record.flattening);
  text += internal::quality_text(record.flattening.measures);
  if(record.flattening.report.injective) {
    text += internal::contact_text(record.flattening.report);
  }
  if(record.split) {
    text += internal::split_text(*record.split);
  }
  text += internal::time_text(record);
  if(const double memory = peak_memory_mb(record.flattening.report); memory > 0) {
    text += report_line("peak memory", format_number("%.0f MB", memory));
  }
  for(const std::string& name : record.written) {
    text += report_line("written", name);
  }
  if(record.written.empty()) {
    text += report_line("written", "nothing", "--output FILE.obj keeps the result, --svg FILE.svg draws it");
  }
  return text;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_TEXT_H
