// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PEAK_MEMORY_H
#define FLATTEN_MESH_PEAK_MEMORY_H

#include <fstream>
#include <string>

namespace flatten_mesh {

// In megabytes, from Linux; 0 on other systems, and for processes that have ended. `name` is VmHWM, the peak, or VmRSS,
// what is held now; both without what is reserved but not used. (`getrusage()` also counts the program that started
// this one.)
inline double resident_memory_mb(const std::string& name, const std::string& process = "self")
{
  std::ifstream status("/proc/" + process + "/status");
  for(std::string word; status >> word;) {
    double kilobytes;
    if(word == name + ":" && status >> kilobytes) {
      return kilobytes / 1024;
    }
  }
  return 0;
}

inline double peak_memory_mb()
{
  return resident_memory_mb("VmHWM");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PEAK_MEMORY_H
