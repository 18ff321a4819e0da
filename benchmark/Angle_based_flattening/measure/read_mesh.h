// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_READ_MESH_H
#define ABF_BENCHMARK_READ_MESH_H

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <stdexcept>
#include <string>

namespace ABF_benchmark {

namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;

// The type of coarse charts, so that their parameterizers are not compiled twice
typedef CGAL::Surface_mesh<abf::Chart::Point_3> Mesh;

// A surface with a border, and the map that a method makes of it
struct Surface
{
  typedef Mesh::Property_map<Mesh::Vertex_index, abf::Chart::Point_2> UV_map;

  Mesh mesh;
  Mesh::Halfedge_index border;
  UV_map uv;
};

template <class Mesh_>
void read_mesh(const std::string& file, Mesh_& mesh)
{
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("cannot read a triangle mesh from '" + file + "'");
}

// The chart of the component with the longest border
template <class Mesh_>
abf::Chart read_chart(const Mesh_& mesh)
{
  abf::Chart_reader<Mesh_> reader(mesh);
  if(const auto defect = reader.read(CGAL::Polygon_mesh_processing::longest_border(mesh).first))
    throw std::runtime_error("the mesh cannot be flattened: " + defect.message);
  return reader.chart;
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_READ_MESH_H
