// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEAM_WAY_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEAM_WAY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Symmetry_report.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// How seams are to be chosen
struct Seam_choice
{
  std::string way = "auto";           // or "length", "near-creases", "creases", "hidden"
  std::optional<double> crease_angle; // if creases are to be seams: of a crease, at least, in radians
  bool favors_creases = true;         // with "auto": if the surface has hard edges
};

// Whether seams could be made symmetric
struct Symmetry
{
  Mirror_plane_report plane;
  bool has_symmetric_surface = false;
  bool has_symmetric_seams = false;
  double asymmetry = 0;    // of the seams: see `Symmetry_report::asymmetry`
  double extra_length = 0; // of the seams, as a share of the length of seams that need not be symmetric
};

// What became of mirrored charts of the texture in the file
struct Mirrored_charts
{
  std::size_t number = 0;         // that were turned over
  std::size_t new_seam_edges = 0; // along which the orientation changes
};

// How seams were chosen
struct Seam_way
{
  std::string name;                    // without an angle; not "auto"
  std::optional<double> crease_angle;  // if creases are seams: of a crease, at least, in radians
  bool lacks_creases = false;          // whether there is none
  std::optional<bool> is_hard_surface; // if that matters: see `Crease_report::is_hard_surface()`
  std::optional<Symmetry> symmetry{};  // if it was asked for
  Mirrored_charts mirrored{};          // if charts were given
};

// That of several models: "various" if they differ
inline Seam_way way_in_common(const std::vector<Seam_way>& ways)
{
  Seam_way common = ways.empty() ? Seam_way{"length", std::nullopt, false, std::nullopt} : ways.front();
  common.mirrored = Mirrored_charts();
  for(const Seam_way& way : ways) {
    common.name = way.name == common.name ? way.name : "various";
    common.mirrored.number += way.mirrored.number;
    common.mirrored.new_seam_edges += way.mirrored.new_seam_edges;
    common.lacks_creases = common.lacks_creases && way.lacks_creases;
    if(way.is_hard_surface) {
      common.is_hard_surface = common.is_hard_surface.value_or(false) || *way.is_hard_surface;
    }
  }
  return common;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SEAM_WAY_H
