// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ATLAS_INPUT_H
#define FLATTEN_MESH_ATLAS_INPUT_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Face_choice.h"
#include "flatten_mesh/model/Model.h"

#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

struct Joined_model;

// The input of an atlas: a model, or several models
struct Atlas_input : public Prepared_surface
{
  Model model;
  std::vector<Joined_model> joined; // several models, whose meshes follow one another in `mesh`; or empty
};

// One of several models, with the numbers of its first face and halfedge in the common mesh
struct Joined_model
{
  Command_line command; // with the names of its own outputs
  Atlas_input input;
  std::size_t first_face = 0, first_halfedge = 0;
};

// Throws an `Input_error` if the model is wrong as a whole.
inline Atlas_input atlas_input_of(Model model, const bool repair, Notes& notes,
                                  const Welding& welding = Welding(),
                                  const Face_choice& choice = Face_choice())
{
  Atlas_input input;
  static_cast<Prepared_surface&>(input) =
      prepare_surface(model, {repair, welding, left_out_polygons(choice, model)}, notes);
  input.model = std::move(model);
  return input;
}

// Throws an `Input_error` if the file cannot be read, or is wrong as a whole. Whether there are the names that the
// command gives is not checked.
Atlas_input read_atlas_input(const Command_line& command, Notes& notes);

// The number of the model that a triangle is part of, of several
inline std::size_t model_of_face(const Atlas_input& input, const std::size_t face)
{
  const auto after = std::upper_bound(
      input.joined.begin(), input.joined.end(), face,
      [](const std::size_t number, const Joined_model& model) { return number < model.first_face; });
  return input.joined.empty() ? 0 : static_cast<std::size_t>(after - input.joined.begin()) - 1;
}

// The face of the file that a triangle is part of, from 0
inline std::size_t face_in_file(const Atlas_input& input, const Face f)
{
  if(!input.joined.empty()) {
    const Joined_model& model = input.joined[model_of_face(input, f.idx())];
    return face_in_file(model.input, Face(static_cast<Mesh::size_type>(f.idx() - model.first_face)));
  }
  return input.model.polygon_of_corner(input.origins.corners[input.mesh.halfedge(f).idx()]);
}

} // namespace flatten_mesh

#ifndef FLATTEN_MESH_COMPILED
#include "flatten_mesh/atlas/read_atlas_input_impl.h"
#endif

#endif // FLATTEN_MESH_ATLAS_INPUT_H
