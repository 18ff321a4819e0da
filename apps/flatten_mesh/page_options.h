// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_OPTIONS_H
#define FLATTEN_MESH_PAGE_OPTIONS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

namespace flatten_mesh {

namespace internal {

namespace abf = CGAL::Texture_atlas::internal;

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
inline void check_page_size(Atlas_command& atlas)
{
  int height = 0;
  if(!read_page_size(atlas.page, atlas.resolution, height)) {
    throw Usage_error("--resolution takes a number, or two of them, as in 2048x1024; see --help");
  }
  atlas.height = height;
  TA::Packing_options packing = atlas;
  packing.quantization_bits.reset(); // it is checked when the gutter is known
  const std::string wrong = abf::wrong_option(packing);
  if(!wrong.empty()) {
    const bool is_divided = atlas.resolution % atlas.block == 0 && height % atlas.block == 0;
    throw Usage_error((is_divided ? "--resolution " + atlas.page : "--block " + std::to_string(atlas.block)) +
                      ": " + wrong + "; see --help");
  }
  TA::Baking_options baking;
  baking.resolution = atlas.resolution;
  baking.height = height;
  if(const std::string too_large = abf::wrong_option(baking);
     !atlas.bake_from.empty() && !too_large.empty()) {
    throw Usage_error("--bake-from with --resolution " + atlas.page + ": " + too_large + "; see --help");
  }
}

inline void check_pages(const Command_line& command)
{
  const Atlas_command& atlas = command.atlas;
  if(!command.chart_image.empty() &&
     (command.is_plain || !atlas.pack_into_square || atlas.is_in_world_units())) {
    throw Usage_error(std::string("--chart-image goes without ") +
                      (command.is_plain         ? "--plain"
                       : atlas.pack_into_square ? "--units world"
                                                : "--no-pack") +
                      ": it has the texels of the unit square");
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_OPTIONS_H
