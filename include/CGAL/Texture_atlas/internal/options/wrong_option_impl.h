// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/options/option_table.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>

#include <algorithm>
#include <string>

namespace CGAL::Texture_atlas::internal {

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Seam_options& options)
{
  return option_out_of_range(options);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Packing_options& options)
{
  std::string wrong = option_out_of_range(options);
  for(const int side : {options.resolution, options.number_of_rows()})
    if(wrong.empty() && side % options.block != 0)
      wrong = "the block of " + std::to_string(options.block) + " texels does not divide the " +
              std::to_string(side) + " texels along a side of the page";
  return wrong;
}

// Charts that are not packed have no page.
// What is wrong with the gutter of a page, or nothing
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_gutter(const Packing_options& options)
{
  const int most = (std::min)(options.resolution, options.number_of_rows()) / 4;
  return options.gutter.value_or(0) <= most
             ? ""
             : "gutter is " + std::to_string(*options.gutter) + ", and must be from 0 to " +
                   std::to_string(most) + ", a quarter of the shorter side of a page";
}

// Options of pages do not matter to charts in rows.
template <class Options>
std::string wrong_atlas_option(Options options)
{
  if(!options.pack_into_square)
    static_cast<Packing_options&>(options) = Packing_options();
  const std::string wrong = option_out_of_range(options);
  return wrong.empty() ? wrong_option(static_cast<const Packing_options&>(options)) : wrong;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Atlas_options& options)
{
  return wrong_atlas_option(options);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Soup_options& options)
{
  return wrong_atlas_option(options);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Baking_options& options)
{
  return option_out_of_range(options);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_IMPL_H
