// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CONTENTS_OF_CHART_H
#define FLATTEN_MESH_CONTENTS_OF_CHART_H

#include "flatten_mesh/atlas/Atlas_input.h"
#include "pictures/Textured_surface.h"
#include "flatten_mesh/plain/report_chart.h"
#include "flatten_mesh/report/Report_contents.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/bounding_box.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

namespace flatten_mesh {

using namespace pictures;
using namespace CGAL::Texture_atlas::internal::prepare;

// `surface` has the triangles of the input's mesh that are in the chart, in their order.
inline Report_contents contents_of_chart(const Atlas_input& input, const Atlas& atlas,
                                         const Chart_record& record, Textured_surface surface,
                                         const std::string& up)
{
  const Flattening& flattening = record.flattening;
  Report_contents contents;
  contents.title = std::filesystem::path(record.input).filename().string();
  contents.is_atlas = false;
  contents.rows = surface_rows(record);
  contents.notes = record.notes;
  contents.charts = {{surface.triangles.size(), 1, flattening.method, flattening.measures.l2_stretch,
                      flattening.scale_stretch,
                      record.seams && flattening.method == "direct"
                          ? std::exp(flattening.report.largest_seam_jump)
                          : std::numeric_limits<double>::quiet_NaN()}};
  contents.up = up;
  for(const Face f : input.mesh.faces()) {
    if(atlas.chart[f] >= 0) {
      contents.faces.push_back(static_cast<Textured_surface::Index>(face_in_file(input, f)));
    }
  }
  contents.surface = std::move(surface);
  for(const std::array<Kernel::Point_2, 3>& corners : contents.surface.uv) {
    contents.box += CGAL::bbox_2(corners.begin(), corners.end());
  }
  std::fill(contents.surface.charts.begin(), contents.surface.charts.end(),
            0); // also of a chart that was split
  for(Textured_surface::Border& border : contents.surface.borders) {
    border.chart = 0;
  }
  return contents;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CONTENTS_OF_CHART_H
