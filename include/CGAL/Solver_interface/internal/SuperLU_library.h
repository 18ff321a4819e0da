// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// What has to be true before a function of SuperLU is called: one thread of OpenBLAS, and memory. `SuperLU_factors.h`
// calls the functions of either number type.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LIBRARY_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LIBRARY_H

#include <CGAL/Solver_interface/internal/SuperLU_headers.h>

#ifdef __linux__
#include <sys/resource.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <new>

namespace CGAL {
namespace internal {

// Functions that only OpenBLAS has. With another BLAS, their addresses are null; so they are in programs of
// position-dependent code that gold or lld has linked.
#ifdef __ELF__
extern "C" {
int openblas_get_num_threads() __attribute__((weak));
void openblas_set_num_threads(int) __attribute__((weak));
}
#define CGAL_SUPERLU_CAN_FIND_OPENBLAS
#endif

inline namespace CGAL_SUPERLU_TYPES {

// The functions of SuperLU that depend on the number type, and SuperLU's name of that type.
template <class FT>
struct SuperLU_functions;

template <>
struct SuperLU_functions<double>
{
  static constexpr superlu::Dtype_t number_type = superlu::SLU_D;
  static constexpr auto factor = &superlu::dgstrf;
  static constexpr auto solve = &superlu::dgstrs;
  static constexpr auto estimate_condition = &superlu::dgscon;
};

#ifdef CGAL_SUPERLU_HAS_SINGLE_PRECISION
template <>
struct SuperLU_functions<float>
{
  static constexpr superlu::Dtype_t number_type = superlu::SLU_S;
  static constexpr auto factor = &superlu::sgstrf;
  static constexpr auto solve = &superlu::sgstrs;
  static constexpr auto estimate_condition = &superlu::sgscon;
};
#endif

} // namespace CGAL_SUPERLU_TYPES

// While an object of this class lives, OpenBLAS computes on the calling thread only.
//
// The order of summation in OpenBLAS depends on the number of threads, so results would depend on the machine.
// Several threads are no faster on SuperLU's small blocks: they mostly wait for one another. The setting is global,
// so it is restored only when the last such object is destroyed. Other BLAS implementations are not changed.
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
    static int (*const get_threads)() = openblas_get_num_threads;
    static void (*const set_threads)(int) = openblas_set_num_threads;
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

// The number of bytes of the buffer that OpenBLAS allocates at its first use in a thread, and for which it would wait
// forever: they are asked for together with the `bytes` of a factorization. It is 0 for small factorizations where
// address space is not limited. There it is unlikely to fail, and would take longer than the factorization.
inline double SuperLU_blas_buffer(double bytes)
{
#ifdef __linux__
  const auto is_unlimited = [](auto resource) {
    rlimit limit;
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  };
  if(bytes < 1e7 && is_unlimited(RLIMIT_AS) && is_unlimited(RLIMIT_DATA))
    return 0;
#endif
  return 1.5e8;
}

// Memory that a call of SuperLU is going to allocate while this object lives. To find out whether it is available, it
// is allocated and freed, together with the memory for other calls that have not returned yet. Several threads may
// call SuperLU at the same time, and it is unknown how much they have already allocated.
class SuperLU_memory
{
public:
  explicit SuperLU_memory(double bytes) : m_bytes(std::ceil(bytes)) // sums of integers are exact
  {
    const std::lock_guard<std::mutex> lock(mutex());
    if(!can_allocate(promised() + m_bytes))
      throw std::bad_alloc();
    promised() += m_bytes;
  }

  ~SuperLU_memory()
  {
    const std::lock_guard<std::mutex> lock(mutex());
    promised() -= m_bytes;
  }

  SuperLU_memory(const SuperLU_memory&) = delete;
  SuperLU_memory& operator=(const SuperLU_memory&) = delete;

private:
  static bool can_allocate(double bytes)
  {
    if(bytes >= static_cast<double>((std::numeric_limits<std::ptrdiff_t>::max)()))
      return false;
    void* volatile memory =
        std::malloc(static_cast<std::size_t>(bytes)); // volatile: do not optimize this away
    std::free(memory);
    return memory != nullptr;
  }

  static std::mutex& mutex()
  {
    static std::mutex mutex;
    return mutex;
  }

  static double& promised()
  {
    static double bytes = 0; // for the calls that have not returned
    return bytes;
  }

  double m_bytes;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LIBRARY_H
