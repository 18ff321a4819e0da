// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sequential.h"

#include "run.h"

namespace hierarchical {

Measurement run_sequential(const Task& task, Mesh& mesh)
{
  return run(mesh, Sequential_parameterizer<Mesh>(options_of(task)));
}

} // namespace hierarchical
