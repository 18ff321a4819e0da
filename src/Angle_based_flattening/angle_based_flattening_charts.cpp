// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Checking options, reading charts, certifying maps with points of doubles, and filling holes

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/one_to_one_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/holes/fill_holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option_impl.h>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

template std::vector<int> flipped_triangles(const std::vector<int>&, const std::vector<Exact_point_2>&);
template bool is_injective_at_vertices(const std::vector<int>&, const std::vector<Border_edge>&,
                                       const std::vector<Exact_point_2>&);
template bool bounds_region(const std::vector<Border_edge>&, const std::vector<Exact_point_2>&);
template std::vector<std::pair<int, int>> touching_edges(const std::vector<Border_edge>&,
                                                         const std::vector<Exact_point_2>&);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF
