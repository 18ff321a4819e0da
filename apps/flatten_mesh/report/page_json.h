// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_JSON_H
#define FLATTEN_MESH_PAGE_JSON_H

#include "flatten_mesh/json.h"
#include "flatten_mesh/report/Displayed_surface.h"
#include "flatten_mesh/report/Measure_summary.h"
#include "flatten_mesh/report/Report_contents.h"
#include "flatten_mesh/report/page_arrays.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline std::string json_numbers(const std::vector<double>& numbers)
{
  return json_array(numbers, [&numbers](const std::size_t i) { return json_number(numbers[i]); });
}

inline std::string row_json(const Report_row& row)
{
  return row.value.empty() ? json_texts({row.label}) : json_texts({row.label, row.value, row.remark});
}

inline std::string chart_json(const Report_contents::Chart_row& chart)
{
  Json_object json;
  json.add("triangles", json_number(chart.triangles));
  json.add("share_of_area", json_number(chart.share_of_area));
  json.add("method", json_text(chart.method));
  json.add("l2_stretch", json_number(chart.l2_stretch));
  json.add("scale_stretch", json_number(chart.scale_stretch));
  json.add("seam_jump", json_number(chart.seam_jump));
  return json.text();
}

// Faces are counted from 0 here.
inline std::string page_skipped_json(const Skipped_part& part)
{
  Json_object json;
  json.add("faces", json_number(part.faces));
  json.add("first_face", json_number(part.first_face));
  json.add("diagnosis", json_text(part.status));
  json.add("message", json_text(part.message));
  return json.text();
}

// `shown` are the numbers of the triangles that are drawn, rising. The worst ones are among them.
inline std::string measure_json(const Measure_of_triangles& measure, const Measure_summary& summary,
                                const std::vector<Wedge_mesh::Index>& faces,
                                const std::vector<std::size_t>& shown)
{
  const auto worst = [&](const std::size_t i) {
    const std::size_t t = summary.worst[i];
    const auto place = std::lower_bound(shown.begin(), shown.end(), t);
    Json_object json;
    json.add("triangle", json_number(place - shown.begin()));
    json.add("face", json_number(faces[t]));
    json.add("value", json_number(measure.values[t]));
    return json.text();
  };
  Json_object json, histogram;
  histogram.add("first", json_number(summary.first));
  histogram.add("width", json_number(summary.width));
  histogram.add("shares", json_numbers(summary.shares));
  json.add("name", json_text(measure.name));
  json.add("title", json_text(measure.title));
  json.add("unit", json_text(measure.unit));
  json.add("best", json_number(measure.best));
  json.add("limits", json_numbers({summary.low, summary.high}));
  json.add("histogram", histogram.text());
  json.add("worst", json_array(summary.worst, worst));
  return json.text();
}

} // namespace internal

// The measures of all triangles, with their summaries
struct Page_measures
{
  std::array<Measure_of_triangles, 3> measures;
  std::array<Measure_summary, 3> summaries;
  double scale;
};

// What the page tells in words and single numbers, as JSON that is safe within HTML
inline std::string page_json(const Report_contents& contents, const Page_measures& all,
                             const Displayed_surface& shown, const Display_factors& factors)
{
  using internal::json_array;
  using internal::json_number;
  using internal::json_text;
  const CGAL::Bbox_2& box = contents.box;
  internal::Json_object json;
  json.add("title", json_text(contents.title));
  json.add("version", json_text(ABF_VERSION));
  json.add("kind", json_text(contents.is_atlas ? "atlas" : "chart"));
  json.add("up", json_text(contents.up));
  json.add("triangles", json_number(contents.surface.triangles.size()));
  json.add("shown_triangles", json_number(shown.origins.size()));
  json.add("box", internal::json_numbers({factors.plane * box.xmin(), factors.plane * box.ymin(),
                                          factors.plane * box.xmax(), factors.plane * box.ymax()}));
  json.add("pages", json_number(contents.pages));
  json.add("is_packed", internal::json_bool(contents.is_packed));
  if(contents.is_packed) {
    json.add("resolution", json_number(contents.resolution));
  }
  json.add("scale", json_number(all.scale * factors.plane / factors.surface));
  json.add("rows", json_array(contents.rows,
                              [&](const std::size_t i) { return internal::row_json(contents.rows[i]); }));
  json.add("notes", internal::json_texts(contents.notes));
  json.add("charts", json_array(contents.charts, [&](const std::size_t i) {
             return internal::chart_json(contents.charts[i]);
           }));
  json.add("skipped", json_array(contents.skipped, [&](const std::size_t i) {
             return internal::page_skipped_json(contents.skipped[i]);
           }));
  json.add("measures", json_array(all.measures, [&](const std::size_t i) {
             return internal::measure_json(all.measures[i], all.summaries[i], contents.faces, shown.origins);
           }));
  return boost::replace_all_copy(json.text(), "<", "\\u003c");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_JSON_H
