// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_CONTENTS_H
#define FLATTEN_MESH_REPORT_CONTENTS_H

#include "pictures/Textured_surface.h"
#include "flatten_mesh/report_rows.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Texture_atlas/Atlas_report.h>

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace pictures;
using namespace CGAL::Texture_atlas::internal::prepare;

// What the page of a report shows
struct Report_contents
{
  struct Chart_row
  {
    std::size_t triangles;
    double share_of_area; // on the surface
    std::string method;
    double l2_stretch, scale_stretch;
    double
        seam_jump; // largest ratio of the lengths of both sides of an edge on a seam; not a number without seams
  };

  std::string title;
  bool is_atlas = true; // otherwise one chart, of `--plain`
  Report_rows rows;
  std::vector<std::string> notes;
  bool is_packed = false;
  int resolution = 0;    // if it is packed
  CGAL::Bbox_2 box;      // of the plane
  std::size_t pages = 1; // in this box, ten in a row
  std::vector<Chart_row> charts;
  std::vector<CGAL::Texture_atlas::Atlas_report::Skipped> skipped;
  Textured_surface surface;
  std::string up;                             // the axis of it that points upwards
  std::vector<Textured_surface::Index> faces; // of each triangle: its face in the file, from 0
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_CONTENTS_H
