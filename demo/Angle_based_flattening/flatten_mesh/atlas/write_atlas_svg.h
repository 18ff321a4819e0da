// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_ATLAS_SVG_H
#define FLATTEN_MESH_WRITE_ATLAS_SVG_H

#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/pictures/Textured_surface.h"
#include "flatten_mesh/pictures/chart_colors.h"
#include "flatten_mesh/pictures/svg_paths.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Bbox_2.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

namespace flatten_mesh {

namespace internal {

// "#rrggbb", lighter than on the surface
inline std::string light_color_of_chart(const int chart)
{
  std::string text = "#";
  for(const double part : color_of_chart(chart)) {
    char digits[3];
    std::snprintf(digits, sizeof(digits), "%02x",
                  static_cast<unsigned>(std::lround(255 * (0.55 + 0.45 * part))) & 255u);
    text += digits;
  }
  return text;
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
    text += "<path fill=\"" + light_color_of_chart(chart) + "\" d=\"" + path + "\"/>\n";
  }
  return text;
}

} // namespace internal

// A picture of the charts in the plane, with the outline of a box. Both sides of a seam have the same colour; borders
// of the surface are dark.
inline void write_atlas_svg(Output_file& file, const Textured_surface& surface, const CGAL::Bbox_2& box,
                            const std::string& title)
{
  const int width_of_seams = 260;
  const Svg_frame frame(box);
  std::string text = svg_head(frame.width(), frame.height(), title);
  text += "<g transform=\"scale(.01)\" stroke=\"#222\" stroke-width=\"100\" stroke-linejoin=\"bevel\" "
          "fill-rule=\"evenodd\">\n";
  text += "<rect width=\"" + format_number("%.0f", 100 * frame.width()) + "\" height=\"" +
          format_number("%.0f", 100 * frame.height()) + "\" fill=\"none\" stroke=\"#999\"/>\n";
  text += internal::chart_paths(surface, frame);
  text += seam_lines(surface, frame, width_of_seams);
  file.write(text + "</g>\n</svg>\n");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_ATLAS_SVG_H
