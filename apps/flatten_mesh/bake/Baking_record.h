// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BAKING_RECORD_H
#define FLATTEN_MESH_BAKING_RECORD_H

#include "flatten_mesh/json.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/Baked_textures.h>

#include <cstddef>
#include <string>

namespace flatten_mesh {

// What the reports say about baking
struct Baking_record
{
  std::string from;          // the file; empty if nothing is baked
  std::size_t triangles = 0; // of the fine surface
  bool has_colors = false;
  double least_displacement = 0, greatest_displacement = 0;
  CGAL::Texture_atlas::Baking_report report;
  double seconds = 0;

  double share(const std::size_t texels) const
  {
    return report.number_of_chart_texels == 0
               ? 0
               : static_cast<double>(texels) / static_cast<double>(report.number_of_chart_texels);
  }
};

inline Report_rows baking_rows(const Baking_record& record)
{
  const auto share = [&record](const std::size_t texels) {
    return format_number("%.3g %%", 100 * record.share(texels));
  };
  const auto& report = record.report;
  return {{"baked", count_text(report.number_of_chart_texels, "texel"),
           "from " + count_text(record.triangles, "triangle") + " of " + record.from + "; " +
               count_text(report.number_of_gutter_texels, "texel") + " around the charts"},
          {"  missed", share(report.number_of_missed_rays),
           "of the rays met nothing: there, the closest point was taken"},
          {"  back faces", share(report.number_of_back_faces),
           "of the rays met only back faces: there, normals were reversed"},
          {"  distance", format_number("%.4g", report.mean_distance),
           "mean; largest " + format_number("%.4g", report.largest_distance) + "; rays reach " +
               format_number("%.4g", report.ray_length)},
          {"  displacement", format_number("%.4g", record.least_displacement),
           "black in the picture; white is " + format_number("%.4g", record.greatest_displacement)}};
}

inline std::string baking_json(const Baking_record& record)
{
  using internal::json_number;
  const auto& report = record.report;
  internal::Json_object json;
  json.add("from", internal::json_text(record.from));
  json.add("triangles", json_number(record.triangles));
  json.add("colors", record.has_colors ? "true" : "false");
  json.add("chart_texels", json_number(report.number_of_chart_texels));
  json.add("gutter_texels", json_number(report.number_of_gutter_texels));
  json.add("missed_rays", json_number(report.number_of_missed_rays));
  json.add("back_faces", json_number(report.number_of_back_faces));
  json.add("reach", json_number(report.ray_length));
  json.add("mean_distance", json_number(report.mean_distance));
  json.add("largest_distance", json_number(report.largest_distance));
  json.add("least_displacement", json_number(record.least_displacement));
  json.add("greatest_displacement", json_number(record.greatest_displacement));
  return json.text();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BAKING_RECORD_H
