// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/option_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option.h>

#include <string>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

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
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Atlas_options& options)
{
  Atlas_options checked = options;
  if(!options.pack_into_square)
    static_cast<Packing_options&>(checked) = Packing_options();
  const std::string wrong = option_out_of_range(checked);
  return wrong.empty() ? wrong_option(static_cast<const Packing_options&>(checked)) : wrong;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const ABF_plus_plus_options& options)
{
  return option_out_of_range(options);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Hierarchical_options& options)
{
  if(options.polish_options.equal_seam_lengths.value_or(false))
    return "polishing does not support seams of equal lengths: only the direct method does";
  const std::string wrong = option_out_of_range(options);
  return wrong.empty() && options.polish ? wrong_option(options.polish_options) : wrong;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Baking_options& options)
{
  return option_out_of_range(options);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_IMPL_H
