// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of options of seams, packing, atlases and baking, and the words for seams of the program and of Python

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_OPTION_TABLE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_OPTION_TABLE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/option_table.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/Soup_options.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {

namespace Texture_atlas::internal {

inline Option_words words_of_purposes()
{
  return {{"texture", "few-charts", "conformal"}};
}

} // namespace Texture_atlas::internal

namespace Texture_atlas {

using internal::any_count;
using internal::finite_numbers;
using internal::no_bound;
using internal::numbers_of_threads;
using internal::Option_range;
using internal::Option_switch;
using internal::Option_words;

// The checks of the parameterizers find these functions by their argument, and so they are where the options are.
template <class Visit>
void visit_options(Seam_options& options, const Visit& visit)
{
  visit(
      "stretch_bound", options.stretch_bound, Option_range{1},
      "seams are added until the scale stretch of each chart is at most this bound; 1 is perfect. Up to 1.03 "
      "times the bound is accepted; otherwise, a note says that the bound is missed. With inf, the surface "
      "is "
      "only cut to disks");
  visit("maximum_number_of_terminals", options.maximum_number_of_terminals, any_count,
        "the largest number of vertices of each part that seams lead to because of their scale");
  visit("time_limit", options.time_limit, Option_range{}, "the longest time, in seconds");
}

template <class Visit>
void visit_options(Packing_options& options, const Visit& visit)
{
  const Option_range sides{1, 32768};
  visit("resolution", options.resolution, sides, "number of texels along the horizontal sides of a page");
  visit("height", options.height, sides,
        "number of texels along its vertical sides; by default, as `resolution`");
  visit(
      "gutter", options.gutter, Option_range{0, 1024},
      "number of texels that stay free between charts; by default, a 256th of the shorter side of a page, at "
      "least 1");
  visit("block", options.block, Option_range{1, 1024},
        "no block of N x N texels belongs to two charts, for compressed textures; N divides both sides of a "
        "page");
  visit("texels_per_unit", options.texels_per_unit, finite_numbers,
        "number of texels per unit of length on the surface. There are as many pages as the charts then "
        "take, side "
        "by side as in UDIM, ten in a row; charts larger than a page are cut. With 0, there is one page, "
        "which the "
        "charts fill");
  visit("number_of_rotations", options.number_of_rotations, Option_range{1, 1024},
        "number of directions in which each large chart is tried");
  visit("quantization_bits", options.quantization_bits, Option_range{8, 16},
        "move coordinates to the grid of programs that store them in N bits, such as 12, 14 or 16, so that "
        "quantization turns no triangle over");
}

template <class Visit>
void visit_options(Atlas_options& options, const Visit& visit)
{
  visit_options(static_cast<Seam_options&>(options), visit);
  visit_options(static_cast<Packing_options&>(options), visit);
  visit("given_charts", options.given_charts, Option_words{{"replace", "keep", "repair"}},
        "what becomes of the charts of given coordinates. keep: they keep their shapes and are only packed "
        "anew. "
        "repair: those that are not injective are flattened anew");
  visit("area_weight", options.area_weight, Option_range{0, 1},
        "how much injective maps preserve areas: 0 not at all, 1 as isometric as possible");
  visit(
      "separate_overlaps", options.separate_overlaps, Option_switch(),
      "on: where the map of ABF++ overlaps itself, split the chart into several, which keep their maps. off: "
      "change the map");
  visit("isometric_charts", options.isometric_charts, Option_switch(),
        "on: all charts get injective maps that are as isometric as possible. off: maps keep the angles of "
        "ABF++ "
        "where they can");
  visit("seam_price", options.seam_price, Option_range{},
        "cut charts in two as long as they then cover more of the square: by a factor of e^(price x length), "
        "where "
        "the length of new seams is in units of the square root of the area; inf: cut none");
  visit("equal_seam_lengths", options.equal_seam_lengths, Option_switch(),
        "on: both sides of each edge on a seam get equal lengths, so that the scale does not jump there. "
        "off: their "
        "lengths are free");
  visit("pack_into_square", options.pack_into_square, Option_switch(),
        "off: charts have the same size as in space, and lie in rows, in their order, not turned");
  visit("float_coordinates", options.float_coordinates, Option_switch(),
        "coordinates are rounded to single precision before they are certified");
  visit("threads", options.threads, numbers_of_threads,
        "number of threads; 0: one on each processor. It never changes the result");
}

template <class Visit>
void visit_options(Soup_options& options, const Visit& visit)
{
  visit_options(static_cast<Atlas_options&>(options), visit);
  visit("crease_angle", options.crease_angle, Option_range{0, CGAL_PI, false, false},
        "the least angle of a crease, in radians, where creases are seams");
  visit("weld_tolerance", options.weld_tolerance, finite_numbers,
        "the distance of points that count as the same place");
}

template <class Visit>
void visit_options(Baking_options& options, const Visit& visit)
{
  const Option_range sides{1, 16384};
  visit("resolution", options.resolution, sides,
        "number of texels along the horizontal sides of the texture");
  visit("height", options.height, sides,
        "number of texels along its vertical sides; by default, as `resolution`");
  visit("gutter", options.gutter, Option_range{0, 1024}, "number of texels around charts that are filled");
  visit("ray_length", options.ray_length, Option_range{0, no_bound, false, false},
        "length of rays to each side; by default, a twentieth of the diagonal of the simple surface");
  visit("normals_in_object_space", options.normals_in_object_space, Option_switch(),
        "whether normals are in the coordinates of the surface");
  visit("threads", options.threads, numbers_of_threads,
        "number of threads; 0: one on each processor. It never changes the result");
}

} // namespace Texture_atlas

namespace Surface_mesh_parameterization::internal::ABF {

// "0", or "texture: 1; few-charts, conformal: 0.02" where the purpose sets the option
template <>
inline std::string text_of_default<Texture_atlas::Atlas_options>(const std::string& name)
{
  using Texture_atlas::Atlas_options;
  std::vector<std::pair<std::string, std::string>> values; // each with its purposes
  for(const auto purpose : {Atlas_options::TEXTURE, Atlas_options::FEW_CHARTS, Atlas_options::CONFORMAL}) {
    const std::string value = text_of_value(Atlas_options(purpose), name),
                      word = Texture_atlas::internal::words_of_purposes().value_text(purpose);
    if(!values.empty() && values.back().first == value)
      values.back().second += ", " + word;
    else if(values.size() > 1 && values.front().first == value)
      values.front().second += ", " + word;
    else
      values.emplace_back(value, word);
  }
  std::string text;
  for(const auto& [value, purposes] : values)
    text += (text.empty() ? "" : "; ") + purposes + ": " + value;
  return values.size() == 1 ? values.front().first : text;
}

} // namespace Surface_mesh_parameterization::internal::ABF

} // namespace CGAL

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

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_OPTION_TABLE_H
