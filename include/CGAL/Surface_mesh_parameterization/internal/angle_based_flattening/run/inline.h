// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_INLINE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_INLINE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

// Functions without templates are in the compiled library if there is one, and inline otherwise.
#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#define CGAL_ANGLE_BASED_FLATTENING_INLINE
#else
#define CGAL_ANGLE_BASED_FLATTENING_INLINE inline
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_INLINE_H
