// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of packing: `pack()`, `charts_too_large()` and `certify_packing()` on flat arrays, without a mesh.
// `pack_mesh.h` and `atlas/build_atlas_impl.h` include it. Without the compiled library it brings in `pack_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <vector>

namespace CGAL::Texture_atlas::internal {

// Turns, scales and moves charts so that they fill the unit square, as large as is possible with one scale, or, with
// `texels_per_unit`, as many pages as they need. `corners` are three points for each triangle, `chart` is the chart of
// each triangle, and `area` is its area: a chart is scaled to the sum of its areas. Where charts of one scale do not
// cover more than `least_share` of the page, there are too many: that is found out sooner than how much they cover.
CGAL_ANGLE_BASED_FLATTENING_INLINE Packing pack(const std::vector<Planar_point>& corners,
                                                const std::vector<int>& chart,
                                                const std::vector<double>& area, int number_of_charts,
                                                const Packing_options& options, double least_share = 0);

// The charts that are larger than a page with the given `texels_per_unit`; none if `pack()` finds something else wrong
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<int>
charts_too_large(const std::vector<Planar_point>& corners, const std::vector<int>& chart,
                 const std::vector<double>& area, int number_of_charts, const Packing_options& options);

// Whether each chart is on its page, and any two texels that different charts touch have a gutter between them, and the
// border of the page half of that, rounded up; likewise for blocks of texels. Rounding errors make triangles larger
// only, by less than 2^-20 texels: what is certified is true of the exact triangles.
CGAL_ANGLE_BASED_FLATTENING_INLINE Packing_check certify_packing(const std::vector<Planar_point>& corners,
                                                                 const std::vector<int>& chart,
                                                                 const std::vector<int>& page_of_chart,
                                                                 const Packing_options& options);

// Moves the vertices of packed charts to the grid of so many bits. `vertex` holds the vertex of each corner.
CGAL_ANGLE_BASED_FLATTENING_INLINE void quantize(const std::vector<int>& vertex, int bits,
                                                 std::vector<Chart::Point_2>& uv);

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/packing/pack_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_H
