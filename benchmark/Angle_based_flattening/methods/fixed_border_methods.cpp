// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Parameterizer_method.h"

#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

namespace ABF_benchmark {

std::vector<Method> fixed_border_methods()
{
  return {parameterizer_method<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>(
              "conformal", "discrete conformal map, on a circle (CGAL)"),
          parameterizer_method<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>(
              "mean-value", "mean value coordinates, on a circle (CGAL)"),
          parameterizer_method<SMP::Iterative_authalic_parameterizer_3<Mesh>>(
              "authalic", "iterative authalic, on a circle (CGAL)")};
}

} // namespace ABF_benchmark
