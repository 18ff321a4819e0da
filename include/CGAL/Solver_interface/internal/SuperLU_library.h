// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LIBRARY_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LIBRARY_H

#include <CGAL/Solver_interface/internal/SuperLU_headers.h>

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#define CGAL_SUPERLU_CAN_FIND_OPENBLAS
#endif

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <mutex>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// The functions of SuperLU that differ by the number type, and what it calls that type.
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

// Memory that a call of SuperLU is going to allocate. Whether it is there is found out by allocating and freeing it,
// together with what other calls that have not returned yet were promised: several threads may call SuperLU at a time, and
// how much of their memory they have allocated already is not known.
class SuperLU_memory
{
public:
  explicit SuperLU_memory(double bytes) : m_bytes(std::ceil(bytes)) // sums of integers are exact
  {
    const std::lock_guard<std::mutex> lock(mutex());
    m_is_there = can_allocate(promised() + m_bytes);
    if(m_is_there)
      promised() += m_bytes;
  }

  ~SuperLU_memory()
  {
    const std::lock_guard<std::mutex> lock(mutex());
    if(m_is_there)
      promised() -= m_bytes;
  }

  SuperLU_memory(const SuperLU_memory&) = delete;
  SuperLU_memory& operator=(const SuperLU_memory&) = delete;

  bool is_there() const { return m_is_there; }

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
    static double bytes = 0; // of the calls that have not returned
    return bytes;
  }

  double m_bytes;
  bool m_is_there;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LIBRARY_H
