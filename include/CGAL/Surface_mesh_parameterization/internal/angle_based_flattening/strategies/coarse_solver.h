// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_SOLVER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <CGAL/Surface_mesh.h>

#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Hands a coarse chart to any parameterizer, as a `Surface_mesh`.
template <typename Parameterizer>
class Coarse_solver
{
  typedef typename Parameterizer::Triangle_mesh Mesh;
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;

public:
  explicit Coarse_solver(Parameterizer& parameterizer) : m_parameterizer(parameterizer) {}

  std::optional<std::vector<Chart::Point_2>> operator()(const Chart& chart) const
  {
    Mesh mesh;
    for(const Chart::Point_3& p : chart.points)
      mesh.add_vertex(p);
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      mesh.add_face(Vertex(chart.vertex[3 * t]), Vertex(chart.vertex[3 * t + 1]),
                    Vertex(chart.vertex[3 * t + 2]));
    const int c = chart.borders.front().front();
    const Halfedge border = mesh.halfedge(Vertex(chart.edge_target(c)), Vertex(chart.edge_source(c)));

    const auto uvmap = mesh.template add_property_map<Vertex, Chart::Point_2>("v:uv").first;
    const auto parameterized = mesh.template add_property_map<Vertex, bool>("v:parameterized", false).first;
    const auto vimap = get(boost::vertex_index, mesh);
    if(m_parameterizer.parameterize(mesh, border, uvmap, vimap, parameterized) != OK)
      return std::nullopt;
    std::vector<Chart::Point_2> uv;
    for(Vertex v : mesh.vertices())
      uv.push_back(uvmap[v]);
    return uv;
  }

private:
  Parameterizer& m_parameterizer;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_SOLVER_H
