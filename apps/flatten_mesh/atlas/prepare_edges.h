// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PREPARE_EDGES_H
#define FLATTEN_MESH_PREPARE_EDGES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/crease_option.h"
#include "flatten_mesh/model/build_mesh.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/seam_weights.h>
#include <CGAL/Texture_atlas/select_crease_seams.h>

#include <algorithm>
#include <optional>
#include <string>

namespace flatten_mesh {

namespace internal {

inline TA::Crease_report examine_creases(Mesh& mesh)
{
  auto marks = mesh.add_property_map<Edge, bool>().first;
  const auto report = TA::select_crease_seams(mesh, marks, TA::Crease_options(),
                                              CGAL::parameters::edge_is_constrained_map(diagonals(mesh)));
  mesh.remove_property_map(marks);
  return report;
}

// Whether maps without stretch are worth seams along creases, as those of boxes and cylinders are.
inline bool unfolds_well(const TA::Crease_report& report)
{
  const double longest_seams = 3; // on surfaces that are hardly flat anywhere
  return report && report.is_developable && report.seam_length > 0 &&
         (report.is_hard_surface() || report.relative_seam_length <= longest_seams);
}

inline bool has_seams(const Mesh& mesh, const Edge_marks& is_seam)
{
  const auto edges = mesh.edges();
  return std::any_of(edges.begin(), edges.end(), [&](const Edge e) { return is_seam[e]; });
}

// Marks seams along creases. They do not divide polygons.
inline Seam_way lay_seams_along_creases(const double angle, Mesh& mesh, const Edge_marks& is_seam)
{
  const bool are_given = has_seams(mesh, is_seam);
  TA::Crease_options options;
  options.angle = angle;
  const auto report = TA::select_crease_seams(mesh, is_seam, options,
                                              CGAL::parameters::edge_is_constrained_map(diagonals(mesh)));
  if(!report) {
    throw Input_error("cannot lay seams along creases: " + report.message);
  }
  if(are_given) { // seams may be on all creases already
    return {"creases", angle, false, std::nullopt};
  }
  return {"creases", angle, !has_seams(mesh, is_seam), report.is_hard_surface()};
}

// Finds out what `--seams` means for a mesh, and marks seams along creases if they are asked for.
inline Seam_way choose_seams(const Atlas_command& options, Mesh& mesh, const Edge_marks& is_seam)
{
  const std::optional<double> angle = crease_angle(options.seams);
  if(angle && !mesh.faces().empty()) {
    return lay_seams_along_creases(*angle, mesh, is_seam);
  }
  Seam_way way;
  way.name = angle ? "creases" : options.seams;
  if(way.name == "auto") {
    way.name = "length";
    if(options.purpose == "texture") {
      const TA::Crease_report report = examine_creases(mesh);
      way.is_hard_surface = report && report.is_hard_surface();
      if(unfolds_well(report) && !has_seams(mesh, is_seam)) {
        return lay_seams_along_creases(TA::Crease_options().angle, mesh, is_seam);
      }
      way.name = *way.is_hard_surface ? "near-creases" : way.name;
    }
  }
  return way;
}

// What seams cost along each edge, unless that is its length
inline void weigh_edges(const std::string& way, const Mesh& mesh,
                        const Mesh::Property_map<Edge, double>& weight)
{
  const double cheapest = way == "near-creases" ? 0.475 : 0.3;
  const auto report = way == "hidden" ? TA::compute_visibility_weights(mesh, weight)
                                      : TA::compute_crease_weights(mesh, weight, cheapest);
  if(!report) {
    throw Input_error("cannot weigh edges for --seams " + way + ": " + report.message);
  }
}

inline Mesh::Property_map<Edge, double> edge_weights(Mesh& mesh)
{
  return mesh.add_property_map<Edge, double>("e:flatten_mesh_weight", 0).first;
}

inline bool has_weights(const Seam_way& way)
{
  return way.name != "length" && way.name != "given";
}

// Marks and weighs edges as `--seams` says.
inline Seam_way prepare_edges(const Atlas_command& options, Mesh& mesh, const Edge_marks& is_seam)
{
  if(options.repacks) {
    return {"given", std::nullopt, false, std::nullopt};
  }
  const Seam_way way = choose_seams(options, mesh, is_seam);
  if(has_weights(way) && !mesh.is_empty()) {
    weigh_edges(way.name, mesh, edge_weights(mesh));
  }
  return way;
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PREPARE_EDGES_H
