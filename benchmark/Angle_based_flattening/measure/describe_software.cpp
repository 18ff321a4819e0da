// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <Eigen/SuperLUSupport> // must come before CGAL's traits
#include <slu_util.h>

#include "subcommands.h"

#include <CGAL/version.h>

#ifdef ABF_WITH_CHOLMOD
#include <cholmod.h>
#endif

#include <dlfcn.h>

#include <initializer_list>

namespace ABF_benchmark {

namespace {

std::string version(const std::initializer_list<int> parts)
{
  std::string text;
  for(const int part : parts)
    text += (text.empty() ? "" : ".") + std::to_string(part);
  return text;
}

// OpenBLAS tells of itself; others do not.
std::string blas()
{
  const auto get_config = reinterpret_cast<const char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_config"));
  return get_config != nullptr ? get_config() : "a BLAS that is not OpenBLAS";
}

} // namespace

void describe_software(Measurement& m)
{
#ifdef __clang__
  m.add("compiler", "Clang " __clang_version__);
#else
  m.add("compiler", "GCC " __VERSION__);
#endif
  m.add("CGAL", CGAL_VERSION_STR);
  m.add("SuperLU", version({SUPERLU_MAJOR_VERSION, SUPERLU_MINOR_VERSION, SUPERLU_PATCH_VERSION}));
  m.add("Eigen", version({EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION}));
#ifdef ABF_WITH_CHOLMOD
  m.add("CHOLMOD", version({CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION}));
#endif
  m.add("BLAS", blas());
}

} // namespace ABF_benchmark
