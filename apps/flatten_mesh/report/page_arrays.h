// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_ARRAYS_H
#define FLATTEN_MESH_PAGE_ARRAYS_H

#include "flatten_mesh/report/Displayed_surface.h"
#include "flatten_mesh/report/base64.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flatten_mesh {

// Factors for coordinates of the surface and of the plane: 1, unless numbers of four bytes could not hold them.
struct Display_factors
{
  double surface = 1, plane = 1;
};

namespace internal {

inline double display_factor(const double extent)
{
  return extent > 1e-15 && extent < 1e15 ? 1 : 1 / abf::power_of_two(extent);
}

inline CGAL::Bbox_3 box_of(const std::vector<Kernel::Point_3>& points)
{
  CGAL::Bbox_3 box;
  for(const Kernel::Point_3& p : points) {
    box += p.bbox();
  }
  return box;
}

template <class Number>
std::string array_element(const std::string& name, const std::vector<Number>& numbers)
{
  std::string text = "<script type=\"text/plain\" id=\"array-" + name + "\">";
  append_base64(text, numbers);
  return text + "</script>\n";
}

// The numbers of all members of an array, one after the other
template <class Rows>
std::vector<Wedge_mesh::Index> flat(const Rows& rows)
{
  std::vector<Wedge_mesh::Index> numbers;
  numbers.reserve(3 * rows.size());
  for(const auto& row : rows) {
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  return numbers;
}

inline std::vector<float> floats(const std::vector<double>& numbers)
{
  std::vector<float> result;
  result.reserve(numbers.size());
  for(const double number : numbers) {
    result.push_back(static_cast<float>(number));
  }
  return result;
}

// Relative to the centre of their box
inline std::vector<float> point_numbers(const std::vector<Kernel::Point_3>& points, const double factor)
{
  const CGAL::Bbox_3 box = box_of(points);
  std::vector<float> numbers;
  numbers.reserve(3 * points.size());
  for(const Kernel::Point_3& p : points) {
    for(int axis = 0; axis < 3; ++axis) {
      const double centre = box.min(axis) / 2 + box.max(axis) / 2;
      numbers.push_back(static_cast<float>(factor * (p[axis] - centre)));
    }
  }
  return numbers;
}

inline std::vector<float> plane_numbers(const std::vector<Kernel::Point_2>& points, const double factor)
{
  std::vector<float> numbers;
  numbers.reserve(2 * points.size());
  for(const Kernel::Point_2& p : points) {
    numbers.push_back(static_cast<float>(factor * p.x()));
    numbers.push_back(static_cast<float>(factor * p.y()));
  }
  return numbers;
}

inline std::vector<Wedge_mesh::Index> border_numbers(const std::vector<Wedge_mesh::Side>& borders)
{
  std::vector<Wedge_mesh::Index> numbers;
  numbers.reserve(3 * borders.size());
  for(const Wedge_mesh::Side& side : borders) {
    numbers.insert(numbers.end(), side.wedges.begin(), side.wedges.end());
    numbers.push_back(static_cast<Wedge_mesh::Index>(side.seam)); // 0xFFFFFFFF without one
  }
  return numbers;
}

} // namespace internal

inline Display_factors display_factors(const Wedge_mesh& mesh, const CGAL::Bbox_2& box)
{
  const CGAL::Bbox_3 space = internal::box_of(mesh.points);
  return {internal::display_factor((std::max)({space.x_span(), space.y_span(), space.z_span()})),
          internal::display_factor((std::max)(box.x_span(), box.y_span()))};
}

// The arrays as elements of the page
inline std::string page_arrays(const Displayed_surface& surface, const Display_factors& factors,
                               const std::vector<Wedge_mesh::Index>& faces)
{
  const Wedge_mesh& mesh = surface.mesh;
  std::vector<Wedge_mesh::Index> faces_shown;
  faces_shown.reserve(surface.origins.size());
  for(const std::size_t t : surface.origins) {
    faces_shown.push_back(faces[t]);
  }
  std::string text;
  text += internal::array_element("points", internal::point_numbers(mesh.points, factors.surface));
  text += internal::array_element("wedge_points", mesh.wedge_points);
  text += internal::array_element("wedge_uv", internal::plane_numbers(mesh.wedge_uv, factors.plane));
  text += internal::array_element("triangles", internal::flat(mesh.triangles));
  text += internal::array_element("charts", mesh.charts);
  text += internal::array_element("faces", faces_shown);
  for(const Measure_of_triangles& measure : measures_of_page(surface.measures)) {
    text += internal::array_element(measure.name, internal::floats(measure.values));
  }
  text += internal::array_element("borders", internal::border_numbers(mesh.borders));
  return text;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_ARRAYS_H
