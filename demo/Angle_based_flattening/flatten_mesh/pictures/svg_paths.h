// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SVG_PATHS_H
#define FLATTEN_MESH_SVG_PATHS_H

#include "flatten_mesh/pictures/Textured_surface.h"
#include "flatten_mesh/pictures/seam_chains.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace flatten_mesh {

// Maps a box in the plane, y up, to integer hundredths of a unit of the picture, y down.
class Svg_frame
{
public:
  using Position = std::pair<long, long>;

  static constexpr double extent = 1500; // the longer side of the box in the picture
  static constexpr double margin = 20;

  explicit Svg_frame(const CGAL::Bbox_2& box) : m_box(box)
  {
    const double longest = (std::max)(box.x_span(), box.y_span());
    m_scale = longest > 0 ? extent / longest : 1.;
  }

  double width() const { return m_scale * m_box.x_span(); }

  double height() const { return m_scale * m_box.y_span(); }

  Position operator()(const Kernel::Point_2& uv) const
  {
    return {std::lround(100 * m_scale * (uv.x() - m_box.xmin())),
            std::lround(100 * m_scale * (m_box.ymax() - uv.y()))};
  }

private:
  CGAL::Bbox_2 m_box;
  double m_scale;
};

inline std::string svg_head(const double width, const double height, const std::string& title)
{
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + format_number("%.0f", -Svg_frame::margin) +
         " " + format_number("%.0f", -Svg_frame::margin) + " " +
         format_number("%.0f", width + 2 * Svg_frame::margin) + " " +
         format_number("%.0f", height + 2 * Svg_frame::margin) + "\">\n<title>" + title + "</title>\n";
}

inline void append_position(std::string& path, const char command, const long x, const long y)
{
  path += command;
  append_number(path, x);
  if(y >= 0) {
    path += ' ';
  }
  append_number(path, y);
}

inline void append_border(std::string& path, const Textured_surface& surface,
                          const Textured_surface::Border& border, const Svg_frame& frame)
{
  char command = 'M';
  for(const Textured_surface::Side& side : border.sides) {
    const Svg_frame::Position position = frame(surface.start(side));
    append_position(path, command, position.first, position.second);
    command = 'L';
  }
  path += 'z';
}

// Lines along the seams, with their width in hundredths. Both sides of a seam have the same colour.
inline std::string seam_lines(const Textured_surface& surface, const Svg_frame& frame, const int width)
{
  std::map<int, std::string> paths;
  for(const Textured_surface::Border& border : surface.borders) {
    for(const Textured_surface::Side& side : border.sides) {
      if(side.seam >= 0) {
        const Svg_frame::Position p = frame(surface.start(side)), q = frame(surface.end(side));
        append_position(paths[side.seam], 'M', p.first, p.second);
        append_position(paths[side.seam], 'L', q.first, q.second);
      }
    }
  }
  std::string text;
  for(const auto& [seam, path] : paths) {
    text += "<path fill=\"none\" stroke-width=\"" + std::to_string(width) +
            "\" stroke-linecap=\"round\" stroke=\"" + chain_color(seam) + "\" d=\"" + path + "\"/>\n";
  }
  return text;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SVG_PATHS_H
