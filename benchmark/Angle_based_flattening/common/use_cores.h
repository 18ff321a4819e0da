// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_USE_CORES_H
#define BENCHMARKS_COMMON_USE_CORES_H

#include <sched.h>

#include <stdexcept>
#include <string>

namespace benchmarks {

// Confines this process to so many of its cores, so that it has no more threads at work than that, whoever starts
// them. Call it before there are others. Linux only.
inline void use_cores(const int number)
{
  cpu_set_t available, chosen;
  CPU_ZERO(&chosen);
  if(sched_getaffinity(0, sizeof(available), &available) != 0) {
    throw std::runtime_error("cannot tell the cores of this process");
  }
  // From behind: the first core has other things to do as well.
  for(int core = CPU_SETSIZE - 1; core >= 0 && CPU_COUNT(&chosen) < number; --core) {
    if(CPU_ISSET(core, &available)) {
      CPU_SET(core, &chosen);
    }
  }
  if(CPU_COUNT(&chosen) < number || sched_setaffinity(0, sizeof(chosen), &chosen) != 0) {
    throw std::runtime_error("cannot use " + std::to_string(number) + " cores");
  }
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_USE_CORES_H
