// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Parameterizer_method.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>

namespace ABF_benchmark {

std::vector<Method> free_border_methods()
{
  return {parameterizer_method<SMP::LSCM_parameterizer_3<Mesh>>("lscm", "LSCM (CGAL)"),
          parameterizer_method<SMP::ARAP_parameterizer_3<Mesh>>("arap", "ARAP (CGAL)")};
}

} // namespace ABF_benchmark
