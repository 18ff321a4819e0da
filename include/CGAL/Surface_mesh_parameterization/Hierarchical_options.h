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
  /// Fraction of the vertices that is removed before the coarse chart is flattened, in (0, 1). The paper uses 0.95.
  /// Injective maps ignore this option and `coarse_triangles`: they start from about 300 vertices, or 1000 if
  /// `area_weight` is above 0.1.
  double simplification_rate = 0.95;

  /// Number of triangles of the coarse chart. If not 0, it replaces `simplification_rate`. At least about 200
  /// triangles always remain.
  int coarse_triangles = 0;

  /// Coarsening makes no angle smaller than this angle, or larger than \f$\pi\f$ minus this angle, in radians. The
  /// default is 2.5 degrees.
  double extreme_angle = 0.0436;

  /// Sweeps of relaxation on each level; 0 for none, and at most 1000. The three largest levels have at most one
  /// sweep. More sweeps lower the distortion and take more time.
  int sweeps = 3;

  /// Largest number of final sweeps over the finest level that lower the energy of the direct method, vertex by vertex;
  /// at most 1000. They help if the surface is noisy or has slivers. For injective maps, 0 means five sweeps, three if
  /// there are more than 100,000 vertices, and none if `area_weight` is above 0.1.
  int angle_sweeps = 0;

  /// The final sweeps end when a sweep lowers the energy by less than this fraction; below 1. With 0, all sweeps are
  /// done.
  double energy_tolerance = 0;

  /// How often a coarse chart that cannot be flattened is replaced by a finer one. Refinement then starts from one
  /// triangle, without a solver.
  int max_retries = 3;

  /// Whether the direct solver starts from the angles of the refined map. This lowers the distortion to that of the
  /// direct method. For injective maps, Newton's method lowers the same energy by moving the vertices, so that the map
  /// stays injective. It uses the same solver traits, and ignores `polish_options`.
  bool polish = false;

  /// Options of the direct solver that polishes. The solver of its linear systems is a template parameter of the
  /// parameterizer.
  ABF_plus_plus_options polish_options;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_OPTIONS_H
