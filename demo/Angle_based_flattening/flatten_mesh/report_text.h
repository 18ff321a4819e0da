// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_TEXT_H
#define FLATTEN_MESH_REPORT_TEXT_H

#include "Run_record.h"
#include "texts.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace flatten_mesh {

namespace internal {

inline std::string report_line(std::string label, const std::string& value, const std::string& remark = "")
{
  label.resize(22, ' ');
  std::string line = label + value;
  if(!remark.empty()) {
    line.resize((std::max)(line.size() + 2, std::size_t(36)), ' ');
    line += "(" + remark + ")";
  }
  return line + "\n";
}

inline std::string degrees_text(const double radians)
{
  return format_number("%.4g", radians * 180. / CGAL_PI) + " degrees";
}

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

inline std::string quality_text(const SMP::Flattening_measures& measures)
{
  const auto line = [](const char* label, const double value, const std::string& remark) {
    return report_line(label, format_number("%.5g", value), remark);
  };
  return report_line("angle change", degrees_text(measures.mean_angle_change),
                     "mean by area; root mean square " + degrees_text(measures.rms_angle_change)) +
         report_line("  per corner", degrees_text(measures.mean_corner_angle_change),
                     "mean; root mean square " + degrees_text(measures.rms_corner_angle_change)) +
         line("quasi-conformal ratio", measures.mean_quasi_conformal_ratio,
              "mean; on 95 % of the area at most " +
                  format_number("%.5g", measures.quasi_conformal_ratio_95) + "; largest " +
                  format_number("%.5g", measures.max_quasi_conformal_ratio) + "; best 1") +
         report_line("scale", format_number("%.5g", measures.min_scale),
                     "of lengths, least; largest " + format_number("%.5g", measures.max_scale) + "; best 1") +
         report_line("energy", format_number("%.4e", measures.angular_distortion),
                     "mean square relative change of the target angles, Equation 1; best 0") +
         line("L2 stretch", measures.l2_stretch, "of lengths, root mean square; best 1") +
         line("L-infinity stretch", measures.linf_stretch, "of lengths, largest; best 1") +
         line("L2 shear", measures.l2_shear, "of the axes, Equation 24; best 0") +
         line("L2 principal shear", measures.l2_principal_shear,
              "for the worst axes of each triangle; best 0") +
         line("equal-stretch error", measures.l2_equal_stretch_error,
              "one axis stretched more than the other; best 0") +
         line("area distortion", measures.l2_area_distortion,
              "logarithm of the factor of areas, root mean square; best 0") +
         line("symmetric Dirichlet", measures.symmetric_dirichlet_energy, "energy per area; best 4") +
         report_line("flipped triangles", std::to_string(measures.flipped_triangles), "must be 0") +
         report_line("border", measures.border_is_simple ? "simple" : "not simple",
                     measures.border_is_simple ? "the map is injective"
                                               : "parts of the layout overlap or touch") +
         report_line("smallest angle", degrees_text(measures.smallest_angle));
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
