// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/wrong_option.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <string>

namespace CGAL::Texture_atlas {

struct Atlas_options;
struct Baking_options;
struct Packing_options;
struct Seam_options;
struct Soup_options;

namespace internal {

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Seam_options& options);
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Packing_options& options);
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Atlas_options& options);
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Soup_options& options);
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_option(const Baking_options& options);

// What is wrong with the grid that coordinates are moved to, or nothing
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_quantization(const Packing_options& options);

// What is wrong with a gutter that must leave room on its page, or nothing
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string wrong_gutter(const Packing_options& options);

} // namespace internal

} // namespace CGAL::Texture_atlas

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/options/wrong_option_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OPTIONS_WRONG_OPTION_H
