// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <limits>

namespace CGAL {

namespace Surface_mesh_parameterization {

class Flattening_visitor;

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options that `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3` have in common.
struct Flattening_options
{
  /// What happens to the holes of a chart: all its borders but the given one.
  enum Holes
  {
    /// Holes take the shape with the least energy: four equations for each hole ensure that the surface closes around
    /// it. The borders of holes need not be simple. If this fails, holes are filled. A coarse parameterizer must accept
    /// charts with holes.
    SOLVE,

    /// Each hole is filled during the computation, by triangles with a tenth of the weight of the triangles around the
    /// hole. The filling changes the angles a little, but the chart is a disk, and has a valid map like any disk. If
    /// the angles converge and the outer border is simple, the borders of holes are simple too. A hole of up to 1000
    /// vertices is triangulated (`Polygon_mesh_processing::triangulate_hole_polyline()`), in at most 0.3 s. A larger
    /// hole, or a hole without a triangulation, gets a fan around a new vertex. A coarse parameterizer gets disks.
    FILL,
    REFUSE ///< The chart is refused with `ERROR_NO_TOPOLOGICAL_DISC`.
  };

  /// Weight \f$\kappa\f$ of the barrier that keeps angles away from zero; `0` is exactly the energy of the paper. The
  /// barrier and the energy have their minimum at the same place, so that ordinary charts hardly change. The weight has
  /// no unit and must not be negative. The hierarchical method uses it in the energy of
  /// `Hierarchical_options::angle_sweeps`.
  double barrier = 0.1;

  /// Number of threads that work at once, 0 for one on each processor. It has no effect unless the program is linked
  /// with `CGAL::TBB_support`. It never changes the result.
  int threads = 0;

  /// What happens to a chart with more than one border. Other charts ignore this option.
  Holes holes = SOLVE;

  /// Whether the map must be globally injective: no two triangles overlap. The result is then an injective map or an
  /// error. The hierarchical method starts from Tutte's map of a coarse chart, stays injective on each level, and does
  /// not call the coarse parameterizer. The direct method returns its own map if that does not overlap itself, and
  /// otherwise the polished injective map of the hierarchical method. Holes are filled during the computation (`FILL`),
  /// unless the direct method solves them and its map does not overlap itself. Programs without the compiled library
  /// must include `ABF_plus_plus_strategies.h`.
  bool injective = false;

  /// How much injective maps preserve areas, from 0 to 1: the exponent \f$\theta\f$ in the energy
  /// \f$\frac{1}{2}(\sigma_1/\sigma_2 + \sigma_2/\sigma_1) \left(\frac{1}{2}(d + 1/d)\right)^\theta\f$ of a triangle,
  /// where \f$\sigma_1\f$ and \f$\sigma_2\f$ are the singular values of its map, and \f$d = \sigma_1 \sigma_2\f$. At 1,
  /// this is a quarter of the symmetric Dirichlet energy: the map is as isometric as possible. At 0, only angles count;
  /// branches of the surface that are stuck between others then shrink. Up to 0.1, final sweeps lower the energy of the
  /// direct method. Polishing lowers this energy for any weight, and the direct method polishes.
  double area_weight = 0.005;

  /// The distance below which parts of the border of an injective map repel each other, in lengths of the shorter of
  /// the edges there; above 0 and at most 1.
  double clearance = 0.25;

  /// How much more than two pins (`ABF_plus_plus_parameterizer_3::set_pins()`) count against angles. If it is infinite,
  /// they are exactly at their positions. Otherwise, they are drawn there: with the weight 1, pins that are missed by a
  /// tenth of the width of the map cost as much as a change of all angles by about a tenth of a radian. The weight has
  /// no unit and must be positive.
  double pin_weight = (std::numeric_limits<double>::infinity)();

  /// If not null, this visitor follows the progress and may stop the computation. A coarse parameterizer and
  /// `Hierarchical_options::polish_options` have visitors of their own.
  Flattening_visitor* visitor = nullptr;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H
