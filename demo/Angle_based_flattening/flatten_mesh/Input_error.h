// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_INPUT_ERROR_H
#define FLATTEN_MESH_INPUT_ERROR_H

#include <stdexcept>

namespace flatten_mesh {

// Something that the user has to put right: the command line, or a file. The text is one line that names
// what is wrong and what to do. The program ends with status 2.
struct Input_error : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_INPUT_ERROR_H
