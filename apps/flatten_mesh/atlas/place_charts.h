// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PLACE_CHARTS_H
#define FLATTEN_MESH_PLACE_CHARTS_H

#include "flatten_mesh/texts.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/place_in_rows.h>

#include <cstddef>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

inline CGAL::Bbox_2 box_of(const Mesh& mesh, const Atlas& atlas)
{
  CGAL::Bbox_2 box;
  for_each_corner(mesh, atlas, [&](const Halfedge h, std::size_t) { box += atlas.uv[h].bbox(); });
  return box;
}

inline void scale_charts(const Mesh& mesh, const Atlas& atlas, const double width, const double height)
{
  for_each_corner(mesh, atlas, [&](const Halfedge h, std::size_t) {
    atlas.uv[h] = Kernel::Point_2(width * atlas.uv[h].x(), height * atlas.uv[h].y());
  });
}

// Throws if a triangle has lost its orientation to rounding.
inline void check_orientation(const Mesh& mesh, const Atlas& atlas)
{
  if(first_turned_face(mesh, atlas) != Mesh::null_face()) {
    throw Precision_exceeded("a triangle is so thin that rounding turns it over in world units; use "
                             "--units square without --no-pack");
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PLACE_CHARTS_H
