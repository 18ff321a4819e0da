// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_SCENES_H
#define ANGLE_BASED_FLATTENING_SCENES_H

#include "seam_surfaces.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Meshes for functions that must change nothing if they fail.
namespace scenes {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

// A mesh with all property maps that functions write, and what they were before.
struct Scene
{
  explicit Scene(Mesh surface)
      : mesh(std::move(surface)), uv(mesh.add_property_map<Vertex, Point_2>("v:uv", untouched).first),
        corner_uv(mesh.add_property_map<Halfedge, Point_2>("h:uv", untouched).first),
        seams(mesh.add_property_map<Edge, bool>("e:seam", false).first),
        charts(mesh.add_property_map<Face, int>("f:chart", -17).first), before(state())
  {}

  typedef std::tuple<std::vector<Point_3>, std::vector<Halfedge>, std::vector<std::string>> Input;
  typedef std::tuple<std::vector<Point_2>, std::vector<bool>, std::vector<int>> Output;

  Input input() const
  {
    Input result;
    for(Vertex v : mesh.vertices())
      std::get<0>(result).push_back(mesh.point(v));
    for(Halfedge h : mesh.halfedges()) {
      std::get<1>(result).push_back(mesh.next(h));
      std::get<1>(result).push_back(mesh.halfedge(mesh.target(h)));
    }
    for(const auto& names : {mesh.properties<Vertex>(), mesh.properties<Halfedge>(), mesh.properties<Edge>(),
                             mesh.properties<Face>()})
      std::get<2>(result).insert(std::get<2>(result).end(), names.begin(), names.end());
    return result;
  }

  Output output() const
  {
    Output result;
    for(Vertex v : mesh.vertices())
      std::get<0>(result).push_back(uv[v]);
    for(Halfedge h : mesh.halfedges())
      std::get<0>(result).push_back(corner_uv[h]);
    for(Edge e : mesh.edges())
      std::get<1>(result).push_back(seams[e]);
    for(Face f : mesh.faces())
      std::get<2>(result).push_back(charts[f]);
    return result;
  }

  std::pair<Input, Output> state() const { return {input(), output()}; }

  void clear()
  {
    for(Vertex v : mesh.vertices())
      uv[v] = untouched;
    for(Halfedge h : mesh.halfedges())
      corner_uv[h] = untouched;
    for(Edge e : mesh.edges())
      seams[e] = false;
    for(Face f : mesh.faces())
      charts[f] = -17;
  }

  static constexpr double away = -17;
  const Point_2 untouched{away, away};
  Mesh mesh;
  Mesh::Property_map<Vertex, Point_2> uv;
  Mesh::Property_map<Halfedge, Point_2> corner_uv;
  Mesh::Property_map<Edge, bool> seams;
  Mesh::Property_map<Face, int> charts;
  std::pair<Input, Output> before;
};

// Two parts, which are flattened at the same time if there are several threads
inline Mesh sphere_and_torus()
{
  Mesh mesh = seam_surfaces::sphere(1).mesh<Mesh>();
  for(Vertex v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(5, 0, 0);
  mesh += seam_surfaces::torus(8, 6).mesh<Mesh>();
  return mesh;
}

} // namespace scenes

#endif // ANGLE_BASED_FLATTENING_SCENES_H
