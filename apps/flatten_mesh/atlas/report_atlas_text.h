// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_ATLAS_TEXT_H
#define FLATTEN_MESH_REPORT_ATLAS_TEXT_H

#include "flatten_mesh/atlas/Atlas_record.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// How many charts were made in which way
inline std::string methods_text(const TA::Atlas_report& report)
{
  std::map<TA::Atlas_report::Method, std::size_t> counts;
  for(const TA::Atlas_report::Chart& chart : report.charts) {
    ++counts[chart.method];
  }
  std::string text;
  for(const auto& [method, count] : counts) {
    text += (text.empty() ? "" : "; ") + (counts.size() > 1 ? std::to_string(count) + " " : std::string()) +
            to_string(method);
  }
  return text;
}

// How many charts were made otherwise than the options say, to be good
inline std::string strategies_text(const TA::Atlas_report& report)
{
  std::map<TA::Atlas_report::Strategy, std::size_t> counts;
  for(const TA::Atlas_report::Chart& chart : report.charts) {
    ++counts[chart.strategy];
  }
  std::string text;
  for(const auto& [strategy, what] :
      {std::pair(TA::Atlas_report::LARGER_AREA_WEIGHT, " with a larger area weight"),
       std::pair(TA::Atlas_report::MORE_CHARTS, " of divided parts")}) {
    if(counts[strategy] > 0) {
      text += "; " + std::to_string(counts[strategy]) + what;
    }
  }
  return text;
}

// The largest ratio of the lengths of both sides of an edge on a seam; not a number without seams
inline double seam_jump(const TA::Atlas_report::Chart& chart)
{
  return chart.seam_lengths == TA::Atlas_report::NO_SEAMS ? std::numeric_limits<double>::quiet_NaN()
                                                          : std::exp(chart.largest_seam_jump);
}

// How much the scale jumps at seams within charts, if there are some
inline Report_rows seam_jump_rows(const TA::Atlas_report& report)
{
  std::size_t with_seams = 0, equal = 0;
  double jump = 0;
  for(const TA::Atlas_report::Chart& chart : report.charts) {
    with_seams += chart.seam_lengths != TA::Atlas_report::NO_SEAMS;
    equal += chart.has_equal_seams;
    jump = (std::max)(jump, chart.largest_seam_jump);
  }
  if(with_seams == 0) {
    return {};
  }
  const std::string charts = with_seams == 1 ? (equal == 1 ? "equal lengths were kept" : "lengths are free")
                                             : std::to_string(equal) + " of " + std::to_string(with_seams) +
                                                   " charts with seams have equal ones";
  return {{"seam jump", format_number("%.4g", std::exp(jump)),
           "largest ratio of the lengths of both sides of an edge on a seam; " + charts + "; best 1"}};
}

// Where seams run
inline std::string way_text(const TA::Soup_report::Seams& way)
{
  const std::string surface = way.is_hard_surface.value_or(false) ? " of a hard surface" : "";
  if(way.crease_angle) {
    return "along creases" + surface + ", above " +
           format_number("%.4g degrees", *way.crease_angle * 180 / CGAL_PI);
  }
  if(way.name == "near-creases") {
    return "short, near creases" + surface;
  }
  return way.name == "hidden" ? "in hidden places" : way.name == "length" ? "short" : way.name;
}

inline Report_rows chart_rows(const Atlas_record& record)
{
  const TA::Atlas_report& report = record.report;
  double worst = 1;
  for(const TA::Atlas_report::Chart& chart : report.charts) {
    worst = (std::max)(worst, chart.scale_stretch);
  }
  Report_rows rows = {
      {"charts", std::to_string(report.charts.size()), methods_text(report) + strategies_text(report)}};
  if(record.report.number_of_ignored > 0) {
    rows.push_back({"left out", count_text(record.report.number_of_ignored, "face"),
                    "which keep the coordinates that they had"});
  }
  append(rows, skipped_rows(record.report.skipped));
  rows.push_back({"seams", format_number("%.4g", report.relative_seam_length),
                  "length in units of the square root of the area; " +
                      count_text(report.number_of_terminals, "terminal") + "; " +
                      way_text(record.report.seams)});
  const std::string bound = record.options.keeps_all_charts()
                                ? std::string()
                                : "bound " + format_number("%.4g", record.options.stretch_bound) + "; ";
  rows.push_back({"scale stretch", format_number("%.4g", worst),
                  "of the worst chart, by changes of area; " + bound + "best 1"});
  append(rows, seam_jump_rows(report));
  if(record.options.pack_into_square) {
    const std::string pages =
        report.number_of_pages > 1 ? count_text(report.number_of_pages, "page") : "the square";
    rows.push_back({"covered", format_number("%.1f %%", 100 * report.covered_share),
                    "of " + pages + "; " + std::to_string(record.options.resolution) + " x " +
                        std::to_string(record.options.number_of_rows()) + " texels, gutter " +
                        std::to_string(record.options.number_of_gutter_texels())});
    if(record.options.texels_per_unit > 0) {
      rows.push_back({"texels per unit", format_number("%.6g", record.options.texels_per_unit), "as given"});
    }
    rows.push_back({"texel density", format_number("%.3f", report.texel_density),
                    "mean; 95 % of the surface have at least " +
                        format_number("%.3f", report.low_texel_density) + " in all directions; best 1"});
  }
  return rows;
}

// The charts of the largest areas, if there are several
inline std::string largest_charts_text(const Atlas_record& record)
{
  const std::size_t most = 10;
  const std::vector<TA::Atlas_report::Chart>& charts = record.report.charts;
  if(charts.size() < 2) {
    return "";
  }
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&record](const std::size_t a, const std::size_t b) {
    return record.share_of_area[a] > record.share_of_area[b];
  });
  order.resize((std::min)(order.size(), most));
  std::string text = order.size() < charts.size() ? "largest charts\n" : "all charts\n";
  const bool has_pages = record.report.number_of_pages > 1;
  text += "  number   triangles      area   stretch   scale stretch   " +
          std::string(has_pages ? "page   " : "") + "method\n";
  for(const std::size_t i : order) {
    char line[128];
    std::snprintf(line, sizeof(line), "%8zu %11zu %7.2f %% %9.4g %15.4g   ", i + 1, charts[i].number_of_faces,
                  100 * record.share_of_area[i], charts[i].l2_stretch, charts[i].scale_stretch);
    text += line + (has_pages ? std::to_string(1001 + charts[i].page) + "   " : std::string()) +
            to_string(charts[i].method) + "\n";
  }
  return text;
}

// A line for each of several models
inline Report_rows model_rows(const Atlas_record& record)
{
  Report_rows rows;
  for(std::size_t i = 0; i < record.models.size(); ++i) {
    const Atlas_record::Model& model = record.models[i];
    std::size_t skipped = 0;
    for(const TA::Atlas_report::Skipped& part : skipped_of_model(record, i)) {
      skipped += part.number_of_faces;
    }
    const std::string first = std::to_string(model.first_chart + 1),
                      last = std::to_string(model.first_chart + model.charts);
    rows.push_back({"  model", model.input,
                    count_text(model.triangles, "triangle") + "; " +
                        (model.charts == 0   ? "no chart"
                         : model.charts == 1 ? "chart " + first
                                             : "charts " + first + " to " + last) +
                        (skipped == 0 ? "" : "; " + count_text(skipped, "face") + " without chart")});
  }
  return rows;
}

} // namespace internal

// The report for people, as far as it is on the surface and its atlas
inline Report_rows surface_rows(const Atlas_record& record)
{
  Report_rows rows = {{"input", record.input,
                       record.report.number_of_components > 1
                           ? count_text(record.report.number_of_components, "component")
                           : ""}};
  append(rows, internal::model_rows(record));
  append(rows, {{"vertices", std::to_string(record.report.number_of_vertices)},
                {"triangles", std::to_string(record.report.number_of_triangles)}});
  append(rows, internal::chart_rows(record));
  append(rows, internal::quality_rows(record.report.measures));
  if(!record.baking.from.empty()) {
    append(rows, baking_rows(record.baking));
  }
  return rows;
}

inline std::string report_text(const Atlas_record& record)
{
  Report_rows stages;
  for(const auto& [stage, seconds] : seconds_of_stages(record)) {
    stages.push_back({"  " + stage, format_number("%9.3f", seconds)});
  }
  return rows_text(surface_rows(record)) + internal::largest_charts_text(record) +
         rows_text(internal::run_rows(record, stages,
                                      "--output FILE.obj keeps the atlas, --picture FILE.png draws it"));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_ATLAS_TEXT_H
