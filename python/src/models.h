// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_MODELS_H
#define ABF_PYTHON_MODELS_H

#include "arrays.h"

#include "flatten_mesh/model/Model.h"

#include <pybind11/pybind11.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

using flatten_mesh::Index;
using flatten_mesh::Kernel;
using flatten_mesh::Model;

// A mesh as Python gives it; what is not given is None.
struct Given_mesh
{
  py::array vertices; // (n, 3)
  py::object offsets; // of polygons in `indices`; None: `indices` has a row for each triangle
  py::array indices;
  py::object marked_seams;  // (k, 2) vertices
  py::object uv;            // (number of corners, 2)
  py::object ignored_faces; // a flag for each face
};

inline std::string name_of(const std::string& array, const std::string& mesh)
{
  return mesh.empty() ? array : array + " of " + mesh;
}

namespace internal {

inline void read_faces(const Given_mesh& given, const std::string& mesh, Model& model)
{
  if(static_cast<std::uint64_t>(given.indices.size()) >= flatten_mesh::no_index) {
    throw py::value_error(name_of("faces", mesh) + " has more than 4294967294 corners");
  }
  model.vertices = read_indices(given.indices, model.points.size(), name_of("faces", mesh), "vertices");
  if(given.offsets.is_none()) {
    for(Index c = 3; c <= model.vertices.size(); c += 3) {
      model.first_corners.push_back(c);
    }
    return;
  }
  model.first_corners = read_indices(given.offsets.cast<py::array>(), model.vertices.size() + 1,
                                     name_of("offsets", mesh), "indices, and one more may be an offset");
  for(std::size_t p = 1; p < model.first_corners.size(); ++p) {
    if(model.first_corners[p] < model.first_corners[p - 1]) {
      throw py::value_error(name_of("offsets", mesh) + "[" + std::to_string(p) +
                            "] is less than the one before");
    }
  }
  if(model.first_corners.front() != 0 || model.first_corners.back() != model.vertices.size()) {
    throw py::value_error(name_of("offsets", mesh) + " must begin with 0 and end with the number of indices");
  }
}

inline void read_texture(const py::array& uv, Model& model)
{
  model.texture = read_points<Kernel::Point_2, 2>(uv);
  model.corner_texture.resize(model.texture.size());
  for(Index c = 0; c < model.corner_texture.size(); ++c) {
    const Kernel::Point_2& p = model.texture[c];
    model.corner_texture[c] = std::isfinite(p.x()) && std::isfinite(p.y()) ? c : flatten_mesh::no_index;
  }
}

} // namespace internal

// The name of the material that stands for faces to be ignored
const char* const ignored_material = "ignored";

inline Model model_of(const Given_mesh& given, const std::string& mesh)
{
  Model model;
  model.points = read_points<Kernel::Point_3, 3>(given.vertices);
  internal::read_faces(given, mesh, model);
  if(!given.uv.is_none()) {
    internal::read_texture(given.uv.cast<py::array>(), model);
  }
  if(!given.ignored_faces.is_none()) {
    const auto is_ignored = given.ignored_faces.cast<py::array_t<bool>>();
    model.material_names = {ignored_material};
    for(py::ssize_t p = 0; p < is_ignored.size(); ++p) {
      model.materials.push_back(is_ignored.at(p) ? 0 : flatten_mesh::no_index);
    }
  }
  model.file = mesh.empty() ? "mesh" : mesh;
  return model;
}

} // namespace abf_python

#endif // ABF_PYTHON_MODELS_H
