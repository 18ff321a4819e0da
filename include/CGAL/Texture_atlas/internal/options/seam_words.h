// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The words for seams of the program and of Python

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_SEAM_WORDS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_SEAM_WORDS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/number_type_config.h>
#include <CGAL/Texture_atlas/internal/options/option_table.h>
#include <CGAL/Texture_atlas/Soup_options.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace CGAL::Texture_atlas::internal {

// The angle of creases in radians, if words ask for seams along creases and give an angle that can be one
inline std::optional<double> crease_angle(const std::string& seams)
{
  const std::string name = "creases";
  if(seams == name) {
    return Crease_options().angle;
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

// Sets the options that words stand for. Of other atlases than for textures, "auto" seams are short.
inline void set_seams(const std::string& seams, const bool is_texture, Soup_options& options)
{
  using Options = Soup_options;
  const std::optional<double> angle = crease_angle(seams);
  options.seams = angle                           ? Options::CREASES
                  : seams == "near-creases"       ? Options::NEAR_CREASES
                  : seams == "hidden"             ? Options::HIDDEN
                  : seams == "auto" && is_texture ? Options::AUTO
                                                  : Options::LENGTH;
  options.crease_angle = angle.value_or(options.crease_angle);
}

// What is wrong with words for seams, or nothing
inline std::string wrong_seams(const std::string& seams)
{
  const Option_words ways{{"auto", "length", "near-creases", "creases",
                           "creases:DEGREES with an angle above 0 and below 180", "hidden"}};
  const bool is_known = crease_angle(seams) || std::count(ways.words.begin(), ways.words.end(), seams) > 0;
  return is_known ? "" : "seams is '" + seams + "', and must be " + ways.text();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_SEAM_WORDS_H
