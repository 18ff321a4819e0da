// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which option has a value that it cannot have, as a text for the report, or nothing. All functions with options ask
// before they read the mesh.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/inline.h>

#include <string>

namespace CGAL::Surface_mesh_parameterization {

struct ABF_plus_plus_options;
struct Hierarchical_options;

} // namespace CGAL::Surface_mesh_parameterization

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const ABF_plus_plus_options& options);
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Hierarchical_options& options);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_WRONG_OPTION_H
