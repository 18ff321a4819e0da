// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/cut_surface.h"

#include "flatten_mesh/atlas/keep_seams.h"
#include "flatten_mesh/plain/flatten_sheet.h"
#include "flatten_mesh/texts.h"

#include <CGAL/number_utils.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/property_map.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Texture_atlas/internal/atlas/reduce_stretch.h>
#include <CGAL/Texture_atlas/internal/prepare/components.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/split_overlaps.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
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

std::string defect_text(const TA::Disk_cut_report<Mesh>::Part& part)
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

void check_disks(const std::string& file, const Seamed_component& component)
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

// Marks the seams in a file. Throws an `Input_error` unless they are edges of the input and leave disks.
void read_seams(const std::string& file, Atlas_input& input, Seamed_component& component)
{
  const Edge_marks seams = seam_marks(input.mesh);
  internal::keep_seams_of_file(file, input.mesh);
  for(const Edge e : component.part.mesh.edges()) {
    component.seams[e] = seams[component.part.edge_origins[e.idx()]];
  }
  check_disks(file, component);
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

void choose_seams(const Command_line& command, Atlas_input& input, Seamed_component& component,
                  Seam_record& record)
{
  const Mesh& mesh = component.part.mesh;
  const auto forbidden = CGAL::parameters::edge_is_constrained_map(component.forbidden);
  record.cut = component.cones ? "cones" : command.cut;
  if(component.cones) {
    check_report(cut_through_cones(component));
  } else if(command.cut == "auto") {
    TA::Seam_options options;
    options.stretch_bound = command.stretch_bound;
    const auto report = TA::select_seams(mesh, component.seams, options, forbidden);
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

namespace {

namespace ABF = CGAL::Texture_atlas::internal;

Flat_sheet flatten_once(const Command_line& command, Mesh& input, const Seamed_component& component,
                        Progress& progress)
{
  Flat_sheet flat{cut_sheet(input, component, static_cast<std::size_t>(command.border)), {}};
  flat.flattening = flatten_sheet(flat.sheet, command, progress);
  return flat;
}

// Seams that are added where the map stretches most stay if the next map stretches less.
class Seam_adder
{
public:
  Seam_adder(const Command_line& command, Mesh& input, Seamed_component& component, Seam_record& record,
             Progress& progress, Flat_sheet& flat)
      : m_command(command), m_input(input), m_component(component), m_record(record), m_progress(progress),
        m_flat(flat)
  {}

  void run()
  {
    const auto rounds = ABF::add_seams_in_rounds(
        m_record.stretch_bound, [this] { return m_flat.flattening.scale_stretch; },
        [this](const ABF::Stretch_criterion criterion, const std::size_t count) {
          improve(criterion, count);
        });
    m_record.rounds = rounds.all;
  }

private:
  void improve(const ABF::Stretch_criterion criterion, const std::size_t count)
  {
    const Mesh& mesh = m_component.part.mesh;
    if(criterion == ABF::Stretch_criterion::LOG_SCALE) {
      m_progress.round(m_flat.flattening.scale_stretch);
    }
    std::vector<bool> before;
    for(const Edge e : mesh.edges()) {
      before.push_back(m_component.seams[e]);
    }
    const auto uv = [this](const Halfedge h) {
      return m_flat.flattening.uv[m_flat.sheet.cut->copies[h.idx()]];
    };
    const std::size_t added =
        ABF::add_terminals(mesh, uv, m_component.seams, criterion, count,
                           CGAL::parameters::edge_is_constrained_map(m_component.forbidden));
    if(added == 0) {
      return;
    }
    Flat_sheet next = flatten_once(m_command, m_input, m_component, m_progress);
    if(!next.flattening.succeeded() || !(next.flattening.scale_stretch < m_flat.flattening.scale_stretch)) {
      for(const Edge e : mesh.edges()) {
        m_component.seams[e] = before[e.idx()];
      }
      m_flat.flattening.add_attempt(next.flattening);
      return;
    }
    next.flattening.add_attempt(m_flat.flattening);
    m_flat = std::move(next);
    m_record.terminals = *m_record.terminals + added;
  }

  const Command_line& m_command;
  Mesh& m_input;
  Seamed_component& m_component;
  Seam_record& m_record;
  Progress& m_progress;
  Flat_sheet& m_flat;
};

// In units of the square root of the area
double length_of_seams(const Seamed_component& component)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Mesh& mesh = component.part.mesh;
  double length = 0;
  for(const Edge e : mesh.edges()) {
    length += component.seams[e] ? PMP::edge_length(mesh.halfedge(e), mesh) : 0;
  }
  return length / std::sqrt(PMP::area(mesh));
}

} // namespace

Flat_sheet flatten_along_seams(const Command_line& command, Mesh& input, Seamed_component& component,
                               Seam_record& record, Progress& progress)
{
  Flat_sheet flat = flatten_once(command, input, component, progress);
  const bool has_bound = record.terminals.has_value();
  if(has_bound && flat.flattening.succeeded()) {
    Seam_adder(command, input, component, record, progress, flat).run();
  }
  record.disks = flat.sheet.components;
  record.length = length_of_seams(component);
  if(flat.flattening.succeeded()) {
    record.scale_stretch = flat.flattening.scale_stretch;
    if(has_bound) {
      record.bound_reached = !ABF::misses_stretch_bound(record.scale_stretch, record.stretch_bound);
    }
  }
  return flat;
}

Split_record split_chart(const Sheet& sheet, const Flattening& flattening, const Atlas& atlas)
{
  CGAL::Real_timer timer;
  timer.start();
  const CGAL::Constant_property_map<Edge, bool> uncut(false);
  Cut_mesh alone = cut_open(sheet.mesh(), sheet.faces, sheet.vertices, uncut);
  const auto input_edge = [&](const Edge e) { return sheet.input_edge(alone.edge_origins[e.idx()]); };
  const Edge_marks seams = seam_marks(alone.mesh), is_diagonal = diagonals(*sheet.input);
  const auto piece = alone.mesh.add_property_map<Face, int>("f:piece").first;
  const auto uv = boost::make_function_property_map<Vertex>(
      [&](const Vertex v) { return flattening.uv[alone.origins[v.idx()]]; });
  const auto forbidden =
      boost::make_function_property_map<Edge>([&](const Edge e) { return is_diagonal[input_edge(e)]; });
  const auto report =
      TA::split_overlaps(alone.mesh, uv, seams, piece, CGAL::parameters::edge_is_constrained_map(forbidden));
  if(!report) {
    throw Seams_failed("cannot split overlaps: " + report.message);
  }
  for(const Edge e : alone.mesh.edges()) {
    atlas.seams[input_edge(e)] = atlas.seams[input_edge(e)] || seams[e];
  }
  for(const Face f : alone.mesh.faces()) {
    atlas.chart[sheet.input_face(sheet.faces[f.idx()])] = piece[f];
  }
  return {report.number_of_pieces, report.number_of_overlapping_faces, report.added_seam_length,
          report.extra_seam, timer.time()};
}

} // namespace flatten_mesh
