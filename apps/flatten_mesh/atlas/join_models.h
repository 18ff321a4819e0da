// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JOIN_MODELS_H
#define FLATTEN_MESH_JOIN_MODELS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/commands_of_inputs.h"

#include <CGAL/Texture_atlas/internal/prepare/Given_surface.h>

#include <cstddef>
#include <utility>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

inline Given_surface given_surface(Joined_model& model)
{
  return {model.input.model, model.input, model.command.title, model.first_face, model.first_halfedge};
}

// Appends a model. Models that touch stay apart.
inline void join_model(Joined_model&& model, Atlas_input& whole)
{
  Given_surface given = given_surface(model);
  append(given, whole.mesh);
  model.first_face = given.first_face;
  model.first_halfedge = given.first_halfedge;
  whole.left_out += model.input.left_out;
  whole.joined.push_back(std::move(model));
}

// Reads all inputs as one. Throws an `Input_error` if one of the files cannot be read, or is wrong as a whole.
inline Atlas_input read_joined_models(const Command_line& command, Notes& notes)
{
  Atlas_input whole;
  for(Command_line& each : commands_of_models(command)) {
    notes.set_subject(each.title);
    Joined_model model;
    model.input = read_atlas_input(each, notes);
    model.command = std::move(each);
    join_model(std::move(model), whole);
  }
  notes.set_subject("");
  return whole;
}

// The part of the common atlas that belongs to a model, as properties of its own mesh
inline Atlas atlas_of_model(const Atlas& whole, Joined_model& model)
{
  return atlas_of_surface(whole, given_surface(model));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_JOIN_MODELS_H
