// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_RANKS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_RANKS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Ranks by integers of the caller's, which need not be consecutive: those in [0, limit) are in an array, all others in a hash table.
template <typename Index>
class Vertex_ranks
{
public:
  explicit Vertex_ranks(std::size_t limit) : m_limit(limit) {}

  // The rank of an index, -1 if it has not been set; valid until the next call
  int& operator[](const Index& index)
  {
    if(index < Index(0) || !(static_cast<std::size_t>(index) < m_limit))
      return m_others.emplace(index, -1).first->second;
    const std::size_t i = static_cast<std::size_t>(index);
    if(i >= m_ranks.size())
      m_ranks.resize((std::min)((std::max)(i + 1, 2 * m_ranks.size()), m_limit), -1);
    return m_ranks[i];
  }

private:
  std::size_t m_limit;
  std::vector<int> m_ranks;
  std::unordered_map<Index, int> m_others;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_RANKS_H
