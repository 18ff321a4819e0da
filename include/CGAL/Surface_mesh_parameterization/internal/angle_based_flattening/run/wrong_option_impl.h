// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/idle_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/option_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option.h>

#include <algorithm>
#include <string>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

inline const Option_names options_of_injective_maps = {"area_weight", "clearance"};

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const ABF_plus_plus_options& options)
{
  const std::string wrong = option_out_of_range(options);
  if(!wrong.empty())
    return wrong;
  const bool is_direct = !(options.injective && is_isometric(options));
  Idle_options idle(changed_options(options));
  idle.check(!options.injective, options_of_injective_maps, "it is for injective maps; set injective, too")
      .check(!is_direct,
             {"tolerance", "energy_tolerance", "max_iterations", "step", "linear_solver", "layout",
              "warm_start"},
             "injective maps with an area_weight above 0.1 are not made by the direct method");
  if(idle.wrong().empty() && !is_direct && options.equal_seam_lengths.value_or(false))
    return "equal_seam_lengths would have no effect: an area_weight above 0.1 leaves lengths of injective "
           "maps free";
  return idle.wrong();
}

// What is wrong with the options of polishing. Threads never change the result.
inline std::string wrong_polish_option(const Hierarchical_options& options)
{
  const ABF_plus_plus_options& polish_options = options.polish_options;
  if(const std::string wrong = option_out_of_range(polish_options); options.polish && !wrong.empty())
    return wrong;
  const Option_names of_solver = {"barrier",       "tolerance", "energy_tolerance", "max_iterations", "step",
                                  "linear_solver", "layout"};
  for(const std::string& name : changed_options(polish_options)) {
    const std::string start = "polish_options." + name + " would have no effect: ";
    if(!options.polish && name != "threads")
      return start + "set polish, too";
    if(const bool is_of_solver = std::count(of_solver.begin(), of_solver.end(), name) > 0;
       is_of_solver && options.injective)
      return start + "injective maps are polished by another solver, of which time_limit is the only option";
    else if(!is_of_solver && name != "threads" && name != "time_limit")
      return start + "it is no option of polishing";
  }
  return {};
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Hierarchical_options& options)
{
  if(options.polish_options.equal_seam_lengths.value_or(false))
    return "polishing does not support seams of equal lengths: only the direct method does";
  const std::string wrong = option_out_of_range(options);
  if(!wrong.empty())
    return wrong;
  if(options.injective && options.polish && is_isometric(options))
    return "polish lowers the energy of angles, which undoes an area_weight above 0.1: take one of both";
  Idle_options idle(changed_options(options));
  idle.check(!options.injective, options_of_injective_maps, "it is for injective maps; set injective, too")
      .check(options.injective, {"simplification_rate", "coarse_triangles"},
             "injective maps start from about 300 vertices")
      .check(options.coarse_triangles > 0, {"simplification_rate"},
             "coarse_triangles replaces it; set one of both")
      .check(options.angle_sweeps == 0, {"energy_tolerance"}, "it ends final sweeps; set angle_sweeps, too");
  return idle.wrong().empty() ? wrong_polish_option(options) : idle.wrong();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_IMPL_H
