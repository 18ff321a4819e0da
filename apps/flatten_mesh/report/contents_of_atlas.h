// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CONTENTS_OF_ATLAS_H
#define FLATTEN_MESH_CONTENTS_OF_ATLAS_H

#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/atlas/Atlas_record.h"
#include "flatten_mesh/atlas/report_atlas_text.h"
#include "pictures/Textured_surface.h"
#include "flatten_mesh/pictures/page_boxes.h"
#include "flatten_mesh/report/Report_contents.h"

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace pictures;

// `surface` has the triangles of the input's mesh in their order.
inline Report_contents contents_of_atlas(const Atlas_input& input, const Atlas_record& record,
                                         Textured_surface surface, const std::string& up,
                                         const std::vector<CGAL::Bbox_2>& pages)
{
  Report_contents contents;
  contents.title = std::filesystem::path(record.input).filename().string();
  contents.rows = surface_rows(record);
  contents.notes = record.notes;
  contents.is_packed = record.options.pack_into_square;
  contents.resolution = record.options.resolution;
  contents.box = box_around(pages);
  contents.pages = pages.size();
  for(std::size_t i = 0; i < record.report.charts.size(); ++i) {
    const TA::Atlas_report::Chart& chart = record.report.charts[i];
    contents.charts.push_back({chart.number_of_faces, record.share_of_area[i], to_string(chart.method),
                               chart.l2_stretch, chart.scale_stretch, internal::seam_jump(chart)});
  }
  contents.skipped = record.report.skipped;
  for(TA::Atlas_report::Skipped& part : contents.skipped) {
    part.message = (record.models.empty() ? "" : record.models[part.mesh].input + ": ") + part.message;
  }
  contents.surface = std::move(surface);
  contents.up = up;
  for(const Face f : input.mesh.faces()) {
    contents.faces.push_back(static_cast<Textured_surface::Index>(face_in_file(input, f)));
  }
  return contents;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CONTENTS_OF_ATLAS_H
