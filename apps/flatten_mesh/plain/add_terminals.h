// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ADD_TERMINALS_H
#define FLATTEN_MESH_ADD_TERMINALS_H

#include "flatten_mesh/model/build_mesh.h"

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline bool is_on_seam(const Mesh& mesh, const Edge_marks& seams, const Vertex v)
{
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v))) {
    if(seams[mesh.edge(h)] || mesh.is_border(mesh.edge(h))) {
      return true;
    }
  }
  return false;
}

// Ends a search at the first vertex on a seam or border.
struct Seam_finder : public boost::dijkstra_visitor<>
{
  struct Found
  {
    Vertex vertex;
  };

  Seam_finder(const Mesh& mesh, const Edge_marks& seams) : m_mesh(mesh), m_seams(seams) {}

  void examine_vertex(const Vertex v, const Mesh&) const
  {
    if(is_on_seam(m_mesh, m_seams, v)) {
      throw Found{v};
    }
  }

private:
  const Mesh& m_mesh;
  Edge_marks m_seams;
};

// Marks the shortest path from a vertex to the seams or borders. Returns whether there is one, with an edge at least.
inline bool add_terminal(const Mesh& mesh, const Edge_marks& seams, const Edge_marks& forbidden,
                         const Vertex terminal)
{
  const auto cost = boost::make_function_property_map<Edge>([&](const Edge e) {
    const Halfedge h = mesh.halfedge(e);
    return forbidden[e]
               ? std::numeric_limits<double>::infinity()
               : std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  });
  std::vector<Vertex> predecessors(mesh.number_of_vertices());
  Vertex v = terminal;
  try {
    const auto index = get(boost::vertex_index, mesh);
    boost::dijkstra_shortest_paths(
        mesh, terminal,
        boost::weight_map(cost)
            .visitor(Seam_finder(mesh, seams))
            .predecessor_map(boost::make_iterator_property_map(predecessors.begin(), index)));
    return false;
  } catch(const Seam_finder::Found& found) {
    v = found.vertex;
  }
  if(predecessors[v.idx()] == v) { // on a seam already, or without a way to one
    return false;
  }
  for(; v != terminal; v = predecessors[v.idx()]) {
    seams[mesh.edge(mesh.halfedge(predecessors[v.idx()], v))] = true;
  }
  return true;
}

} // namespace internal

// Joins each of these vertices to the nearest seam or border. Returns the number of vertices that were joined.
inline std::size_t add_terminals(const Mesh& mesh, const Edge_marks& seams, const Edge_marks& forbidden,
                                 const std::vector<Vertex>& vertices)
{
  std::size_t count = 0;
  for(const Vertex v : vertices) {
    count += internal::add_terminal(mesh, seams, forbidden, v);
  }
  return count;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ADD_TERMINALS_H
