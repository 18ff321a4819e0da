// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_PEAK_MEMORY_H
#define BENCHMARKS_COMMON_PEAK_MEMORY_H

#include <algorithm>
#include <fstream>
#include <string>

namespace benchmarks {

// The largest memory that this process used since the object was made, beyond what it used then. Linux only.
class Peak_memory
{
public:
  Peak_memory()
  {
    std::ofstream("/proc/self/clear_refs") << "5"; // forget what was the peak until now
    m_before = bytes("VmRSS:");
  }

  double bytes() const { return (std::max)(0., bytes("VmHWM:") - m_before); }

private:
  static double bytes(const std::string& name)
  {
    std::ifstream status("/proc/self/status");
    for(std::string word; status >> word;) {
      double kilobytes = 0;
      if(word == name && status >> kilobytes) {
        return 1024 * kilobytes;
      }
    }
    return 0;
  }

  double m_before;
};

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_PEAK_MEMORY_H
