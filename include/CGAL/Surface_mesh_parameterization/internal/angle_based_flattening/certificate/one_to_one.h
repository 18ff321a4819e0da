// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether any map of a chart is one-to-one, without the predicates that this takes: programs compile fast.
// Both parameterizers ask it. The body is in `one_to_one_impl.h`, which the compiled library has.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_ONE_TO_ONE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_ONE_TO_ONE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_pins.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE bool is_one_to_one(const Chart& chart,
                                                      const std::vector<Chart::Point_2>& uv);

// The same on the component of a border halfedge
template <typename TriangleMesh, typename VertexUVmap>
bool is_one_to_one(const TriangleMesh& mesh,
                   typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexUVmap uvmap)
{
  Chart_reader<TriangleMesh> reader(mesh);
  if(reader.read(bhd))
    return false;
  std::vector<Chart::Point_2> uv;
  uv.reserve(reader.vertex_descriptors.size());
  for(const auto& v : reader.vertex_descriptors)
    uv.push_back(point_of_doubles(get(uvmap, v)));
  return is_one_to_one(reader.chart, uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/one_to_one_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_ONE_TO_ONE_H
