// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BAKING_RECORD_H
#define FLATTEN_MESH_BAKING_RECORD_H

#include "flatten_mesh/Json.h"
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

inline Json baking_json(const Baking_record& record)
{
  const auto& report = record.report;
  return {{"from", record.from},
          {"triangles", record.triangles},
          {"colors", record.has_colors},
          {"chart_texels", report.number_of_chart_texels},
          {"gutter_texels", report.number_of_gutter_texels},
          {"missed_rays", report.number_of_missed_rays},
          {"back_faces", report.number_of_back_faces},
          {"reach", report.ray_length},
          {"mean_distance", report.mean_distance},
          {"largest_distance", report.largest_distance},
          {"least_displacement", record.least_displacement},
          {"greatest_displacement", record.greatest_displacement}};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BAKING_RECORD_H
