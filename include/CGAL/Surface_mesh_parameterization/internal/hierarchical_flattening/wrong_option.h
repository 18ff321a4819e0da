// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_WRONG_OPTION_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_WRONG_OPTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option.h>

#include <cmath>
#include <string>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// What is wrong with the options, or nothing.
inline std::string wrong_option(const Hierarchical_options& options)
{
  if(!(options.simplification_rate > 0 && options.simplification_rate < 1))
    return "the simplification rate must be between 0 and 1";
  if(!(options.extreme_angle >= 0))
    return "the extreme angle must be a number of at least 0";
  if(!std::isfinite(options.barrier) || options.barrier < 0)
    return "the barrier must be a number of at least 0";
  if(options.coarse_triangles < 0 || options.sweeps < 0 || options.angle_sweeps < 0 ||
     options.max_retries < 0 || options.threads < 0)
    return "numbers of triangles, sweeps, retries and threads must not be negative";
  return options.polish ? wrong_option(options.polish_options) : std::string();
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_WRONG_OPTION_H
