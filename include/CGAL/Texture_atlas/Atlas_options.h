// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_ATLAS_OPTIONS_H
#define CGAL_TEXTURE_ATLAS_ATLAS_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <algorithm>
#include <limits>
#include <optional>

/// \file Atlas_options.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// Options of `select_seams()`.
struct Seam_options
{
  /// The largest predicted \f$L_2\f$ stretch of a disk; at least 1. With infinity, the surface is only cut to disks.
  double stretch_bound = 1.1;

  /// The largest number of terminals of each part: vertices that seams lead to because of their scale. At least 0. It
  /// needs a finite `stretch_bound`.
  int maximum_number_of_terminals = 100;

  /// The longest time that the computation may take, in seconds; see `Flattening_options::time_limit`.
  double time_limit = std::numeric_limits<double>::infinity();
};

/// \ingroup PkgTextureAtlasRef
///
/// Options of `pack_charts()`.
struct Packing_options
{
  int resolution = 1024; ///< Number of texels along the horizontal sides of a page, from 1 to 32768.

  /// Number of texels along the vertical sides of a page, from 1 to 32768; by default, the same as `resolution`.
  std::optional<int> height;

  /// Number of free texels between two charts, from 0 to 1024; by default, a 256th of the shorter side of a page, at
  /// least 1: 4 for 1024. Half as many, rounded up, are free at the border of a page. With \f$2^n\f$, no texel of the
  /// first \f$n\f$ reduced copies of a texture (mipmaps) belongs to two charts.
  std::optional<int> gutter;

  /// Number of texels along each side of a block, from 1 to 1024, for compressed textures: no block belongs to two
  /// charts. It divides both sides of a page.
  int block = 1;

  /// Number of texels per unit of length on the surface, for faces of weight 1. The charts then take as many pages as
  /// they need. With 0, there is one page, and the charts are as large as the search finds.
  double texels_per_unit = 0;

  int number_of_rotations = 32; ///< Number of directions that are tried for large charts, from 1 to 1024.

  /// If given, coordinates are moved to a grid of so many bits, from 8 to 16, as programs store them that quantize
  /// files. No triangle is turned over there, none loses its area, and charts stay apart, except at
  /// `Packing_report::faces_off_grid`. It needs one page, and a gutter that is at least two steps of the grid wide.
  /// Section \ref ABF_packing_grid says which grid this is.
  std::optional<int> quantization_bits;

  /// The number of texels along the vertical sides of a page: `height`, or its default.
  int number_of_rows() const { return height.value_or(resolution); }

  /// The number of free texels between two charts: `gutter`, or its default.
  int number_of_gutter_texels() const
  {
    return gutter.value_or((std::max)(1, (std::min)(resolution, number_of_rows()) / 256));
  }
};

class Atlas_visitor;

/// \ingroup PkgTextureAtlasRef
///
/// Options of `make_atlas()`, where `Seam_options::stretch_bound` bounds the stretch of each chart.
///
/// The constructor takes what the atlas is for, by default a texture, and sets options accordingly. Each option can be
/// changed afterwards. `make_atlas(mesh, uv, Atlas_options::FEW_CHARTS)` works; with named parameters, write
/// `Atlas_options(Atlas_options::FEW_CHARTS)`.
///
/// | option                | `TEXTURE` | `FEW_CHARTS` | `CONFORMAL` |
/// | :-------------------- | :-------- | :----------- | :---------- |
/// | `stretch_bound`       | 1.07      | 1.1          | 1.1         |
/// | `separate_overlaps`   | `true`    | `false`      | `true`      |
/// | `isometric_charts`    | `true`    | `false`      | `false`     |
/// | `area_weight`         | 1         | 0.02         | 0.02        |
/// | `equal_seam_lengths`  | `false`   | `true`       | `true`      |
/// | `seam_price`          | 0.04      | infinity     | 0.04        |
struct Atlas_options : Seam_options, Packing_options
{
  /// What an atlas is for.
  enum Purpose
  {
    TEXTURE, ///< Many and even texels: charts are as isometric as possible, and cut so that they cover the square.
    FEW_CHARTS, ///< As few charts and seams as possible: one chart for each component where that gives an even scale.
    CONFORMAL ///< The angles of ABF++ wherever it has a valid map; charts are split where it would overlap itself.
  };

  /// What becomes of coordinates that `uv` has already. Edges whose two sides have different ones are seams, and each
  /// connected part between them is a chart. Their page has the same ratio of its sides as that of the new coordinates.
  enum Given_charts
  {
    REPLACE, ///< They are ignored.
    KEEP, ///< Charts keep their shapes, and are packed anew. All have to be injective. The stretch bound is 2.
    REPAIR ///< The same, but charts that are flipped, overlap themselves or have no coordinates are flattened anew.
  };

  /// How charts are given. If they are not replaced, `uv` must be a model of `ReadWritePropertyMap`, charts are not cut
  /// by their price, and `seam_price` keeps the default for a purpose. With `KEEP`, so do `stretch_bound`, `area_weight`
  /// and `maximum_number_of_terminals`.
  Given_charts given_charts = REPLACE;

  /// How much injective maps preserve areas, from 0 to 1 (see `Flattening_options::area_weight`). The default is larger
  /// than for single charts, because an atlas should have even texels. With `isometric_charts`, it has no other value.
  double area_weight = 1;

  /// Whether a map of ABF++ that overlaps itself is split into several charts, as by `split_overlaps()`. Otherwise, an
  /// injective map replaces it.
  bool separate_overlaps = true;

  /// Whether all charts get injective maps that are as isometric as possible, in place of those of ABF++. Charts whose
  /// map is nearly isometric already keep it.
  bool isometric_charts = true;

  /// What a seam costs: at least 0. Charts are cut in two as long as they then cover more of the square: by a factor of
  /// \f$e^{pl}\f$, where \f$p\f$ is this price and \f$l\f$ the length of the new seams, in units of the square root of the
  /// area of all charts. With infinity, without `pack_into_square`, and if there are more than 256 charts, none is cut.
  double seam_price = 0.04;

  /// Whether both sides of each seam edge within a chart get equal lengths in the plane, as by
  /// `ABF_plus_plus_options::equal_seam_lengths`. Hierarchical and injective maps ignore this option. If the solver
  /// does not reach equal lengths, the chart is mapped without them (`Atlas_report::Chart::seam_lengths`).
  bool equal_seam_lengths = false;

  /// Whether the charts are packed into the unit square. Otherwise, each chart has the same area as on the surface, and
  /// the lower left corner of its bounding box is the origin, and options of packing keep their defaults.
  bool pack_into_square = true;

  /// Whether coordinates are rounded to numbers of type `float` before they are certified, whatever the number type of
  /// `uv`, as for files that hold `float`. With `pack_into_square`, 1 - v is also such a number for each coordinate v:
  /// in glTF, v goes down. Vertices of triangles that rounding would turn over move on to such numbers nearby.
  bool float_coordinates = false;

  int threads = 0; ///< See `Flattening_options::threads`.

  /// If not null, this visitor follows the progress and may cancel the computation.
  Atlas_visitor* visitor = nullptr;

  /// sets the options for a purpose.
  Atlas_options(Purpose purpose = TEXTURE) // implicit: `make_atlas()` takes the name of a purpose
  {
    if(purpose == TEXTURE) {
      stretch_bound = 1.07;
      return;
    }
    area_weight = 0.02;
    isometric_charts = false;
    equal_seam_lengths = true;
    if(purpose == FEW_CHARTS) {
      separate_overlaps = false;
      seam_price = std::numeric_limits<double>::infinity();
    }
  }
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_ATLAS_OPTIONS_H
