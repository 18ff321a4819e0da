// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OUTCOME_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OUTCOME_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/peak_memory.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/report_failure.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <string>
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

  // Calls `run`, which returns an error code, turns the end that a visitor put to it into another one, and notes how
  // much memory it took.
  template <typename Run>
  Error_code of_run(const Run& run)
  {
    Error_code result = OK;
    try {
      result = run();
    } catch(const Cancelled&) {
      fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::CANCELLED,
           "a visitor stopped the computation");
      result = report.status;
    }
    report.peak_memory = peak_resident_size();
    return result;
  }

  // Returns `false`, with the reason in the report, if the options make no sense.
  bool accept(const std::string& wrong_option)
  {
    if(wrong_option.empty())
      return true;
    fail(report, ERROR_WRONG_PARAMETER, ABF_plus_plus_report::WRONG_OPTION, wrong_option);
    return false;
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

// Coordinates as the points that a property map holds. What is certified is read back from the very points that are
// written: a conversion to their number type and back in one expression is not enough, as GCC 12 removes it at -O2 where
// it vectorizes straight-line code.
template <typename VertexUVmap>
class Rounded_points
{
  typedef typename boost::property_traits<VertexUVmap>::value_type Point;
  typedef typename CGAL::Kernel_traits<Point>::Kernel::FT FT;

public:
  // Rounds `uv` to what the points hold.
  void operator()(std::vector<Chart::Point_2>& uv)
  {
    m_points.clear();
    m_points.reserve(uv.size());
    for(const Chart::Point_2& p : uv)
      m_points.push_back(Point(FT(p.x()), FT(p.y())));
    for(std::size_t v = 0; v < uv.size(); ++v)
      uv[v] = Chart::Point_2(CGAL::to_double(m_points[v].x()), CGAL::to_double(m_points[v].y()));
  }

  template <typename TriangleMesh>
  void write(const Chart_reader<TriangleMesh>& reader, VertexUVmap uvmap) const
  {
    for(std::size_t v = 0; v < m_points.size(); ++v)
      put(uvmap, reader.vertex_descriptors[v], m_points[v]);
  }

private:
  std::vector<Point> m_points;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OUTCOME_H
