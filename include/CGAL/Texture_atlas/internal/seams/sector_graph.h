// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface opened along seams, as a graph for Boost: nodes are the sectors of a vertex between seams, so no path
// crosses a seam. `shortest_paths.h` searches it. `repair_cut.h`, `coarse_seams.h` and `atlas/` open and close seams in
// it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SECTOR_GRAPH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SECTOR_GRAPH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// A surface opened along seams, as an `IncidenceGraph` of Boost.Graph. Its vertices are the sectors between two seams
// or borders at a vertex of the surface, here called nodes. The edge that corner `c` faces leads from the node of the
// next corner to that of the previous one; there are none along seams and borders.
class Sector_graph
{
public:
  explicit Sector_graph(const Chart& surface)
      : m_surface(&surface), m_is_seam(surface.vertex.size(), false), m_node(surface.vertex.size(), -1)
  {
    for(int c = 0; c < surface.number_of_corners(); ++c)
      if(m_node[c] < 0)
        number_sector(first_of_sector(c), new_node());
  }

  const Chart& surface() const { return *m_surface; }
  bool is_seam(int c) const { return m_is_seam[c]; }

  // Whether the edge that the corner faces is a seam, or on a border of the surface
  bool is_open(int c) const { return m_is_seam[c] || m_surface->opposite[c] < 0; }

  int number_of_nodes() const { return static_cast<int>(m_first_corner.size()); }
  int node(int c) const { return m_node[c]; }
  bool is_node(int x) const { return m_first_corner[x] >= 0; } // numbers may be unused
  int first_corner(int x) const { return m_first_corner[x]; }  // in clockwise order
  int vertex(int x) const { return m_surface->vertex[m_first_corner[x]]; }
  bool is_on_border(int x) const { return is_open(next_corner(m_first_corner[x])); }
  int source_node(int c) const { return m_node[next_corner(c)]; }
  int target_node(int c) const { return m_node[previous_corner(c)]; }

  // The next corner of the sector, or -1
  int rotate(int c) const { return is_open(previous_corner(c)) ? -1 : m_surface->rotate(c); }

  // The next one on a border of the opened surface, as `next_on_border()` gives it for charts
  int next_open(int c) const
  {
    int corner = previous_corner(c);
    for(int next = rotate(corner); next >= 0; next = rotate(corner))
      corner = next;
    return previous_corner(corner);
  }

  void set_seam(int c, bool is_seam)
  {
    m_is_seam[c] = m_is_seam[m_surface->opposite[c]] = is_seam;
    renumber(next_corner(c));
    renumber(previous_corner(c));
  }

  // The seams from the vertex of a corner, named by the corners that face them
  std::vector<int> seams_at(int corner) const
  {
    std::vector<int> seams;
    for_corners_around(*m_surface, corner, [&](int c) {
      if(m_is_seam[previous_corner(c)])
        seams.push_back(previous_corner(c));
    });
    return seams;
  }

  int number_of_seams_at(int corner) const
  {
    int number = 0;
    for_corners_around(*m_surface, corner, [&](int c) { number += m_is_seam[previous_corner(c)]; });
    return number;
  }

  // The edges at a node: the corner that faces the edge to the vertex of the next corner is the previous one.
  class Out_edge_iterator
      : public boost::iterator_facade<Out_edge_iterator, int, boost::forward_traversal_tag, int>
  {
  public:
    Out_edge_iterator() = default;
    Out_edge_iterator(const Sector_graph& surface, int first)
        : m_surface(&surface), m_first(first), m_corner(first)
    {
      if(first >= 0 && surface.is_open(previous_corner(first)))
        m_corner = -1;
    }

  private:
    friend class boost::iterator_core_access;

    int dereference() const { return previous_corner(m_corner); }
    bool equal(const Out_edge_iterator& other) const { return m_corner == other.m_corner; }
    void increment()
    {
      m_corner = m_surface->rotate(m_corner);
      if(m_corner == m_first || m_surface->is_open(previous_corner(m_corner)))
        m_corner = -1;
    }

    const Sector_graph* m_surface = nullptr;
    int m_first = -1, m_corner = -1;
  };

private:
  int first_of_sector(int c) const
  {
    int first = c;
    do {
      if(is_open(next_corner(first)))
        return first;
      first = next_corner(m_surface->opposite[next_corner(first)]);
    } while(first != c);
    return c;
  }

  int new_node()
  {
    if(m_unused.empty()) {
      m_first_corner.push_back(-1);
      return number_of_nodes() - 1;
    }
    const int x = m_unused.back();
    m_unused.pop_back();
    return x;
  }

  void number_sector(int first, int x)
  {
    m_first_corner[x] = first;
    int c = first;
    do {
      m_node[c] = x;
      c = rotate(c);
    } while(c >= 0 && c != first);
  }

  // Numbers the sectors at the vertex of a corner again.
  void renumber(int corner)
  {
    for_corners_around(*m_surface, corner, [&](int c) {
      if(const int x = m_node[c]; x >= 0 && m_first_corner[x] >= 0) {
        m_first_corner[x] = -1;
        m_unused.push_back(x);
      }
      m_node[c] = -1;
    });
    for_corners_around(*m_surface, corner, [&](int c) {
      if(m_node[c] < 0)
        number_sector(first_of_sector(c), new_node());
    });
  }

  const Chart* m_surface;
  std::vector<char> m_is_seam; // of each corner: that of the edge that it faces
  std::vector<int> m_node;     // of each corner
  std::vector<int> m_first_corner;
  std::vector<int> m_unused;
};

inline std::pair<Sector_graph::Out_edge_iterator, Sector_graph::Out_edge_iterator>
out_edges(int x, const Sector_graph& surface)
{
  const int first = surface.first_corner(x);
  return {Sector_graph::Out_edge_iterator(surface, first), Sector_graph::Out_edge_iterator(surface, -1)};
}

inline std::size_t out_degree(int x, const Sector_graph& surface)
{
  const auto [begin, end] = out_edges(x, surface);
  return std::distance(begin, end);
}

inline int source(int c, const Sector_graph& surface)
{
  return surface.source_node(c);
}

inline int target(int c, const Sector_graph& surface)
{
  return surface.target_node(c);
}

inline std::size_t num_vertices(const Sector_graph& surface)
{
  return surface.number_of_nodes();
}

} // namespace CGAL::Texture_atlas::internal

template <>
struct boost::graph_traits<CGAL::Texture_atlas::internal::Sector_graph>
{
  typedef int vertex_descriptor, edge_descriptor;
  typedef boost::directed_tag directed_category;
  typedef boost::allow_parallel_edge_tag edge_parallel_category;
  typedef boost::incidence_graph_tag traversal_category;
  typedef CGAL::Texture_atlas::internal::Sector_graph::Out_edge_iterator out_edge_iterator;
  typedef std::size_t degree_size_type, vertices_size_type;

  static int null_vertex() { return -1; }
};

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SECTOR_GRAPH_H
