// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_MEASURE_IN_CHILD_H
#define BENCHMARKS_COMMON_MEASURE_IN_CHILD_H

#include "Measurement.h"
#include "format.h"
#include "run_child.h"

#include <string>
#include <vector>

namespace benchmarks {

// Runs this program once more with arguments by which it measures something and prints that.
inline Measurement measure_in_child(const std::vector<std::string>& arguments, const Child_limits& limits)
{
  const Child_result child = run_child(arguments, limits);
  const std::string failure = child.failure(limits);
  return failure.empty() ? measurement_from_text(child.output) : failed_measurement(failure);
}

// Its seconds, or why there are none
inline std::string outcome_text(const Measurement& measurement, const double seconds)
{
  return measurement.succeeded() ? format_seconds(seconds) + " s" : measurement.failure;
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_MEASURE_IN_CHILD_H
