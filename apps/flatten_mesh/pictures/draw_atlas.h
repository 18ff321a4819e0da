// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DRAW_ATLAS_H
#define FLATTEN_MESH_DRAW_ATLAS_H

#include "pictures/Canvas.h"
#include "pictures/Surface_view.h"
#include "pictures/Textured_surface.h"
#include "flatten_mesh/pictures/Up_axis.h"
#include "pictures/Drawing.h"
#include "pictures/draw_checkerboard.h"
#include "flatten_mesh/pictures/draw_plane.h"
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

using namespace pictures;

namespace internal {

struct Named_view
{
  std::string name;
  Surface_view view;
};

inline std::array<Named_view, 6> six_sides(const Upright& upright)
{
  const auto& [right, back, up] = upright;
  return {{{"front", {-back, up}},
           {"right", {right, up}},
           {"back", {back, up}},
           {"left", {-right, up}},
           {"top", {up, back}},
           {"bottom", {-up, back}}}};
}

// Draws the six sides, all on the same scale: above from the front, the right and the back, below from the left, the
// top and the bottom.
inline void draw_six_sides(const Textured_surface& surface, const Upright& upright, const int size,
                           Drawing& drawing)
{
  const double margin = 12, size_of_names = 15, squares = 20, width_of_seams = 2;
  const double top = 2 * margin + size_of_names;
  const Frame frame{margin, top, size - 2. * margin, size - margin - top};
  const std::array<Named_view, 6> sides = six_sides(upright);
  const std::vector<Kernel::Vector_3> normals = point_normals(surface);
  const double side = std::sqrt(textured_areas(surface).plane) / squares;
  std::array<CGAL::Bbox_2, 6> boxes;
  double scale = std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < boxes.size(); ++i) {
    boxes[i] = box_of(surface, sides[i].view);
    scale = (std::min)(scale, Projection::scale_to_fit(boxes[i], frame));
  }
  for(std::size_t i = 0; i < sides.size(); ++i) {
    Canvas canvas(size, size);
    const Projection projection(sides[i].view, boxes[i], frame, scale);
    draw_checkerboard(canvas, surface, normals, side, projection);
    draw_seams(canvas, surface, width_of_seams, projection);
    const double left = size * static_cast<double>(i % 3), above = i < 3 ? 0 : size;
    drawing.paste(canvas.pixels(), left, above);
    drawing.write(left + margin, above + margin + size_of_names, size_of_names, sides[i].name, ink);
  }
}

} // namespace internal

// A picture of an atlas, as a PNG file: six sides of the surface, and beside them the plane with outlines of the pages.
// Triangles without chart are red.
inline std::string atlas_picture(const Textured_surface& surface, const Upright& upright,
                                 const std::vector<CGAL::Bbox_2>& pages)
{
  const int size = 420, margin = 12;
  Drawing drawing(Drawing::PNG, 5 * size, 2 * size);
  internal::draw_six_sides(surface, upright, size, drawing);
  internal::draw_pages_of_atlas(
      internal::Plane(drawing, surface, box_around(pages), 3 * size + margin, margin, 2 * (size - margin)),
      pages);
  return drawing.file();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DRAW_ATLAS_H
