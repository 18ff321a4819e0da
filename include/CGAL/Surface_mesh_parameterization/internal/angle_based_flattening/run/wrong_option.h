// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_WRONG_OPTION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_WRONG_OPTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>

#include <cmath>
#include <string>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// What is wrong with the options, or nothing.
inline std::string wrong_option(const ABF_plus_plus_options& options)
{
  if(!std::isfinite(options.barrier) || options.barrier < 0)
    return "the barrier must be a number of at least 0";
  if(!(options.tolerance > 0))
    return "the tolerance must be above 0";
  if(!(options.energy_tolerance > 0))
    return "the energy tolerance must be above 0";
  if(options.max_iterations < 0)
    return "the number of iterations must not be negative";
  if(options.threads < 0)
    return "the number of threads must not be negative";
  return std::string();
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_WRONG_OPTION_H
