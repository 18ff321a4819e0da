// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_OPTIONS_H
#define FLATTEN_MESH_PAGE_OPTIONS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/texts.h"

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <cmath>
#include <cstddef>
#include <string>

namespace flatten_mesh {

namespace internal {

// Reads "2048", or "2048x1024". Returns whether the text is one of these.
inline bool read_page_size(const std::string& text, int& width, int& height)
{
  const std::size_t x = text.find('x');
  const bool is_number = boost::conversion::try_lexical_convert(text.substr(0, x), width);
  height = width;
  return is_number &&
         (x == std::string::npos || boost::conversion::try_lexical_convert(text.substr(x + 1), height));
}

// Sets the numbers of texels of a page.
inline void check_page_size(Atlas_options& atlas)
{
  const auto is_side = [](const int side) { return side >= 16 && side <= 16384; };
  if(!read_page_size(atlas.page, atlas.resolution, atlas.height) || !is_side(atlas.resolution) ||
     !is_side(atlas.height)) {
    throw Usage_error(
        "--resolution takes a number from 16 to 16384, or two of them, as in 2048x1024; see --help");
  }
  if(atlas.block < 1 || atlas.resolution % atlas.block != 0 || atlas.height % atlas.block != 0) {
    throw Usage_error("--block takes a number of at least 1 that divides both sides of the page, " +
                      std::to_string(atlas.resolution) + " and " + std::to_string(atlas.height) +
                      "; see --help");
  }
}

inline void check_pages(const bool asks_for_density, const Command_line& command)
{
  const Atlas_options& atlas = command.atlas;
  if(asks_for_density && !(atlas.texels_per_unit > 0 && std::isfinite(atlas.texels_per_unit))) {
    throw Usage_error("--texels-per-unit takes a number above 0; see --help");
  }
  if(!command.chart_image.empty() && (command.is_plain || !atlas.is_packed || atlas.is_in_world_units())) {
    throw Usage_error(std::string("--chart-image goes without ") +
                      (command.is_plain  ? "--plain"
                       : atlas.is_packed ? "--units world"
                                         : "--no-pack") +
                      ": it has the texels of the unit square");
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_OPTIONS_H
