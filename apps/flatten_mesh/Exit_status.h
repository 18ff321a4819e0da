// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_EXIT_STATUS_H
#define FLATTEN_MESH_EXIT_STATUS_H

namespace flatten_mesh {

enum Exit_status
{
  SUCCESS = 0,
  COMPUTATION_FAILED = 1,
  WRONG_INPUT = 2,
  TIMED_OUT = 3,
  OUT_OF_MEMORY = 4,
  RUN_CRASHED = 5
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_EXIT_STATUS_H
