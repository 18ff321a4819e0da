// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_SVG_H
#define FLATTEN_MESH_WRITE_SVG_H

#include "flatten_mesh/pictures/Distortion_scale.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/pictures/Textured_surface.h"
#include "flatten_mesh/pictures/svg_paths.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// A corner of a prescribed border, or a copy of a cone
struct Angle_mark
{
  Kernel::Point_2 uv;
  std::string title;
};

namespace internal {

// One path for each colour: three corners a triangle, the last two relative to the one before.
inline std::vector<std::string> triangle_paths(const Textured_surface& surface,
                                               const std::vector<double>& distortions, const Svg_frame& frame,
                                               const Distortion_scale& scale)
{
  std::vector<std::string> paths(Distortion_scale::number_of_colors);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.uv[t];
    const std::array<Svg_frame::Position, 3> p = {frame(b), frame(c), frame(a)};
    if(p[0] != p[1] || p[0] != p[2]) { // otherwise too small to be seen
      std::string& path = paths[static_cast<std::size_t>(scale.color_index(distortions[t]))];
      append_position(path, 'M', p[0].first, p[0].second);
      append_position(path, 'l', p[1].first - p[0].first, p[1].second - p[0].second);
      append_position(path, 'l', p[2].first - p[1].first, p[2].second - p[1].second);
      path += 'z';
    }
  }
  return paths;
}

inline std::string svg_text(const double x, const double y, const std::string& anchor,
                            const std::string& text)
{
  return "<text x=\"" + format_number("%.1f", x) + "\" y=\"" + format_number("%.1f", y) +
         "\" text-anchor=\"" + anchor + "\">" + text + "</text>\n";
}

// The colours in a row, with the powers of ten below.
inline std::string legend(const Distortion_scale& scale, const double left, const double top,
                          const double width)
{
  std::string text = "<g font-family=\"sans-serif\" font-size=\"22\" fill=\"#333\">\n";
  text += svg_text(left, top, "start", "change of the angles of each triangle, in degrees");
  for(int color = 0; color < Distortion_scale::number_of_colors; ++color) {
    const double x = width * color / Distortion_scale::number_of_colors; // up to the end, without hairlines
    text += "<rect x=\"" + format_number("%.2f", left + x) + "\" y=\"" + format_number("%.2f", top + 12) +
            "\" width=\"" + format_number("%.2f", width - x) + "\" height=\"18\" fill=\"" +
            Distortion_scale::color(color) + "\"/>\n";
  }
  const int decades = scale.last_decade() - scale.first_decade();
  for(int i = 0; i <= decades; ++i) {
    const std::string anchor = i == 0 ? "start" : i == decades ? "end" : "middle";
    text += svg_text(left + width * i / decades, top + 54, anchor,
                     "1e" + std::to_string(scale.first_decade() + i));
  }
  return text + "</g>\n";
}

// A dot at each marked place. Viewers show its title.
inline std::string angle_marks(const std::vector<Angle_mark>& marks, const Svg_frame& frame)
{
  std::string text;
  for(const Angle_mark& mark : marks) {
    const Svg_frame::Position position = frame(mark.uv);
    text += "<circle cx=\"" + std::to_string(position.first) + "\" cy=\"" + std::to_string(position.second) +
            "\" r=\"900\" fill=\"#d22\" stroke=\"#fff\" stroke-width=\"250\"><title>" + mark.title +
            "</title></circle>\n";
  }
  return text;
}

inline std::string svg_drawing(const Textured_surface& surface, const std::vector<double>& distortions,
                               const std::vector<Angle_mark>& marks, const Svg_frame& frame,
                               const Distortion_scale& scale)
{
  const int width_of_seams = 350;
  std::string borders;
  for(const Textured_surface::Border& border : surface.borders) {
    append_border(borders, surface, border, frame);
  }
  // Strokes in the colour of the triangles close the hairlines between neighbours.
  std::string text = "<g transform=\"scale(.01)\" stroke-width=\"70\" stroke-linejoin=\"bevel\">\n";
  const std::vector<std::string> paths = triangle_paths(surface, distortions, frame, scale);
  for(std::size_t i = 0; i < paths.size(); ++i) {
    if(!paths[i].empty()) {
      const std::string color = Distortion_scale::color(static_cast<int>(i));
      text += "<path fill=\"" + color + "\" stroke=\"" + color + "\" d=\"" + paths[i] + "\"/>\n";
    }
  }
  return text + "<path fill=\"none\" stroke=\"#222\" stroke-width=\"120\" d=\"" + borders + "\"/>\n" +
         seam_lines(surface, frame, width_of_seams) + angle_marks(marks, frame) + "</g>\n";
}

} // namespace internal

// A picture of the chart, coloured by the change of angles, with a legend below. Seams are coloured lines.
inline void write_svg(Output_file& file, const Textured_surface& surface,
                      const std::vector<double>& distortions, const std::vector<Angle_mark>& marks)
{
  CGAL::Bbox_2 chart_box;
  for(const std::array<Kernel::Point_2, 3>& corners : surface.uv) {
    chart_box += CGAL::bbox_2(corners.begin(), corners.end());
  }
  const Svg_frame frame(chart_box);
  const Distortion_scale scale(distortions);

  const double legend_width = 560;
  const double legend_height = 90;
  const double width = (std::max)(frame.width(), legend_width);
  const double height = frame.height() + legend_height;
  std::string text =
      svg_head(width, height, "Angle-based flattening, " + count_text(surface.triangles.size(), "triangle"));
  text += internal::svg_drawing(surface, distortions, marks, frame, scale);
  text += internal::legend(scale, 0, frame.height() + 40, legend_width);
  file.write(text + "</svg>\n");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_SVG_H
