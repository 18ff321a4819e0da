// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Objects that keep their memory from one use to the next. `SuperLU_factorization.h` keeps the arrays of factors in
// them, and solvers the matrices and vectors that they convert.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SPARE_OBJECTS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SPARE_OBJECTS_H

#include <list>
#include <mutex>

namespace CGAL {
namespace internal {

// Whoever needs an object takes the one that was used last, or a new one if all are in use. So there are no more
// objects than were in use at the same time. Several threads may do so at once.
template <class T>
class Spare_objects
{
public:
  Spare_objects() = default;
  Spare_objects(const Spare_objects&) = delete;
  Spare_objects& operator=(const Spare_objects&) = delete;

  // An object in use, which is spare again at the end of the loan
  class Loan
  {
  public:
    explicit Loan(Spare_objects& owner) : m_owner(owner)
    {
      {
        const std::lock_guard<std::mutex> lock(m_owner.m_mutex);
        if(!m_owner.m_objects.empty())
          m_object.splice(m_object.begin(), m_owner.m_objects, m_owner.m_objects.begin());
      }
      if(m_object.empty())
        m_object.emplace_back();
    }

    ~Loan()
    {
      const std::lock_guard<std::mutex> lock(m_owner.m_mutex);
      m_owner.m_objects.splice(m_owner.m_objects.begin(), m_object);
    }

    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    T& operator*() const { return m_object.front(); }
    T* operator->() const { return &m_object.front(); }

  private:
    Spare_objects& m_owner;
    mutable std::list<T> m_object;
  };

  // Frees those that are not in use.
  void clear()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_objects.clear();
  }

private:
  std::mutex m_mutex;
  std::list<T> m_objects;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SPARE_OBJECTS_H
