// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `Hierarchical_parameterizer_3`.
struct Hierarchical_options : Flattening_options
{
  /// Part of the vertices that is removed before the coarse chart is solved, in (0, 1). The paper uses 0.95.
  double simplification_rate = 0.95;

  /// Number of triangles of the coarse chart; if not 0, it is used instead of `simplification_rate`. At least about
  /// 200 triangles are left in any case.
  int coarse_triangles = 0;

  /// Coarsening makes no angles smaller than this or larger than \f$\pi\f$ less this, in radians; 2.5 degrees.
  double extreme_angle = 0.0436;

  /// Sweeps of relaxation on each level but the three largest ones, which have at most one; 0 for none, and at most 1000. More
  /// of them bring the distortion down and take more time.
  int sweeps = 3;

  /// Sweeps over the finest level, in the end, that lower the energy of the direct method vertex by vertex; at most 1000.
  /// They help where there are slivers.
  int angle_sweeps = 0;

  /// How often a coarse chart that cannot be solved is replaced by a finer one, before the refinement starts from one
  /// triangle without any solver.
  int max_retries = 3;

  /// Whether the refined map is the start of the direct solver, with the angles of the refined map: that brings the
  /// distortion down to that of the direct method.
  bool polish = false;

  /// Options of the direct solver that polishes. What solves its linear systems is named to the parameterizer.
  ABF_plus_plus_options polish_options;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_OPTIONS_H
