// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_RESULTS_H
#define SOLVERS_RESULTS_H

#include "../common/Measurement.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace solvers {

using namespace benchmarks;

// Of the first factorization, with its ordering
inline double first_seconds(const Measurement& m)
{
  return m["order"] + m["factor"];
}

inline double total_seconds(const Measurement& m)
{
  return first_seconds(m) + m["solve"];
}

enum Matrix_kind
{
  PLANARITY_BLOCK,
  FULL_MATRIX
};

constexpr std::array<Matrix_kind, 2> matrix_kinds = {PLANARITY_BLOCK, FULL_MATRIX};

// All that was measured on one matrix.
struct Matrix_results
{
  int order = 0;
  std::map<std::string, std::vector<Measurement>> measurements; // of each solver

  Measurement of(const std::string& solver) const
  {
    const auto found = measurements.find(solver);
    return found == measurements.end() ? failed_measurement("not measured") : median(found->second);
  }

  // A solver that failed once is not tried again.
  bool has_failed(const std::string& solver) const
  {
    return measurements.count(solver) > 0 && !of(solver).succeeded();
  }
};

// All that was measured for one mesh.
struct Mesh_results
{
  std::size_t asked_triangles = 0, triangles = 0;
  std::array<Matrix_results, matrix_kinds.size()> matrices;
};

} // namespace solvers

#endif // SOLVERS_RESULTS_H
