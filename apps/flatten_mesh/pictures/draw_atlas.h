// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DRAW_ATLAS_H
#define FLATTEN_MESH_DRAW_ATLAS_H

#include "flatten_mesh/pictures/Canvas.h"
#include "flatten_mesh/pictures/Surface_view.h"
#include "flatten_mesh/pictures/Textured_surface.h"
#include "flatten_mesh/pictures/Up_axis.h"
#include "flatten_mesh/pictures/chart_colors.h"
#include "flatten_mesh/pictures/draw_checkerboard.h"
#include "flatten_mesh/pictures/draw_word.h"
#include "flatten_mesh/pictures/page_boxes.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

struct Named_view
{
  std::string name;
  Surface_view view;
};

inline std::array<Named_view, 6> six_sides(const Upright& upright)
{
  const auto& [right, back, up] = upright;
  return {{{"FRONT", {-back, up}},
           {"RIGHT", {right, up}},
           {"BACK", {back, up}},
           {"LEFT", {-right, up}},
           {"TOP", {up, back}},
           {"BOTTOM", {-up, back}}}};
}

// Draws the six sides, all on the same scale.
inline std::array<Pixels, 6> draw_six_sides(const Textured_surface& surface, const Upright& upright,
                                            const int size)
{
  const int margin = 12, height_of_names = 11, squares = 20, width_of_seams = 2;
  const double top = 2 * margin + height_of_names;
  const Frame frame{margin, top, size - 2. * margin, size - margin - top};
  const Color ink = {0.35, 0.35, 0.35};
  const std::array<Named_view, 6> sides = six_sides(upright);
  const std::vector<Kernel::Vector_3> normals = point_normals(surface);
  const double side = std::sqrt(textured_areas(surface).plane) / squares;
  std::array<CGAL::Bbox_2, 6> boxes;
  double scale = std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i] = box_of(surface, sides[i].view);
    scale = (std::min)(scale, Projection::scale_to_fit(boxes[i], frame));
  }
  std::array<Pixels, 6> pictures;
  for(std::size_t i = 0; i < pictures.size(); ++i) {
    Canvas canvas(size, size);
    const Projection projection(sides[i].view, boxes[i], frame, scale);
    draw_checkerboard(canvas, surface, normals, side, projection);
    draw_seams(canvas, surface, width_of_seams, projection);
    draw_word(canvas, sides[i].name, margin, margin, height_of_names, ink);
    pictures[i] = canvas.pixels();
  }
  return pictures;
}

// Draws the plane with the outlines of the pages.
inline Pixels draw_plane(const Textured_surface& surface, const std::vector<CGAL::Bbox_2>& pages,
                         const int size)
{
  const CGAL::Bbox_2 box = box_around(pages);
  const double margin = 12, width_of_borders = 1.2, width_of_outline = 2;
  const Color ink = {0.1, 0.1, 0.1}, grey = {0.6, 0.6, 0.6}, white = {1, 1, 1};
  const double scale = (size - 2 * margin) / (std::max)({box.x_span(), box.y_span(), 1e-300});
  const auto corner = [&](const double x, const double y, const double depth) {
    return Canvas::Corner{
        margin + scale * (x - box.xmin()), size - margin - scale * (y - box.ymin()), depth, {}};
  };
  Canvas canvas(size, size);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if(surface.charts[t] >= 0) {
      const auto& [a, b, c] = surface.uv[t];
      const Color color = mix(color_of_chart(surface.charts[t]), white, 0.55);
      canvas.draw_triangle(corner(a.x(), a.y(), 0), corner(b.x(), b.y(), 0), corner(c.x(), c.y(), 0),
                           [&color](const auto&) { return color; });
    }
  }
  for(const Textured_surface::Border& border : surface.borders) {
    for(const Textured_surface::Side& side : border.sides) {
      const Kernel::Point_2 &p = surface.start(side), &q = surface.end(side);
      canvas.draw_line(corner(p.x(), p.y(), 1), corner(q.x(), q.y(), 1), width_of_borders, ink);
    }
  }
  for(const CGAL::Bbox_2& page : pages) {
    const std::array<Canvas::Corner, 4> outline = {
        corner(page.xmin(), page.ymin(), 2), corner(page.xmax(), page.ymin(), 2),
        corner(page.xmax(), page.ymax(), 2), corner(page.xmin(), page.ymax(), 2)};
    for(std::size_t i = 0; i < outline.size(); ++i) {
      canvas.draw_line(outline[i], outline[(i + 1) % 4], width_of_outline, grey);
    }
  }
  return canvas.pixels();
}

} // namespace internal

// A picture of an atlas, as a PNG file: above the surface from the front, the right and the back, below from the
// left, the top and the bottom; beside it the plane with outlines of the pages. Triangles without chart are red.
inline std::string atlas_picture(const Textured_surface& surface, const Upright& upright,
                                 const std::vector<CGAL::Bbox_2>& pages)
{
  const int size = 420, columns = 3, rows = 2;
  Pixels whole{(columns + rows) * size, rows * size, {}};
  whole.bytes.assign(3 * static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height), 255);
  const std::array<Pixels, 6> sides = internal::draw_six_sides(surface, upright, size);
  for(int i = 0; i < columns * rows; ++i) {
    paste(sides[static_cast<std::size_t>(i)], i % columns * size, i / columns * size, whole);
  }
  paste(internal::draw_plane(surface, pages, rows * size), columns * size, 0, whole);
  return png_file(whole);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DRAW_ATLAS_H
