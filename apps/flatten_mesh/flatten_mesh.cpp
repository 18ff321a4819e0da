// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a texture atlas of the surface in a file: `flatten_mesh scan.ply --output atlas.obj --picture atlas.png`. See
// `--help`.

#include "flatten_mesh/run_program.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  const flatten_mesh::Exit_status status = flatten_mesh::run_program(argc, argv);
  if(status != flatten_mesh::SUCCESS) { // memory may have run out for one of several inputs
    std::_Exit(status);
  }
  return status;
}
