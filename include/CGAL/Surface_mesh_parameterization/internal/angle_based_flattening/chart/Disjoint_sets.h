// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Union and find over numbers. Boost's own class does not compile behind some headers that CGAL includes.
// Used where vertices or triangles are merged to classes: places of seams, components of surfaces, and their cuts.

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ABF_DISJOINT_SETS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ABF_DISJOINT_SETS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Disjoint sets of the numbers from 0 on, at first of one each. `boost::disjoint_sets_with_storage` keeps them in
// pointers, and does not compile if its header was included before those of Boost's property maps, as CGAL 6 does.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t size)
      : m_ranks(size, 0), m_parents(size), m_sets(Map(m_ranks.begin()), Map(m_parents.begin()))
  {
    std::iota(m_parents.begin(), m_parents.end(), std::size_t(0));
  }

  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  template <class Number>
  std::size_t find_set(const Number x)
  {
    return m_sets.find_set(static_cast<std::size_t>(x));
  }

  // Of two representatives
  void link(const std::size_t x, const std::size_t y) { m_sets.link(x, y); }

  template <class Number>
  void union_set(const Number x, const Number y)
  {
    m_sets.union_set(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
  }

private:
  using Map = boost::iterator_property_map<std::vector<std::size_t>::iterator,
                                           boost::typed_identity_property_map<std::size_t>>;

  std::vector<std::size_t> m_ranks, m_parents;
  boost::disjoint_sets<Map, Map> m_sets;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ABF_DISJOINT_SETS_H
