// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_POLYGON_SOUP_H
#define FLATTEN_MESH_POLYGON_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <vector>

namespace flatten_mesh {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = std::vector<std::size_t>;

// Points and polygons in the order of the file.
struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
  bool is_welded = false; // from a file without indices, such as STL: the reader merged equal points
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_POLYGON_SOUP_H
