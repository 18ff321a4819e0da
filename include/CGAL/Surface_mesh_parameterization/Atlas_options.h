// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Packing_options.h>
#include <CGAL/Surface_mesh_parameterization/Seam_options.h>

/// \file Atlas_options.h

namespace CGAL {

namespace Surface_mesh_parameterization {

class Atlas_visitor;

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `make_atlas()`. `Seam_options::stretch_bound` is a bound on the stretch of each chart here.
struct Atlas_options : Seam_options, Packing_options
{
  /// How much injective maps keep areas (see `Flattening_options::area_weight`), from 0 to 1. The default is larger
  /// than that of a single chart, because an equal texel density over an atlas is worth a little more change of
  /// angles.
  double area_weight = 0.02;

  /// Whether a map of ABF++ that overlaps itself is cut into several charts, as by `split_overlaps()`, instead of
  /// replaced by an injective one.
  bool separate_overlaps = false;

  /// Whether branches of charts, such as the legs of a figure, are cut off along chords that are shorter than the
  /// square root of the area that they cut off. The charts then cover more of the square.
  bool cut_necks = false;

  /// Whether both sides of each edge on a seam within a chart get the same length in the plane, as by
  /// `ABF_plus_plus_options::equal_seam_lengths`. This applies to maps that ABF++ makes directly, and to pieces of
  /// them, but neither to hierarchical nor to injective maps. Where the solver does not reach equal lengths, the
  /// chart is mapped without them; `Atlas_report::Chart::seam_lengths` says so.
  bool equal_seam_lengths = true;

  /// Whether the charts are packed into the unit square. Otherwise, each chart has the area of its surface, and the
  /// lower left corner of its bounding box is at the origin.
  bool pack_into_square = true;

  int threads = 0; ///< As `Flattening_options::threads`.

  Atlas_visitor* visitor =
      nullptr; ///< If not null, this visitor follows the progress and may stop the computation.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_OPTIONS_H
