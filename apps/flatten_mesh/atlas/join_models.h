// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JOIN_MODELS_H
#define FLATTEN_MESH_JOIN_MODELS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/atlas/Atlas.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/commands_of_inputs.h"
#include "flatten_mesh/model/build_mesh.h"

#include <cstddef>
#include <utility>

namespace flatten_mesh {

namespace internal {

inline Halfedge in_common_mesh(const Joined_model& model, const Halfedge h)
{
  return Halfedge(static_cast<Mesh::size_type>(model.first_halfedge + h.idx()));
}

inline Edge in_common_mesh(const Joined_model& model, const Edge e)
{
  return Edge(static_cast<Mesh::size_type>(model.first_halfedge / 2 + e.idx()));
}

inline Face in_common_mesh(const Joined_model& model, const Face f)
{
  return Face(static_cast<Mesh::size_type>(model.first_face + f.idx()));
}

} // namespace internal

// Appends a model. Models that touch stay apart.
inline void join_model(Joined_model&& model, Atlas_input& whole)
{
  model.first_face = whole.mesh.number_of_faces();
  model.first_halfedge = whole.mesh.number_of_halfedges();
  whole.mesh += model.input.mesh;
  const Edge_marks is_diagonal = diagonals(model.input.mesh), is_diagonal_of_whole = diagonals(whole.mesh);
  for(const Edge e : model.input.mesh.edges()) {
    is_diagonal_of_whole[internal::in_common_mesh(model, e)] = is_diagonal[e];
  }
  for(Skipped_part part : model.input.set_aside) {
    part.model = whole.joined.size();
    whole.set_aside.push_back(std::move(part));
  }
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
  Mesh& mesh = model.input.mesh;
  Atlas atlas = empty_atlas(mesh);
  for(const Halfedge h : mesh.halfedges()) {
    atlas.uv[h] = whole.uv[internal::in_common_mesh(model, h)];
  }
  for(const Face f : mesh.faces()) {
    atlas.chart[f] = whole.chart[internal::in_common_mesh(model, f)];
  }
  for(const Edge e : mesh.edges()) {
    atlas.seams[e] = whole.seams[internal::in_common_mesh(model, e)];
  }
  return atlas;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_JOIN_MODELS_H
