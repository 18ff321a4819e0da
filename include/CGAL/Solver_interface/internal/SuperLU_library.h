// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_MEMORY_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_MEMORY_H

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <mutex>

namespace CGAL {
namespace internal {

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

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_MEMORY_H
