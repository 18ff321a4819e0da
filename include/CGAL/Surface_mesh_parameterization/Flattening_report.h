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
#include <string>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The common part of the reports of `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3`.
struct Flattening_report : Report
{
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
/// returns the code that `parameterize()` returns for a diagnosis. A run that a visitor stopped has no code of its
/// own: its code is `ERROR_NO_1_TO_1_MAPPING`.
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

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_REPORT_H
