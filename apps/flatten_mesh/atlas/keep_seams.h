// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_KEEP_SEAMS_H
#define FLATTEN_MESH_KEEP_SEAMS_H

#include "flatten_mesh/atlas/Atlas.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/atlas/orient_texture.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/model/build_mesh.h"
#include "flatten_mesh/model/model_seams.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/seam_selection.h>

#include <limits>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline void keep_seams_of_texture(const std::string& option, Atlas_input& input, const Edge_marks& seams)
{
  if(input.model.texture.empty()) {
    throw Input_error(option + ": the input has no texture coordinates; leave the option out");
  }
  const std::vector<bool> is_seam = texture_seams(input.model, input.mesh, input.origins);
  for(const Edge e : input.mesh.edges()) {
    seams[e] = seams[e] || is_seam[e.idx()];
  }
}

inline void keep_seams_of_materials(Atlas_input& input, const Edge_marks& seams)
{
  if(input.model.material_names.empty()) {
    throw Input_error("--charts-from-materials: the input has no materials; leave the option out");
  }
  const std::vector<Index> materials = materials_of_faces(input.model, input.mesh, input.origins);
  for(const Edge e : input.mesh.edges()) {
    if(!input.mesh.is_border(e)) {
      const Halfedge h = input.mesh.halfedge(e);
      seams[e] = seams[e] || materials[input.mesh.face(h).idx()] !=
                                 materials[input.mesh.face(input.mesh.opposite(h)).idx()];
    }
  }
}

// Vertices count from 0.
[[noreturn]] inline void refuse_diagonal(const std::string& file, const Vertex v, const Vertex w)
{
  throw Input_error("'" + file + "': there is no edge between vertices " + std::to_string(v.idx()) + " and " +
                    std::to_string(w.idx()) +
                    ", counted from 0: both are corners of a larger polygon, but not next to each other");
}

inline void keep_seams_of_file(const std::string& file, Atlas_input& input, const Edge_marks& seams)
{
  const auto report = TA::read_seam_selection(file, input.mesh, seams);
  if(!report) {
    throw Input_error(report.message + "; vertices count from 0 in this file");
  }
  const Edge_marks is_diagonal = diagonals(input.mesh);
  for(const Edge e : input.mesh.edges()) {
    if(seams[e] && is_diagonal[e]) {
      refuse_diagonal(file, input.mesh.vertex(e, 0), input.mesh.vertex(e, 1));
    }
  }
}

} // namespace internal

// Marks the seams that are given. Throws an `Input_error` if there are none where they should be.
inline void keep_seams(const Atlas_command& options, Atlas_input& input, const Edge_marks& seams)
{
  if(options.seams_from == "uv") {
    internal::keep_seams_of_texture("--seams-from uv", input, seams);
  } else if(!options.seams_from.empty()) {
    internal::keep_seams_of_file(options.seams_from, input, seams);
  }
  if(options.charts_from_materials) {
    internal::keep_seams_of_materials(input, seams);
  }
}

// Marks the seams of the coordinates in the file, and sets `uv(h)` to these for each corner; no numbers where there are
// none.
// Mirrored charts are turned over. If charts are repaired, there may be no coordinates at all, and charts that are
// mirrored in part are not divided. Otherwise throws an `Input_error` if there are none.
template <class Uv>
Mirrored_charts take_texture(const bool repairs, Atlas_input& input, const Edge_marks& seams, const Uv& uv)
{
  const Model& model = input.model;
  if(!(model.texture.empty() && repairs)) {
    internal::keep_seams_of_texture("--repack", input, seams);
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  for(const Halfedge h : input.mesh.halfedges()) {
    if(!input.mesh.is_border(h)) {
      const Index t = model.texture_point(input.origins.corners[h.idx()]);
      uv(h) = t == no_index ? Kernel::Point_2(none, none) : model.texture[t];
    }
  }
  return orient_texture(!repairs, input.mesh, seams, uv);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_KEEP_SEAMS_H
