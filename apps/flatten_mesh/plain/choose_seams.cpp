// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/choose_seams.h"

#include "flatten_mesh/model/components.h"
#include "flatten_mesh/seam_file.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace {

void check_cones(const TA::Cone_selection<Mesh>& selection, const Seamed_component& component)
{
  if(selection) {
    return;
  }
  std::string text = "cannot choose cones: " + selection.message;
  for(std::size_t i = 0; i < selection.offending_vertices.size(); ++i) {
    text += (i == 0 ? " (" : ", ") +
            vertex_name(component.part.origins[selection.offending_vertices[i].idx()].idx());
  }
  text += selection.offending_vertices.empty() ? "" : ")";
  if(selection.status == SMP::Diagnosis::LINEAR_SYSTEM_FAILED) {
    throw Seams_failed(text);
  }
  throw Input_error(text);
}

// Marks short seams through the cones that make the surface a disk.
TA::Seam_report cut_through_cones(Seamed_component& component)
{
  std::set<Vertex> cones;
  for(const auto& cone : *component.cones) {
    cones.insert(cone.first);
  }
  return TA::cut_to_disks(component.part.mesh, component.seams,
                          CGAL::parameters::vertex_is_constrained_map(CGAL::make_boolean_property_map(cones))
                              .edge_is_constrained_map(component.forbidden));
}

void check_report(const TA::Seam_report& report)
{
  if(report) {
    return;
  }
  const std::string text = "cannot choose seams: " + report.message;
  if(report.status == SMP::Diagnosis::LINEAR_SYSTEM_FAILED) {
    throw Seams_failed(text);
  }
  throw Input_error(text);
}

} // namespace

Cone_record choose_cones(const Command_line& command, Seamed_component& component)
{
  Cone_record record;
  record.wanted = static_cast<std::size_t>(command.cones);
  record.multiple = command.cone_angle_multiple / 180 * CGAL_PI;
  TA::Cone_options options;
  options.angle_multiple = record.multiple;
  const auto selection = TA::select_cones(component.part.mesh, record.wanted, options);
  check_cones(selection, component);
  record.predicted_stretch = selection.predicted_stretch;
  component.cones.emplace();
  for(const auto& [v, angle] : selection.cones) {
    component.cones->emplace(v, angle);
    record.cones.emplace_back(component.part.origins[v.idx()].idx(), angle);
  }
  return record;
}

bool is_cut(const Command_line& command, Mesh& mesh, const Component& component)
{
  return command.asks_for_cones  ? true
         : command.cut == "auto" ? command.asks_for_stretch || !is_disk_with_holes(mesh, component.number)
                                 : command.cut != "none";
}

void choose_seams(const Command_line& command, Mesh& input, Seamed_component& component, Seam_record& record)
{
  const Mesh& mesh = component.part.mesh;
  const auto forbidden = CGAL::parameters::edge_is_constrained_map(component.forbidden);
  record.cut = component.cones ? "cones" : command.cut;
  if(component.cones) {
    check_report(cut_through_cones(component));
  } else if(command.cut == "auto") {
    TA::Seam_options options;
    options.stretch_bound = command.stretch_bound;
    const TA::Seam_report report = TA::select_seams(mesh, component.seams, options, forbidden);
    check_report(report);
    record.stretch_bound = command.stretch_bound;
    record.terminals = report.number_of_terminals;
    record.predicted_stretch = report.predicted_stretch;
  } else if(command.cut == "topology") {
    check_report(TA::cut_to_disks(mesh, component.seams, forbidden));
  } else {
    read_seams(command.cut, input, component);
  }
}

} // namespace flatten_mesh
