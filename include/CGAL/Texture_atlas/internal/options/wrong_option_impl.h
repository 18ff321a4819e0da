// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/idle_options.h>
#include <CGAL/Texture_atlas/internal/options/option_table.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace CGAL::Texture_atlas::internal {

inline std::string idle_seam_option(const Seam_options& options, const Option_names& changed)
{
  return Idle_options(changed)
      .check(std::isinf(options.stretch_bound), {"maximum_number_of_terminals"},
             "with an infinite stretch_bound, the surface is only cut to disks")
      .wrong();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Seam_options& options)
{
  const std::string wrong = option_out_of_range(options);
  return wrong.empty() ? idle_seam_option(options, changed_options(options)) : wrong;
}

// What is wrong with the grid of coordinates, or nothing
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_quantization(const Packing_options& options)
{
  if(!options.quantization_bits)
    return "";
  if(options.texels_per_unit > 0)
    return "quantization_bits and texels_per_unit exclude each other: the grid is that of one page";
  const int side = (std::max)(options.resolution, options.number_of_rows()),
            gutter = (std::max)(1, options.number_of_gutter_texels());
  const auto suffice = [&](int bits) { return 2. * side <= gutter * ((1 << bits) - 1.); };
  const int most = 16;
  int needed = *options.quantization_bits;
  while(needed <= most && !suffice(needed))
    ++needed;
  if(needed == *options.quantization_bits)
    return "";
  return "a grid of " + std::to_string(*options.quantization_bits) +
         " bits (quantization_bits) is too coarse for a gutter of " + std::to_string(gutter) + " among " +
         std::to_string(side) + " texels; " +
         (needed <= most ? std::to_string(needed) + " bits suffice"
                         : "no grid of up to " + std::to_string(most) + " bits suffices");
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Packing_options& options)
{
  std::string wrong = option_out_of_range(options);
  for(const int side : {options.resolution, options.number_of_rows()})
    if(wrong.empty() && side % options.block != 0)
      wrong = "the block of " + std::to_string(options.block) + " texels does not divide the " +
              std::to_string(side) + " texels along a side of the page";
  return wrong.empty() ? wrong_quantization(options) : wrong;
}

// What is wrong with the gutter of a page, or nothing
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_gutter(const Packing_options& options)
{
  const int most = (std::min)(options.resolution, options.number_of_rows()) / 4;
  return options.gutter.value_or(0) <= most
             ? ""
             : "gutter is " + std::to_string(*options.gutter) + ", and must be from 0 to " +
                   std::to_string(most) + ", a quarter of the shorter side of a page";
}

// The options that differ from the defaults for each purpose
template <class Options>
Option_names changed_atlas_options(const Options& options)
{
  return changed_options(options, {Options(Atlas_options::TEXTURE), Options(Atlas_options::FEW_CHARTS),
                                   Options(Atlas_options::CONFORMAL)});
}

inline std::string idle_atlas_option(const Atlas_options& options, const Option_names& changed)
{
  const std::string wrong = idle_seam_option(options, changed);
  if(!wrong.empty())
    return wrong;
  Idle_options idle(changed);
  idle.check(!options.pack_into_square,
             {"resolution", "height", "gutter", "block", "texels_per_unit", "number_of_rotations",
              "seam_price", "quantization_bits"},
             "charts that are not packed have no page; set pack_into_square")
      .check(options.given_charts != Atlas_options::REPLACE, {"seam_price"},
             "charts that are given are not cut in two")
      .check(options.given_charts == Atlas_options::KEEP, {"maximum_number_of_terminals", "area_weight"},
             "charts that are kept are neither cut nor flattened")
      .check(options.given_charts == Atlas_options::KEEP && options.stretch_bound != 2, {"stretch_bound"},
             "charts that are kept are not flattened")
      .check(options.isometric_charts, {"area_weight"},
             "isometric charts preserve areas as much as they can; set isometric_charts to false");
  return idle.wrong();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Atlas_options& options)
{
  std::string wrong = option_out_of_range(options);
  if(wrong.empty())
    wrong = wrong_option(static_cast<const Packing_options&>(options));
  return wrong.empty() ? idle_atlas_option(options, changed_atlas_options(options)) : wrong;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Soup_options& options)
{
  std::string wrong = option_out_of_range(options);
  if(wrong.empty())
    wrong = wrong_option(static_cast<const Atlas_options&>(options));
  if(!wrong.empty())
    return wrong;
  const bool are_given = options.given_charts != Atlas_options::REPLACE;
  const std::string have_seams = " would have no effect: charts that are kept or repaired have their seams";
  if(are_given && options.seams != Soup_options::AUTO && options.seams != Soup_options::LENGTH)
    return "seams" + have_seams;
  if(are_given && (options.texture_seams || options.material_seams))
    return (options.texture_seams ? "texture_seams" : "material_seams") + have_seams;
  return Idle_options(changed_atlas_options(options))
      .check(options.seams != Soup_options::CREASES, {"crease_angle"}, "set seams to CREASES, too")
      .check(!options.weld || !options.repair, {"weld_tolerance"},
             "without weld and repair, nothing is joined")
      .wrong();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Baking_options& options)
{
  return option_out_of_range(options);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_IMPL_H
