// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>

#include <limits>
#include <optional>

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
  /// `Hierarchical_options::angle_sweeps`, and where relaxation lowers that energy
  /// (`Hierarchical_report::relaxed_angles`). Of maps that are as isometric as possible, it only shapes crushed
  /// triangles.
  double barrier = 0.1;

  /// Number of threads that work at once, at most 1024; 0 for one on each processor. It has no effect unless the program
  /// is linked with `CGAL::TBB_support`. It never changes the result.
  int threads = 0;

  /// What happens to a chart with more than one border. Other charts ignore this option.
  Holes holes = SOLVE;

  /// Whether something else may take the place of the method if it fails; otherwise, its failure is an error. The
  /// direct method then tries other strategies than Newton's method from the target angles, and
  /// `ABF_plus_plus_report::strategy` names the one that gave the result. The hierarchical method starts from one
  /// triangle if no coarse chart can be flattened or refined, or fills holes that cannot be solved;
  /// `Hierarchical_report::note` says so. Without fallbacks, its error is `Diagnosis::COARSE_CHART_FAILED`. Injective
  /// maps of the hierarchical method need no fallback.
  bool fallbacks = true;

  /// Whether the map must be globally injective: no two triangles overlap. The result is then an injective map or an
  /// error. The hierarchical method starts from Tutte's map of a coarse chart, stays injective on each level, and does
  /// not call the coarse parameterizer. The direct method returns its own map if that does not overlap itself, and
  /// otherwise the polished injective map of the hierarchical method; see also `area_weight`. Holes are filled during
  /// the computation (`FILL`), unless the direct method solves them and its map does not overlap itself.
  bool injective = false;

  /// How much injective maps preserve areas, from 0 to 1: the exponent \f$\theta\f$ in the energy
  /// \f$\frac{1}{2}(\sigma_1/\sigma_2 + \sigma_2/\sigma_1) \left(\frac{1}{2}(d + 1/d)\right)^\theta\f$ of a triangle,
  /// where \f$\sigma_1\f$ and \f$\sigma_2\f$ are the singular values of its map, and \f$d = \sigma_1 \sigma_2\f$. At 1,
  /// this is a quarter of the symmetric Dirichlet energy: the map is as isometric as possible. At 0, only angles count;
  /// branches of the surface that are stuck between others then shrink. Up to 0.1, final sweeps lower the energy of the
  /// direct method, and the direct method polishes: the weight shapes only the map that it starts from. Above 0.1, both
  /// methods give the same map, which lowers this energy, also where the map of the direct method would not overlap
  /// itself. Polishing and prescribed angles do not go with such weights (`Diagnosis::WRONG_OPTION`).
  double area_weight = 0.005;

  /// The distance below which parts of the border of an injective map repel each other, in lengths of the shorter of
  /// the edges there; above 0 and at most 1. Like `area_weight`, it may only be set together with `injective`.
  double clearance = 0.25;

  /// How much more than two pins (`ABF_plus_plus_parameterizer_3::set_pins()`) count against angles. If it is infinite,
  /// they are exactly at their positions. Otherwise, they are drawn there: with the weight 1, pins that are missed by a
  /// tenth of the width of the map cost as much as a change of all angles by about a tenth of a radian. The weight has
  /// no unit and must be positive. It may only be set together with pins; one or two are always at their positions.
  double pin_weight = (std::numeric_limits<double>::infinity)();

  /// If not null, this visitor follows the progress and may stop the computation. A coarse parameterizer and
  /// `Hierarchical_options::polish_options` have visitors of their own.
  Flattening_visitor* visitor = nullptr;

  /// The longest time that the computation may take, in seconds, on a clock that never goes back; at least 0. After it,
  /// the computation ends with the diagnosis `Diagnosis::TIMED_OUT`, and no property map is changed; see \ref
  /// ABF_time_limits "the manual". The limit also holds for a coarse parameterizer, which may have a limit of its own.
  double time_limit = (std::numeric_limits<double>::infinity)();
};

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

  /// Largest accepted violation of a constraint at a vertex, in radians; finite and at least 1e-14. For the
  /// reconstruction constraint, the violation is the logarithm of a ratio of lengths; for a hole, also ten times the gap
  /// relative to its circumference; for seams of equal lengths, also twice the largest difference of the logarithms of
  /// both lengths. The layout closes the remaining gap. With the default value, measures of distortion have at least
  /// four correct digits.
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
  /// the distortion was hardly higher, and the time up to 1.25 times as long.
  ///
  /// A seam with a side on the border of a hole keeps different lengths; if this is `true`, it is an error. With
  /// `Flattening_options::injective`, lengths are equal only if the map of the direct method does not overlap itself
  /// and `Flattening_options::area_weight` is at most 0.1;
  /// see `ABF_plus_plus_report::largest_seam_jump`.
  std::optional<bool> equal_seam_lengths;

  /// Whether a call of `parameterize()` starts from the angles of the last call on this parameterizer, or on a copy, if
  /// the component has the same triangles in the same order. That saves Newton steps if the points, the importance or
  /// the prescribed angles changed little. The map is the same up to the tolerances, but not to the last digit. It is
  /// found from the target angles, as without this option, if Newton's method does not converge from the last angles;
  /// `ABF_plus_plus_report::strategy` tells. Copies that run at the same time start from the angles that the original
  /// had when it was copied.
  bool warm_start = false;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `Hierarchical_parameterizer_3`.
struct Hierarchical_options : Flattening_options
{
  /// Fraction of the vertices that is removed before the coarse chart is flattened, in (0, 1). The paper uses 0.95.
  /// Injective maps start from about 300 vertices: neither this option nor `coarse_triangles` goes with them.
  double simplification_rate = 0.95;

  /// Number of triangles of the coarse chart. If not 0, it replaces `simplification_rate`, which then keeps its default.
  /// At least about 200 triangles always remain.
  int coarse_triangles = 0;

  /// Coarsening makes no angle smaller than this angle, or larger than \f$\pi\f$ minus this angle, in radians. The
  /// default is 2.5 degrees.
  double extreme_angle = 0.0436;

  /// Sweeps of relaxation on each level; 0 for none, and at most 1000. The three largest levels have at most one
  /// sweep. More sweeps lower the distortion and take more time.
  int sweeps = 3;

  /// Largest number of final sweeps over the finest level that lower the energy of the direct method, vertex by vertex;
  /// at most 1000. They help if the surface is noisy or has slivers. For injective maps, 0 means seven sweeps with
  /// over-relaxation; four if there are more than 20,000 vertices, or if the map is to be polished; three if there are
  /// more than 100,000; none if `area_weight` is above 0.1.
  int angle_sweeps = 0;

  /// The final sweeps end when a sweep lowers the energy by less than this fraction; below 1. With 0, all sweeps are
  /// done. It may only be set together with `angle_sweeps`.
  double energy_tolerance = 0;

  /// How often a coarse chart that cannot be flattened is replaced by a finer one
  /// (`Hierarchical_report::failed_coarse_charts`). Refinement then starts from one triangle, without a solver, unless
  /// `Flattening_options::fallbacks` is `false`.
  int max_retries = 3;

  /// Whether the direct solver starts from the angles of the refined map. This lowers the distortion to that of the
  /// direct method. For injective maps, Newton's method lowers the same energy by moving the vertices, so that the map
  /// stays injective. It uses the same solver traits; of `polish_options`, only the time limit applies.
  bool polish = false;

  /// Options of the direct solver that polishes: `barrier`, `visitor` and `time_limit` of `Flattening_options`, and
  /// tolerances, `max_iterations`, `step`, `linear_solver` and `layout`. All others, and all without `polish`, keep their
  /// defaults. The solver of its linear systems is a template parameter of the
  /// parameterizer. `Flattening_options::time_limit` of these options is no error: the map stays as it was before
  /// (`Hierarchical_report::polishing_timed_out`).
  ABF_plus_plus_options polish_options;
};

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

// From this weight on, areas count as much as angles, and lowering the energy of angles alone would undo this.
inline bool is_isometric(const Flattening_options& options)
{
  return options.area_weight > 0.1;
}

} // namespace internal::ABF
#endif // DOXYGEN_RUNNING

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_OPTIONS_H
