// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PROCESS_MEMORY_H
#define FLATTEN_MESH_PROCESS_MEMORY_H

#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

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

// Charts take arrays of the same sizes many times. What glibc returns to the system in between, the system clears
// before it gives it again.
inline void keep_freed_memory()
{
#ifdef __GLIBC__
  const int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * megabyte); // its largest value
  mallopt(M_TRIM_THRESHOLD, 256 * megabyte);
#endif
}

// After much was freed that nothing else will take
inline void return_freed_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PROCESS_MEMORY_H
