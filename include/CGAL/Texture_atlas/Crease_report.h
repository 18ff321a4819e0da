// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_CREASE_REPORT_H
#define CGAL_TEXTURE_ATLAS_CREASE_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/number_type_config.h>

#include <cstddef>

/// \file Crease_report.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// Options of `select_crease_seams()`.
struct Crease_options
{
  /// A crease is an edge whose two faces differ by more than this angle, in radians: above 0, and below \f$\pi\f$.
  double angle = 40 * CGAL_PI / 180;
};

/// \ingroup PkgTextureAtlasRef
///
/// The report of `select_crease_seams()`.
struct Crease_report : Report
{
  using Report::Report;

  std::size_t number_of_patches = 0; ///< The number of patches between creases, given seams and borders.
  std::size_t number_of_parts = 0;   ///< The number of parts between all seams, after patches were joined.

  /// The share of the area that belongs to flat patches of at least two triangles, on surfaces with creases.
  double flat_share = 0;

  /// Whether each component has at most 16 patches, and none is bent in two directions: the angles at inner vertices
  /// of a patch sum to \f$2\pi\f$. With seams along creases, the parts then have maps without stretch.
  bool is_developable = true;

  double seam_length = 0;          ///< The length of all seams, each counted once.
  double relative_seam_length = 0; ///< `seam_length`, divided by the square root of the area.

  /// Whether at least a tenth of the area is flat, between creases: so are machine parts, and hardly any scans.
  bool is_hard_surface() const { return flat_share >= 0.1; }
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_CREASE_REPORT_H
