// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OUTCOME_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OUTCOME_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/report_failure.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/visit.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// What a run of a parameterizer tells, in terms of the caller's mesh.
template <typename TriangleMesh, typename Report>
struct Outcome
{
  Report report;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> offending_vertices;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> offending_faces;

  void name_offenders(const Chart_reader<TriangleMesh>& reader, const std::vector<int>& vertices,
                      const std::vector<int>& triangles)
  {
    for(int v : vertices)
      offending_vertices.push_back(reader.vertex_descriptors[v]);
    for(int t : triangles)
      offending_faces.push_back(reader.face_descriptors[t]);
  }

  // Calls `run`, which returns an error code, and turns the end that a visitor put to it into another one.
  template <typename Run>
  Error_code unless_cancelled(const Run& run)
  {
    try {
      return run();
    } catch(const Cancelled&) {
      fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::CANCELLED,
           "a visitor stopped the computation");
      return report.status;
    }
  }

  // Reads the chart of `bhd`. Returns `false`, with the reason in the report, if it cannot be flattened.
  template <typename Halfedge, typename VertexIndexMap>
  bool read(Chart_reader<TriangleMesh>& reader, Halfedge bhd, VertexIndexMap vimap, bool allow_holes)
  {
    Chart_defect defect = reader.read(bhd, vimap);
    if(!defect)
      defect = diagnose(reader.chart, allow_holes);
    report.vertices = reader.chart.number_of_vertices();
    report.triangles = static_cast<int>(reader.face_descriptors.size());
    report.borders = static_cast<int>(reader.chart.borders.size());
    if(!defect)
      return true;
    fail(report, error_code(defect.diagnosis), defect.diagnosis, defect.message);
    name_offenders(reader, defect.vertices, defect.triangles);
    return false;
  }
};

// Rounds coordinates to the number type of the points that a property map holds, so that what is certified is what
// will be written.
template <typename VertexUVmap>
struct Rounding
{
  typedef typename boost::property_traits<VertexUVmap>::value_type Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel::FT FT;

  Chart::Point_2 operator()(const Chart::Point_2& p) const
  {
    return Chart::Point_2(CGAL::to_double(FT(p.x())), CGAL::to_double(FT(p.y())));
  }
};

template <typename TriangleMesh, typename VertexUVmap>
void write(const Chart_reader<TriangleMesh>& reader, const std::vector<Chart::Point_2>& uv, VertexUVmap uvmap)
{
  typedef typename Rounding<VertexUVmap>::Point Point;
  typedef typename Rounding<VertexUVmap>::FT FT;
  for(std::size_t v = 0; v < uv.size(); ++v)
    put(uvmap, reader.vertex_descriptors[v], Point(FT(uv[v].x()), FT(uv[v].y())));
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OUTCOME_H
