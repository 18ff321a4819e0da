// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_MESH_OF_CHART_H
#define ANGLE_BASED_FLATTENING_MESH_OF_CHART_H

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <vector>

namespace test_charts {

// Makes the mesh of a chart, corner by corner: with everything that functions for polygons refuse, such as parallel
// edges and pinched vertices. Vertices and faces are in the order of the chart.
template <typename Mesh>
void make_mesh(const CGAL::Surface_mesh_parameterization::internal::ABF::Chart& chart, Mesh& mesh)
{
  namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
  typedef boost::graph_traits<Mesh> Graph_traits;
  typedef typename boost::property_map<Mesh, CGAL::vertex_point_t>::type Point_map;
  typedef typename boost::property_traits<Point_map>::value_type Point;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

  std::vector<typename Graph_traits::vertex_descriptor> vertices;
  for(const auto& p : chart.points) {
    vertices.push_back(add_vertex(mesh));
    put(CGAL::vertex_point, mesh, vertices.back(), Point(p.x(), p.y(), p.z()));
  }

  std::vector<halfedge_descriptor> faced(chart.vertex.size()); // of each corner: within its triangle
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    const int across = chart.opposite[c];
    faced[c] = across < 0 || across > c ? halfedge(add_edge(mesh), mesh) : opposite(faced[across], mesh);
    set_target(faced[c], vertices[chart.edge_target(c)], mesh);
    set_halfedge(vertices[chart.edge_target(c)], faced[c], mesh);
  }
  for(int c = 0; c < chart.number_of_corners(); c += 3) {
    const auto face = add_face(mesh);
    set_halfedge(face, faced[c], mesh);
    for(int corner : {c, c + 1, c + 2}) {
      set_face(faced[corner], face, mesh);
      set_next(faced[corner], faced[abf::next_corner(corner)], mesh);
    }
  }
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(chart.opposite[c] < 0) {
      const halfedge_descriptor border = opposite(faced[c], mesh);
      set_face(border, Graph_traits::null_face(), mesh);
      set_target(border, vertices[chart.edge_source(c)], mesh);
      set_halfedge(vertices[chart.edge_source(c)], border, mesh);
      set_next(opposite(faced[abf::next_on_border(chart, c)], mesh), border, mesh);
    }
}

template <typename Mesh>
Mesh mesh_of_chart(const CGAL::Surface_mesh_parameterization::internal::ABF::Chart& chart)
{
  Mesh mesh;
  make_mesh(chart, mesh);
  return mesh;
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_MESH_OF_CHART_H
