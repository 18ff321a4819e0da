// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RUN_PROGRAM_H
#define FLATTEN_MESH_RUN_PROGRAM_H

#include "flatten_mesh/Exit_status.h"

namespace flatten_mesh {

// The whole program, which the Python module has, too. After a failure, the process must end with `std::_Exit()`: if
// memory ran out, threads of OpenBLAS wait for more forever, and a regular exit would wait for these threads.
Exit_status run_program(int argc, char* argv[]);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RUN_PROGRAM_H
