// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_ATLAS_SVG_H
#define FLATTEN_MESH_WRITE_ATLAS_SVG_H

#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/pictures/Textured_surface.h"
#include "flatten_mesh/pictures/chart_colors.h"
#include "flatten_mesh/pictures/page_boxes.h"
#include "flatten_mesh/pictures/svg_paths.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Bbox_2.h>

#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// "#rrggbb"
inline std::string color_text(const std::array<unsigned char, 3>& color)
{
  std::string text = "#";
  for(const unsigned part : color) {
    char digits[3];
    std::snprintf(digits, sizeof(digits), "%02x", part & 255u);
    text += digits;
  }
  return text;
}

// The outline of a page
inline std::string page_outline(const CGAL::Bbox_2& page, const Svg_frame& frame)
{
  const auto [left, top] = frame(Kernel::Point_2(page.xmin(), page.ymax()));
  const auto [right, bottom] = frame(Kernel::Point_2(page.xmax(), page.ymin()));
  const std::string corner =
      left == 0 && top == 0 ? "" : "x=\"" + std::to_string(left) + "\" y=\"" + std::to_string(top) + "\" ";
  return "<rect " + corner + "width=\"" + std::to_string(right - left) + "\" height=\"" +
         std::to_string(bottom - top) + "\" fill=\"none\" stroke=\"#999\"/>\n";
}

// One path for each chart: its borders, of which all but one are holes
inline std::string chart_paths(const Textured_surface& surface, const Svg_frame& frame)
{
  std::map<int, std::string> paths;
  for(const Textured_surface::Border& border : surface.borders) {
    append_border(paths[border.chart], surface, border, frame);
  }
  std::string text;
  for(const auto& [chart, path] : paths) {
    text += "<path fill=\"" + color_text(light_color_of_chart(chart)) + "\" d=\"" + path + "\"/>\n";
  }
  return text;
}

} // namespace internal

// A picture of the charts in the plane, with the outlines of the pages. Both sides of a seam have the same colour;
// borders of the surface are dark.
inline void write_atlas_svg(Output_file& file, const Textured_surface& surface,
                            const std::vector<CGAL::Bbox_2>& pages, const std::string& title)
{
  const int width_of_seams = 260;
  const Svg_frame frame(box_around(pages));
  std::string text = svg_head(frame.width(), frame.height(), title);
  text += "<g transform=\"scale(.01)\" stroke=\"#222\" stroke-width=\"100\" stroke-linejoin=\"bevel\" "
          "fill-rule=\"evenodd\">\n";
  for(const CGAL::Bbox_2& page : pages) {
    text += internal::page_outline(page, frame);
  }
  text += internal::chart_paths(surface, frame);
  text += seam_lines(surface, frame, width_of_seams);
  file.write(text + "</g>\n</svg>\n");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_ATLAS_SVG_H
