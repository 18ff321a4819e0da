// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_COMPONENTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_COMPONENTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
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

// The faces of each component, the largest component first.
inline std::vector<std::vector<Face>> components_by_size(Mesh& mesh)
{
  auto component = mesh.add_property_map<Face, Index>("f:flatten_mesh_component", 0).first;
  std::vector<std::vector<Face>> components(
      CGAL::Polygon_mesh_processing::connected_components(mesh, component));
  for(const Face f : mesh.faces()) {
    components[component[f]].push_back(f);
  }
  mesh.remove_property_map(component);
  for(std::vector<Face>& faces : components) {
    faces.shrink_to_fit();
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return components;
}

// Whether each component is a disk, perhaps with holes: by Euler's formula, whether it has a border and no handle.
inline std::vector<bool> are_disks(const Mesh& mesh, const std::vector<std::vector<Face>>& components)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  for(std::size_t c = 0; c < components.size(); ++c) {
    for(const Face f : components[c]) {
      component[f.idx()] = c;
    }
  }
  const auto component_of = [&](const Halfedge h) {
    return component[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h).idx()];
  };
  std::vector<long long> characteristic(components.size(), 0), borders(components.size(), 0);
  for(const Vertex v : mesh.vertices()) {
    if(!mesh.is_isolated(v)) {
      ++characteristic[component_of(mesh.halfedge(v))];
    }
  }
  for(const Mesh::Edge_index e : mesh.edges()) {
    --characteristic[component_of(mesh.halfedge(e))];
  }
  std::vector<bool> is_seen(mesh.number_of_halfedges(), false);
  for(const Halfedge first : mesh.halfedges()) {
    if(mesh.is_border(first) && !is_seen[first.idx()]) {
      ++borders[component_of(first)];
      for(Halfedge h = first; !is_seen[h.idx()]; h = mesh.next(h)) {
        is_seen[h.idx()] = true;
      }
    }
  }
  std::vector<bool> result;
  for(std::size_t c = 0; c < components.size(); ++c) {
    const long long faces = static_cast<long long>(components[c].size());
    result.push_back(borders[c] > 0 && characteristic[c] + faces + borders[c] == 2);
  }
  return result;
}

// Whether a component, numbered by falling number of faces, has a border and no handles.
inline bool is_disk_with_holes(Mesh& mesh, const std::size_t component)
{
  return are_disks(mesh, components_by_size(mesh))[component];
}

// By rising number
inline std::vector<Vertex> vertices_of_faces(const Mesh& mesh, const std::vector<Face>& faces)
{
  std::vector<bool> is_used(mesh.number_of_vertices(), false);
  for(const Face f : faces) {
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      is_used[v.idx()] = true;
    }
  }
  std::vector<Vertex> vertices;
  std::copy_if(mesh.vertices_begin(), mesh.vertices_end(), std::back_inserter(vertices),
               [&is_used](const Vertex v) { return is_used[v.idx()]; });
  return vertices;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_COMPONENTS_H
