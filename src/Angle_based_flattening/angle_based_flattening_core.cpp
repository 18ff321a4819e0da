// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/ladder.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/flatten_chart_hierarchically.h>

template std::shared_ptr<const CGAL::Surface_mesh_parameterization::internal::Solver_source>
CGAL::Surface_mesh_parameterization::internal::solver_source(const CGAL::SuperLU_solver_traits<>&);
