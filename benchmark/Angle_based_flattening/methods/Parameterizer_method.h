// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_PARAMETERIZER_METHOD_H
#define ABF_BENCHMARK_PARAMETERIZER_METHOD_H

#include "Method.h"
#include "finish.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <exception>
#include <iostream>
#include <new>
#include <streambuf>
#include <string>
#include <vector>

namespace ABF_benchmark {

// Keeps what some parameterizers print out of our tables.
class Silence
{
public:
  Silence() : m_buffer(std::cout.rdbuf(nullptr)) {}
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence()
  {
    std::cout.rdbuf(m_buffer); // clears the error state, too
  }

private:
  std::streambuf* m_buffer;
};

typedef CGAL::Surface_mesh<Chart::Point_3> Mesh;

// The mesh whose vertices have the numbers of those of the chart.
inline Mesh mesh_of_chart(const Chart& chart)
{
  typedef Mesh::Vertex_index Vertex;
  Mesh mesh;
  mesh.reserve(chart.number_of_vertices(), chart.number_of_vertices() + chart.number_of_triangles(),
               chart.number_of_triangles());
  for(const Chart::Point_3& p : chart.points)
    mesh.add_vertex(p);
  for(int c = 0; c < chart.number_of_corners(); c += 3)
    mesh.add_face(Vertex(chart.vertex[c]), Vertex(chart.vertex[c + 1]), Vertex(chart.vertex[c + 2]));
  return mesh;
}

// Any parameterizer on `Surface_mesh`, as it is by default.
template <typename Parameterizer>
struct Parameterizer_method
{
  bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    typedef Mesh::Vertex_index Vertex;
    Mesh mesh = mesh_of_chart(chart);
    const int c = chart.borders.front().front();
    const Mesh::Halfedge_index border =
        mesh.halfedge(Vertex(chart.edge_target(c)), Vertex(chart.edge_source(c)));
    const auto uvmap = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
    const auto parameterized = mesh.add_property_map<Vertex, bool>("v:parameterized", false).first;
    if(report.begin)
      report.begin();
    try {
      const Silence silence;
      const SMP::Error_code status =
          Parameterizer().parameterize(mesh, border, uvmap, get(boost::vertex_index, mesh), parameterized);
      if(status != SMP::OK)
        return fail(report, SMP::get_error_message(status));
    } catch(const std::bad_alloc&) {
      return fail(report, "out of memory");
    } catch(const std::exception& error) {
      return fail(report, std::string("the parameterizer threw an exception: ") + error.what());
    }
    uv.assign(chart.points.size(), Point_2(0, 0));
    for(Vertex v : mesh.vertices())
      uv[v] = uvmap[v];
    return finish(chart, uv, report);
  }
};

template <typename Parameterizer>
Method parameterizer_method(const char* name, const char* title)
{
  return make_method<Parameterizer_method<Parameterizer>>(name, title);
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_PARAMETERIZER_METHOD_H
