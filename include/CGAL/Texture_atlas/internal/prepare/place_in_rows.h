// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PLACE_IN_ROWS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PLACE_IN_ROWS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Calls `f(halfedge, chart)` for the corners of all charts.
template <class Function>
void for_each_corner(const Mesh& mesh, const Atlas& atlas, const Function& f)
{
  for(const Face face : mesh.faces()) {
    if(atlas.chart[face] >= 0) {
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
        f(h, static_cast<std::size_t>(atlas.chart[face]));
      }
    }
  }
}

// Moves the charts side by side, in rows of about the same length, the first row below.
inline void place_in_rows(const Mesh& mesh, const Atlas& atlas, const std::size_t charts)
{
  std::vector<CGAL::Bbox_2> boxes(charts);
  for_each_corner(mesh, atlas,
                  [&](const Halfedge h, const std::size_t c) { boxes[c] += atlas.uv[h].bbox(); });
  double area = 0, widest = 0;
  for(const CGAL::Bbox_2& box : boxes) {
    area += box.x_span() * box.y_span();
    widest = (std::max)(widest, box.x_span());
  }
  const double row_length = (std::max)(widest, 1.2 * std::sqrt(area)), gap = row_length / 100;
  std::vector<Kernel::Vector_2> shifts;
  double x = 0, y = 0, height = 0;
  for(const CGAL::Bbox_2& box : boxes) {
    if(x > 0 && x + box.x_span() > row_length) {
      x = 0;
      y += height + gap;
      height = 0;
    }
    shifts.emplace_back(x - box.xmin(), y - box.ymin());
    x += box.x_span() + gap;
    height = (std::max)(height, box.y_span());
  }
  for_each_corner(mesh, atlas,
                  [&](const Halfedge h, const std::size_t c) { atlas.uv[h] = atlas.uv[h] + shifts[c]; });
}

// The first triangle that has lost its orientation to rounding, or no face
inline Face first_turned_face(const Mesh& mesh, const Atlas& atlas)
{
  for(const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    if(atlas.chart[f] >= 0 &&
       orientation(atlas.uv[h], atlas.uv[mesh.next(h)], atlas.uv[mesh.prev(h)]) != LEFT_TURN) {
      return f;
    }
  }
  return Mesh::null_face();
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PLACE_IN_ROWS_H
