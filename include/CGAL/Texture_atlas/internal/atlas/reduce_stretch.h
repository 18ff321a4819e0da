// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Adds seams in rounds as long as a map stretches too much. `flatten_part.h` does so for the parts of an atlas,
// and the program `flatten_mesh` for a mesh that becomes a single chart. They lead to the vertices where it stretches
// most.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_REDUCE_STRETCH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_REDUCE_STRETCH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/apply_seams.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>
#include <CGAL/Texture_atlas/Seam_report.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// How vertices are chosen where a map stretches too much
enum class Stretch_criterion
{
  LOG_SCALE, // finds tips, however small their triangles are
  AREA       // finds what large triangles hide
};

// Joins vertices where a map stretches most to the seams of a disk, which remains a disk.
class Terminal_adder
{
public:
  // `cost` is that of the edge that each corner faces.
  Terminal_adder(const Chart& surface, const std::vector<double>& cost, const std::vector<char>& is_seam)
      : m_graph(surface), m_cost(cost), m_corner(surface.points.size(), -1)
  {
    for(int c = 0; c < surface.number_of_corners(); ++c) {
      m_corner[surface.vertex[c]] = c;
      if(is_seam[c] && !m_graph.is_seam(c))
        m_graph.set_seam(c, true);
    }
  }

  // Returns how many vertices were joined, at most `count`.
  int add(const std::vector<Vertex_scale>& scales, Stretch_criterion criterion, std::size_t count)
  {
    std::vector<double> badness;
    for(const Vertex_scale& scale : scales)
      badness.push_back(criterion == Stretch_criterion::AREA ? scale.stretch_by_area()
                                                             : std::abs(scale.log_scale));
    int added = 0;
    for(int v : worst_vertices(badness, count))
      added += join(v);
    return added;
  }

  std::vector<char> seams() const
  {
    std::vector<char> is_seam;
    for(int c = 0; c < m_graph.surface().number_of_corners(); ++c)
      is_seam.push_back(m_graph.is_seam(c));
    return is_seam;
  }

private:
  // The worst vertices among those that are worse than all their neighbours
  std::vector<int> worst_vertices(const std::vector<double>& badness, std::size_t count) const
  {
    const auto is_worse = [&](int v, int w) {
      return badness[v] > badness[w] || (badness[v] == badness[w] && v < w);
    };
    std::vector<int> worst;
    for(int v = 0; v < m_graph.surface().number_of_vertices(); ++v)
      if(m_corner[v] >= 0 && is_interior(v) && is_local_maximum(v, is_worse))
        worst.push_back(v);
    const std::size_t size = (std::min)(worst.size(), count);
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(size), worst.end(),
                      is_worse);
    worst.resize(size);
    return worst;
  }

  bool is_interior(int v) const { return !m_graph.is_on_border(m_graph.node(m_corner[v])); }

  template <typename IsWorse>
  bool is_local_maximum(int v, const IsWorse& is_worse) const
  {
    const Chart& surface = m_graph.surface();
    const int first = m_corner[v];
    int c = first;
    do {
      if(!is_worse(v, surface.vertex[next_corner(c)]))
        return false;
      c = surface.rotate(c); // around an interior vertex
    } while(c != first);
    return true;
  }

  // Returns whether there was a way to a seam or border.
  bool join(int v)
  {
    if(!is_interior(v)) // one of those before was joined through it
      return false;
    Shortest_paths paths(m_graph, m_cost);
    const int end =
        paths.find({m_graph.node(m_corner[v])}, forbidden, [&](int x) { return m_graph.is_on_border(x); });
    if(end < 0)
      return false;
    for(int c : paths.path(end))
      m_graph.set_seam(c, true);
    return true;
  }

  Sector_graph m_graph;
  const std::vector<double>& m_cost;
  std::vector<int> m_corner; // of each vertex: one of its corners
};

inline bool misses_stretch_bound(double stretch, double bound)
{
  return stretch > stretch_tolerance * bound;
}

// How often seams were added, and how often this reduced the stretch
struct Seam_rounds
{
  int all = 0;
  int successful = 0;
};

// The round to begin with where maps take long: later ones where the stretch is far above the bound
inline int first_round(double bound, double stretch)
{
  const int most = 4;
  int round = 0;
  while(round < most && stretch - 1 > 2 * (1 << round) * (bound - 1))
    ++round;
  return round;
}

// Calls `improve(criterion, count)`, which adds at most that many terminals and takes the new map if it stretches less,
// until `stretch()` meets the bound. The number of terminals doubles with each round, so that only two rounds in a row
// that gain little tell that more will not help.
template <typename Stretch, typename Improve>
Seam_rounds add_seams_in_rounds(double bound, int first, const Stretch& stretch, const Improve& improve)
{
  const int max_rounds = 5;
  const double least_gain = 0.02;
  Seam_rounds rounds;
  int weak_rounds = 0;
  while(misses_stretch_bound(stretch(), bound) && weak_rounds < 2 && first + rounds.all < max_rounds) {
    const double before = stretch();
    const std::size_t count = std::size_t(3) << (first + rounds.all++);
    for(Stretch_criterion criterion : {Stretch_criterion::LOG_SCALE, Stretch_criterion::AREA})
      if(stretch() > (1 - least_gain) * before)
        improve(criterion, count);
    rounds.successful += stretch() < before;
    weak_rounds = stretch() > (1 - least_gain) * before ? weak_rounds + 1 : 0;
  }
  return rounds;
}

// Joins vertices of a mesh where its map stretches most to the seams that leave disks, and returns how many.
// `uv_of(h)` is the place of the halfedge's target in its face.
template <typename TriangleMesh, typename UvOf, typename EdgeIsSeamMap, typename NamedParameters>
std::size_t add_terminals(const TriangleMesh& mesh, const UvOf& uv_of, EdgeIsSeamMap seams,
                          Stretch_criterion criterion, std::size_t count, const NamedParameters& np)
{
  std::size_t added = 0;
  Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np, false);
  application.run([&](const Surface_part& part) {
    Chart triangles; // each with vertices of its own, because those on seams have several places
    std::vector<Chart::Point_2> uv;
    for(int c = 0; c < part.chart.number_of_corners(); ++c) {
      const auto& p = uv_of(application.halfedge_to(part, c));
      triangles.vertex.push_back(c);
      triangles.points.push_back(part.chart.points[part.chart.vertex[c]]);
      uv.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    }
    Terminal_adder adder(part.chart, part.cost, application.seams_of(part));
    added += static_cast<std::size_t>(adder.add(
        vertex_scales(triangles, uv, part.chart.vertex, part.chart.number_of_vertices()), criterion, count));
    Seams result;
    result.is_seam = adder.seams();
    return result;
  });
  return added;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_REDUCE_STRETCH_H
