// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_TERMINAL_CHOICES_H
#define ABF_BENCHMARK_TERMINAL_CHOICES_H

#include "read_mesh.h"

#include <CGAL/Texture_atlas/select_seams.h>

#include <CGAL/number_utils.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace ABF_benchmark {

typedef Mesh::Property_map<Mesh::Edge_index, bool> Seam_map;

inline void check(const CGAL::Texture_atlas::Seam_report& report)
{
  if(!report)
    throw std::runtime_error(report.message);
}

// Seams of a connected surface with other terminals than those of `select_seams()`. The rest is the same: cut to a disk
// first, joined by shortest paths one after the other, shortened in the end. The path that cuts a sphere has two
// terminals.
class Terminal_choice
{
public:
  Terminal_choice(const Mesh& mesh, Seam_map seams)
      : m_mesh(mesh), m_seams(seams), m_lengths(mesh.number_of_edges()),
        m_distances(mesh.number_of_vertices()), m_previous(mesh.number_of_vertices())
  {
    for(const Mesh::Edge_index e : mesh.edges())
      m_lengths[e] = CGAL::Polygon_mesh_processing::edge_length(mesh.halfedge(e), mesh);
  }

  // Each terminal is the vertex farthest from the seams.
  void add_farthest_points(const int terminals)
  {
    check(CGAL::Texture_atlas::cut_to_disks(m_mesh, m_seams));
    add_terminals(is_sphere() ? terminals - 2 : terminals, [&](const Mesh::Vertex_index v) {
      return m_distances[v] < unreached ? m_distances[v] : 0;
    });
  }

  // In the manner of Seamster: each terminal is the vertex of the largest absolute angle defect that is not near the
  // seams, where near is half the radius of so many disks as large as the surface.
  void add_curvature_peaks(const int terminals)
  {
    const double near =
        std::sqrt(CGAL::Polygon_mesh_processing::area(m_mesh) / (CGAL_PI * (terminals + 1))) / 2;
    const std::vector<double> defects = absolute_defects();
    const Rank rank = [&](const Mesh::Vertex_index v) {
      return m_distances[v] > near && m_distances[v] < unreached ? defects[v] : 0;
    };
    if(is_sphere()) {
      const auto highest = std::max_element(defects.begin(), defects.end());
      find_distances({Mesh::Vertex_index(static_cast<unsigned>(highest - defects.begin()))}, m_lengths);
      add_path_to(best_vertex(rank));
    } else
      check(CGAL::Texture_atlas::cut_to_disks(m_mesh, m_seams));
    add_terminals(is_sphere() ? terminals - 2 : terminals, rank);
  }

private:
  typedef std::function<double(Mesh::Vertex_index)> Rank; // 0 for vertices that must not be terminals

  static constexpr double unreached = std::numeric_limits<double>::infinity();

  bool is_sphere() const
  {
    return CGAL::is_closed(m_mesh) &&
           m_mesh.number_of_vertices() + m_mesh.number_of_faces() == m_mesh.number_of_edges() + 2;
  }

  void add_terminals(const int terminals, const Rank& rank)
  {
    for(int i = 0; i < terminals; ++i) {
      find_distances_from_seams();
      add_path_to(best_vertex(rank));
    }
    check(CGAL::Texture_atlas::shorten_seams(m_mesh, m_seams));
  }

  // Paths avoid the ends of others: these remain ends, which shortening keeps.
  void find_distances_from_seams()
  {
    std::vector<Mesh::Vertex_index> sources;
    std::vector<double> lengths = m_lengths;
    for(const Mesh::Vertex_index v : m_mesh.vertices()) {
      int seams = 0;
      for(const Mesh::Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        seams += m_seams[m_mesh.edge(h)];
      if(m_mesh.is_border(v) || seams > 1)
        sources.push_back(v);
      else if(seams == 1)
        for(const Mesh::Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
          lengths[m_mesh.edge(h)] = unreached;
    }
    find_distances(sources, lengths);
  }

  void find_distances(const std::vector<Mesh::Vertex_index>& sources, const std::vector<double>& lengths)
  {
    const auto index = get(boost::vertex_index, m_mesh);
    boost::dijkstra_shortest_paths(
        m_mesh, sources.begin(), sources.end(), boost::make_iterator_property_map(m_previous.begin(), index),
        boost::make_iterator_property_map(m_distances.begin(), index),
        boost::make_iterator_property_map(lengths.begin(), get(boost::edge_index, m_mesh)), index,
        std::less<double>(), std::plus<double>(), unreached, 0., boost::dijkstra_visitor<>());
  }

  Mesh::Vertex_index best_vertex(const Rank& rank) const
  {
    Mesh::Vertex_index best(0);
    for(const Mesh::Vertex_index v : m_mesh.vertices())
      if(rank(v) > rank(best))
        best = v;
    if(!(rank(best) > 0))
      throw std::runtime_error("no vertex is left that can be a terminal");
    return best;
  }

  void add_path_to(Mesh::Vertex_index v)
  {
    for(; m_previous[v] != v; v = m_previous[v])
      m_seams[m_mesh.edge(m_mesh.halfedge(v, m_previous[v]))] = true;
  }

  std::vector<double> absolute_defects() const
  {
    std::vector<double> defects(m_mesh.number_of_vertices());
    for(const Mesh::Vertex_index v : m_mesh.vertices()) {
      if(m_mesh.is_border(v))
        continue;
      double sum = 0; // in degrees
      for(const Mesh::Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        sum += CGAL::approximate_angle(m_mesh.point(m_mesh.source(h)), m_mesh.point(v),
                                       m_mesh.point(m_mesh.target(m_mesh.next(h))));
      defects[v] = std::abs(360 - sum);
    }
    return defects;
  }

  const Mesh& m_mesh;
  Seam_map m_seams;
  std::vector<double> m_lengths;   // of each edge
  std::vector<double> m_distances; // of each vertex from the nearest source
  std::vector<Mesh::Vertex_index> m_previous;
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_TERMINAL_CHOICES_H
