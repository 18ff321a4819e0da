// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BORDER_ANGLES_H
#define FLATTEN_MESH_BORDER_ANGLES_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/corner_numbers.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// A vertex on the outer border of a chart, by its number from 1. `place` says where the number is.
inline Vertex border_vertex(const std::size_t number, const std::vector<Vertex>& border,
                            const std::string& place)
{
  const auto found = std::find_if(border.begin(), border.end(),
                                  [&](const Vertex v) { return std::size_t(v.idx()) + 1 == number; });
  if(found == border.end()) {
    throw Input_error(place + ": vertex " + std::to_string(number) +
                      " is not on the outer border of the surface; vertices count from 1, as in OBJ files");
  }
  return *found;
}

} // namespace internal

// The vertices of the outer border
inline std::vector<Vertex> outer_border(const Mesh& mesh, const Chart& chart)
{
  const auto range = mesh.vertices_around_face(chart.border);
  return std::vector<Vertex>(range.begin(), range.end());
}

// Reads a line for each vertex: its number, from 1, and its angle in degrees. Lines that start with '#' are comments.
inline SMP::Vertex_angles<Mesh> read_border_angles(const std::string& file, const std::vector<Vertex>& border)
{
  std::ifstream in(file);
  if(!in) {
    throw Input_error("cannot open '" + file + "'");
  }
  SMP::Vertex_angles<Mesh> angles;
  std::string line;
  for(std::size_t i = 1; std::getline(in, line); ++i) {
    const std::vector<std::string> words = internal::words_of(line, " \t");
    if(words.empty() || words.front().front() == '#') {
      continue;
    }
    const std::string place = "'" + file + "', line " + std::to_string(i);
    const auto number = internal::number_of<std::size_t>(words.front());
    const auto degrees = internal::number_of<double>(words.back());
    if(words.size() != 2 || !number || !degrees || !std::isfinite(*degrees)) {
      throw Input_error(place + ": expected the number of a vertex and an angle in degrees, as in '17 90'");
    }
    const Vertex v = internal::border_vertex(*number, border, place);
    if(angles[v]) {
      throw Input_error(place + ": vertex " + std::to_string(*number) + " has an angle already");
    }
    angles.set(v, *degrees == 180 ? CGAL_PI : *degrees / 180 * CGAL_PI);
  }
  if(in.bad()) {
    throw Input_error("cannot read '" + file + "'");
  }
  return angles;
}

// The vertices with prescribed angles that are not inside of straight sides
inline std::vector<Vertex> corners_of(const SMP::Vertex_angles<Mesh>& angles,
                                      const std::vector<Vertex>& border)
{
  std::vector<Vertex> corners;
  for(const Vertex v : border) {
    if(const auto angle = angles[v]; angle && std::abs(*angle - CGAL_PI) > 1e-9) {
      corners.push_back(v);
    }
  }
  return corners;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BORDER_ANGLES_H
