// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_UP_AXIS_H
#define FLATTEN_MESH_UP_AXIS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/file_names.h"
#include "pictures/Surface_view.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace flatten_mesh {

using namespace pictures;

namespace internal {

inline CGAL::Bbox_3 box_of_triangles(const Textured_surface& surface)
{
  CGAL::Bbox_3 box;
  for(const auto& triangle : surface.triangles) {
    for(const Textured_surface::Index v : triangle) {
      box += surface.points[v].bbox();
    }
  }
  return box;
}

// By how much the lowest part of a surface extends further than the highest, as a part of its box: much for what
// stands on the ground, such as animals on their legs. If it extends less, that tells nothing.
inline double standing(const Textured_surface& surface, const CGAL::Bbox_3& box, const int axis)
{
  const double slab = 0.05 * (box.max(axis) - box.min(axis));
  CGAL::Bbox_3 low, high;
  for(const auto& triangle : surface.triangles) {
    for(const Textured_surface::Index v : triangle) {
      const Kernel::Point_3& p = surface.points[v];
      if(p[axis] <= box.min(axis) + slab) {
        low += p.bbox();
      }
      if(p[axis] >= box.max(axis) - slab) {
        high += p.bbox();
      }
    }
  }
  double shares[2] = {1, 1};
  for(int i = 0; i < 3; ++i) {
    if(i != axis && box.max(i) > box.min(i)) {
      shares[0] *= (low.max(i) - low.min(i)) / (box.max(i) - box.min(i));
      shares[1] *= (high.max(i) - high.min(i)) / (box.max(i) - box.min(i));
    }
  }
  return (std::max)(shares[0] - shares[1], 0.);
}

// Whether a surface with a border faces along the z axis, as a mask does, and is no flat terrain.
inline bool faces_along_z(const Textured_surface& surface, const CGAL::Bbox_3& box)
{
  Kernel::Vector_3 sum(0, 0, 0);
  double area = 0;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Kernel::Vector_3 normal = surface.doubled_area_vector(t);
    sum = sum + normal;
    area += std::sqrt(normal.squared_length());
  }
  const double thin = 0.3;
  return std::abs(sum.z()) > 0.5 * area && box.z_span() > thin * (std::min)(box.x_span(), box.y_span());
}

} // namespace internal

// Which axis of a surface points upwards, as far as its shape tells: y or z. Where it tells nothing, that is z in STL
// files, which are mostly of parts of machines, and y in others.
inline std::string likely_up_axis(const Textured_surface& surface, const std::string& format)
{
  const double noticeable = 0.1;
  const CGAL::Bbox_3 box = internal::box_of_triangles(surface);
  if(internal::faces_along_z(surface, box)) {
    return "y";
  }
  const double y = internal::standing(surface, box, 1), z = internal::standing(surface, box, 2);
  return std::abs(y - z) > noticeable ? (y > z ? "y" : "z") : format == "stl" ? "z" : "y";
}

// What `--up` asks for: "x", "y" or "z"
inline std::string up_axis(const Command_line& command, const Textured_surface& surface)
{
  const std::string& input = command.input.empty() ? command.inputs.front() : command.input;
  return command.up == "auto" ? likely_up_axis(surface, file_format(input)) : command.up;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_UP_AXIS_H
