// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SYMMETRY_REPORT_H
#define CGAL_TEXTURE_ATLAS_SYMMETRY_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <array>

/// \file Symmetry_report.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// The report of `find_mirror_plane()`.
struct Mirror_plane_report : Report
{
  using Report::Report;

  std::array<double, 3> normal = {
      1, 0, 0};      ///< The normal of the plane, of length 1. Its largest coordinate is positive.
  double offset = 0; ///< The plane consists of the points whose scalar product with the normal is this.

  /// The root mean square distance of the mirror image of the surface from the surface, in units of the diagonal of the
  /// bounding box.
  double deviation = 0;
};

/// \ingroup PkgTextureAtlasRef
///
/// The report of `symmetrize_seams()`.
struct Symmetry_report : Report
{
  using Report::Report;

  /// The mean distance of the mirror images of the seams from the seams, in units of the diagonal of the bounding box.
  double asymmetry = 0;
  double seam_length = 0; ///< The length of all seams, each counted once.
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_SYMMETRY_REPORT_H
