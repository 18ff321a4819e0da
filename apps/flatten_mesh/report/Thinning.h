// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_THINNING_H
#define FLATTEN_MESH_THINNING_H

#include "flatten_mesh/report/Wedge_mesh.h"
#include "flatten_mesh/report/link_corners.h"
#include "flatten_mesh/report/measure_triangles.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/collapse_cost.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

namespace flatten_mesh {

// A chart whose vertices are the fans of triangles around the wedges of a mesh
struct Fan_chart
{
  abf::Chart chart;
  std::vector<int> wedges;            // of its vertices
  std::vector<std::size_t> triangles; // of the mesh, of each triangle
};

namespace internal {

// In an order in which neighbours are close together in memory: else jumps would take most of the time.
inline std::vector<std::size_t> triangles_along_curve(const Wedge_mesh& mesh)
{
  std::vector<std::size_t> triangles(mesh.triangles.size());
  std::iota(triangles.begin(), triangles.end(), std::size_t(0));
  const auto point = boost::make_function_property_map<std::size_t>(
      [&mesh](const std::size_t t) { return mesh.points[mesh.wedge_points[mesh.triangles[t][0]]]; });
  CGAL::hilbert_sort(triangles.begin(), triangles.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(point)>(point),
                     CGAL::Hilbert_sort_middle_policy());
  return triangles;
}

} // namespace internal

inline Fan_chart fan_chart(const Wedge_mesh& mesh)
{
  Fan_chart result{chart_of_wedges(mesh), {}, internal::triangles_along_curve(mesh)};
  auto corner = result.chart.vertex.begin();
  for(const std::size_t t : result.triangles) {
    corner = std::copy(mesh.triangles[t].begin(), mesh.triangles[t].end(), corner);
  }
  link_corners(result.chart);
  result.wedges = separate_fans(result.chart);
  abf::find_borders(result.chart);
  return result;
}

// Removes vertices of a surface until few enough triangles are left for display. Each is merged into a neighbour, as
// the package does to solve large charts: CGAL's simplification takes about ten times as long. Wedges on the borders of
// charts stay, and so both sides of seams do. What is left keeps its places on the surface and in the plane. No
// triangle turns over in the plane.
class Thinning
{
public:
  // The triangles `kept` stay as they are.
  Thinning(const Wedge_mesh& mesh, const std::vector<std::size_t>& kept)
      : m_fans(fan_chart(mesh)), m_collapses(m_fans.chart), m_heirs(mesh.triangles.size()),
        m_triangles(mesh.triangles.size())
  {
    std::iota(m_heirs.begin(), m_heirs.end(), std::size_t(0));
    for(const int wedge : m_fans.wedges) { // as the page has them
      const Kernel::Point_2& p = mesh.wedge_uv[static_cast<std::size_t>(wedge)];
      m_uv.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    }
    m_places.resize(m_heirs.size());
    for(std::size_t i = 0; i < m_places.size(); ++i) {
      m_places[m_fans.triangles[i]] = i;
    }
    std::vector<char> stays(m_uv.size(), false);
    for(const std::size_t t : kept) {
      for(std::size_t c = 3 * m_places[t]; c < 3 * m_places[t] + 3; ++c) {
        stays[static_cast<std::size_t>(chart().vertex[c])] = true;
      }
    }
    for(int v = 0; v < chart().number_of_vertices(); ++v) {
      if(chart().interior[static_cast<std::size_t>(v)] >= 0 && !stays[static_cast<std::size_t>(v)]) {
        m_removable.push_back(v);
      }
    }
  }

  Thinning(const Thinning&) = delete;
  Thinning& operator=(const Thinning&) = delete;

  std::size_t number_of_triangles() const { return m_triangles; }

  // Leaves at most that many triangles, or as few as can be where borders have too many vertices.
  void thin(const std::size_t most)
  {
    while(m_triangles > most) {
      const std::size_t before = m_triangles;
      add_level((before - most + 1) / 2);
      if(before - m_triangles <= before / 200) {
        break;
      }
    }
  }

  // Of each triangle: itself, or the one that it became part of
  std::vector<std::size_t> heirs() const
  {
    std::vector<std::size_t> result = m_heirs;
    for(std::size_t t = 0; t < result.size(); ++t) {
      while(result[t] != result[result[t]]) {
        result[t] = result[result[t]];
      }
    }
    return result;
  }

  // The wedges of a triangle that is left
  std::array<Wedge_mesh::Index, 3> wedges(const std::size_t t) const
  {
    const auto wedge = [this](const std::size_t corner) {
      return static_cast<Wedge_mesh::Index>(m_fans.wedges[static_cast<std::size_t>(chart().vertex[corner])]);
    };
    const std::size_t first = 3 * m_places[t];
    return {wedge(first), wedge(first + 1), wedge(first + 2)};
  }

private:
  static constexpr double smallest_angle = 0.05; // in radians, unless there is a smaller one before

  const abf::Chart& chart() const { return m_fans.chart; }

  int opposite(const int corner) const { return chart().opposite[static_cast<std::size_t>(corner)]; }

  // Of the mesh
  std::size_t triangle(const int corner) const
  {
    return m_fans.triangles[static_cast<std::size_t>(corner / 3)];
  }

  const Kernel::Point_2& uv(const int corner) const
  {
    return m_uv[static_cast<std::size_t>(chart().vertex[static_cast<std::size_t>(corner)])];
  }

  // Removes up to that many vertices, no two of which are neighbours.
  void add_level(const std::size_t most)
  {
    const std::vector<abf::Collapse_candidate> candidates = cheapest_collapses();
    std::size_t quota = (std::min)(most, m_removable.size() / 4 + 1);
    abf::Collapse_cost cost(m_collapses, smallest_angle);
    std::vector<char> has_changed(m_uv.size(), false); // whether triangles around a vertex have
    for(const std::size_t i : ranked(candidates)) {
      const abf::Edge_collapses::Record record = candidates[i].record;
      const int v = m_removable[i], w = m_collapses.kept_vertex(record);
      if(has_changed[static_cast<std::size_t>(v)] ||
         (has_changed[static_cast<std::size_t>(w)] && !cost.is_still_allowed(v, record))) {
        continue;
      }
      m_collapses.for_each_corner(v, [&](const int c) {
        for(const int d : {abf::next_corner(c), abf::previous_corner(c)}) {
          has_changed[static_cast<std::size_t>(chart().vertex[static_cast<std::size_t>(d)])] = true;
        }
      });
      collapse(record);
      if(--quota == 0) {
        break;
      }
    }
    m_removable.erase(std::remove_if(m_removable.begin(), m_removable.end(),
                                     [this](const int v) { return !m_collapses.is_alive(v); }),
                      m_removable.end());
  }

  // The cheapest collapse of each removable vertex
  std::vector<abf::Collapse_candidate> cheapest_collapses() const
  {
    std::vector<abf::Collapse_candidate> candidates(m_removable.size());
    abf::parallel_for_blocks(static_cast<int>(m_removable.size()), [&](const int begin, const int end) {
      abf::Collapse_cost cost(m_collapses, smallest_angle);
      for(auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
        const abf::Collapse_candidate candidate = cost.best(m_removable[i]);
        if(candidate && keeps_orientation(m_removable[i], candidate.record)) {
          candidates[i] = candidate;
        }
      }
    });
    return candidates;
  }

  // Whether no triangle turns over in the plane
  bool keeps_orientation(const int v, const abf::Edge_collapses::Record record) const
  {
    const int w = m_collapses.kept_vertex(record);
    const Kernel::Point_2& target = m_uv[static_cast<std::size_t>(w)];
    bool is_kept = true;
    m_collapses.for_each_corner(v, [&](const int c) {
      const int next = abf::next_corner(c), previous = abf::previous_corner(c);
      const bool vanishes = chart().vertex[static_cast<std::size_t>(next)] == w ||
                            chart().vertex[static_cast<std::size_t>(previous)] == w;
      is_kept = is_kept && (vanishes || std::isnan(target.x()) ||
                            CGAL::orientation(target, uv(next), uv(previous)) == CGAL::LEFT_TURN);
    });
    return is_kept;
  }

  // The cheapest first, in powers of two, and else in the order of the vertices, which lie close together in memory
  // then
  static std::vector<std::size_t> ranked(const std::vector<abf::Collapse_candidate>& candidates)
  {
    std::map<int, std::vector<std::size_t>> of_exponent;
    for(std::size_t i = 0; i < candidates.size(); ++i) {
      if(candidates[i]) {
        of_exponent[std::ilogb(candidates[i].cost)].push_back(i);
      }
    }
    std::vector<std::size_t> result;
    for(const auto& [exponent, numbers] : of_exponent) {
      result.insert(result.end(), numbers.begin(), numbers.end());
    }
    return result;
  }

  // The vertex that is removed is interior. Each triangle that vanishes becomes part of the next one around it.
  void collapse(const abf::Edge_collapses::Record record)
  {
    for(const int kept :
        {abf::next_corner(record), abf::next_corner(opposite(abf::previous_corner(record)))}) {
      m_heirs[triangle(kept)] = triangle(opposite(kept));
    }
    m_collapses.collapse(record);
    m_triangles -= 2;
  }

  Fan_chart m_fans;
  abf::Edge_collapses m_collapses;
  std::vector<Kernel::Point_2> m_uv; // of the vertices of the chart
  std::vector<int> m_removable;
  std::vector<std::size_t> m_places; // of the triangles of the mesh: their numbers in the chart
  std::vector<std::size_t> m_heirs;  // of the triangles of the mesh
  std::size_t m_triangles;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_THINNING_H
