// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DRAW_PLANE_H
#define FLATTEN_MESH_DRAW_PLANE_H

#include "pictures/Distortion_scale.h"
#include "pictures/Drawing.h"
#include "pictures/Textured_surface.h"
#include "pictures/chart_colors.h"
#include "flatten_mesh/pictures/page_boxes.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace pictures;

// A corner of a prescribed border, or a copy of a cone
struct Angle_mark
{
  Kernel::Point_2 uv;
  std::string title;
};

namespace internal {

const Color ink = {0.13, 0.13, 0.13};

// The plane in a square of a drawing, y up. Lines are as wide as they should be if it is 1500 pixels wide.
class Plane
{
public:
  Plane(Drawing& drawing, const Textured_surface& surface, const CGAL::Bbox_2& box, const double left,
        const double top, const double size)
      : m_drawing(drawing), m_surface(surface), m_box(box), m_left(left), m_top(top), m_size(size),
        m_scale(scale(box, size))
  {}

  static double scale(const CGAL::Bbox_2& box, const double size)
  {
    return size / (std::max)({box.x_span(), box.y_span(), 1e-300});
  }

  std::pair<double, double> place(const Kernel::Point_2& uv) const
  {
    return {m_left + m_scale * (uv.x() - m_box.xmin()), m_top + m_scale * (m_box.ymax() - uv.y())};
  }

  // The borders of holes run the other way round than that around the chart, which leaves them out.
  void draw_charts() const
  {
    std::map<int, std::vector<const Textured_surface::Border*>> borders;
    for(const Textured_surface::Border& border : m_surface.borders) {
      borders[border.chart].push_back(&border);
    }
    for(const auto& [chart, borders_of_chart] : borders) {
      for(const Textured_surface::Border* const border : borders_of_chart) {
        add(*border);
      }
      m_drawing.fill(light_color_of_chart(chart));
      m_drawing.stroke(ink, width(1));
    }
  }

  void draw_triangles(const std::vector<double>& distortions, const Distortion_scale& scale) const
  {
    std::vector<std::vector<std::size_t>> triangles(Distortion_scale::number_of_colors);
    for(std::size_t t = 0; t < distortions.size(); ++t) {
      triangles[static_cast<std::size_t>(scale.color_index(distortions[t]))].push_back(t);
    }
    for(std::size_t i = 0; i < triangles.size(); ++i) {
      for(const std::size_t t : triangles[i]) {
        const auto& [a, b, c] = m_surface.uv[t];
        move_to(a);
        line_to(b);
        line_to(c);
        m_drawing.close();
      }
      const Color color = Distortion_scale::color(static_cast<int>(i));
      m_drawing.fill(color);
      m_drawing.stroke(color, width(0.7)); // closes the hairlines between neighbours
    }
  }

  void draw_borders() const
  {
    for(const Textured_surface::Border& border : m_surface.borders) {
      add(border);
    }
    m_drawing.stroke(ink, width(1.2));
  }

  // Both sides of a seam have the same colour.
  void draw_seams(const double line_width) const
  {
    std::map<int, std::vector<Textured_surface::Side>> seams;
    for(const Textured_surface::Border& border : m_surface.borders) {
      for(const Textured_surface::Side& side : border.sides) {
        if(side.seam >= 0) {
          seams[side.seam].push_back(side);
        }
      }
    }
    for(const auto& [seam, sides] : seams) {
      for(const Textured_surface::Side& side : sides) {
        move_to(m_surface.start(side));
        line_to(m_surface.end(side));
      }
      m_drawing.stroke(color_of_seam(seam), width(line_width));
    }
  }

  void draw_pages(const std::vector<CGAL::Bbox_2>& pages) const
  {
    for(const CGAL::Bbox_2& page : pages) {
      const auto [left, top] = place({page.xmin(), page.ymax()});
      m_drawing.rectangle(left, top, m_scale * page.x_span(), m_scale * page.y_span());
      m_drawing.stroke({0.6, 0.6, 0.6}, width(1.5));
    }
  }

private:
  double width(const double pixels) const { return pixels * m_size / 1500; }

  void move_to(const Kernel::Point_2& uv) const
  {
    const auto [x, y] = place(uv);
    m_drawing.move_to(x, y);
  }

  void line_to(const Kernel::Point_2& uv) const
  {
    const auto [x, y] = place(uv);
    m_drawing.line_to(x, y);
  }

  void add(const Textured_surface::Border& border) const
  {
    move_to(m_surface.start(border.sides.front()));
    for(std::size_t i = 1; i < border.sides.size(); ++i) {
      line_to(m_surface.start(border.sides[i]));
    }
    m_drawing.close();
  }

  Drawing& m_drawing;
  const Textured_surface& m_surface;
  CGAL::Bbox_2 m_box;
  double m_left, m_top, m_size, m_scale;
};

inline void draw_pages_of_atlas(const Plane& plane, const std::vector<CGAL::Bbox_2>& pages)
{
  plane.draw_pages(pages);
  plane.draw_charts();
  plane.draw_seams(2.6);
}

// The colours in a row, with the powers of ten below.
inline void draw_legend(const Distortion_scale& scale, const double left, const double top,
                        const double width, Drawing& drawing)
{
  const double size = 22, height = 18;
  drawing.write(left, top, size, "change of the angles of each triangle, in degrees", ink);
  for(int color = 0; color < Distortion_scale::number_of_colors; ++color) {
    const double x = width * color / Distortion_scale::number_of_colors; // up to the end, without hairlines
    drawing.rectangle(left + x, top + 12, width - x, height);
    drawing.fill(Distortion_scale::color(color));
    drawing.end_path();
  }
  const int decades = scale.last_decade() - scale.first_decade();
  for(int i = 0; i <= decades; ++i) {
    const double part = i == 0 ? 0 : i == decades ? 1 : 0.5;
    drawing.write(left + width * i / decades, top + 54, size, "1e" + std::to_string(scale.first_decade() + i),
                  ink, part);
  }
}

const double svg_size = 1500, svg_margin = 20;

// Viewers show the title, and fit a drawing without size to their window.
inline std::string titled(std::string svg, const std::string& title)
{
  const std::size_t size = svg.find("width=", svg.find("<svg"));
  svg.erase(size, svg.find("viewBox=", size) - size);
  return svg.insert(svg.find('>', size) + 1, "\n<title>" + title + "</title>");
}

} // namespace internal

// The charts in the plane, with the outlines of the pages, as an SVG file
inline std::string atlas_svg(const Textured_surface& surface, const std::vector<CGAL::Bbox_2>& pages)
{
  using namespace internal;
  const CGAL::Bbox_2 box = box_around(pages);
  const double scale = Plane::scale(box, svg_size);
  Drawing drawing(Drawing::SVG, scale * box.x_span() + 2 * svg_margin, scale * box.y_span() + 2 * svg_margin);
  draw_pages_of_atlas(Plane(drawing, surface, box, svg_margin, svg_margin, svg_size), pages);
  std::size_t charts = 0;
  for(const int chart : surface.charts) {
    charts = (std::max)(charts, static_cast<std::size_t>(chart + 1));
  }
  return titled(drawing.file(), "Texture atlas, " + count_text(charts, "chart"));
}

// A chart as an SVG file, coloured by the change of angles, with a legend below. Marks are dots whose titles viewers
// show.
inline std::string chart_svg(const Textured_surface& surface, const std::vector<double>& distortions,
                             const std::vector<Angle_mark>& marks)
{
  using namespace internal;
  CGAL::Bbox_2 box;
  for(const std::array<Kernel::Point_2, 3>& corners : surface.uv) {
    box += CGAL::bbox_2(corners.begin(), corners.end());
  }
  const double scale = Plane::scale(box, svg_size), width_of_legend = 560, height_of_legend = 90;
  const double height = scale * box.y_span();
  Drawing drawing(Drawing::SVG, (std::max)(scale * box.x_span(), width_of_legend) + 2 * svg_margin,
                  height + height_of_legend + 2 * svg_margin);
  const Plane plane(drawing, surface, box, svg_margin, svg_margin, svg_size);
  const Distortion_scale colors(distortions);
  plane.draw_triangles(distortions, colors);
  plane.draw_borders();
  plane.draw_seams(3.5);
  draw_legend(colors, svg_margin, svg_margin + height + 40, width_of_legend, drawing);
  std::string dots;
  for(const Angle_mark& mark : marks) {
    const auto [x, y] = plane.place(mark.uv);
    dots += "<circle cx=\"" + format_number("%.2f", x) + "\" cy=\"" + format_number("%.2f", y) +
            "\" r=\"9\" fill=\"#d22\" stroke=\"#fff\" stroke-width=\"2.5\"><title>" + mark.title +
            "</title></circle>\n";
  }
  std::string svg = drawing.file();
  svg.insert(svg.rfind("</svg>"), dots); // Cairo has no titles
  return titled(svg, "Angle-based flattening, " + count_text(surface.triangles.size(), "triangle"));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DRAW_PLANE_H
