// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_VISITOR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_VISITOR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Base class of visitors that follow `ABF_plus_plus_parameterizer_3` and `Hierarchical_parameterizer_3`, and may
/// cancel them. If a function returns `false`, the computation ends. `parameterize()` then returns
/// `ERROR_NO_1_TO_1_MAPPING` with the diagnosis `Diagnosis::CANCELLED`, and no property map is changed. The report then
/// contains the size of the chart, but no steps. `Flattening_options::time_limit` ends a computation in the same way,
/// with `Diagnosis::TIMED_OUT`, and needs no visitor. If a function throws an exception, the exception passes through
/// `parameterize()`, with the same effects.
///
/// \cgalModels{FlatteningVisitor}
///
/// One thread at a time calls the functions. With \tbb and a number of threads in the options, this thread may differ
/// from the caller of `parameterize()`. The functions of the base class do nothing.
class Flattening_visitor
{
public:
  /// The stages. They are repeated if the direct method tries another strategy. Its third strategy simplifies and
  /// refines the chart, as the hierarchical method does.
  enum Stage
  {
    READ,          ///< Copying the mesh into arrays, and checking the input.
    TARGET_ANGLES, ///< Computing the target angles.
    ANGLES,        ///< The nonlinear solver.
    LAYOUT,        ///< Computing coordinates from angles.
    COARSEN,       ///< Collapses of the hierarchical method.
    COARSE_CHART,  ///< The coarse parameterizer.
    REFINE,        ///< Insertion and relaxation.
    POLISH,        ///< The direct solver on the refined chart.
    CERTIFY,       ///< Exact check of the result.
    WRITE          ///< Writing the caller's property map.
  };

  virtual ~Flattening_visitor() {}

  /// is called when a stage begins. Returns whether to continue.
  virtual bool start(Stage) { return true; }

  /// is called after each Newton step, with its entry in the report. Returns whether to continue.
  virtual bool step(const ABF_plus_plus_step&) { return true; }

  /// is called when the hierarchical method has added or undone a level of collapses. The arguments are the current
  /// number of vertices and the number of vertices of the whole chart. Returns whether to continue.
  virtual bool level(int /* vertices */, int /* all_vertices */) { return true; }
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns a name, such as `"WRITE"`.
///
/// \relates Flattening_visitor
inline const char* to_string(Flattening_visitor::Stage stage)
{
  constexpr const char* names[] = {"READ",         "TARGET_ANGLES", "ANGLES", "LAYOUT",  "COARSEN",
                                   "COARSE_CHART", "REFINE",        "POLISH", "CERTIFY", "WRITE"};
  return internal::ABF::name_of(stage, names);
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTENING_VISITOR_H
