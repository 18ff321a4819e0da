// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SWEEP_FLATTEN_FILE_H
#define SWEEP_FLATTEN_FILE_H

#include <string>

namespace sweep {

// Flattens the components with a border of the mesh in a file, and tells of each run on standard output. Components
// with several borders are flattened twice, the second time with holes allowed. The runs before number `first_run`
// are left out.
void flatten_file(const std::string& file, const std::string& method, int first_run);

} // namespace sweep

#endif // SWEEP_FLATTEN_FILE_H
