// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

class Flattening_visitor;

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options that `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3` have in common.
struct Flattening_options
{
  /// What is done with the holes of a chart: with all its borders but the given one.
  enum Holes
  {
    SOLVE, ///< They take the shape with the least energy: four equations for each hole ensure that the surface closes
    ///< around it. Their borders need not be simple. If this fails, they are filled. A coarse parameterizer must accept
    ///< charts with holes too.

    /// Each hole is filled during the flattening, by triangles of a tenth of the weight of those around it. The angles
    /// bend to the filling a little, but the holes close, and like any disk the chart has a valid map. If the angles
    /// converge and the outer border comes out simple, so do those of the holes. A hole of up to 1000 vertices is
    /// triangulated (`Polygon_mesh_processing::triangulate_hole_polyline()`), in 0.3 s at most. A larger one, or one
    /// without a triangulation, gets a fan around a new vertex. A coarse parameterizer gets disks.
    FILL,
    REFUSE ///< The chart is refused with `ERROR_NO_TOPOLOGICAL_DISC`.
  };

  /// Weight \f$\kappa\f$ of the barrier that keeps angles away from zero; `0` is exactly the energy of the
  /// paper. The barrier and the energy have their minimum at the same place, so ordinary charts hardly change. The
  /// weight has no unit and must not be negative. The hierarchical method uses it in the energy of
  /// `Hierarchical_options::angle_sweeps`.
  double barrier = 0.1;

  /// Number of threads that work at once, 0 for one on each processor. It has no effect unless the program is linked
  /// with `CGAL::TBB_support`. It never changes the result.
  int threads = 0;

  /// What is done with a chart that has more than one border. Other charts are flattened in the same way whatever
  /// this is. The result is checked as always.
  Holes holes = SOLVE;

  /// Whether the map must be globally injective: no two triangles overlap, wherever they are on the surface. Then the
  /// result is an injective map or an error. The hierarchical method starts from Tutte's map of a coarse chart, stays
  /// injective on each level, and does not call the coarse parameterizer. The direct method gives its own map if that
  /// does not overlap itself, and otherwise the injective map of the hierarchical method, polished. Holes are filled
  /// meanwhile (`FILL`), unless they are solved by the direct method and its map does not overlap. Programs without the
  /// compiled library include `ABF_plus_plus_strategies.h` for it.
  bool injective = false;

  /// How much injective maps keep areas, from 0 to 1: the exponent \f$\theta\f$ in the energy
  /// \f$\frac{1}{2}(\sigma_1/\sigma_2 + \sigma_2/\sigma_1) \left(\frac{1}{2}(d + 1/d)\right)^\theta\f$ of a triangle,
  /// where \f$\sigma_1\f$ and \f$\sigma_2\f$ are the singular values of its map, and \f$d = \sigma_1 \sigma_2\f$. At 1,
  /// that is a quarter of the symmetric Dirichlet energy: the map is as isometric as possible. At 0 only angles count;
  /// then branches of the surface that get stuck between others shrink. Up to 0.1, final sweeps lower the energy of the
  /// direct method. Polishing lowers it whatever the weight is, and the direct method polishes.
  double area_weight = 0.005;

  /// Parts of the border of an injective map that come nearer to one another than this many edge lengths repel each
  /// other; above 0 and at most 1. The length is that of the shorter of the edges there.
  double clearance = 0.25;

  /// If not null, this visitor follows the progress and may stop the computation. A coarse parameterizer and
  /// `Hierarchical_options::polish_options` have visitors of their own.
  Flattening_visitor* visitor = nullptr;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H
