// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHOOSE_CONES_H
#define FLATTEN_MESH_CHOOSE_CONES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/plain/Seamed_component.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/cut_to_disks.h>
#include <CGAL/Surface_mesh_parameterization/select_cones.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline void check_cones(const SMP::Cone_selection<Mesh>& selection, const Seamed_component& component)
{
  if(selection.diagnosis == SMP::Cone_report::NOTHING_WRONG) {
    return;
  }
  std::string text = "cannot choose cones: " + selection.message;
  for(std::size_t i = 0; i < selection.offending_vertices.size(); ++i) {
    text += (i == 0 ? " (" : ", ") +
            vertex_name(component.part.origins[selection.offending_vertices[i].idx()].idx());
  }
  text += selection.offending_vertices.empty() ? "" : ")";
  if(selection.diagnosis == SMP::Cone_report::LINEAR_SYSTEM_FAILED) {
    throw Seams_failed(text);
  }
  throw Input_error(text);
}

} // namespace internal

// Chooses the cones that `--cones` asks for. Throws unless their angles are possible.
inline Cone_record choose_cones(const Command_line& command, Seamed_component& component)
{
  Cone_record record;
  record.wanted = static_cast<std::size_t>(command.cones);
  record.multiple = command.cone_angle_multiple / 180 * CGAL_PI;
  const auto selection =
      SMP::select_cones(component.part.mesh, record.wanted, CGAL::parameters::angle_quantum(record.multiple));
  internal::check_cones(selection, component);
  record.predicted_stretch = selection.predicted_stretch;
  component.cones.emplace();
  for(const auto& [v, angle] : selection.cones) {
    component.cones->emplace(v, angle);
    record.cones.emplace_back(component.part.origins[v.idx()].idx(), angle);
  }
  return record;
}

// Marks short seams through the cones that make the surface a disk.
inline SMP::Seam_report cut_through_cones(Seamed_component& component)
{
  std::vector<Vertex> terminals;
  for(const auto& cone : *component.cones) {
    terminals.push_back(cone.first);
  }
  return SMP::cut_to_disks(
      component.part.mesh, component.seams,
      CGAL::parameters::terminals(terminals, CGAL::parameters::edge_is_constrained_map(component.forbidden)));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHOOSE_CONES_H
