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
  /// Weight \f$\kappa\f$ of the barrier that keeps angles away from zero; `0` is exactly the energy of the
  /// paper. The barrier has its minimum where the energy has, so that ordinary charts hardly change. It has no unit,
  /// and must not be negative. The hierarchical method has it in the energy of `Hierarchical_options::angle_sweeps`.
  double barrier = 0.1;

  /// Number of threads that work at once, 0 for one on each processor. It takes no effect unless the program is linked
  /// with `CGAL::TBB_support`, and none on the result.
  int threads = 0;

  /// Whether charts with more than one border are flattened. The angles leave the closing of a hole open, and
  /// the least squares layout spreads what is missing; the result is checked as always. Without this, such a
  /// chart is refused with `ERROR_NO_TOPOLOGICAL_DISC`. A coarse parameterizer has to accept them, too.
  bool allow_holes = false;

  /// Is told of the progress and may stop the computation, if not null. A coarse parameterizer and
  /// `Hierarchical_options::polish_options` have visitors of their own.
  Flattening_visitor* visitor = nullptr;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H
