// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_STRATEGIES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/all_strategies.h>
#endif

/// \file ABF_plus_plus_strategies.h
///
/// \ingroup PkgAngleBasedFlatteningRef
///
/// If one file of a program includes this header, `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3`
/// have all strategies. Without this header, programs compile in less than half of the time, and
/// - `Flattening_options::injective` and `Flattening_options::FILL` are refused, with the diagnosis
///   `Diagnosis::WRONG_OPTION`;
/// - angles of `ABF_plus_plus_parameterizer_3::set_angle_sums()` are refused in the same way, unless the program
///   includes `polygon_angles.h`;
/// - the last strategies of `ABF_plus_plus_options::fallbacks`, progressive embeddings and filled holes, are not tried.
///   The message of a failure says so.
///
/// Programs that link with the compiled library have all strategies without this header. Programs that include
/// `make_atlas.h` have all but filled holes and prescribed angles.

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_STRATEGIES_H
