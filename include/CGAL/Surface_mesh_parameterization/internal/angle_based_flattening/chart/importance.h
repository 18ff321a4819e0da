// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the importance of faces as weights of triangles in the energy, and refuses weights with which Newton's method
// is slow. `prescriptions.h` calls it when a mesh is read; `coarse_solver.h` keeps the weights of coarse charts in the
// same range.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_IMPORTANCE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_IMPORTANCE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <sstream>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Newton's method takes up to 4 times as many steps where neighbours differ by a factor of 10, up to 25 times as many
// where they differ by 100, and often does not converge where they differ by 1000.
inline constexpr double least_importance = 0.1, largest_importance = 10;

// The importance of each face of a mesh; empty if all are equal. It hides the type of the caller's property map.
template <typename TriangleMesh>
using Face_importance =
    std::function<double(const typename boost::graph_traits<TriangleMesh>::face_descriptor&)>;

template <typename TriangleMesh, typename FaceImportanceMap>
Face_importance<TriangleMesh> face_importance(FaceImportanceMap map)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  return [map](const face_descriptor& f) { return static_cast<double>(get(map, f)); };
}

// Finds the weights of triangles that are out of range.
inline Chart_defect find_wrong_weight(const std::vector<double>& weight)
{
  Chart_defect defect;
  for(std::size_t t = 0; t < weight.size(); ++t)
    if(!(weight[t] >= least_importance && weight[t] <= largest_importance))
      defect.triangles.push_back(static_cast<int>(t));
  if(defect.triangles.empty())
    return defect;
  std::ostringstream text;
  text << "the importance of a face is " << weight[defect.triangles.front()] << ", but must be between "
       << least_importance << " and " << largest_importance;
  defect.status = Diagnosis::WRONG_WEIGHT;
  defect.message = text.str();
  return defect;
}

// Sets the weights of the triangles of the chart that was read, from the importance of its faces.
template <typename ChartReader, typename FaceImportance>
Chart_defect read_importance(ChartReader& reader, const FaceImportance& importance)
{
  if(!importance)
    return {};
  std::vector<double>& weight = reader.chart.weight;
  weight.reserve(reader.number_of_faces());
  for(int t = 0; t < reader.number_of_faces(); ++t)
    weight.push_back(importance(reader.face_of_triangle(t)));
  return find_wrong_weight(weight);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_IMPORTANCE_H
