// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SEAM_FILE_H
#define FLATTEN_MESH_SEAM_FILE_H

#include "flatten_mesh/plain/Seamed_component.h"
#include "flatten_mesh/model/check_polygons.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/seam_selection.h>

#include <sstream>
#include <string>

namespace flatten_mesh {

namespace internal {

// Vertices count from 0.
[[noreturn]] inline void refuse_diagonal(const std::string& file, const Vertex v, const Vertex w)
{
  throw Input_error("'" + file + "': there is no edge between vertices " + std::to_string(v.idx()) + " and " +
                    std::to_string(w.idx()) +
                    ", counted from 0: both are corners of a larger polygon, but not next to each other");
}

inline void check_no_diagonals(const std::string& file, const Seamed_component& component)
{
  const Mesh& mesh = component.part.mesh;
  for(const Edge e : mesh.edges()) {
    if(component.seams[e] && component.forbidden[e]) {
      const Halfedge h = mesh.halfedge(e);
      refuse_diagonal(file, component.part.origins[mesh.source(h).idx()],
                      component.part.origins[mesh.target(h).idx()]);
    }
  }
}

inline std::string defect_text(const TA::Disk_cut_report<Mesh>::Part& part)
{
  switch(part.status) {
  case SMP::Diagnosis::NO_BORDER:
    return "it has no border";
  case SMP::Diagnosis::NONZERO_GENUS:
    return "it has " + count_text(part.number_of_handles, "handle");
  case SMP::Diagnosis::SEVERAL_BORDERS:
    return "it has " + std::to_string(part.borders.size()) + " borders";
  case SMP::Diagnosis::SHORT_BORDER:
    return "a single edge does not open it";
  case SMP::Diagnosis::PARALLEL_EDGES:
    return "two of its edges would have the same vertices";
  default:
    return to_string(part.status);
  }
}

inline void check_disks(const std::string& file, const Seamed_component& component)
{
  const Mesh& mesh = component.part.mesh;
  const auto check = TA::is_disk_cut(mesh, component.seams);
  if(check) {
    return;
  }
  const auto& part = check.parts[check.defective_part];
  throw Input_error("'" + file + "': the seams do not leave disks: the part of " +
                    count_text(part.number_of_faces, "triangle") + " at " +
                    vertex_name(component.part.origins[mesh.target(part.where).idx()]) +
                    " cannot be flattened: " + defect_text(part) +
                    "; add seams, or let --cut auto choose them");
}

} // namespace internal

// Marks the seams in a file. Throws an `Input_error` unless they are edges of the input and leave disks.
inline void read_seams(const std::string& file, Mesh& input, Seamed_component& component)
{
  const Edge_marks seams = seam_marks(input);
  const auto report = TA::read_seam_selection(file, input, seams);
  if(!report) {
    throw Input_error(report.message + "; vertices count from 0 in this file");
  }
  for(const Edge e : component.part.mesh.edges()) {
    component.seams[e] = seams[component.part.edge_origins[e.idx()]];
  }
  internal::check_no_diagonals(file, component);
  internal::check_disks(file, component);
}

// The seams of a component as the text of a `.selection.txt` file of the input.
inline std::string seams_text(Mesh& input, const Seamed_component& component)
{
  const Edge_marks seams = seam_marks(input);
  for(const Edge e : component.part.mesh.edges()) {
    seams[component.part.edge_origins[e.idx()]] = component.seams[e];
  }
  std::ostringstream text;
  TA::write_seam_selection(text, input, seams);
  return text.str();
}

inline std::string no_seams_text()
{
  return "\n\n\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SEAM_FILE_H
