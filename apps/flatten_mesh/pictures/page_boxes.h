// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_BOXES_H
#define FLATTEN_MESH_PAGE_BOXES_H

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <vector>

namespace flatten_mesh {

// The pages side by side, ten in a row
inline std::vector<CGAL::Bbox_2> page_boxes(const std::size_t pages, const double width, const double height)
{
  std::vector<CGAL::Bbox_2> boxes;
  for(std::size_t i = 0; i < pages; ++i) {
    const double x = static_cast<double>(i % 10), y = static_cast<double>(i / 10);
    boxes.emplace_back(x * width, y * height, (x + 1) * width, (y + 1) * height);
  }
  return boxes;
}

inline CGAL::Bbox_2 box_around(const std::vector<CGAL::Bbox_2>& boxes)
{
  CGAL::Bbox_2 all;
  for(const CGAL::Bbox_2& box : boxes) {
    all += box;
  }
  return all;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_BOXES_H
