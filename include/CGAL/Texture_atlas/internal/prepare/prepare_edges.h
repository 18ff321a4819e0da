// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_EDGES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_EDGES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Seam_way.h>

#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>
#include <CGAL/Texture_atlas/seam_weights.h>
#include <CGAL/Texture_atlas/select_crease_seams.h>

#include <algorithm>
#include <optional>
#include <string>

namespace CGAL::Texture_atlas::internal::prepare {

inline Crease_report examine_creases(Mesh& mesh)
{
  auto marks = mesh.add_property_map<Edge, bool>().first;
  const auto report = select_crease_seams(mesh, marks, Crease_options(),
                                          parameters::edge_is_constrained_map(diagonals(mesh)));
  mesh.remove_property_map(marks);
  return report;
}

// Whether maps without stretch are worth seams along creases, as those of boxes and cylinders are.
inline bool unfolds_well(const Crease_report& report)
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
  Crease_options options;
  options.angle = angle;
  const auto report =
      select_crease_seams(mesh, is_seam, options, parameters::edge_is_constrained_map(diagonals(mesh)));
  if(!report) {
    throw Input_error("cannot lay seams along creases: " + report.message);
  }
  if(are_given) { // seams may be on all creases already
    return {"creases", angle, false, std::nullopt};
  }
  return {"creases", angle, !has_seams(mesh, is_seam), report.is_hard_surface()};
}

// Finds out what the choice means for a mesh, and marks seams along creases if they are asked for.
inline Seam_way choose_seams(const Seam_choice& choice, Mesh& mesh, const Edge_marks& is_seam)
{
  if(choice.crease_angle && !mesh.faces().empty()) {
    return lay_seams_along_creases(*choice.crease_angle, mesh, is_seam);
  }
  Seam_way way;
  way.name = choice.way;
  if(way.name == "auto") {
    way.name = "length";
    if(choice.favors_creases) {
      const Crease_report report = examine_creases(mesh);
      way.is_hard_surface = report && report.is_hard_surface();
      if(unfolds_well(report) && !has_seams(mesh, is_seam)) {
        return lay_seams_along_creases(Crease_options().angle, mesh, is_seam);
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
  const auto report = way == "hidden" ? compute_visibility_weights(mesh, weight)
                                      : compute_crease_weights(mesh, weight, cheapest);
  if(!report) {
    throw Input_error("cannot weigh edges for seams of the kind '" + way + "': " + report.message);
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

// Marks and weighs edges for seams of this choice.
inline Seam_way prepare_edges(const Seam_choice& choice, Mesh& mesh, const Edge_marks& is_seam)
{
  const Seam_way way = choose_seams(choice, mesh, is_seam);
  if(has_weights(way) && !mesh.is_empty()) {
    weigh_edges(way.name, mesh, edge_weights(mesh));
  }
  return way;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_EDGES_H
