// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_parameterizer.h"
#include "sequential_hierarchy.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>

namespace ABF_benchmark {

Methods package_methods()
{
  typedef SMP::Hierarchical_parameterizer_3<Mesh, SMP::LSCM_parameterizer_3<Mesh>> Hierarchical_LSCM;
  return {{"abf++", run_parameterizer<SMP::ABF_plus_plus_parameterizer_3<Mesh>>},
          {"habf++", run_parameterizer<SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>>},
          {"hlscm", run_parameterizer<Hierarchical_LSCM>},
          {"sequential", run_parameterizer<Sequential_parameterizer<Mesh>>}};
}

} // namespace ABF_benchmark
