// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lets any CGAL parameterizer solve the coarse chart of the hierarchical method (Section 5), by way of a
// `Surface_mesh`. `Hierarchical_parameterizer_3.h` passes it on as the coarse solver.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_SOLVER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

template <typename Parameterizer, typename FaceImportanceMap, typename = void>
struct Takes_importance : std::false_type
{};

template <typename Parameterizer, typename FaceImportanceMap>
struct Takes_importance<
    Parameterizer, FaceImportanceMap,
    std::void_t<decltype(std::declval<Parameterizer&>().set_importance(std::declval<FaceImportanceMap>()))>>
    : std::true_type
{};

// Hands a coarse chart to any parameterizer, as a `Surface_mesh`.
template <typename Parameterizer>
class Coarse_solver
{
  typedef typename Parameterizer::Triangle_mesh Mesh;
  typedef typename Mesh::Vertex_index Vertex;
  typedef typename Mesh::Halfedge_index Halfedge;
  typedef typename Mesh::Face_index Face;
  typedef typename Mesh::template Property_map<Face, double> Importance;

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
    if constexpr(Takes_importance<Parameterizer, Importance>::value)
      if(!chart.weight.empty()) {
        Parameterizer weighing = m_parameterizer; // the mesh, and with it the map, is gone soon
        weighing.set_importance(importance(chart, mesh));
        return parameterize(chart, mesh, weighing);
      }
    return parameterize(chart, mesh, m_parameterizer);
  }

private:
  static Importance importance(const Chart& chart, Mesh& mesh)
  {
    const Importance map = mesh.template add_property_map<Face, double>("f:importance").first;
    for(Face f : mesh.faces()) // that of what fills holes may be less
      map[f] = (std::min)((std::max)(chart.weight[f], least_importance), largest_importance);
    return map;
  }

  static std::optional<std::vector<Chart::Point_2>> parameterize(const Chart& chart, Mesh& mesh,
                                                                 Parameterizer& parameterizer)
  {
    const int c = chart.borders.front().front();
    const Halfedge border = mesh.halfedge(Vertex(chart.edge_target(c)), Vertex(chart.edge_source(c)));

    const auto uvmap = mesh.template add_property_map<Vertex, Chart::Point_2>("v:uv").first;
    const auto parameterized = mesh.template add_property_map<Vertex, bool>("v:parameterized", false).first;
    const auto vimap = get(boost::vertex_index, mesh);
    if(parameterizer.parameterize(mesh, border, uvmap, vimap, parameterized) != OK)
      return std::nullopt;
    std::vector<Chart::Point_2> uv;
    for(Vertex v : mesh.vertices())
      uv.push_back(uvmap[v]);
    return uv;
  }

  Parameterizer& m_parameterizer;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_SOLVER_H
