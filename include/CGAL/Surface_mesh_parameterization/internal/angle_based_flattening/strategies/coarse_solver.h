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
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <optional>
#include <string>
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

// Whether a parameterizer has the report of the direct method
template <typename Parameterizer, typename = void>
struct Has_direct_report : std::false_type
{};

template <typename Parameterizer>
struct Has_direct_report<Parameterizer, std::void_t<decltype(std::declval<const Parameterizer&>().report())>>
    : std::is_base_of<ABF_plus_plus_report,
                      std::decay_t<decltype(std::declval<const Parameterizer&>().report())>>
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

  // An assertion or precondition of CGAL that the parameterizer violates is a failure on this chart. Other exceptions
  // pass through: those of visitors, and of memory that runs out.
  Coarse_map operator()(const Chart& chart) const
  {
    try {
      return flatten(chart);
    } catch(const CGAL::Failure_exception& failure) {
      Coarse_map none(std::nullopt);
      none.message = "the coarse parameterizer threw an exception: " + one_line(failure.what());
      return none;
    }
  }

private:
  static std::string one_line(std::string text)
  {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }

  Coarse_map flatten(const Chart& chart) const
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

  static Importance importance(const Chart& chart, Mesh& mesh)
  {
    const Importance map = mesh.template add_property_map<Face, double>("f:importance").first;
    for(Face f : mesh.faces()) // that of what fills holes may be less
      map[f] = (std::min)((std::max)(chart.weight[f], least_importance), largest_importance);
    return map;
  }

  static Coarse_map parameterize(const Chart& chart, Mesh& mesh, Parameterizer& parameterizer)
  {
    const int c = chart.borders.front().front();
    const Halfedge border = mesh.halfedge(Vertex(chart.edge_target(c)), Vertex(chart.edge_source(c)));

    const auto uvmap = mesh.template add_property_map<Vertex, Chart::Point_2>("v:uv").first;
    const auto parameterized = mesh.template add_property_map<Vertex, bool>("v:parameterized", false).first;
    const auto vimap = get(boost::vertex_index, mesh);
    const Error_code error = parameterizer.parameterize(mesh, border, uvmap, vimap, parameterized);
    std::optional<std::vector<Chart::Point_2>> uv;
    if(error == OK) {
      uv.emplace();
      for(Vertex v : mesh.vertices())
        uv->push_back(uvmap[v]);
    }
    Coarse_map map(std::move(uv));
    map.error = error;
    if(error != OK)
      map.message = "the coarse parameterizer returned " + name_of_error(error);
    if constexpr(Has_direct_report<Parameterizer>::value)
      add_report(parameterizer.report(), map);
    return map;
  }

  // What the direct method tells of its map beyond the error code
  static void add_report(const ABF_plus_plus_report& report, Coarse_map& map)
  {
    if(!map.uv) {
      map.flipped_triangles = report.flipped_triangles;
      map.message += ": " + report.message;
    } else if(report.strategy == ABF_plus_plus_report::PROGRESSIVE_EMBEDDING) {
      map.note = "the map of the coarse chart is a progressive embedding: " +
                 report.failed_strategies.back().message;
    }
  }

  Parameterizer& m_parameterizer;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_SOLVER_H
