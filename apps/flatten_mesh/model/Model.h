// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MODEL_H
#define FLATTEN_MESH_MODEL_H

#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

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

// A surface as its file describes it: everything that the program keeps, in the order of the file
struct Model : public Surface_soup
{
  std::vector<Point_color> colors; // of each point, or empty; NaN where a point has none
  std::vector<Kernel::Vector_3> normals;
  std::vector<Index> corner_normals; // of each corner, or empty
  bool has_point_normals = false;    // normals belong to the points, in their order

  std::vector<Statement> statements;
  std::vector<Point_color> material_colors; // of each name; empty: material files tell
  Model_in_gltf gltf;

  std::vector<std::string> files_beside; // that it refers to, and that were read with it

  // In `normals`
  Index normal(const Index corner) const
  {
    return has_point_normals ? vertices[corner] : corner_normals.empty() ? no_index : corner_normals[corner];
  }

  // Its corners have to be in `vertices` already.
  void end_polygon()
  {
    if(vertices.size() >= no_index) {
      throw Input_error("'" + name + "': the file has more than 4294967294 corners of faces; split the mesh");
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

// The faces of a mesh as polygons, each of which begins with the target of its halfedge
template <class Polygon_mesh>
Model model_of_mesh(const Polygon_mesh& mesh, const std::string& name)
{
  Model model;
  model.name = name;
  for(const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    model.points.emplace_back(p.x(), p.y(), p.z());
  }
  for(const auto f : mesh.faces()) {
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      model.vertices.push_back(static_cast<Index>(v.idx()));
    }
    model.end_polygon();
  }
  return model;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MODEL_H
