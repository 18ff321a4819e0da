// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Texture_atlas/internal/prepare/build_mesh_impl.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface_impl.h>
#include <CGAL/Texture_atlas/internal/prepare/soup_atlas_impl.h>
