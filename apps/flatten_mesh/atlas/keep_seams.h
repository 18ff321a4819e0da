// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_KEEP_SEAMS_H
#define FLATTEN_MESH_KEEP_SEAMS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
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

inline void keep_seams_of_file(const std::string& file, Mesh& mesh)
{
  const Edge_marks seams = seam_marks(mesh);
  const auto report = TA::read_seam_selection(file, mesh, seams);
  if(!report) {
    throw Input_error(report.message + "; vertices count from 0 in this file");
  }
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : mesh.edges()) {
    if(seams[e] && is_diagonal[e]) {
      refuse_diagonal(file, mesh.vertex(e, 0), mesh.vertex(e, 1));
    }
  }
}

} // namespace internal

// Marks the seams of a file, if one is given. Throws an `Input_error`.
inline void keep_seams(const Atlas_command& options, Mesh& mesh)
{
  if(!options.seams_from.empty() && options.seams_from != "uv") {
    internal::keep_seams_of_file(options.seams_from, mesh);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_KEEP_SEAMS_H
