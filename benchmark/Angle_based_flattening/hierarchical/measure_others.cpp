// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sequential.h"

#include "run.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>

#include <stdexcept>

namespace hierarchical {

Measurement run_other_method(const Task& task, Mesh& mesh)
{
  if(task.method == hlscm) {
    typedef SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh> Coarse;
    return run(mesh, SMP::Hierarchical_parameterizer_3<Mesh, Coarse>(options_of(task)));
  } else if(task.method == sequential) {
    return run(mesh, Sequential_parameterizer<Mesh>(options_of(task)));
  } else if(task.method == lscm) {
    return run(mesh, SMP::LSCM_parameterizer_3<Mesh>());
  }
  throw std::runtime_error("unknown method '" + task.method + "'");
}

} // namespace hierarchical
