// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface opened along seams, as a graph: nodes are the sectors of a vertex between seams, so no path crosses a seam;
// and the topology of what is opened. `shortest_paths.h` searches it. `coarse_seams.h` and `atlas/` open and close
// seams in it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SECTOR_GRAPH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SECTOR_GRAPH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <boost/iterator/iterator_facade.hpp>

#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// A surface opened along seams, as a graph. Its nodes are the sectors between two seams or borders at a vertex of the
// surface. The edge that corner `c` faces leads from the node of the
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

inline std::vector<int> border_nodes(const Sector_graph& surface)
{
  std::vector<int> nodes;
  for(int x = 0; x < surface.number_of_nodes(); ++x)
    if(surface.is_node(x) && surface.is_on_border(x))
      nodes.push_back(x);
  return nodes;
}

// Sets `is_on_border` for each vertex: whether it is on a border or seam
inline void find_border_vertices(const Sector_graph& surface, std::vector<char>& is_on_border)
{
  is_on_border.assign(surface.surface().points.size(), false);
  for(int x = 0; x < surface.number_of_nodes(); ++x)
    if(surface.is_node(x) && surface.is_on_border(x))
      is_on_border[surface.vertex(x)] = true;
}

// The number of the border on which each node is, or -1
inline std::vector<int> number_borders(const Sector_graph& surface, int& count)
{
  std::vector<int> number(surface.number_of_nodes(), -1);
  count = 0;
  for(int x : border_nodes(surface)) {
    if(number[x] >= 0)
      continue;
    const int first = next_corner(surface.first_corner(x));
    int c = first;
    do {
      number[surface.target_node(c)] = count;
      c = surface.next_open(c);
    } while(c != first);
    ++count;
  }
  return number;
}

// The topology of a surface that is connected, also without its seams
struct Topology
{
  explicit Topology(const Sector_graph& surface)
  {
    const Chart& chart = surface.surface();
    int nodes = 0;
    number_borders(surface, borders);
    for(int x = 0; x < surface.number_of_nodes(); ++x)
      nodes += surface.is_node(x);
    for(int c = 0; c < chart.number_of_corners(); ++c)
      border_edges += surface.is_open(c);
    const int edges = (chart.number_of_corners() + border_edges) / 2;
    handles = (2 - borders - nodes + edges - chart.number_of_triangles()) / 2;
  }

  bool is_disk() const { return handles == 0 && borders == 1; }

  // A border of two edges, along a seam of one edge, is not a polygon.
  bool can_be_flattened() const { return is_disk() && border_edges >= 3; }

  int handles, borders = 0, border_edges = 0;
};

// Whether the seams leave disks, and nothing else. The surface may consist of several parts.
inline bool leaves_disks(const Sector_graph& surface)
{
  const Chart& chart = surface.surface();
  const int triangles = chart.number_of_triangles();
  Disjoint_sets parts(triangles);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(!surface.is_open(c))
      parts.union_set(c / 3, chart.opposite[c] / 3);
  std::vector<int> characteristic(triangles, 0), borders(triangles, 0); // of each part, the former twice
  for(int c = 0; c < chart.number_of_corners(); ++c)
    characteristic[parts.find_set(c / 3)] -= surface.is_open(c) ? 2 : 1;
  int count = 0;
  const std::vector<int> border = number_borders(surface, count);
  std::vector<char> is_counted(count, false);
  for(int x = 0; x < surface.number_of_nodes(); ++x)
    if(surface.is_node(x)) {
      const auto part = parts.find_set(surface.first_corner(x) / 3);
      characteristic[part] += 2;
      if(border[x] >= 0 && !is_counted[border[x]]) {
        is_counted[border[x]] = true;
        ++borders[part];
      }
    }
  for(int t = 0; t < triangles; ++t)
    characteristic[parts.find_set(t)] += 2;
  for(int t = 0; t < triangles; ++t)
    if(const auto part = parts.find_set(t); characteristic[part] != 2 || borders[part] != 1)
      return false;
  return true;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SECTOR_GRAPH_H
