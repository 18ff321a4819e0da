// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <algorithm>
#include <optional>

/// \file Atlas_options.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Options of `select_seams()`.
struct Seam_options
{
  /// The largest predicted \f$L_2\f$ stretch of a disk; at least 1. With infinity, the surface is only cut to disks.
  double stretch_bound = 1.1;

  /// The largest number of terminals of each part: vertices that seams lead to because of their scale. At least 0.
  int maximum_number_of_terminals = 100;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Options of `pack_charts()`.
struct Packing_options
{
  int resolution = 1024; ///< Number of texels along each side of the unit square, from 1 to 32768.

  /// Number of free texels between two charts, from 0 to 1024; by default, a 256th of the resolution, at least 1: 4 for
  /// 1024. Half as many, rounded up, are free at the border of the square. With \f$2^n\f$, no texel of the first
  /// \f$n\f$ reduced copies of a texture (mipmaps) belongs to two charts.
  std::optional<int> gutter;

  int number_of_rotations = 32; ///< Number of directions that are tried for large charts, from 1 to 1024.

  /// The number of free texels between two charts: `gutter`, or its default.
  int number_of_gutter_texels() const { return gutter.value_or((std::max)(1, resolution / 256)); }
};

class Atlas_visitor;

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Options of `make_atlas()`, where `Seam_options::stretch_bound` bounds the stretch of each chart.
struct Atlas_options : Seam_options, Packing_options
{
  /// How much injective maps preserve areas, from 0 to 1 (see `Flattening_options::area_weight`). The default is larger
  /// than for single charts, because an atlas should have even texels.
  double area_weight = 0.02;

  /// Whether a map of ABF++ that overlaps itself is split into several charts, as by `split_overlaps()`. Otherwise, an
  /// injective map replaces it.
  bool separate_overlaps = false;

  /// Whether branches of charts, such as legs of a figure, are cut off along chords that are shorter than the square
  /// root of the area behind them. The charts then cover more of the square.
  bool cut_necks = false;

  /// Whether both sides of each seam edge within a chart get equal lengths in the plane, as by
  /// `ABF_plus_plus_options::equal_seam_lengths`. Hierarchical and injective maps ignore this option. If the solver
  /// does not reach equal lengths, the chart is mapped without them (`Atlas_report::Chart::seam_lengths`).
  bool equal_seam_lengths = true;

  /// Whether the charts are packed into the unit square. Otherwise, each chart has the same area as on the surface, and
  /// the lower left corner of its bounding box is the origin.
  bool pack_into_square = true;

  int threads = 0; ///< See `Flattening_options::threads`.

  /// If not null, this visitor follows the progress and may cancel the computation.
  Atlas_visitor* visitor = nullptr;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_OPTIONS_H
