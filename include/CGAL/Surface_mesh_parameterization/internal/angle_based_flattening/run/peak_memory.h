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

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The largest resident size of the process so far, in bytes; 0 if the system does not tell. On Linux, the count starts
// with the size of the parent process.
inline std::size_t peak_resident_size()
{
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
