// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_OPTIONS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/internal/prepare/Seam_way.h>

#include <cstddef>
#include <optional>

namespace CGAL::Texture_atlas::internal::prepare {

// The options of `make_atlas()`, and what is done before
struct Soup_options : public Atlas_options
{
  Seam_choice seams;
  bool is_symmetric = false;            // seams are, if the surface is
  std::optional<std::size_t> component; // the only one of which charts are made, by falling number of faces

  using Atlas_options::Atlas_options;
};

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SOUP_OPTIONS_H
