// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_VISITOR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_VISITOR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Is told how far `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3` have come, and may stop them: any of
/// its functions that returns `false` ends the computation. `parameterize()` then returns `ERROR_NO_1_TO_1_MAPPING` with
/// the diagnosis `Flattening_report::CANCELLED`, and leaves the caller's property maps as they were. The report then has
/// the size of the chart, but nothing of the steps that were taken. Exceptions that a function throws pass through
/// `parameterize()` in the same manner.
///
/// All functions are called one after the other, never by two threads at once; with \tbb and a number of threads in the options,
/// this may be another thread than the caller of `parameterize()`. Those of the base class do nothing.
class Flattening_visitor
{
public:
  /// What is about to be done. The same may be done again where the direct method tries another strategy; its
  /// third one simplifies the chart and refines it, as the hierarchical method does.
  enum Stage
  {
    READ,          ///< From the mesh to flat arrays, and the check of the input.
    TARGET_ANGLES, ///< From the surface to target angles.
    ANGLES,        ///< The nonlinear solver.
    LAYOUT,        ///< From angles to coordinates.
    COARSEN,       ///< Collapses of the hierarchical method.
    COARSE_CHART,  ///< The coarse parameterizer.
    REFINE,        ///< Insertion and relaxation.
    POLISH,        ///< The direct solver on the refined chart.
    CERTIFY,       ///< Exact check of the result.
    WRITE          ///< Into the caller's property map.
  };

  virtual ~Flattening_visitor() {}

  /// is called at the beginning of a stage. Returns whether to go on.
  virtual bool start(Stage) { return true; }

  /// is called after each Newton step, with what the report will have of it. Returns whether to go on.
  virtual bool step(const ABF_plus_plus_step&) { return true; }

  /// is called when the hierarchical method has added or undone a level of collapses, with the number of vertices that
  /// are there, and that of the whole chart. Returns whether to go on.
  virtual bool level(int /* vertices */, int /* all_vertices */) { return true; }
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_VISITOR_H
