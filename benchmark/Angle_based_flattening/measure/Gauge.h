// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_GAUGE_H
#define ABF_BENCHMARK_GAUGE_H

#include "Measurement.h"

#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/peak_memory.h>

#include <malloc.h>

#include <algorithm>
#include <fstream>

namespace ABF_benchmark {

template <class Function>
double seconds_of(const Function& function)
{
  CGAL::Real_timer timer;
  timer.start();
  function();
  return timer.time();
}

// The time since the object was made, and the largest memory that this process used since then, beyond what it used
// then. Memory on Linux only.
class Gauge
{
public:
  Gauge()
  {
    malloc_trim(0);                                // what was freed before shall not be used again unseen
    std::ofstream("/proc/self/clear_refs") << "5"; // the peak is what is used now
    m_bytes_before = peak();
    m_timer.start();
  }

  double bytes() const { return (std::max)(0., peak() - m_bytes_before); }

  void add_to(Measurement& m) const
  {
    m.add("seconds", m_timer.time());
    m.add("bytes", bytes());
  }

private:
  static double peak()
  {
    return static_cast<double>(CGAL::Surface_mesh_parameterization::internal::ABF::peak_resident_size());
  }

  CGAL::Real_timer m_timer;
  double m_bytes_before;
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_GAUGE_H
