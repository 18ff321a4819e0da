// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The largest memory that the process has had, as reports state it.
// `strategies/run_parameterizer.h` and `cones/cone_flattener.h` ask for it at the end of a run.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_PEAK_MEMORY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_PEAK_MEMORY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

#include <cstddef>
#include <cstdio>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The peak memory of this program in bytes, from Linux; 0 on other systems. Does not use a stream, which could throw
// after a successful run.
inline std::size_t peak_of_program()
{
  std::size_t kilobytes = 0;
#ifdef __linux__
  if(std::FILE* status = std::fopen("/proc/self/status", "r")) {
    char line[256];
    while(kilobytes == 0 && std::fgets(line, sizeof(line), status))
      std::sscanf(line, "VmHWM: %zu", &kilobytes);
    std::fclose(status);
  }
#endif
  return kilobytes * 1024;
}

// The largest resident size of the process so far, in bytes; 0 if the system does not tell.
inline std::size_t peak_resident_size()
{
  // getrusage() comes second: on Linux its count starts with the size of the parent process.
  if(const std::size_t peak = peak_of_program())
    return peak;
#if defined(__unix__) || defined(__APPLE__)
#ifdef __APPLE__
  const std::size_t unit = 1;
#else
  const std::size_t unit = 1024;
#endif
  rusage usage;
  if(getrusage(RUSAGE_SELF, &usage) == 0)
    return static_cast<std::size_t>(usage.ru_maxrss) * unit;
#endif
  return 0;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_PEAK_MEMORY_H
