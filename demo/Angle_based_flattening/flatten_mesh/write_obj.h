// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_OBJ_H
#define FLATTEN_MESH_WRITE_OBJ_H

#include "Chart.h"
#include "Output_file.h"
#include "Run_record.h"
#include "Polygon_soup.h"
#include "texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline void append_obj_vertices(std::string& text, const Polygon_soup& soup)
{
  for(const Kernel::Point_3& point : soup.points) {
    text += "v ";
    append_number(text, point.x());
    text += ' ';
    append_number(text, point.y());
    text += ' ';
    append_number(text, point.z());
    text += '\n';
  }
}

// Returns the number of each vertex among the texture coordinates, from 1; 0 outside the chart.
inline std::vector<std::size_t> append_obj_texture(std::string& text, const Polygon_soup& soup,
                                                   const Chart& chart, const Flattening& flattening)
{
  std::vector<std::size_t> numbers(soup.points.size(), 0);
  std::size_t number = 0;
  for(const Vertex v : chart.vertices) {
    const Kernel::Point_2& uv = flattening.uv[v];
    text += "vt ";
    append_number(text, uv.x());
    text += ' ';
    append_number(text, uv.y());
    text += '\n';
    numbers[v.idx()] = ++number;
  }
  return numbers;
}

inline void append_obj_faces(std::string& text, const Polygon_soup& soup,
                             const std::vector<std::size_t>& numbers)
{
  for(const Polygon& polygon : soup.polygons) {
    text += 'f';
    for(const std::size_t v : polygon) {
      text += ' ';
      append_number(text, v + 1);
      if(numbers[v] != 0) {
        text += '/';
        append_number(text, numbers[v]);
      }
    }
    text += '\n';
  }
}

} // namespace internal

// The input's vertices and faces in the input's order, with texture coordinates for the chart.
inline void write_obj(Output_file& file, const Polygon_soup& soup, const Chart& chart,
                      const Flattening& flattening)
{
  std::string text =
      "# flattened by flatten_mesh: 'vt' are the coordinates in the plane, on the scale of the surface\n";
  internal::append_obj_vertices(text, soup);
  const std::vector<std::size_t> numbers = internal::append_obj_texture(text, soup, chart, flattening);
  internal::append_obj_faces(text, soup, numbers);
  file.write(text);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_OBJ_H
