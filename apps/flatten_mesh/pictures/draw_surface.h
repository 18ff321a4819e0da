// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DRAW_SURFACE_H
#define FLATTEN_MESH_DRAW_SURFACE_H

#include "pictures/Canvas.h"
#include "pictures/Surface_view.h"
#include "pictures/draw_checkerboard.h"
#include "pictures/Textured_surface.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Origin.h>

#include <cmath>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace pictures;

// A picture of the chart with a checkerboard, as a PNG file. Seams are dark lines. The square root of the surface's
// area is about `squares` squares long.
inline std::string checkerboard_picture(const Textured_surface& surface, const Upright& upright)
{
  const int size = 900, squares = 20, width_of_seams = 3;
  Canvas canvas(size, size);
  const Frame frame{20, 20, size - 40., size - 40.};
  const Surface_view view = Surface_view::of(surface, upright);
  const Projection projection(view, box_of(surface, view), frame);
  const double side = std::sqrt(textured_areas(surface).space) / squares;
  draw_checkerboard(canvas, surface, point_normals(surface), side, projection);
  draw_seams(canvas, surface, width_of_seams, projection);
  return canvas.png();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DRAW_SURFACE_H
