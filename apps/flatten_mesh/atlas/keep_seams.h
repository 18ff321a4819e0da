// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_KEEP_SEAMS_H
#define FLATTEN_MESH_KEEP_SEAMS_H

#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/given_seams.h>
#include <CGAL/Texture_atlas/seam_selection.h>

#include <string>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

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
    keep_seams_of_texture(input.model, input, seams);
  } else if(!options.seams_from.empty()) {
    internal::keep_seams_of_file(options.seams_from, input, seams);
  }
  if(options.charts_from_materials) {
    keep_seams_of_materials(input.model, input, seams);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_KEEP_SEAMS_H
