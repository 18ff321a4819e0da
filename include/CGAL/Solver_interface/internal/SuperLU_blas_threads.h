// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_BLAS_THREADS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_BLAS_THREADS_H

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#define CGAL_SUPERLU_CAN_FIND_OPENBLAS
#endif

#include <mutex>

namespace CGAL {
namespace internal {

// While an object of this class lives, OpenBLAS computes on the calling thread only.
//
// OpenBLAS sums in another order on another number of threads, so that results would depend on the machine. Its
// threads do not pay for SuperLU's small blocks either: they spend their time waiting for one another. The number of
// threads is one for the whole program, so that it is restored only when the last such object is gone. Other
// implementations of the BLAS are left alone.
class SuperLU_one_blas_thread
{
public:
  SuperLU_one_blas_thread() { enter(1); }
  ~SuperLU_one_blas_thread() { enter(-1); }
  SuperLU_one_blas_thread(const SuperLU_one_blas_thread&) = delete;
  SuperLU_one_blas_thread& operator=(const SuperLU_one_blas_thread&) = delete;

private:
  static void enter(int change)
  {
#ifdef CGAL_SUPERLU_CAN_FIND_OPENBLAS
    static const auto get_threads =
        reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
    static const auto set_threads =
        reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
    static std::mutex mutex;
    static int users = 0, threads = 1;

    if(get_threads == nullptr || set_threads == nullptr)
      return;
    const std::lock_guard<std::mutex> lock(mutex);
    if(users == 0)
      threads = get_threads();
    users += change;
    set_threads(users > 0 ? 1 : threads);
#else
    (void)change;
#endif
  }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_BLAS_THREADS_H
