// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes seams symmetric: those on one side of a plane replace those on the other side. `symmetry_impl.h` calls it.
//
// A plane of symmetry, and on which side of it vertices are. `symmetry.h` offers what is computed with it, by
// `symmetry_impl.h` and `mirror_seams.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_MIRROR_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_MIRROR_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>
#include <CGAL/Texture_atlas/internal/seams/join_small_regions.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_seams.h>
#include <CGAL/Texture_atlas/internal/seams/seam_router.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

struct Mirror_plane
{
  Seam_kernel::Vector_3 normal{1, 0, 0}; // of length 1
  double offset = 0;                     // of the points of the plane along the normal
  double deviation = 0;                  // the root mean square distance of the mirror image from the surface

  double height(const Seam_kernel::Point_3& p) const { return normal * (p - CGAL::ORIGIN) - offset; }
  Seam_kernel::Point_3 mirrored(const Seam_kernel::Point_3& p) const { return p - 2 * height(p) * normal; }
};

inline double diagonal_of(const std::vector<Seam_kernel::Point_3>& points)
{
  CGAL::Bbox_3 box;
  for(const Seam_kernel::Point_3& p : points)
    box += p.bbox();
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

// On which side of the plane each vertex is: -1, 1, or 0. Of two vertices on different sides of the plane that an edge
// joins, the nearer one counts as on the plane.
inline std::vector<signed char> sides_of_vertices(const Edge_graph& graph, const Mirror_plane& plane)
{
  std::vector<double> height;
  for(const Seam_kernel::Point_3& p : graph.points)
    height.push_back(plane.height(p));
  std::vector<signed char> side;
  for(double h : height)
    side.push_back(static_cast<signed char>((h > 0) - (h < 0)));
  for(const auto& [a, b] : graph.ends)
    if(height[a] * height[b] < 0)
      side[std::abs(height[b]) < std::abs(height[a]) ? b : a] = 0;
  return side;
}

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
    Region_joining(m_mesh, m_graph).run(smallest_region, m_result);
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

  static constexpr double width = 0.02;            // in units of the diagonal
  static constexpr double smallest_region = 0.002; // as a share of the area

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
