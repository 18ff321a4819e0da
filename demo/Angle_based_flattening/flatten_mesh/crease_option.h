// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CREASE_OPTION_H
#define FLATTEN_MESH_CREASE_OPTION_H

#include <CGAL/Surface_mesh_parameterization/select_crease_seams.h>
#include <CGAL/number_type_config.h>

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace flatten_mesh {

// What became of `--seams`
struct Seam_way
{
  std::string name;                    // without an angle; not "auto"
  std::optional<double> crease_angle;  // if creases are seams: of a crease, at least, in radians
  bool lacks_creases = false;          // whether there is none
  std::optional<bool> is_hard_surface; // if that matters: see `Crease_report::is_hard_surface()`
};

// The angle of creases in radians, if `--seams` asks for seams along creases and gives an angle that can be one
inline std::optional<double> crease_angle(const std::string& seams)
{
  const std::string name = "creases";
  if(seams == name) {
    return CGAL::Surface_mesh_parameterization::Crease_options().angle;
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

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CREASE_OPTION_H
