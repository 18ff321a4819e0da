// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The common part of the reports of `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3`.
struct Flattening_report : Report
{
  using Report::Report;

  /// Wall clock time of each stage, in seconds; 0 for stages that the method does not have.
  struct Seconds
  {
    double read = 0;         ///< Copying the mesh into arrays, and checking the input.
    double targets = 0;      ///< Target angles.
    double angles = 0;       ///< The nonlinear solver.
    double layout = 0;       ///< Computing coordinates from angles.
    double coarsen = 0;      ///< Collapses.
    double coarse_chart = 0; ///< The coarse parameterizer.
    double refine = 0;       ///< Insertion and relaxation.
    double polish = 0;       ///< The direct solver on the fine chart, if requested.
    double certify = 0;      ///< Exact check of the orientations.
    double write = 0;        ///< Writing the caller's property map.

    /// adds the times of another run.
    Seconds& operator+=(const Seconds& other)
    {
      read += other.read;
      targets += other.targets;
      angles += other.angles;
      layout += other.layout;
      coarsen += other.coarsen;
      coarse_chart += other.coarse_chart;
      refine += other.refine;
      polish += other.polish;
      certify += other.certify;
      write += other.write;
      return *this;
    }

    /// returns the sum of the stages.
    double total() const
    {
      return read + targets + angles + layout + coarsen + coarse_chart + refine + polish + certify + write;
    }
  };

  int vertices = 0;  ///< Vertices of the chart.
  int triangles = 0; ///< Triangles of the chart.
  int borders = 0;   ///< Border cycles of the chart.
  /// Triangles of the surface whose vertices are on a line, or at one point, up to the rounding of coordinates.
  int degenerate_triangles = 0;

  /// Whether the borders are simple; see `Flattening_measures::border_is_simple`. If no triangle is flipped, the map is
  /// injective if and only if the borders are simple.
  bool border_is_simple = false;
  double scale_range = 1; ///< Ratio of the longest to the shortest edge of the layout.
  /// Ratio of the largest to the smallest scale of a conformal map of a chart with several borders, predicted by one
  /// linear system; 1 for other charts. Above 1e4, a cut between the borders gives a better map.
  double predicted_scale_range = 1;
  int flipped_triangles = 0; ///< Triangles that are not positively oriented.
  double smallest_angle = 0; ///< Smallest angle of the planar triangulation, in radians.

  /// Whether an injective map was asked for (`Flattening_options::injective`) and is certified.
  bool injective = false;
  /// Share of the border of an injective map, by length, that is in contact: nearer to another part of the border than
  /// `Flattening_options::clearance`. It is 0 if the direct method's own map is injective.
  double contact = 0;
  /// Least distance between two parts of the border of an injective map, measured outside of the map and divided by the
  /// length of the shorter of the edges there. It is infinite if it would be 1 or more, or if the direct method's own
  /// map is injective.
  double least_clearance = (std::numeric_limits<double>::infinity)();
  /// Moves and steps that were refused because the border would have touched itself.
  int border_rejections = 0;

  int pins = 0; ///< Vertices with given positions (`ABF_plus_plus_parameterizer_3::set_pins()`).
  double largest_pin_distance = 0; ///< Largest distance of such a vertex from its position, in the plane.
  double largest_pin_angle_change =
      0; ///< Largest difference of a planar angle from that of the map without pins, in radians.
  double mean_pin_angle_change = 0; ///< Mean difference of the planar angles, in radians.

  Seconds seconds; ///< Time of each stage.

  /// Largest resident size of the process until the end of the run, in bytes, as `getrusage()` has it; 0 if the system
  /// does not report it. On Linux, it is at least the size of the process that started this one.
  std::size_t peak_memory = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the code that `parameterize()` returns for a diagnosis. A run that a visitor or a time limit stopped has
/// no code of its own: its code is `ERROR_NO_1_TO_1_MAPPING`.
///
/// \relates Flattening_report
inline Error_code error_code(Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Diagnosis::NOTHING_WRONG:
    return OK;
  case Diagnosis::EMPTY_MESH:
    return ERROR_EMPTY_MESH;
  case Diagnosis::NOT_TRIANGULATED:
    return ERROR_NON_TRIANGULAR_MESH;
  case Diagnosis::NO_BORDER:
  case Diagnosis::NON_MANIFOLD_VERTEX:
  case Diagnosis::SEVERAL_BORDERS:
  case Diagnosis::NONZERO_GENUS:
    return ERROR_NO_TOPOLOGICAL_DISC;
  case Diagnosis::LINEAR_SYSTEM_FAILED:
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  case Diagnosis::NOT_ON_BORDER:
  case Diagnosis::NON_FINITE_POINT:
  case Diagnosis::FAR_POINT:
  case Diagnosis::TOO_LARGE:
  case Diagnosis::NO_AREA:
  case Diagnosis::WRONG_OPTION:
  case Diagnosis::WRONG_WEIGHT:
  case Diagnosis::WRONG_ANGLE_SUM:
  case Diagnosis::WRONG_ANGLE_TOTAL:
  case Diagnosis::FLAT_CHORD:
  case Diagnosis::WRONG_PIN:
  case Diagnosis::INFEASIBLE_ANGLE_SUMS:
    return ERROR_WRONG_PARAMETER;
  default:
    return ERROR_NO_1_TO_1_MAPPING;
  }
}

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

// The name of an error code. (CGAL's `get_error_message()` confuses them before CGAL 6.1.)
inline std::string name_of_error(Error_code error)
{
  switch(error) {
  case OK:
    return "OK";
  case ERROR_EMPTY_MESH:
    return "ERROR_EMPTY_MESH";
  case ERROR_NON_TRIANGULAR_MESH:
    return "ERROR_NON_TRIANGULAR_MESH";
  case ERROR_NO_TOPOLOGICAL_DISC:
    return "ERROR_NO_TOPOLOGICAL_DISC";
  case ERROR_NO_TOPOLOGICAL_BALL:
    return "ERROR_NO_TOPOLOGICAL_BALL";
  case ERROR_BORDER_TOO_SHORT:
    return "ERROR_BORDER_TOO_SHORT";
  case ERROR_NON_CONVEX_BORDER:
    return "ERROR_NON_CONVEX_BORDER";
  case ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
    return "ERROR_CANNOT_SOLVE_LINEAR_SYSTEM";
  case ERROR_NO_1_TO_1_MAPPING:
    return "ERROR_NO_1_TO_1_MAPPING";
  case ERROR_WRONG_PARAMETER:
    return "ERROR_WRONG_PARAMETER";
  }
  return "the unknown error code " + std::to_string(static_cast<int>(error));
}

} // namespace internal::ABF
#endif // DOXYGEN_RUNNING

/// \ingroup PkgAngleBasedFlatteningRef
///
/// One step of the angle solver.
struct ABF_plus_plus_step
{
  int iteration = 0;              ///< Number of the step, from 1.
  double energy = 0;              ///< Energy after the step.
  double constraint_residual = 0; ///< Largest violation of a constraint after the step, in radians.
  double predicted_decrease = 0;  ///< Decrease of the energy that the step's quadratic model promised.
  /// Fraction of the full step that was taken. It is above 1 if full steps converge slowly.
  double step_length = 0;
  int linear_iterations = 0; ///< Steps of conjugate gradients.
  /// Number of matrices that were factored: one by the direct solver; two by the iterative solver in the first step. If
  /// there are slivers, steep cones or holes, the iterative solver factors one more small matrix in each step.
  int factorizations = 0;
  /// Number of factorizations that the solver traits repeated, because the counterpart of lower precision
  /// (`Low_precision_solver_traits`) failed.
  int repeated_factorizations = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of the last run of `ABF_plus_plus_parameterizer_3`.
struct ABF_plus_plus_report : Flattening_report
{
  using Flattening_report::Flattening_report;

  /// The ways to a valid map, in the order in which they are tried.
  enum Strategy
  {
    FROM_LAST_ANGLES, ///< Newton's method from the angles of the last call (`ABF_plus_plus_options::warm_start`).
    FROM_TARGET_ANGLES, ///< Newton's method from the target angles.

    /// The same with a higher barrier, and then with the given barrier from the angles found, if possible.
    RAISED_BARRIER,
    FROM_SOFT_PATCHES, ///< Newton's method from the angles of `SOFT_PATCHES` (`Flattening_options::SOLVE`).
    SOFT_PATCHES,      ///< Newton's method from the target angles, with the holes filled.
    STIFF_PATCHES,     ///< The same; the fillings have the full weight of the triangles around them.
    FROM_PROGRESSIVE_EMBEDDING, ///< Newton's method from the angles of a progressive embedding, which satisfy all
    ///< constraints: the surface is simplified to one triangle, and all vertices are inserted again where their
    ///< triangles are valid.
    PROGRESSIVE_EMBEDDING, ///< The progressive embedding itself, improved by local descent on the energy.

    /// The polished injective map of the hierarchical method, if the map of the direct method overlaps itself
    /// (`Flattening_options::injective`).
    INJECTIVE_DESCENT
  };

  /// A strategy that did not give a valid map.
  struct Failed_strategy
  {
    Strategy strategy;   ///< The strategy.
    Diagnosis status;    ///< Why it failed.
    std::string message; ///< The reason as a sentence.
    int iterations;      ///< Newton steps taken.
  };

  /// The layout that gave the coordinates.
  enum Layout
  {
    NO_LAYOUT,    ///< None, because the run ended before.
    EXACT,        ///< `ABF_plus_plus_options::EXACT_LAYOUT`.
    LEAST_SQUARES ///< `ABF_plus_plus_options::LEAST_SQUARES_LAYOUT`.
  };

  Strategy strategy = FROM_TARGET_ANGLES;         ///< The strategy that gave the result, or was tried last.
  std::vector<Failed_strategy> failed_strategies; ///< The strategies that failed before this one.

  bool converged = false;                ///< Whether both tolerances were met.
  int iterations = 0;                    ///< Newton steps taken.
  double energy = 0;                     ///< Energy of the planar angles, including the barrier.
  double constraint_residual = 0;        ///< Largest violation of a constraint at a vertex, in radians.
  std::vector<ABF_plus_plus_step> steps; ///< All steps.

  /// The layout that gave the coordinates; none if they are those of an embedding.
  Layout layout = NO_LAYOUT;
  bool layout_repeated = false; ///< Whether low precision was not enough for the exact layout.

  /// Largest gap in a border that the exact layout closed, relative to the border's length.
  double closure = 0;

  /// Largest difference between the logarithms of the lengths of both sides of a seam edge; 0 without seams.
  double largest_seam_jump = 0;
  /// Largest difference between \f$2\pi\f$ and the sum of planar angles at a vertex in the middle of a seam, in
  /// radians. This is the difference between the turns of both sides of the seam. Vertices with a prescribed or free
  /// sum do not count.
  double largest_seam_turn = 0;

  /// Number of vertices with a prescribed angle. If seams have equal lengths, these are vertices of the surface before
  /// the cut.
  int prescribed_angles = 0;
  /// Largest difference between a prescribed angle and the angle in the map, in radians.
  double largest_angle_error = 0;
  /// Largest distance between a vertex and the straight side that it should be on: the distance from the line through
  /// the ends of the side, divided by the length of the side.
  double side_deviation = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of the last run of `Hierarchical_parameterizer_3`.
struct Hierarchical_report : Flattening_report
{
  using Flattening_report::Flattening_report;

  /// Where the refinement started.
  enum Start
  {
    COARSE_PARAMETERIZER,  ///< The coarse chart, flattened by the coarse parameterizer.
    PROGRESSIVE_EMBEDDING, ///< A single triangle, because no coarse chart could be flattened or refined.
    TUTTE_MAP              ///< Tutte's map of the coarse chart to a circle (`Flattening_options::injective`).
  };

  /// A coarse chart of which the coarse parameterizer gave no valid map.
  struct Failed_coarse_chart
  {
    int vertices;  ///< Vertices of the coarse chart.
    int triangles; ///< Triangles of the coarse chart.

    /// The code that the coarse parameterizer returned: `OK` with a map that is not valid. None if it threw an
    /// exception, or was not called because the scale would vary too much (`Diagnosis::SCALE_TOO_LARGE`).
    std::optional<Error_code> error;

    /// Triangles of its map that are not positively oriented. Without a map, 0, or what the report of an
    /// `ABF_plus_plus_parameterizer_3` says.
    int flipped_triangles;
    std::string message; ///< What was wrong, as a sentence.
  };

  int levels = 0;                     ///< Levels of collapses above the coarse chart.
  int coarse_vertices = 0;            ///< Vertices of the coarse chart.
  int coarse_triangles = 0;           ///< Triangles of the coarse chart.
  Start start = COARSE_PARAMETERIZER; ///< Where the refinement started.
  bool holes_filled = false; ///< Whether holes were filled, by request or because they could not be solved.

  /// The coarse charts that could not be flattened, in the order in which they were tried: each is finer than the one
  /// before. Charts with holes that were filled later are among them.
  std::vector<Failed_coarse_chart> failed_coarse_charts;

  /// A sentence on what took the place of the coarse parameterizer's map, and why; empty if that map was refined, or
  /// without a result. The default coarse parameterizer has fallbacks of its own: if its map is a progressive
  /// embedding, the sentence says so, too.
  std::string note;

  int kernel_insertions = 0; ///< Number of vertices that were inserted at the centre of a kernel.
  int moves = 0;             ///< Number of vertices that relaxation moved.
  int rejected_moves = 0;    ///< Number of vertices that relaxation did not move.
  int angle_sweeps = 0;      ///< Number of final sweeps.

  /// Whether relaxation lowered the energy of the direct method on each level, because MIPS would have changed the
  /// angles by more; see \ref ABF_relaxed_angles "the manual".
  bool relaxed_angles = false;

  /// Energy of the planar angles, including the barrier. It is computed only for final sweeps and polishing; otherwise
  /// NaN.
  double energy = (std::numeric_limits<double>::quiet_NaN)();

  /// Whether polishing succeeded: the result is then that of the direct solver. For injective maps: whether Newton's
  /// method converged; if not, the map has the lowest energy that was reached.
  bool polished = false;
  /// Whether polishing ended at its time limit (`Hierarchical_options::polish_options`): the map is that before it, or
  /// before the last step for injective maps.
  bool polishing_timed_out = false;
  /// Newton steps of polishing; for injective maps, all steps on the finest level towards the least energy of angles.
  int polish_iterations = 0;
  double constraint_residual = 0; ///< Largest violation of a constraint by the polished angles, in radians.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns a name, such as `"INJECTIVE_DESCENT"`.
///
/// \relates ABF_plus_plus_report
inline std::string to_string(ABF_plus_plus_report::Strategy strategy)
{
  constexpr const char* names[] = {
      "FROM_LAST_ANGLES",           "FROM_TARGET_ANGLES",    "RAISED_BARRIER",
      "FROM_SOFT_PATCHES",          "SOFT_PATCHES",          "STIFF_PATCHES",
      "FROM_PROGRESSIVE_EMBEDDING", "PROGRESSIVE_EMBEDDING", "INJECTIVE_DESCENT"};
  return internal::ABF::name_of(strategy, names);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns a name, such as `"LEAST_SQUARES"`.
///
/// \relates ABF_plus_plus_report
inline std::string to_string(ABF_plus_plus_report::Layout layout)
{
  constexpr const char* names[] = {"NO_LAYOUT", "EXACT", "LEAST_SQUARES"};
  return internal::ABF::name_of(layout, names);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns a name, such as `"TUTTE_MAP"`.
///
/// \relates Hierarchical_report
inline std::string to_string(Hierarchical_report::Start start)
{
  constexpr const char* names[] = {"COARSE_PARAMETERIZER", "PROGRESSIVE_EMBEDDING", "TUTTE_MAP"};
  return internal::ABF::name_of(start, names);
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_REPORT_H
