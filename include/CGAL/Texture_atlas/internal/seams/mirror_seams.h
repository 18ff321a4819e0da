// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes seams symmetric: those on one side of a plane replace those on the other side. `symmetry_impl.h` calls it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_MIRROR_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_MIRROR_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_objects.h>
#include <CGAL/Texture_atlas/internal/seams/seam_router.h>
#include <CGAL/Texture_atlas/internal/seams/symmetry.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Takes seams away that separate tiny pieces from larger ones. Where mirror images of seams run beside other seams,
// slivers are between them.
class Piece_joining
{
  typedef std::array<std::size_t, 2> Pair;

public:
  Piece_joining(const Triangle_arrays& mesh, const Edge_graph& graph)
      : m_graph(graph), m_faces(graph.ends.size(), {none, none})
  {
    for(std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      m_area.push_back(std::sqrt(mesh.normal(mesh.triangles[t]).squared_length()));
      for(std::size_t i = 0; i < 3; ++i) {
        Pair& faces = m_faces[graph.edge_between(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])];
        faces[faces[0] == none ? 0 : 1] = t;
      }
    }
  }

  // Joins pieces with less than this share of the area to the neighbors with which they have the longest borders.
  void run(double share, std::vector<char>& is_seam) const
  {
    const double least = share * std::accumulate(m_area.begin(), m_area.end(), 0.);
    for(int round = 0; round < most_rounds && join_some(least, is_seam); ++round)
      ;
  }

private:
  // Each piece changes once at most.
  bool join_some(double least, std::vector<char>& is_seam) const
  {
    Disjoint_sets pieces(m_area.size());
    for(std::size_t e = 0; e < is_seam.size(); ++e)
      if(!is_seam[e] && m_faces[e][1] != none)
        pieces.union_set(m_faces[e][0], m_faces[e][1]);
    std::vector<double> area(m_area.size(), 0);
    for(std::size_t t = 0; t < m_area.size(); ++t)
      area[pieces.find_set(t)] += m_area[t];
    std::map<Pair, double> border; // of a small piece and a neighbor
    const auto for_borders = [&](const auto& f) {
      for(std::size_t e = 0; e < is_seam.size(); ++e)
        if(is_seam[e] && m_faces[e][1] != none) {
          const std::size_t a = pieces.find_set(m_faces[e][0]), b = pieces.find_set(m_faces[e][1]);
          if(a != b)
            f(e, a, b);
        }
    };
    for_borders([&](std::size_t e, std::size_t a, std::size_t b) {
      if(area[a] < least)
        border[{a, b}] += m_graph.length(e);
      if(area[b] < least)
        border[{b, a}] += m_graph.length(e);
    });
    const std::vector<std::size_t> partner = partners(border, area);
    bool any = false;
    for_borders([&](std::size_t e, std::size_t a, std::size_t b) {
      if(partner[a] == b) {
        is_seam[e] = false;
        any = true;
      }
    });
    return any;
  }

  // What each piece joins, if anything: the smallest pieces choose first.
  static std::vector<std::size_t> partners(const std::map<Pair, double>& border,
                                           const std::vector<double>& area)
  {
    std::vector<std::array<double, 2>> keys;
    std::vector<Pair> pairs;
    for(const auto& [pair, length] : border) {
      keys.push_back({area[pair[0]], -length});
      pairs.push_back(pair);
    }
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return keys[i] < keys[j]; });
    std::vector<std::size_t> partner(area.size(), none);
    for(std::size_t i : order) {
      const auto [a, b] = pairs[i];
      if(partner[a] == none && partner[b] == none) {
        partner[a] = b;
        partner[b] = a;
      }
    }
    return partner;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr int most_rounds = 10;

  const Edge_graph& m_graph;
  std::vector<Pair> m_faces;  // at each edge
  std::vector<double> m_area; // of each triangle, twice
};

// Draws the seams on one side of the plane again on the other one.
class Seam_mirror
{
public:
  // `may_be_seam` says for each edge whether it may be one.
  Seam_mirror(const Triangle_arrays& mesh, const Edge_graph& graph, const Mirror_plane& plane,
              const std::vector<char>& may_be_seam)
      : m_mesh(mesh), m_graph(graph), m_plane(plane), m_may_be_seam(may_be_seam),
        m_side(sides_of_vertices(graph, plane)), m_surface(mesh.proper_triangles()), m_router(graph),
        m_width(width * diagonal_of(mesh.points))
  {}

  const std::vector<signed char>& sides() const { return m_side; }

  // The seams, for each edge whether it is one, with those on side `kept`, -1 or 1, on both sides
  std::vector<char> run(const std::vector<char>& is_seam, int kept)
  {
    m_result.assign(is_seam.size(), false);
    for(std::size_t e = 0; e < is_seam.size(); ++e)
      m_result[e] = is_seam[e] && is_on_plane(e);
    for(int side : {kept, -kept})
      for(const Path& path : paths(is_seam, side))
        if(runs_along_plane(path))
          mark(along_plane(path));
        else if(side == kept) {
          mark(path.edges);
          mark(mirrored(path));
        }
    Piece_joining(m_mesh, m_graph).run(smallest_piece, m_result);
    return std::move(m_result);
  }

private:
  struct Path
  {
    std::vector<std::size_t> edges, vertices;
  };

  bool is_on_plane(std::size_t e) const
  {
    return m_side[m_graph.ends[e][0]] == 0 && m_side[m_graph.ends[e][1]] == 0;
  }

  void mark(const std::vector<std::size_t>& edges)
  {
    for(std::size_t e : edges)
      m_result[e] = true;
  }

  // The seams on one side, from branch to branch, end or the plane. A closed seam is divided.
  std::vector<Path> paths(const std::vector<char>& is_seam, int side) const
  {
    std::vector<char> is_here(is_seam.size(), false);
    std::vector<int> degree(m_graph.points.size(), 0);
    for(std::size_t e = 0; e < is_seam.size(); ++e) {
      const auto [a, b] = m_graph.ends[e];
      is_here[e] = is_seam[e] && !is_on_plane(e) && m_side[a] != -side && m_side[b] != -side;
      degree[a] += is_here[e];
      degree[b] += is_here[e];
    }
    const auto is_end = [&](std::size_t v) { return degree[v] != 2 || m_side[v] == 0; };
    std::vector<Path> result;
    for(std::size_t v = 0; v < degree.size(); ++v)
      if(degree[v] > 0 && is_end(v))
        m_graph.for_edges_at(v, [&](std::size_t e) {
          if(is_here[e])
            add(follow(e, v, is_end, is_here), result);
        });
    for(std::size_t e = 0; e < is_here.size(); ++e)
      if(is_here[e])
        add(follow(e, m_graph.ends[e][0], is_end, is_here), result);
    return result;
  }

  // Takes the edges of the path away from `is_here`.
  template <typename Is_end>
  Path follow(std::size_t e, std::size_t v, const Is_end& is_end, std::vector<char>& is_here) const
  {
    Path path{{}, {v}};
    for(bool goes_on = true; goes_on;) {
      is_here[e] = false;
      v = m_graph.other_end(e, v);
      path.edges.push_back(e);
      path.vertices.push_back(v);
      goes_on = false;
      if(!is_end(v))
        m_graph.for_edges_at(v, [&](std::size_t next) {
          if(is_here[next]) {
            e = next;
            goes_on = true;
          }
        });
    }
    return path;
  }

  // A closed path in three parts, so that the ends of each differ
  static void add(const Path& path, std::vector<Path>& result)
  {
    const std::size_t n = path.edges.size();
    if(path.vertices.front() != path.vertices.back() || n < 3) {
      result.push_back(path);
      return;
    }
    for(std::size_t i = 0; i < 3; ++i) {
      const auto first = static_cast<std::ptrdiff_t>(i * n / 3),
                 last = static_cast<std::ptrdiff_t>((i + 1) * n / 3);
      result.push_back({{path.edges.begin() + first, path.edges.begin() + last},
                        {path.vertices.begin() + first, path.vertices.begin() + last + 1}});
    }
  }

  // Its mirror image would run beside it.
  bool runs_along_plane(const Path& path) const
  {
    return m_side[path.vertices.front()] == 0 && m_side[path.vertices.back()] == 0 &&
           std::all_of(path.vertices.begin(), path.vertices.end(),
                       [&](std::size_t v) { return std::abs(m_plane.height(m_graph.points[v])) <= m_width; });
  }

  std::vector<std::size_t> along_plane(const Path& path)
  {
    return route(path.vertices.front(), path.vertices.back(), line(path, false),
                 [&](std::size_t v) { return m_side[v] == 0; });
  }

  std::vector<std::size_t> mirrored(const Path& path)
  {
    const int side = m_side[*std::find_if(path.vertices.begin(), path.vertices.end(),
                                          [&](std::size_t v) { return m_side[v] != 0; })];
    return route(mirrored(path.vertices.front()), mirrored(path.vertices.back()), line(path, true),
                 [&](std::size_t v) { return m_side[v] != side; });
  }

  template <typename Is_allowed>
  std::vector<std::size_t> route(std::size_t from, std::size_t to, const Seam_router::Line& line,
                                 const Is_allowed& is_allowed)
  {
    return from == to ? std::vector<std::size_t>()
                      : m_router.path(from, to, line, m_width / 4, is_allowed,
                                      [&](std::size_t e) { return m_may_be_seam[e] != 0; });
  }

  Seam_router::Line line(const Path& path, bool is_mirrored) const
  {
    Seam_router::Line result;
    for(std::size_t v : path.vertices)
      result.push_back(is_mirrored ? m_plane.mirrored(m_graph.points[v]) : m_graph.points[v]);
    return result;
  }

  // The vertex nearest to the mirror image, of those of the triangle that is nearest to it
  std::size_t mirrored(std::size_t v) const
  {
    if(m_side[v] == 0)
      return v;
    const Seam_kernel::Point_3 image = m_plane.mirrored(m_graph.points[v]);
    const auto& t = m_mesh.triangles[m_surface.object(image)];
    return *std::min_element(t.begin(), t.end(), [&](std::size_t a, std::size_t b) {
      return CGAL::squared_distance(m_graph.points[a], image) <
             CGAL::squared_distance(m_graph.points[b], image);
    });
  }

  static constexpr double width = 0.02;           // in units of the diagonal
  static constexpr double smallest_piece = 0.002; // as a share of the area

  const Triangle_arrays& m_mesh;
  const Edge_graph& m_graph;
  const Mirror_plane m_plane;
  const std::vector<char>& m_may_be_seam;
  const std::vector<signed char> m_side; // of each vertex
  const Nearest_objects<Seam_kernel::Triangle_3> m_surface;
  Seam_router m_router;
  const double m_width;
  std::vector<char> m_result;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_MIRROR_SEAMS_H
