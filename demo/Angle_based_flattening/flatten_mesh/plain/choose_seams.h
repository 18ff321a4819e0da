// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHOOSE_SEAMS_H
#define FLATTEN_MESH_CHOOSE_SEAMS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/plain/Seamed_component.h"
#include "flatten_mesh/plain/choose_cones.h"
#include "flatten_mesh/seam_file.h"

#include <CGAL/Surface_mesh_parameterization/cut_to_disks.h>
#include <CGAL/Surface_mesh_parameterization/select_seams.h>

#include <cstddef>
#include <string>

namespace flatten_mesh {

// Whether a component gets seams.
inline bool is_cut(const Command_line& command, Mesh& mesh, const Component& component)
{
  return command.asks_for_cones  ? true
         : command.cut == "auto" ? command.asks_for_stretch || !is_disk_with_holes(mesh, component.number)
                                 : command.cut != "none";
}

namespace internal {

inline void check_report(const SMP::Seam_report& report)
{
  if(report.diagnosis == SMP::Seam_report::NOTHING_WRONG) {
    return;
  }
  const std::string text = "cannot choose seams: " + report.message;
  if(report.diagnosis == SMP::Seam_report::LINEAR_SYSTEM_FAILED) {
    throw Seams_failed(text);
  }
  throw Input_error(text);
}

} // namespace internal

// Marks the seams along which `--cut` cuts a component.
inline void choose_seams(const Command_line& command, Mesh& input, Seamed_component& component,
                         Seam_record& record)
{
  const Mesh& mesh = component.part.mesh;
  const auto options = CGAL::parameters::edge_is_constrained_map(component.forbidden);
  record.cut = component.cones ? "cones" : command.cut;
  if(component.cones) {
    internal::check_report(cut_through_cones(component));
  } else if(command.cut == "auto") {
    const SMP::Seam_report report = SMP::select_seams(
        mesh, component.seams, CGAL::parameters::stretch_bound(command.stretch_bound, options));
    internal::check_report(report);
    record.stretch_bound = command.stretch_bound;
    record.terminals = report.number_of_terminals;
    record.predicted_stretch = report.predicted_stretch;
  } else if(command.cut == "topology") {
    internal::check_report(SMP::cut_to_disks(mesh, component.seams, options));
  } else {
    read_seams(command.cut, input, component);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHOOSE_SEAMS_H
