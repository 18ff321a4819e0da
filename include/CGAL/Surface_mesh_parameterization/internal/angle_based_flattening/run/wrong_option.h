// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which option of a method has a value that it cannot have, as a text for the report.
// `strategies/run_parameterizer.h`, `cones/cone_flattener.h` and `atlas/atlas_options.h` ask before they read the mesh.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>

#include <cmath>
#include <string>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Rounding errors alone violate the constraints by this much, even on meshes of few triangles.
inline constexpr double smallest_tolerance = 1e-14;

// More sweeps take time and change nothing.
inline constexpr int most_sweeps = 1000;

inline std::string wrong_time_limit(double time_limit)
{
  return time_limit >= 0 ? std::string() : "the time limit must be at least 0 seconds";
}

// Returns what is wrong with the options, or an empty string.
inline std::string wrong_option(const Flattening_options& options)
{
  if(!std::isfinite(options.barrier) || options.barrier < 0)
    return "the barrier must be finite and not negative";
  if(options.holes != Flattening_options::SOLVE && options.holes != Flattening_options::FILL &&
     options.holes != Flattening_options::REFUSE)
    return "unknown treatment of holes";
  if(!(options.area_weight >= 0 && options.area_weight <= 1))
    return "the area weight must be at least 0 and at most 1";
  if(!(options.clearance > 0 && options.clearance <= 1))
    return "the clearance must be above 0 and at most 1";
  if(!(options.pin_weight > 0))
    return "the weight of pins must be positive";
  if(options.threads < 0)
    return "the number of threads must not be negative";
  return wrong_time_limit(options.time_limit);
}

inline std::string wrong_option(const ABF_plus_plus_options& options)
{
  if(!(options.tolerance >= smallest_tolerance))
    return "the tolerance must be at least 1e-14";
  if(!(options.energy_tolerance > 0))
    return "the energy tolerance must be positive";
  if(options.max_iterations < 0)
    return "the number of iterations must not be negative";
  if(options.step != ABF_plus_plus_options::NEWTON &&
     options.step != ABF_plus_plus_options::SEQUENTIAL_LINEARLY_CONSTRAINED)
    return "unknown type of step";
  if(options.linear_solver != ABF_plus_plus_options::ITERATIVE &&
     options.linear_solver != ABF_plus_plus_options::DIRECT)
    return "unknown linear solver";
  if(options.layout != ABF_plus_plus_options::AUTOMATIC_LAYOUT &&
     options.layout != ABF_plus_plus_options::EXACT_LAYOUT &&
     options.layout != ABF_plus_plus_options::LEAST_SQUARES_LAYOUT)
    return "unknown layout";
  return wrong_option(static_cast<const Flattening_options&>(options));
}

inline std::string wrong_option(const Hierarchical_options& options)
{
  if(!(options.simplification_rate > 0 && options.simplification_rate < 1))
    return "the simplification rate must be between 0 and 1";
  if(!(options.extreme_angle >= 0))
    return "the extreme angle must not be negative";
  if(options.coarse_triangles < 0 || options.sweeps < 0 || options.angle_sweeps < 0 ||
     options.max_retries < 0)
    return "numbers of triangles, sweeps and retries must not be negative";
  if(options.sweeps > most_sweeps || options.angle_sweeps > most_sweeps)
    return "numbers of sweeps must be at most 1000";
  if(!(options.energy_tolerance >= 0 && options.energy_tolerance < 1))
    return "the energy tolerance must be at least 0 and below 1";
  if(options.polish_options.equal_seam_lengths.value_or(false))
    return "polishing does not support seams of equal lengths: only the direct method does";
  const std::string wrong = wrong_option(static_cast<const Flattening_options&>(options));
  return wrong.empty() && options.polish ? wrong_option(options.polish_options) : wrong;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_H
