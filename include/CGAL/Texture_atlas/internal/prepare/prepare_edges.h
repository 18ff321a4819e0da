// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_EDGES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_EDGES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Soup_options.h>
#include <CGAL/Texture_atlas/Soup_report.h>

#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>
#include <CGAL/Texture_atlas/seam_weights.h>
#include <CGAL/Texture_atlas/select_crease_seams.h>

#include <algorithm>
#include <optional>
#include <string>

namespace CGAL::Texture_atlas::internal::prepare {

inline Mesh_report<Mesh, Crease_report> examine_creases(Mesh& mesh)
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
inline void lay_seams_along_creases(const double angle, Mesh& mesh, const Edge_marks& is_seam,
                                    Soup_report::Seams& way)
{
  const bool are_given = has_seams(mesh, is_seam);
  Crease_options options;
  options.angle = angle;
  const auto report =
      select_crease_seams(mesh, is_seam, options, parameters::edge_is_constrained_map(diagonals(mesh)));
  if(!report) {
    throw Input_error("cannot lay seams along creases: " + report.message, {}, {}, report.status);
  }
  way.name = "creases";
  way.crease_angle = angle;
  if(!are_given) { // otherwise, seams may be on all creases already
    way.lacks_creases = !has_seams(mesh, is_seam);
    way.is_hard_surface = report.is_hard_surface();
  }
}

// Finds out what the options mean for a mesh, and marks seams along creases if they are asked for.
inline void choose_seams(const Soup_options& options, Mesh& mesh, const Edge_marks& is_seam,
                         Soup_report::Seams& way)
{
  switch(options.seams) {
  case Soup_options::CREASES:
    way.name = "creases";
    if(!mesh.faces().empty()) {
      lay_seams_along_creases(options.crease_angle, mesh, is_seam, way);
    }
    break;
  case Soup_options::AUTO: {
    const auto report = examine_creases(mesh);
    way.is_hard_surface = report && report.is_hard_surface();
    way.name = *way.is_hard_surface ? "near-creases" : "length";
    if(unfolds_well(report) && !has_seams(mesh, is_seam)) {
      lay_seams_along_creases(Crease_options().angle, mesh, is_seam, way);
    }
    break;
  }
  case Soup_options::NEAR_CREASES:
    way.name = "near-creases";
    break;
  case Soup_options::HIDDEN:
    way.name = "hidden";
    break;
  case Soup_options::LENGTH:
    way.name = "length";
  }
}

// What seams cost along each edge, unless that is its length
inline void weigh_edges(const std::string& way, const Mesh& mesh,
                        const Mesh::Property_map<Edge, double>& weight)
{
  const double cheapest = way == "near-creases" ? 0.475 : 0.3;
  const auto report = way == "hidden" ? compute_visibility_weights(mesh, weight)
                                      : compute_crease_weights(mesh, weight, cheapest);
  if(!report) {
    throw Input_error("cannot weigh edges for seams of the kind '" + way + "': " + report.message, {}, {},
                      report.status);
  }
}

inline Mesh::Property_map<Edge, double> edge_weights(Mesh& mesh)
{
  return mesh.add_property_map<Edge, double>("e:flatten_mesh_weight", 0).first;
}

inline bool has_weights(const Soup_report::Seams& way)
{
  return way.name != "length" && way.name != "given";
}

// Marks and weighs edges for the seams that are asked for.
inline void prepare_edges(const Soup_options& options, Mesh& mesh, const Edge_marks& is_seam,
                          Soup_report::Seams& way)
{
  choose_seams(options, mesh, is_seam, way);
  if(has_weights(way) && !mesh.is_empty()) {
    weigh_edges(way.name, mesh, edge_weights(mesh));
  }
}

// What the seams of several surfaces have in common: "various" if they differ
inline Soup_report::Seams seams_in_common(const std::vector<Soup_report::Seams>& ways)
{
  Soup_report::Seams common = ways.empty() ? Soup_report::Seams() : ways.front();
  common.turned_charts = common.mirror_edges = 0;
  for(const Soup_report::Seams& way : ways) {
    common.name = way.name == common.name ? way.name : "various";
    common.turned_charts += way.turned_charts;
    common.mirror_edges += way.mirror_edges;
    common.lacks_creases = common.lacks_creases && way.lacks_creases;
    if(way.is_hard_surface) {
      common.is_hard_surface = common.is_hard_surface.value_or(false) || *way.is_hard_surface;
    }
  }
  return common;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_EDGES_H
