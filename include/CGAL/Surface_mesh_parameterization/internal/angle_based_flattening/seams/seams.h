// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SEAMS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

struct Seam_options
{
  double stretch_bound = 1.1;
  int maximum_number_of_terminals = 100;
};

// What is wrong with the options, or nothing
inline std::string wrong_option(const Seam_options& options)
{
  if(!(options.stretch_bound >= 1))
    return "the bound of the stretch is " + std::to_string(options.stretch_bound) +
           ", and must be at least 1";
  if(options.maximum_number_of_terminals < 0)
    return "the number of terminals is at most " + std::to_string(options.maximum_number_of_terminals) +
           ", and must not be negative";
  return "";
}

struct Seams
{
  enum Status
  {
    DONE,
    NO_CUT,
    LINEAR_SYSTEM_FAILED
  };

  Status status = DONE;
  std::vector<char> is_seam; // of each corner: whether the edge that it faces is a seam
  std::vector<int> terminals;
  double predicted_stretch = 1;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SEAMS_H
