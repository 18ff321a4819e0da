// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_MEASURE_H
#define COMPARE_MEASURE_H

#include "Command_line.h"

#include "../common/Measurement.h"

namespace compare {

using namespace benchmarks;

// Runs the method `command.run` on the mesh in `command.file`, in this process.
Measurement measure(const Command_line& command);

} // namespace compare

#endif // COMPARE_MEASURE_H
