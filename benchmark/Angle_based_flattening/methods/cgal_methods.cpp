// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_parameterizer.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

namespace ABF_benchmark {

Methods cgal_methods()
{
  return {{"lscm", run_parameterizer<SMP::LSCM_parameterizer_3<Mesh>>},
          {"arap", run_parameterizer<SMP::ARAP_parameterizer_3<Mesh>>},
          {"conformal", run_parameterizer<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>},
          {"mean-value", run_parameterizer<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>},
          {"authalic", run_parameterizer<SMP::Iterative_authalic_parameterizer_3<Mesh>>}};
}

} // namespace ABF_benchmark
