// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of the seam search: `find_topological_seams()`, `find_seams()` and `shorten_seams()` on a chart,
// without a mesh. `apply_seams.h`, `overlaps/separate_overlaps.h` and `atlas/` include it. Their bodies are in
// `find_seams_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <vector>

namespace CGAL::Texture_atlas::internal {

struct Seams
{
  enum Status
  {
    DONE,
    NO_CUT,
    LINEAR_SYSTEM_FAILED
  };

  Status status = DONE;
  std::vector<char> is_seam; // of each corner: whether the edge that it faces is a seam
  std::vector<int> terminals;
  double predicted_stretch = 1;
};

// Finds seams that make a disk of a connected surface, and reach the terminals. `cost` is that of the edge that each
// corner faces, infinity where it must not be a seam.
CGAL_ANGLE_BASED_FLATTENING_INLINE Seams find_topological_seams(const Chart& surface,
                                                                const std::vector<double>& cost,
                                                                const std::vector<int>& terminals = {});

// Finds seams that make a disk of it that can be flattened with little stretch.
CGAL_ANGLE_BASED_FLATTENING_INLINE Seams find_seams(const Chart& surface, const std::vector<double>& cost,
                                                    const Seam_options& options,
                                                    const Linear_solvers& solvers);

// Shorter seams than `seams`, with the same ends inside the surface
CGAL_ANGLE_BASED_FLATTENING_INLINE Seams shorten_seams(const Chart& surface, const std::vector<double>& cost,
                                                       const std::vector<char>& seams);

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_H
