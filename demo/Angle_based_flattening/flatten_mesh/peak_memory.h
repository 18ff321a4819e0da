// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The largest memory that the program has had, as both commands report it.

#ifndef FLATTEN_MESH_PEAK_MEMORY_H
#define FLATTEN_MESH_PEAK_MEMORY_H

#include <fstream>
#include <string>

namespace flatten_mesh {

// In megabytes, from Linux; 0 on other systems. (`getrusage()` also counts the program that started this one.)
inline double peak_memory_mb()
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;) {
    double kilobytes;
    if(word == "VmHWM:" && status >> kilobytes) {
      return kilobytes / 1024;
    }
  }
  return 0;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PEAK_MEMORY_H
