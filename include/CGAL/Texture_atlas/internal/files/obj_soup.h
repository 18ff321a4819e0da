// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_OBJ_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_OBJ_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/IO/OBJ_material.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The points, texture coordinates and faces of an OBJ file, with numbers from 0
struct Obj_soup
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::size_t number_of_faces() const { return lines.size(); }

  std::size_t face(std::size_t corner) const
  {
    return static_cast<std::size_t>(std::upper_bound(first_corners.begin(), first_corners.end(), corner) -
                                    first_corners.begin()) -
           1;
  }

  std::size_t next(std::size_t corner) const
  {
    const std::size_t f = face(corner);
    return corner + 1 == first_corners[f + 1] ? first_corners[f] : corner + 1;
  }

  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 2>> coordinates;
  std::vector<std::size_t> first_corners = {0}; // of each face, and the end
  std::vector<std::size_t> lines;               // of each face
  std::vector<std::size_t> vertices;            // of each corner
  std::vector<std::size_t> corner_coordinates;  // of each corner, or `none`
};

inline OBJ_report obj_failure(Diagnosis status, const std::string& message, std::size_t line = 0)
{
  OBJ_report report;
  report.status = status;
  report.message = (line == 0 ? std::string() : "line " + std::to_string(line) + ": ") + message;
  report.line = line;
  return report;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_OBJ_SOUP_H
