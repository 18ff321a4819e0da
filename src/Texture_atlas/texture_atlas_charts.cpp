// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Texture_atlas/internal/atlas/build_atlas_impl.h>
#include <CGAL/Texture_atlas/internal/cones/choose_cones_impl.h>
