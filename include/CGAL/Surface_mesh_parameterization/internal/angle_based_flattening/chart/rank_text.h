// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Elements of a mesh as messages name them: by their numbers.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_RANK_TEXT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_RANK_TEXT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The position of an element in a range of the mesh
template <typename Range, typename Descriptor>
std::string rank_text(const Range& range, const Descriptor& descriptor)
{
  return std::to_string(std::distance(range.begin(), std::find(range.begin(), range.end(), descriptor)));
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_RANK_TEXT_H
