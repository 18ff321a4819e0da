// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>

namespace hierarchical {

Measurement run_lscm(const Task& task, Mesh& mesh)
{
  typedef SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh> Coarse;
  return task.method == hlscm ? run(mesh, SMP::Hierarchical_parameterizer_3<Mesh, Coarse>(options_of(task)))
                              : run(mesh, SMP::LSCM_parameterizer_3<Mesh>());
}

} // namespace hierarchical
