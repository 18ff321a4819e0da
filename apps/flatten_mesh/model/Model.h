// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MODEL_H
#define FLATTEN_MESH_MODEL_H

#include "flatten_mesh/texts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace flatten_mesh {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// The number of a point, polygon, corner and so on, from 0. Half as large as `std::size_t`: models are large.
using Index = std::uint32_t;
constexpr Index no_index = static_cast<Index>(-1);

// Red, green, blue and opacity, from 0 to 1; sRGB for points
using Point_color = std::array<double, 4>;

// A line of an OBJ file that is kept as it is: of groups, objects, smoothing groups, materials and display.
struct Statement
{
  Index polygon; // the one that follows
  std::string text;
};

struct Gltf_file;

// Where a model is in a glTF file
struct Model_in_gltf
{
  std::shared_ptr<const Gltf_file> file; // null: it is from another file
  std::vector<Index> primitives;         // of each polygon
  std::vector<Index> vertices;           // of each corner, in the primitive
  std::vector<bool> is_mirrored; // of each primitive: its polygons are turned, because its node mirrors it
};

// A surface as its file describes it: everything that the program keeps, in the order of the file. Repairs do not
// change it. Corners are numbered through, polygon by polygon.
struct Model
{
  std::vector<Kernel::Point_3> points;
  std::vector<Point_color> colors; // of each point, or empty; NaN where a point has none
  std::vector<Kernel::Vector_3> normals;
  std::vector<Kernel::Point_2> texture;

  std::vector<Index> first_corners = {0}; // of each polygon, and the number of corners
  std::vector<Index> vertices;            // the point of each corner
  std::vector<Index> corner_normals;      // of each corner, or empty
  std::vector<Index> corner_texture;
  bool has_point_normals = false; // normals and texture belong to the points, in their order
  bool has_point_texture = false;

  std::vector<Statement> statements;
  std::vector<std::string> material_names;  // each once
  std::vector<Index> materials;             // of each polygon, or empty
  std::vector<Point_color> material_colors; // of each name; empty: material files tell
  Model_in_gltf gltf;

  std::string file;                      // its name
  std::vector<std::string> files_beside; // that it refers to, and that were read with it
  bool is_welded = false; // from a file without indices, such as STL: the reader merged equal points

  std::size_t number_of_polygons() const { return first_corners.size() - 1; }
  std::size_t number_of_corners() const { return vertices.size(); }

  Index size(const Index polygon) const { return first_corners[polygon + 1] - first_corners[polygon]; }

  Index polygon_of_corner(const Index corner) const
  {
    const auto after = std::upper_bound(first_corners.begin(), first_corners.end(), corner);
    return static_cast<Index>(after - first_corners.begin()) - 1;
  }

  // In `normals`
  Index normal(const Index corner) const
  {
    return has_point_normals ? vertices[corner] : corner_normals.empty() ? no_index : corner_normals[corner];
  }

  // In `texture`
  Index texture_point(const Index corner) const
  {
    return has_point_texture ? vertices[corner] : corner_texture.empty() ? no_index : corner_texture[corner];
  }

  // In `material_names`
  Index material(const Index polygon) const { return materials.empty() ? no_index : materials[polygon]; }

  // Its corners have to be in `vertices` already.
  void end_polygon()
  {
    if(vertices.size() >= no_index) {
      throw Input_error("'" + file + "': the file has more than 4294967294 corners of faces; split the mesh");
    }
    first_corners.push_back(static_cast<Index>(vertices.size()));
  }

  // Gives back the memory that was taken for more: models are held to the end.
  void shrink_to_fit()
  {
    points.shrink_to_fit();
    normals.shrink_to_fit();
    texture.shrink_to_fit();
    first_corners.shrink_to_fit();
    vertices.shrink_to_fit();
    corner_normals.shrink_to_fit();
    corner_texture.shrink_to_fit();
  }
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MODEL_H
