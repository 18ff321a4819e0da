// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The direct method and the default solver. Each file here compiles beside the others.

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_surface_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/rectangle_corners_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_directly.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/pin_map.h>

template std::shared_ptr<const CGAL::Surface_mesh_parameterization::internal::ABF::Solver_source>
CGAL::Surface_mesh_parameterization::internal::ABF::solver_source(const CGAL::SuperLU_solver_traits<>&);
