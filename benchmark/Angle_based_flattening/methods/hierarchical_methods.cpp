// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Parameterizer_method.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>

namespace ABF_benchmark {

std::vector<Method> hierarchical_methods()
{
  typedef SMP::LSCM_parameterizer_3<Mesh> LSCM;
  return {parameterizer_method<SMP::Hierarchical_parameterizer_3<Mesh, LSCM>>("hlscm", "hierarchical LSCM")};
}

} // namespace ABF_benchmark
