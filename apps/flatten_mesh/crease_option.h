// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CREASE_OPTION_H
#define FLATTEN_MESH_CREASE_OPTION_H

#include <CGAL/Texture_atlas/Crease_report.h>
#include <CGAL/Texture_atlas/internal/prepare/Seam_way.h>
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

namespace prepare = CGAL::Texture_atlas::internal::prepare;

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

// What `--seams` and `--purpose` ask for
inline prepare::Seam_choice seam_choice(const std::string& seams, const std::string& purpose)
{
  const std::optional<double> angle = crease_angle(seams);
  return {angle ? "creases" : seams, angle, purpose == "texture"};
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
