// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <cstddef>
#include <limits>
#include <string>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What the reports of `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3` have in common.
struct Flattening_report
{
  /// What is wrong with an input, or why a run stopped.
  enum Diagnosis
  {
    NOTHING_WRONG,       ///< The run succeeded.
    EMPTY_MESH,          ///< There is no face at the given border.
    NO_BORDER,           ///< The surface is closed: it must be cut open first.
    NOT_ON_BORDER,       ///< The given halfedge is null or not on a border.
    NOT_TRIANGULATED,    ///< A face is not a triangle.
    NON_FINITE_POINT,    ///< A coordinate is infinite or not a number.
    TOO_LARGE,           ///< More than 153 million triangles.
    NON_MANIFOLD_VERTEX, ///< The surface is not a manifold at a vertex.
    SEVERAL_BORDERS, ///< The chart has holes, and `Flattening_options::holes` is `Flattening_options::REFUSE`.
    NONZERO_GENUS,   ///< The chart has handles, so it is not a disk.
    PARALLEL_EDGES,  ///< Two edges have the same vertices, or an edge is a loop: no planar drawing exists.
    LINEAR_SYSTEM_FAILED, ///< The solver traits failed.
    NO_CONVERGENCE,    ///< The constraints could not be met, and the resulting layout has flipped triangles.
    WRONG_OPTION,      ///< An option is out of its range.
    WRONG_IMPORTANCE,  ///< The importance of a face is out of its range, or not a number.
    WRONG_ANGLE_SUM,   ///< A prescribed angle is not possible at its vertex.
    WRONG_ANGLE_TOTAL, ///< The prescribed angles do not sum to those of a polygon.
    FLAT_CHORD, ///< There is no room between an edge that joins two border vertices and the prescribed border.
    INFEASIBLE_ANGLE_SUMS, ///< The triangles near some border vertices cannot have the angles that are prescribed there.
    SCALE_TOO_LARGE,   ///< The chart has several borders, and its map would need a range of scale above 1e10.
    FLIPPED_TRIANGLES, ///< The layout has flipped triangles although the angles are correct.
    OVERLAPPING, ///< The map overlaps itself, although it was to be injective: why a strategy was not enough.
    PRECISION_EXCEEDED, ///< There is a valid map, but the number type of the coordinates cannot hold the one found.
    CANCELLED           ///< A visitor or an exception stopped the computation.
  };

  /// Wall clock time of each stage, in seconds; 0 for those that the method does not have.
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

  Diagnosis diagnosis = NOTHING_WRONG; ///< What is wrong.
  std::string message;                 ///< A sentence that names the offending element; empty on success.

  int vertices = 0;  ///< Vertices of the chart.
  int triangles = 0; ///< Triangles of the chart.
  int borders = 0;   ///< Border cycles of the chart.

  bool border_is_simple =
      false; ///< Whether the borders are simple, as `Flattening_measures::border_is_simple`: with no
             ///< flipped triangle, the map is injective if and only if they are.
  double scale_range = 1; ///< Ratio of the longest to the shortest edge of the layout.
  /// Ratio of the largest to the smallest scale of a conformal map of a chart with several borders, predicted by one
  /// linear system; 1 for other charts. Above 1e4, a cut between the borders gives a better map.
  double predicted_scale_range = 1;
  int flipped_triangles = 0; ///< Triangles that are not positively oriented.
  double smallest_angle = 0; ///< Smallest angle of the planar triangulation, in radians.

  bool injective =
      false; ///< Whether the map was asked to be injective (`Flattening_options::injective`) and is certified to be.
  /// Share of the length of the border of an injective map that is nearer to another part than `Flattening_options::clearance`
  /// allows without force. It is 0 if the direct method's own map is injective.
  double contact = 0;
  /// Least distance between two parts of the border of an injective map, outside of it, divided by the length of the shorter of the
  /// edges there. It is infinite if it is not below 1, and if the direct method's own map is injective.
  double least_clearance = (std::numeric_limits<double>::infinity)();
  int border_rejections =
      0; ///< Moves and steps that were refused because the border would have touched itself.

  Seconds seconds; ///< Time of each stage.

  /// Largest resident size of the process until the end of the run, in bytes; 0 if the system does not report it.
  std::size_t peak_memory = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"NO_CONVERGENCE"`.
///
/// \relates Flattening_report
inline std::string to_string(Flattening_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Flattening_report::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Flattening_report::EMPTY_MESH:
    return "EMPTY_MESH";
  case Flattening_report::NO_BORDER:
    return "NO_BORDER";
  case Flattening_report::NOT_ON_BORDER:
    return "NOT_ON_BORDER";
  case Flattening_report::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Flattening_report::NON_FINITE_POINT:
    return "NON_FINITE_POINT";
  case Flattening_report::TOO_LARGE:
    return "TOO_LARGE";
  case Flattening_report::NON_MANIFOLD_VERTEX:
    return "NON_MANIFOLD_VERTEX";
  case Flattening_report::SEVERAL_BORDERS:
    return "SEVERAL_BORDERS";
  case Flattening_report::NONZERO_GENUS:
    return "NONZERO_GENUS";
  case Flattening_report::PARALLEL_EDGES:
    return "PARALLEL_EDGES";
  case Flattening_report::LINEAR_SYSTEM_FAILED:
    return "LINEAR_SYSTEM_FAILED";
  case Flattening_report::NO_CONVERGENCE:
    return "NO_CONVERGENCE";
  case Flattening_report::WRONG_OPTION:
    return "WRONG_OPTION";
  case Flattening_report::WRONG_IMPORTANCE:
    return "WRONG_IMPORTANCE";
  case Flattening_report::WRONG_ANGLE_SUM:
    return "WRONG_ANGLE_SUM";
  case Flattening_report::WRONG_ANGLE_TOTAL:
    return "WRONG_ANGLE_TOTAL";
  case Flattening_report::FLAT_CHORD:
    return "FLAT_CHORD";
  case Flattening_report::INFEASIBLE_ANGLE_SUMS:
    return "INFEASIBLE_ANGLE_SUMS";
  case Flattening_report::SCALE_TOO_LARGE:
    return "SCALE_TOO_LARGE";
  case Flattening_report::FLIPPED_TRIANGLES:
    return "FLIPPED_TRIANGLES";
  case Flattening_report::OVERLAPPING:
    return "OVERLAPPING";
  case Flattening_report::PRECISION_EXCEEDED:
    return "PRECISION_EXCEEDED";
  case Flattening_report::CANCELLED:
    return "CANCELLED";
  }
  return "";
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the code that `parameterize()` returns for a diagnosis. A run that a visitor stopped has no code of its
/// own: its code is `ERROR_NO_1_TO_1_MAPPING`.
///
/// \relates Flattening_report
inline Error_code error_code(Flattening_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Flattening_report::NOTHING_WRONG:
    return OK;
  case Flattening_report::EMPTY_MESH:
    return ERROR_EMPTY_MESH;
  case Flattening_report::NOT_TRIANGULATED:
    return ERROR_NON_TRIANGULAR_MESH;
  case Flattening_report::NO_BORDER:
  case Flattening_report::NON_MANIFOLD_VERTEX:
  case Flattening_report::SEVERAL_BORDERS:
  case Flattening_report::NONZERO_GENUS:
    return ERROR_NO_TOPOLOGICAL_DISC;
  case Flattening_report::LINEAR_SYSTEM_FAILED:
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  case Flattening_report::NOT_ON_BORDER:
  case Flattening_report::NON_FINITE_POINT:
  case Flattening_report::TOO_LARGE:
  case Flattening_report::WRONG_OPTION:
  case Flattening_report::WRONG_IMPORTANCE:
  case Flattening_report::WRONG_ANGLE_SUM:
  case Flattening_report::WRONG_ANGLE_TOTAL:
  case Flattening_report::FLAT_CHORD:
  case Flattening_report::INFEASIBLE_ANGLE_SUMS:
    return ERROR_WRONG_PARAMETER;
  case Flattening_report::PARALLEL_EDGES:
  case Flattening_report::NO_CONVERGENCE:
  case Flattening_report::SCALE_TOO_LARGE:
  case Flattening_report::FLIPPED_TRIANGLES:
  case Flattening_report::OVERLAPPING:
  case Flattening_report::PRECISION_EXCEEDED:
  case Flattening_report::CANCELLED:
    break;
  }
  return ERROR_NO_1_TO_1_MAPPING;
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_REPORT_H
