// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SKIPPED_PART_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SKIPPED_PART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace CGAL::Texture_atlas::internal::prepare {

// Faces of the input that have no chart, and why
struct Skipped_part
{
  std::size_t first_face = 0; // in the file, from 0
  std::size_t faces = 0;      // of the file
  std::string status;         // in one word
  std::string message;
  std::size_t model = 0; // among the inputs that share the atlas
};

// Whether a computation failed for this part, rather than that it cannot be flattened
inline bool is_failure_of_computation(const Skipped_part& part)
{
  static const std::array<const char*, 4> names = {"LINEAR_SYSTEM_FAILED", "NO_CONVERGENCE",
                                                   "FLIPPED_TRIANGLES", "OVERLAPPING"};
  return std::find(names.begin(), names.end(), part.status) != names.end();
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SKIPPED_PART_H
