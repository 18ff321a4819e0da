// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>

#include <optional>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `ABF_plus_plus_parameterizer_3`. The default values suit every mesh we know of; none
/// depends on the scale or the resolution of the mesh.
struct ABF_plus_plus_options : Flattening_options
{
  /// How the second derivatives of the constraints enter a step of the angle solver.
  enum Step_type
  {
    NEWTON, ///< They are kept. The Hessian stays diagonal, and convergence is quadratic.
    SEQUENTIAL_LINEARLY_CONSTRAINED ///< They are dropped, as in Section 3.1 of \cgalCite{cgal:slmb-abf-05}.
  };

  /// How the linear system of a step (Equation 16 of \cgalCite{cgal:slmb-abf-05}) is solved.
  enum Linear_solver
  {
    /// By conjugate gradients, to the accuracy that the next step needs. The factors of two scalar matrices, each a
    /// quarter of the system, precondition several steps. The counterpart of lower precision of the solver traits
    /// (`Low_precision_solver_traits`) computes them if that suffices. If conjugate gradients are slow, the system is
    /// factored. Traits without factorization solve each system as a whole.
    ITERATIVE,
    DIRECT ///< As a whole, as in the paper.
  };

  /// How planar coordinates are computed from planar angles.
  enum Layout_type
  {
    AUTOMATIC_LAYOUT,    ///< `EXACT_LAYOUT` if the angles fit together, otherwise `LEAST_SQUARES_LAYOUT`.
    EXACT_LAYOUT,        ///< Walk along the borders, then one Laplace equation.
    LEAST_SQUARES_LAYOUT ///< Equations 19 to 21 of \cgalCite{cgal:slmb-abf-05}.
  };

  /// Largest accepted violation of a constraint at a vertex, in radians; at least 1e-14. For the reconstruction
  /// constraint, the violation is the logarithm of a ratio of lengths; for a hole, also ten times the gap relative to
  /// its circumference; for seams of equal lengths, also twice the largest difference of the logarithms of both
  /// lengths. The layout closes the remaining gap. With the default value, measures of distortion have at least four
  /// correct digits.
  double tolerance = 1e-5;

  /// The solver stops after a step that promised to lower the energy by less than this fraction of it; positive.
  /// Newton's method converges quadratically, so the remaining decrease is far smaller.
  double energy_tolerance = 1e-4;

  /// Largest number of Newton steps of each strategy. If this is not enough, the angles of the last step are laid
  /// out. The result is accepted only if no triangle is flipped.
  int max_iterations = 100;

  Step_type step = NEWTON; ///< How the second derivatives of the constraints are treated.

  Linear_solver linear_solver = ITERATIVE; ///< How the linear system of a step is solved.

  Layout_type layout = AUTOMATIC_LAYOUT; ///< How coordinates are computed from angles.

  /// Whether both sides of each seam edge get equal lengths in the plane, so that the scale does not jump there. If
  /// unset, lengths are equal for a `Seam_mesh`, unless angles of the border of the cut surface are prescribed. Other
  /// meshes have seams only after a call of `ABF_plus_plus_parameterizer_3::set_seam_sides()`, and equal lengths only
  /// if this is `true`. If lengths are not equal, they may differ by a large factor.
  ///
  /// Angles are found on the surface before the cut: the equations of lengths also hold around vertices of seams, and
  /// along loops through handles and around borders. Lengths are equal up to the tolerance. On models with 16 cones,
  /// the distortion was hardly higher, and the time up to 1.3 times as long.
  ///
  /// A seam with a side on the border of a hole keeps different lengths; if this is `true`, it is an error. With
  /// `Flattening_options::injective`, lengths are equal only if the map of the direct method does not overlap itself;
  /// see `ABF_plus_plus_report::largest_seam_jump`.
  std::optional<bool> equal_seam_lengths;

  /// Whether fallback strategies are tried if Newton's method from the target angles gives no valid map.
  /// `ABF_plus_plus_report::strategy` names the strategy that gave the result. If this is `false`, the failure is an
  /// error. Programs without the compiled library must include `ABF_plus_plus_strategies.h` for the last strategies.
  bool fallbacks = true;

  /// Whether a call of `parameterize()` starts from the angles of the last call on this parameterizer, or on a copy, if
  /// the component has the same triangles in the same order. That saves Newton steps if the points, the importance or
  /// the prescribed angles changed little. The map is the same up to the tolerances, but not to the last digit. It is
  /// found from the target angles, as without this option, if Newton's method does not converge from the last angles;
  /// `ABF_plus_plus_report::strategy` tells. Copies that run at the same time start from the angles that the original
  /// had when it was copied.
  bool warm_start = false;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_OPTIONS_H
