// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A flag that several threads may set at once, and that is copied with what contains it.
// `SuperLU_solver_traits.h` and `SuperLU_preconditioner.h` tell by it that memory ran out.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FLAG_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FLAG_H

#include <atomic>

namespace CGAL {
namespace internal {

class SuperLU_flag
{
public:
  SuperLU_flag() = default;
  SuperLU_flag(const SuperLU_flag& other) noexcept : m_value(other.get()) {}

  SuperLU_flag& operator=(const SuperLU_flag& other) noexcept
  {
    set(other.get());
    return *this;
  }

  bool get() const { return m_value; }
  void set(bool value) const { m_value = value; } // solving is a constant operation

private:
  mutable std::atomic<bool> m_value{false};
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FLAG_H
