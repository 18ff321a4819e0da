// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CUT_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CUT_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Some faces of a mesh, cut open along its seams, as a mesh of its own. Its faces have the order of those it is made
// of; its vertices, too, and the further copies of vertices on seams come last.
struct Cut_mesh
{
  Mesh mesh;
  std::vector<Vertex> origins;    // of each vertex: the vertex it is a copy of
  std::vector<Edge> edge_origins; // of each edge: the edge it is a copy of, or one side of
  std::vector<Vertex> copies;     // of each halfedge before the cut: the copy of its target in its face
};

// Gives each sector of a vertex, from seam to seam or border, a copy of the vertex.
template <class Is_seam>
class Vertex_splitter
{
public:
  Vertex_splitter(const Mesh& mesh, const Is_seam& is_seam, Cut_mesh& result)
      : m_mesh(mesh), m_is_seam(is_seam), m_result(result)
  {
    m_result.copies.resize(mesh.number_of_halfedges());
  }

  void add_vertex(const Vertex v)
  {
    bool is_first = true;
    for(const Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v))) {
      if(m_mesh.is_border(h) || !is_cut(h)) {
        continue;
      }
      if(is_first) {
        add_sector(h);
      } else {
        m_later.push_back(h);
      }
      is_first = false;
    }
    if(is_first) {
      add_sector(m_mesh.halfedge(v));
    }
  }

  void add_further_copies()
  {
    for(const Halfedge start : m_later) {
      add_sector(start);
    }
  }

private:
  bool is_cut(const Halfedge h) const
  {
    const Edge e = m_mesh.edge(h);
    return m_mesh.is_border(e) || get(m_is_seam, e);
  }

  void add_sector(const Halfedge start)
  {
    const Vertex origin = m_mesh.target(start), copy = m_result.mesh.add_vertex(m_mesh.point(origin));
    m_result.origins.push_back(origin);
    Halfedge h = start;
    do {
      m_result.copies[h.idx()] = copy;
      h = m_mesh.opposite(m_mesh.next(h));
    } while(h != start && !is_cut(h));
  }

  const Mesh& m_mesh;
  const Is_seam& m_is_seam;
  Cut_mesh& m_result;
  std::vector<Halfedge> m_later; // first halfedges of further sectors
};

inline void add_cut_faces(const Mesh& mesh, const std::vector<Face>& faces, Cut_mesh& result)
{
  std::vector<std::array<Vertex, 3>> corners;
  const auto copy = [&result](const Halfedge h) { return result.copies[h.idx()]; };
  for(const Face f : faces) {
    const Halfedge h = mesh.halfedge(f);
    corners.push_back({copy(h), copy(mesh.next(h)), copy(mesh.next(mesh.next(h)))});
  }
  CGAL::Euler::add_faces(corners, result.mesh);
  result.edge_origins.resize(result.mesh.number_of_edges());
  for(std::size_t i = 0; i < faces.size(); ++i) {
    for(const Halfedge side : mesh.halfedges_around_face(mesh.halfedge(faces[i]))) {
      Halfedge h = result.mesh.halfedge(Face(static_cast<Mesh::size_type>(i)));
      while(result.mesh.target(h) != copy(side)) {
        h = result.mesh.next(h);
      }
      result.edge_origins[result.mesh.edge(h).idx()] = mesh.edge(side);
    }
  }
}

// Cuts along the edges for which `is_seam` is true. `vertices` are those of the faces, all faces of some components.
// A seam must not consist of a single edge off the border.
template <class Is_seam>
Cut_mesh cut_open(const Mesh& mesh, const std::vector<Face>& faces, const std::vector<Vertex>& vertices,
                  const Is_seam& is_seam)
{
  Cut_mesh result;
  Vertex_splitter<Is_seam> splitter(mesh, is_seam, result);
  for(const Vertex v : vertices) {
    splitter.add_vertex(v);
  }
  splitter.add_further_copies();
  add_cut_faces(mesh, faces, result);
  return result;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CUT_MESH_H
