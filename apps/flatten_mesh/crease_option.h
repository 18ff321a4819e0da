// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CREASE_OPTION_H
#define FLATTEN_MESH_CREASE_OPTION_H

#include <CGAL/Texture_atlas/Crease_report.h>
#include <CGAL/Texture_atlas/Symmetry_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/option_table.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

// What became of `--symmetric`
struct Symmetry
{
  CGAL::Texture_atlas::Mirror_plane_report plane;
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

// What became of `--seams`
struct Seam_way
{
  std::string name;                    // without an angle; not "auto"
  std::optional<double> crease_angle;  // if creases are seams: of a crease, at least, in radians
  bool lacks_creases = false;          // whether there is none
  std::optional<bool> is_hard_surface; // if that matters: see `Crease_report::is_hard_surface()`
  std::optional<Symmetry> symmetry{};  // if it was asked for
  Mirrored_charts mirrored{};          // with `--repack`
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

// The angle of creases in radians, if `--seams` asks for seams along creases and gives an angle that can be one
inline std::optional<double> crease_angle(const std::string& seams)
{
  const std::string name = "creases";
  if(seams == name) {
    return CGAL::Texture_atlas::Crease_options().angle;
  }
  if(seams.compare(0, name.size() + 1, name + ":") != 0) {
    return std::nullopt;
  }
  double degrees = 0;
  const char* const last = seams.data() + seams.size();
  const auto [end, error] = std::from_chars(seams.data() + name.size() + 1, last, degrees);
  const bool is_angle = error == std::errc() && end == last && degrees > 0 && degrees < 180;
  return is_angle ? std::optional<double>(degrees / 180 * CGAL_PI) : std::nullopt;
}

// What is wrong with `--seams`, or nothing
inline std::string wrong_way_of_seams(const std::string& seams)
{
  const CGAL::Surface_mesh_parameterization::internal::ABF::Option_words ways{
      {"auto", "length", "near-creases", "creases", "creases:DEGREES with an angle above 0 and below 180",
       "hidden"}};
  const bool is_known = crease_angle(seams) || std::count(ways.words.begin(), ways.words.end(), seams) > 0;
  return is_known ? "" : "seams is '" + seams + "', and must be " + ways.text();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CREASE_OPTION_H
