// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_JSON_H
#define FLATTEN_MESH_PAGE_JSON_H

#include "flatten_mesh/Json.h"
#include "flatten_mesh/report/Displayed_surface.h"
#include "flatten_mesh/report/Measure_summary.h"
#include "flatten_mesh/report/Report_contents.h"
#include "flatten_mesh/report/page_arrays.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline Json row_json(const Report_row& row)
{
  return row.value.empty() ? Json::array({row.label}) : Json::array({row.label, row.value, row.remark});
}

inline Json chart_row_json(const Report_contents::Chart_row& chart)
{
  return {{"triangles", chart.triangles},
          {"share_of_area", chart.share_of_area},
          {"method", chart.method},
          {"l2_stretch", chart.l2_stretch},
          {"scale_stretch", chart.scale_stretch},
          {"seam_jump", chart.seam_jump}};
}

// Faces are counted from 0 here.
inline Json page_skipped_json(const CGAL::Texture_atlas::Atlas_report::Skipped& part)
{
  return {{"faces", part.number_of_faces},
          {"first_face", part.first_face},
          {"diagnosis", to_string(part.status)},
          {"message", part.message}};
}

// `shown` are the numbers of the triangles that are drawn, rising. The worst ones are among them.
inline Json measure_json(const Measure_of_triangles& measure, const Measure_summary& summary,
                         const std::vector<Wedge_mesh::Index>& faces, const std::vector<std::size_t>& shown)
{
  const auto worst = [&](const std::size_t t) -> Json {
    const auto place = std::lower_bound(shown.begin(), shown.end(), t);
    return {{"triangle", place - shown.begin()}, {"face", faces[t]}, {"value", measure.values[t]}};
  };
  return {{"name", measure.name},
          {"title", measure.title},
          {"unit", measure.unit},
          {"best", measure.best},
          {"limits", {summary.low, summary.high}},
          {"histogram", {{"first", summary.first}, {"width", summary.width}, {"shares", summary.shares}}},
          {"worst", json_array(summary.worst, worst)}};
}

} // namespace internal

// The measures of all triangles, with their summaries
struct Page_measures
{
  std::array<Measure_of_triangles, 3> measures;
  std::array<Measure_summary, 3> summaries;
  double scale;
};

// What the page tells in words and single numbers
inline Json page_json(const Report_contents& contents, const Page_measures& all,
                      const Displayed_surface& shown, const Display_factors& factors)
{
  const CGAL::Bbox_2& box = contents.box;
  Json measures = Json::array();
  for(std::size_t i = 0; i < all.measures.size(); ++i) {
    measures.push_back(
        internal::measure_json(all.measures[i], all.summaries[i], contents.faces, shown.origins));
  }
  Json json = {{"title", contents.title},
               {"version", ABF_VERSION},
               {"kind", contents.is_atlas ? "atlas" : "chart"},
               {"up", contents.up},
               {"triangles", contents.surface.triangles.size()},
               {"shown_triangles", shown.origins.size()},
               {"box",
                {factors.plane * box.xmin(), factors.plane * box.ymin(), factors.plane * box.xmax(),
                 factors.plane * box.ymax()}},
               {"pages", contents.pages},
               {"is_packed", contents.is_packed},
               {"scale", all.scale * factors.plane / factors.surface},
               {"rows", internal::json_array(contents.rows, internal::row_json)},
               {"notes", contents.notes},
               {"charts", internal::json_array(contents.charts, internal::chart_row_json)},
               {"skipped", internal::json_array(contents.skipped, internal::page_skipped_json)},
               {"measures", std::move(measures)}};
  if(contents.is_packed) {
    json["resolution"] = contents.resolution;
  }
  return json;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_JSON_H
