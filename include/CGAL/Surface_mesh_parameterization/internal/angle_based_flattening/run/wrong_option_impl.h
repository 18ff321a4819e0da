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

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const ABF_plus_plus_options& options)
{
  return option_out_of_range(options);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Hierarchical_options& options)
{
  if(options.polish_options.equal_seam_lengths.value_or(false))
    return "polishing does not support seams of equal lengths: only the direct method does";
  const std::string wrong = option_out_of_range(options);
  if(wrong.empty() && options.injective && options.polish && is_isometric(options))
    return "polish lowers the energy of angles, which undoes an area_weight above 0.1: take one of both";
  return wrong.empty() && options.polish ? wrong_option(options.polish_options) : wrong;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_IMPL_H
