// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds what makes a chart impossible to flatten: points that are not finite, vertices that are not manifold, the wrong
// topology. `read_chart.h` and `read_surface.h` call `diagnose()`; stages that can fail return the type `Chart_defect`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_DIAGNOSE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_DIAGNOSE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What is wrong with a chart, and where.
struct Chart_defect
{
  Diagnosis status = Diagnosis::NOTHING_WRONG;
  std::string message;
  std::vector<int> vertices;
  std::vector<int> triangles;

  explicit operator bool() const { return status != Diagnosis::NOTHING_WRONG; }
};

inline void fail(Flattening_report& report, Diagnosis diagnosis, const std::string& message)
{
  report.status = diagnosis;
  report.message = message;
}

// A report with a defect of a chart
template <typename Report>
Report report_of(const Chart& chart)
{
  Report report;
  report.vertices = chart.number_of_vertices();
  report.triangles = chart.number_of_triangles();
  report.borders = static_cast<int>(chart.borders.size());
  return report;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_non_finite_point(const Chart& chart);

// The triangles whose vertices are on a line, up to the rounding of their coordinates
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<int> degenerate_triangles(const Chart& chart);

// What is wrong if all triangles are among the `degenerate` ones
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_no_area(const Chart& chart, std::vector<int> degenerate);

// Walks once around every vertex. A second fan of triangles at a vertex, or a neighbour met twice, is an error:
// by Fary's theorem a disk can be drawn in the plane exactly if its edge graph has no loop and no parallel edges.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_bad_vertex(const Chart& chart);

// A connected chart is a disk with holes exactly if its Euler characteristic is two less the number of borders.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_wrong_topology(const Chart& chart, bool with_holes);

// Finds what makes a chart impossible to flatten, in linear time.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect diagnose(const Chart& chart, bool with_holes);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_DIAGNOSE_H
