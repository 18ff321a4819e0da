// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_PARAMETERIZER_METHOD_H
#define ABF_BENCHMARK_PARAMETERIZER_METHOD_H

#include "finish.h"

#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/coarse_solver.h>

#include <exception>
#include <iostream>
#include <streambuf>
#include <string>
#include <vector>

namespace ABF_benchmark {

// Keeps what some parameterizers print out of our tables.
class Silence
{
public:
  Silence() : m_buffer(std::cout.rdbuf(nullptr)) {}
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence()
  {
    std::cout.rdbuf(m_buffer); // clears the error state, too
  }

private:
  std::streambuf* m_buffer;
};

// Any parameterizer on `Surface_mesh`, as it is by default.
template <typename Parameterizer>
struct Parameterizer_method
{
  bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    Parameterizer parameterizer;
    uv.clear();
    try {
      const Silence silence;
      if(!abf::Coarse_solver<Parameterizer>(parameterizer)(chart, uv))
        return fail(report, "the parameterizer returned an error");
    } catch(const std::exception& error) {
      return fail(report, std::string("the parameterizer threw an exception: ") + error.what());
    }
    return finish(chart, uv, report);
  }
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_PARAMETERIZER_METHOD_H
