// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Parameterizer_method.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>

namespace ABF_benchmark {

std::vector<Method> package_methods()
{
  return {parameterizer_method<SMP::ABF_plus_plus_parameterizer_3<Mesh>>("abf++", "ABF++"),
          parameterizer_method<SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>>("habf++",
                                                                                      "hierarchical ABF++")};
}

} // namespace ABF_benchmark
