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
/// Where this header is included in one file of a program, `ABF_plus_plus_parameterizer_3` and
/// `Hierarchical_parameterizer_3` have all strategies. Without it, programs compile in less than half of the time, and
/// - `Flattening_options::injective` and `Flattening_options::FILL` are refused, with the diagnosis
///   `Diagnosis::WRONG_OPTION`;
/// - so are the angles of `ABF_plus_plus_parameterizer_3::set_angle_sums()`, unless `polygon_angles.h` is included;
/// - the last of `ABF_plus_plus_options::fallbacks`, which is a progressive embedding, or filled holes, is not tried,
///   and the message of a failure says so.
///
/// Programs that link with the compiled library have all strategies, and need not include it. Neither do those that
/// include `make_atlas.h`.

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_STRATEGIES_H
