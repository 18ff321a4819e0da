// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_DESCRIBE_MACHINE_H
#define BENCHMARKS_COMMON_DESCRIBE_MACHINE_H

#include <Eigen/SuperLUSupport> // must come before CGAL's traits
#include <slu_util.h>

#include "format.h"

#include <CGAL/version.h>

#include <Eigen/Core>
#ifdef ABF_WITH_CHOLMOD
#include <cholmod.h>
#endif

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <initializer_list>
#include <string>
#include <thread>

namespace benchmarks {

namespace internal {

// What follows the colon in the first line of the file that begins with `key`
inline std::string value_in_file(const char* file, const std::string& key)
{
  std::ifstream stream(file);
  for(std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(':');
    if(line.compare(0, key.size(), key) == 0 && colon != std::string::npos) {
      return line.substr((std::min)(line.size(), line.find_first_not_of(" \t", colon + 1)));
    }
  }
  return "unknown";
}

inline std::string version(const std::initializer_list<int> parts)
{
  std::string text;
  for(const int part : parts) {
    text += (text.empty() ? "" : ".") + std::to_string(part);
  }
  return text;
}

inline std::string compiler()
{
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "another compiler";
#endif
}

// OpenBLAS tells of itself; others do not.
inline std::string blas()
{
  const auto get_config = reinterpret_cast<const char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_config"));
  return get_config != nullptr ? get_config() : "a BLAS that is not OpenBLAS";
}

} // namespace internal

// One sentence about the hardware and one about the software.
inline std::string describe_machine()
{
  const double kilobytes = std::stod("0" + internal::value_in_file("/proc/meminfo", "MemTotal"));
  std::string text = "Machine: " + internal::value_in_file("/proc/cpuinfo", "model name") + ", " +
                     std::to_string(std::thread::hardware_concurrency()) + " cores, " +
                     format_number("%.0f GB of memory. ", kilobytes / (1 << 20));
  text += "Software: " + internal::compiler() + ", CGAL " CGAL_VERSION_STR ", SuperLU " +
          internal::version({SUPERLU_MAJOR_VERSION, SUPERLU_MINOR_VERSION, SUPERLU_PATCH_VERSION}) +
          ", Eigen " + internal::version({EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION});
#ifdef ABF_WITH_CHOLMOD
  text +=
      ", CHOLMOD " + internal::version({CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION});
#endif
  return text + ", " + internal::blas() + ".";
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_DESCRIBE_MACHINE_H
