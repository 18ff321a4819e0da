// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_DRAW_TILE_H
#define PICTURES_DRAW_TILE_H

#include "pictures/Canvas.h"
#include "pictures/Surface_view.h"
#include "pictures/Textured_surface.h"
#include "pictures/draw_checkerboard.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pictures {

// The side of the squares of a checkerboard in the plane: the root of the area there is about `squares` of them long.
inline double side_of_squares(const Textured_surface& surface, const double squares)
{
  return std::sqrt(textured_areas(surface).plane) / squares;
}

inline CGAL::Bbox_2 box_in_plane(const Textured_surface& surface)
{
  CGAL::Bbox_2 box;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if(surface.charts[t] >= 0) {
      for(const Kernel::Point_2& p : surface.uv[t]) {
        box += p.bbox();
      }
    }
  }
  return box;
}

inline void draw_textured_surface(Canvas& canvas, const Textured_surface& surface, const double side,
                                  const Surface_view& view, const Frame& frame)
{
  const double width_of_seams = 2;
  const Projection projection(view, box_of(surface, view), frame);
  draw_checkerboard(canvas, surface, point_normals(surface), side, projection);
  draw_seams(canvas, surface, width_of_seams, projection);
}

// A box of the plane in the middle of a frame, with the same checkerboard and the borders of the charts as dark lines
class Plane_drawing
{
public:
  Plane_drawing(Canvas& canvas, const CGAL::Bbox_2& box, const Frame& frame)
      : m_canvas(canvas), m_box(box), m_frame(frame), m_scale(Projection::scale_to_fit(box, frame))
  {}

  void draw_charts(const Textured_surface& surface, const double side) const
  {
    const Color white = {1, 1, 1};
    for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const int chart = surface.charts[t];
      if(chart < 0) {
        continue;
      }
      std::array<Canvas::Corner, 3> corners;
      for(std::size_t i = 0; i < 3; ++i) {
        const Kernel::Point_2& p = surface.uv[t][i];
        corners[i] = corner(p.x(), p.y(), 0);
        corners[i].values = {p.x() / side, p.y() / side, 0, 0, 0};
      }
      m_canvas.draw_triangle(corners[0], corners[1], corners[2], [chart, &white](const auto& values) {
        return mix(internal::paint(chart, values[0], values[1], false), white, 0.3);
      });
    }
  }

  void draw_borders(const Textured_surface& surface) const
  {
    const Color ink = {0.08, 0.02, 0.02};
    for(const Textured_surface::Border& border : surface.borders) {
      for(const Textured_surface::Side& side : border.sides) {
        const Kernel::Point_2 &p = surface.start(side), &q = surface.end(side);
        m_canvas.draw_line(corner(p.x(), p.y(), 1), corner(q.x(), q.y(), 1), 1.3, ink);
      }
    }
  }

  void draw_outline() const
  {
    const Color grey = {0.6, 0.6, 0.6};
    const std::array<Canvas::Corner, 4> corners = {
        corner(m_box.xmin(), m_box.ymin(), -1), corner(m_box.xmax(), m_box.ymin(), -1),
        corner(m_box.xmax(), m_box.ymax(), -1), corner(m_box.xmin(), m_box.ymax(), -1)};
    for(std::size_t i = 0; i < corners.size(); ++i) {
      m_canvas.draw_line(corners[i], corners[(i + 1) % 4], 1, grey);
    }
  }

private:
  Canvas::Corner corner(const double x, const double y, const double depth) const
  {
    return {m_frame.left + m_frame.width / 2 + m_scale * (x - (m_box.xmin() + m_box.xmax()) / 2),
            m_frame.top + m_frame.height / 2 - m_scale * (y - (m_box.ymin() + m_box.ymax()) / 2),
            depth,
            {}};
  }

  Canvas& m_canvas;
  CGAL::Bbox_2 m_box;
  Frame m_frame;
  double m_scale;
};

// A packed atlas in the unit square
inline void draw_atlas_square(Canvas& canvas, const Textured_surface& surface, const double side,
                              const Frame& frame)
{
  const Plane_drawing drawing(canvas, CGAL::Bbox_2(0, 0, 1, 1), frame);
  drawing.draw_charts(surface, side);
  drawing.draw_borders(surface);
  drawing.draw_outline();
}

} // namespace pictures

#endif // PICTURES_DRAW_TILE_H
