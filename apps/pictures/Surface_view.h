// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_SURFACE_VIEW_H
#define PICTURES_SURFACE_VIEW_H

#include "pictures/Canvas.h"
#include "pictures/Textured_surface.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace pictures {

// A part of the canvas, in pixels.
struct Frame
{
  double left, top, width, height;
};

// The directions of a surface that stands upright, for one who is in front of it
struct Upright
{
  Kernel::Vector_3 right, back, up;

  // The axis "x", "y" or "z" points upwards. With y, the front is that of glTF.
  static Upright of(const std::string& axis)
  {
    using Vector = Kernel::Vector_3;
    const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    return axis == "x" ? Upright{y, z, x} : axis == "y" ? Upright{x, -z, y} : Upright{x, y, z};
  }
};

// From where a surface is seen; without perspective.
class Surface_view
{
  using Vector = Kernel::Vector_3;

public:
  // `towards_eye` is a direction; `up` is upright in the picture.
  Surface_view(const Vector& towards_eye, const Vector& up)
      : m_depth(normalized(towards_eye)), m_right(normalized(CGAL::cross_product(up, m_depth))),
        m_up(CGAL::cross_product(m_depth, m_right))
  {}

  // A surface that faces mainly one way is seen from there, others from the front, slightly from above and from the
  // right.
  static Surface_view of(const Textured_surface& surface, const Upright& upright)
  {
    Vector sum(0, 0, 0);
    double area = 0;
    for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const Vector normal = surface.doubled_area_vector(t);
      sum = sum + normal;
      area += std::sqrt(normal.squared_length());
    }
    const double one_sided = std::sqrt(sum.squared_length()) / area;
    const auto& [right, back, up] = upright;
    const Vector towards_eye = one_sided > 0.25 ? sum : 0.5 * right - back + 0.45 * up;
    const bool is_from_above = std::abs(normalized(towards_eye) * up) > 0.9;
    return Surface_view(towards_eye, is_from_above ? back : up);
  }

  // Right, up, and towards the eye.
  Vector operator()(const Vector& v) const { return Vector(v * m_right, v * m_up, v * m_depth); }

  static Vector normalized(const Vector& v)
  {
    const double length = std::sqrt(v.squared_length());
    return length > 0 ? v / length : v;
  }

private:
  Vector m_depth, m_right, m_up;
};

// A place on the surface becomes one in the picture, without values.
class Projection
{
public:
  // A view of something with this box, in the middle of a frame and as large as fits.
  Projection(const Surface_view& view, const CGAL::Bbox_2& box, const Frame& frame)
      : Projection(view, box, frame, scale_to_fit(box, frame))
  {}

  Projection(const Surface_view& view, const CGAL::Bbox_2& box, const Frame& frame, const double scale)
      : m_view(view), m_scale(scale),
        m_left(frame.left + (frame.width - scale * box.x_span()) / 2 - scale * box.xmin()),
        m_top(frame.top + (frame.height - scale * box.y_span()) / 2 + scale * box.ymax())
  {}

  static double scale_to_fit(const CGAL::Bbox_2& box, const Frame& frame)
  {
    return (std::min)(frame.width / (std::max)(box.x_span(), 1e-300),
                      frame.height / (std::max)(box.y_span(), 1e-300));
  }

  Canvas::Corner operator()(const Kernel::Point_3& point) const
  {
    const Kernel::Vector_3 p = m_view(point - CGAL::ORIGIN);
    return {m_left + m_scale * p.x(), m_top - m_scale * p.y(), m_scale * p.z(), {}};
  }

  const Surface_view& view() const { return m_view; }

private:
  Surface_view m_view;
  double m_scale, m_left, m_top;
};

// The box of the triangles in the picture, before they are scaled
inline CGAL::Bbox_2 box_of(const Textured_surface& surface, const Surface_view& view)
{
  CGAL::Bbox_2 box;
  for(const auto& triangle : surface.triangles) {
    for(const Textured_surface::Index v : triangle) {
      const Kernel::Vector_3 p = view(surface.points[v] - CGAL::ORIGIN);
      box += CGAL::Bbox_2(p.x(), p.y(), p.x(), p.y());
    }
  }
  return box;
}

} // namespace pictures

#endif // PICTURES_SURFACE_VIEW_H
