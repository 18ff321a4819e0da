// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/Soup_options.h>
#include <CGAL/Texture_atlas/Soup_report.h>
#include <CGAL/Texture_atlas/Surface_soup.h>

#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Makes one atlas of soups. If `is_common`, messages name them.
CGAL_ANGLE_BASED_FLATTENING_INLINE Soup_report make_atlas_of_soups(
    const std::vector<const Surface_soup*>& soups, bool is_common, const Soup_options& options,
    const Linear_solvers& solvers, std::vector<Soup_atlas>& atlases);

} // namespace CGAL::Texture_atlas::internal::prepare

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/prepare/soup_atlas_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_ATLAS_H
