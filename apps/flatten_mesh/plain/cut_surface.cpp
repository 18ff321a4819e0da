// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/cut_surface.h"

#include "flatten_mesh/atlas/keep_seams.h"
#include "flatten_mesh/plain/flatten_sheet.h"

#include <CGAL/number_utils.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Texture_atlas/internal/atlas/reduce_stretch.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/split_overlaps.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace {

namespace ABF = CGAL::Texture_atlas::internal;

// `what` was tried.
void check_report(const SMP::Report& report, const std::string& what)
{
  if(report) {
    return;
  }
  const std::string text = "cannot " + what + ": " + report.message;
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

// Marks the seams in a file. Throws an `Input_error` unless they are edges of the input and leave disks.
void read_seams(const std::string& file, Atlas_input& input, Seamed_component& component)
{
  const Edge_marks seams = seam_marks(input.mesh);
  internal::keep_seams_of_file(file, input.mesh);
  const Mesh& mesh = component.part.mesh;
  for(const Edge e : mesh.edges()) {
    component.seams[e] = seams[component.part.edge_origins[e.idx()]];
  }
  if(const auto check = TA::is_disk_cut(mesh, component.seams); !check) {
    const auto& part = check.parts[check.defective_part];
    throw Input_error("'" + file + "': the seams do not leave disks: the part of " +
                      count_text(part.number_of_faces, "triangle") + " at " +
                      ABF::vertex_text(component.part.origins[mesh.target(part.where).idx()].idx() + 1,
                                       mesh.point(mesh.target(part.where))) +
                      " cannot be flattened: " + defect_text(part) +
                      "; add seams, or let --cut auto choose them");
  }
}

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

// The numbers of vertices in messages: those of the file
auto vertex_numbers(const std::vector<Vertex>& origins)
{
  return boost::make_function_property_map<Vertex>(
      [&origins](const Vertex v) { return std::size_t(origins[v.idx()].idx()) + 1; });
}

auto edges_without_seams(const Seamed_component& component)
{
  return CGAL::parameters::edge_is_constrained_map(component.forbidden)
      .vertex_index_map(vertex_numbers(component.part.origins));
}

} // namespace

bool is_cut(const Command_line& command, Mesh& mesh, const Component& component)
{
  return command.asks_for_cones  ? true
         : command.cut == "auto" ? command.asks_for_stretch || !is_disk_with_holes(mesh, component.number)
                                 : command.cut != "none";
}

Cone_record choose_cones(const Command_line& command, Seamed_component& component)
{
  Cone_record record;
  record.wanted = static_cast<std::size_t>(command.cones);
  record.multiple = command.cone_angle_multiple / 180 * CGAL_PI;
  TA::Cone_options options;
  options.angle_multiple = record.multiple;
  component.cones =
      TA::select_cones(component.part.mesh, record.wanted, options,
                       CGAL::parameters::vertex_index_map(vertex_numbers(component.part.origins)));
  check_report(*component.cones, "choose cones");
  record.predicted_stretch = component.cones->predicted_stretch;
  for(const auto& [v, angle] : component.cones->cones) {
    record.cones.emplace_back(std::size_t(component.part.origins[v.idx()].idx()), angle);
  }
  return record;
}

void choose_seams(const Command_line& command, Atlas_input& input, Seamed_component& component,
                  Seam_record& record)
{
  const Mesh& mesh = component.part.mesh;
  const auto forbidden = edges_without_seams(component);
  record.cut = component.cones ? "cones" : command.cut;
  if(component.cones) {
    const std::set<Vertex> cones = component.cones->vertices();
    check_report(
        TA::cut_to_disks(mesh, component.seams,
                         forbidden.vertex_is_constrained_map(CGAL::make_boolean_property_map(cones))),
        "choose seams");
  } else if(command.cut == "auto") {
    TA::Seam_options options;
    options.stretch_bound = command.stretch_bound;
    const auto report = TA::select_seams(mesh, component.seams, options, forbidden);
    check_report(report, "choose seams");
    record.stretch_bound = command.stretch_bound;
    record.terminals = report.number_of_terminals;
    record.predicted_stretch = report.predicted_stretch;
  } else if(command.cut == "topology") {
    check_report(TA::cut_to_disks(mesh, component.seams, forbidden), "choose seams");
  } else {
    read_seams(command.cut, input, component);
  }
}

Flat_sheet flatten_along_seams(const Command_line& command, Mesh& input, Seamed_component& component,
                               Seam_record& record, Progress& progress)
{
  const auto flatten = [&] {
    Flat_sheet flat{cut_sheet(input, component, static_cast<std::size_t>(command.border)), {}};
    flat.flattening = flatten_sheet(flat.sheet, command, progress);
    return flat;
  };
  Flat_sheet flat = flatten();
  const auto stretch = [&flat] { return flat.flattening.scale_stretch; };
  // Seams that are added where the map stretches most stay if the next map stretches less.
  const auto improve = [&](const ABF::Stretch_criterion criterion, const std::size_t count) {
    if(criterion == ABF::Stretch_criterion::LOG_SCALE) {
      progress.round(stretch());
    }
    const std::vector<bool> before(component.seams.begin(), component.seams.end());
    const auto uv = [&flat](const Halfedge h) { return flat.flattening.uv[flat.sheet.cut->copies[h.idx()]]; };
    const std::size_t added = ABF::add_terminals(component.part.mesh, uv, component.seams, criterion, count,
                                                 edges_without_seams(component));
    if(added == 0) {
      return;
    }
    Flat_sheet next = flatten();
    const bool is_better = next.flattening.succeeded() && next.flattening.scale_stretch < stretch();
    if(is_better) {
      std::swap(flat, next);
      *record.terminals += added;
    } else {
      std::copy(before.begin(), before.end(), component.seams.begin());
    }
    flat.flattening.add_attempt(next.flattening);
  };
  if(record.terminals && flat.flattening.succeeded()) {
    record.rounds = ABF::add_seams_in_rounds(record.stretch_bound, 0, stretch, improve).all;
  }
  record.disks = flat.sheet.components;
  record.length = length_of_seams(component);
  if(flat.flattening.succeeded()) {
    record.scale_stretch = stretch();
    if(record.terminals) {
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
  const auto number = boost::make_function_property_map<Vertex>(
      [&](const Vertex v) { return std::size_t(sheet.input_vertex(alone.origins[v.idx()]).idx()) + 1; });
  Split_record record;
  static_cast<TA::Overlap_split_report&>(record) =
      TA::split_overlaps(alone.mesh, uv, seams, piece,
                         CGAL::parameters::edge_is_constrained_map(forbidden).vertex_index_map(number));
  if(!record) {
    throw Seams_failed("cannot split overlaps: " + record.message);
  }
  for(const Edge e : alone.mesh.edges()) {
    atlas.seams[input_edge(e)] = atlas.seams[input_edge(e)] || seams[e];
  }
  for(const Face f : alone.mesh.faces()) {
    atlas.chart[sheet.input_face(sheet.faces[f.idx()])] = piece[f];
  }
  record.seconds = timer.time();
  return record;
}

} // namespace flatten_mesh
