// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MEMORY_BOUND_H
#define FLATTEN_MESH_MEMORY_BOUND_H

#include <algorithm>
#include <cstddef>

#include <sys/resource.h>

namespace flatten_mesh {

// Bounds the address space of the process while it lives. What is told afterwards is not bound.
class Memory_bound
{
public:
  // 0: no bound
  explicit Memory_bound(const std::size_t bytes)
      : m_is_set(bytes > 0 && ::getrlimit(RLIMIT_AS, &m_before) == 0)
  {
    if(m_is_set) {
      rlimit limit = m_before;
      limit.rlim_cur = (std::min)(static_cast<rlim_t>(bytes), limit.rlim_cur);
      ::setrlimit(RLIMIT_AS, &limit);
    }
  }

  ~Memory_bound()
  {
    if(m_is_set) {
      ::setrlimit(RLIMIT_AS, &m_before);
    }
  }

  Memory_bound(const Memory_bound&) = delete;
  Memory_bound& operator=(const Memory_bound&) = delete;

private:
  rlimit m_before = {};
  bool m_is_set;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MEMORY_BOUND_H
