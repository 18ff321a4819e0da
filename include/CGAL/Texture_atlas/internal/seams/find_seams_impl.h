// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The bodies of the functions of `find_seams.h`: a topological cut, paths to terminals where the predicted scale is
// most extreme, until the predicted stretch is small, and shorter paths; by way of a coarse copy of a large surface.
// The scale comes from `log_scale.h`, so no map is made on the way. `apply_seams.h` and `atlas/flatten_part.h` include
// it, or the source file of the compiled library.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/grounded_laplacian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/coarse_seams.h>
#include <CGAL/Texture_atlas/internal/seams/cut_topology.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/internal/seams/log_scale.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_seams.h>
#include <CGAL/Texture_atlas/internal/seams/shorten_paths.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The first searches of key-path exchange visit each node so many times at most, and later ones half as often each
// time. Genus 133 took over 200 s without a limit.
inline constexpr int most_visits = 100;

// Terminals are added at most this many times after seams were shortened.
inline constexpr int most_rounds = 5;

// Values that differ by less, relative to the largest one, are equal but for rounding, as they are at many vertices of
// a symmetric surface. The first of these is taken.
inline constexpr double relative_tie = 1e-9;

// Seams of a connected surface: first those that make a disk of it, then paths to terminals, each the vertex whose
// predicted scale is farthest from 1, until the predicted stretch is small enough.
class Greedy_seams
{
public:
  typedef Seams::Status Status;

  Greedy_seams(Sector_graph& surface, const std::vector<double>& cost, const Seam_options& options,
               const Linear_solvers& solvers)
      : m_surface(surface), m_cost(cost), m_options(options), m_log_scale(surface.surface(), solvers),
        m_sources(m_log_scale.sources()), m_laplacian(m_log_scale.laplacian(), solvers),
        m_nearest(surface, cost), m_shortening(surface, cost)
  {}

  const std::vector<int>& terminals() const { return m_terminals; }
  double predicted_stretch() const { return m_stretch; }

  Status run()
  {
    if(const Status status = open(); status != Seams::DONE)
      return status;
    // Shortening usually changes the stretch a little. The last prediction is for the final seams.
    for(int round = 0;; ++round) {
      const std::size_t before = m_terminals.size();
      if(const Status status = add_terminals(); status != Seams::DONE)
        return status;
      if(round == most_rounds || (round > 0 && m_terminals.size() == before))
        return Seams::DONE;
      m_shortening.add_terminals(m_terminals);
      m_shortening.run(most_visits >> round);
    }
  }

private:
  const Chart& chart() const { return m_surface.surface(); }

  Status open()
  {
    const Topology topology(m_surface);
    if(topology.handles == 0 && topology.borders == 0)
      return open_sphere();
    return Topological_cut(m_surface, m_cost).run() ? Seams::DONE : Seams::NO_CUT;
  }

  // The first terminal is where the sphere shrinks most, the second one where it shrinks or grows most then, away from
  // the first.
  Status open_sphere()
  {
    std::vector<char> is_fixed(chart().points.size(), false);
    is_fixed.front() = true;
    Eigen::VectorXd u;
    if(!m_laplacian.solve(is_fixed, m_log_scale.sources(true), u))
      return Seams::LINEAR_SYSTEM_FAILED;
    const double tie = relative_tie * u.cwiseAbs().maxCoeff(), least = u.minCoeff();
    const int first = static_cast<int>(
        std::find_if(u.begin(), u.end(), [&](double x) { return x <= least + tie; }) - u.begin());
    is_fixed.front() = false;
    is_fixed[first] = true;
    if(!m_laplacian.solve(is_fixed, m_sources, u))
      return Seams::LINEAR_SYSTEM_FAILED;
    const int node = node_of(first);
    Shortest_paths paths(m_surface, m_cost);
    paths.find_all({node});
    double farthest = 0;
    for(int x = 0; x < m_surface.number_of_nodes(); ++x)
      if(paths.is_reached(x))
        farthest = (std::max)(farthest, paths.distance(x));
    const int second = most_extreme(u, [&](int x) {
      return paths.is_reached(x) && paths.distance(x) > 0.25 * farthest && paths.path_has_two_edges(x);
    });
    if(second < 0)
      return Topological_cut(m_surface, m_cost).run() ? Seams::DONE : Seams::NO_CUT;
    m_terminals = {first, m_surface.vertex(second)};
    for(int c : paths.path(second))
      m_surface.set_seam(c, true);
    return Seams::DONE;
  }

  int node_of(int v) const
  {
    int x = 0;
    while(m_surface.vertex(x) != v)
      ++x;
    return x;
  }

  // The node with the largest |u| among some, or -1
  template <typename IsCandidate>
  int most_extreme(const Eigen::VectorXd& u, const IsCandidate& is_candidate) const
  {
    const auto extent = [&](int x) { return std::abs(u[m_surface.vertex(x)]); };
    double largest = 0;
    for(int x = 0; x < m_surface.number_of_nodes(); ++x)
      if(is_candidate(x))
        largest = (std::max)(largest, extent(x));
    for(int x = 0; x < m_surface.number_of_nodes(); ++x)
      if(is_candidate(x) && extent(x) >= largest - relative_tie * largest)
        return x;
    return -1;
  }

  Status add_terminals()
  {
    m_nearest.find();
    for(;;) {
      Deadline::ask();
      find_border_vertices(m_surface, m_is_on_border);
      if(!m_laplacian.solve(m_is_on_border, m_sources, m_u))
        return Seams::LINEAR_SYSTEM_FAILED;
      m_stretch = m_log_scale.stretch(m_u);
      if(m_stretch <= m_options.stretch_bound ||
         static_cast<int>(m_terminals.size()) >= m_options.maximum_number_of_terminals || !add_terminal())
        return Seams::DONE;
    }
  }

  // Joins the vertex of the largest |u| to the seams. Returns `false` if no vertex is left that can be.
  bool add_terminal()
  {
    const int terminal =
        most_extreme(m_u, [&](int x) { return m_surface.is_node(x) && m_nearest.last_edge(x) >= 0; });
    if(terminal < 0)
      return false;
    m_terminals.push_back(m_surface.vertex(terminal));
    m_nearest.open(m_nearest.path(terminal));
    return true;
  }

  Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  const Seam_options& m_options;
  Log_scale m_log_scale;
  const Eigen::VectorXd m_sources;
  Grounded_laplacian m_laplacian;
  Nearest_seams m_nearest;
  Path_shortening m_shortening;
  std::vector<char> m_is_on_border; // of each vertex
  Eigen::VectorXd m_u;              // the predicted log scale of each vertex
  std::vector<int> m_terminals;     // vertices
  double m_stretch = 1;
};

// Surfaces with more vertices get their seams by way of a coarse copy, which has fewer.
inline constexpr int large_surface = 12000, vertices_of_coarse_copy = 5000;

inline Seams seams_of(const Sector_graph& surface)
{
  Seams seams;
  for(int c = 0; c < surface.surface().number_of_corners(); ++c)
    seams.is_seam.push_back(surface.is_seam(c));
  return seams;
}

inline Seams find_seams_directly(const Chart& surface, const std::vector<double>& cost,
                                 const Seam_options& options, const Linear_solvers& solvers)
{
  Sector_graph opened(surface);
  Greedy_seams greedy(opened, cost, options, solvers);
  const Seams::Status status = greedy.run();
  Seams seams = seams_of(opened);
  seams.status = status;
  seams.terminals = greedy.terminals();
  seams.predicted_stretch = greedy.predicted_stretch();
  return seams;
}

// The same seams, with the stretch predicted on the surface itself, and without the terminals that they do not reach
inline Seams predicted_again(Seams seams, const Sector_graph& opened, const Linear_solvers& solvers)
{
  std::vector<char> is_reached;
  find_border_vertices(opened, is_reached);
  const Log_scale log_scale(opened.surface(), solvers);
  if(const std::optional<Eigen::VectorXd> u = log_scale.solve(is_reached))
    seams.predicted_stretch = log_scale.stretch(*u);
  else
    seams.status = Seams::LINEAR_SYSTEM_FAILED;
  const auto is_missed = [&](int v) { return !is_reached[v]; };
  seams.terminals.erase(std::remove_if(seams.terminals.begin(), seams.terminals.end(), is_missed),
                        seams.terminals.end());
  return seams;
}

inline Seams find_seams_on_copy(const Chart& surface, const std::vector<double>& cost,
                                const Seam_options& options, const Linear_solvers& solvers)
{
  const Coarse_copy copy(surface, cost, vertices_of_coarse_copy);
  const std::vector<double> coarse_cost = copy.cost();
  Sector_graph coarse(copy.chart());
  Greedy_seams greedy(coarse, coarse_cost, options, solvers);
  Seams seams;
  seams.status = greedy.run();
  if(seams.status != Seams::DONE)
    return seams;

  std::vector<int> terminals;
  for(int v : greedy.terminals())
    terminals.push_back(copy.fine_vertex(v));
  Sector_graph opened(surface);
  const bool is_as_planned =
      copy.draw(Path_shortening(coarse, coarse_cost, greedy.terminals()).key_paths(), opened);
  if(!Cut_repair(opened, cost, terminals).run()) {
    seams.status = Seams::NO_CUT;
    return seams;
  }
  seams = seams_of(opened);
  seams.terminals = std::move(terminals);
  seams.predicted_stretch = greedy.predicted_stretch();
  return is_as_planned ? seams : predicted_again(std::move(seams), opened, solvers);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Seams find_topological_seams(const Chart& surface,
                                                                const std::vector<double>& cost,
                                                                const std::vector<int>& terminals)
{
  Sector_graph opened(surface);
  if(!Topological_cut(opened, cost, terminals).run()) {
    Seams seams;
    seams.status = Seams::NO_CUT;
    return seams;
  }
  Path_shortening(opened, cost, terminals).run(most_visits);
  Seams seams = seams_of(opened);
  seams.terminals = terminals;
  return seams;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Seams find_seams(const Chart& surface, const std::vector<double>& cost,
                                                    const Seam_options& options,
                                                    const Linear_solvers& solvers)
{
  return surface.number_of_vertices() > large_surface ? find_seams_on_copy(surface, cost, options, solvers)
                                                      : find_seams_directly(surface, cost, options, solvers);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Seams shorten_seams(const Chart& surface, const std::vector<double>& cost,
                                                       const std::vector<char>& seams)
{
  Sector_graph opened(surface);
  for(int c = 0; c < surface.number_of_corners(); ++c)
    if(seams[c] && !opened.is_seam(c))
      opened.set_seam(c, true);
  std::vector<int> ends;
  for(int c = 0; c < surface.number_of_corners(); ++c)
    if(opened.is_seam(c) && opened.number_of_seams_at(next_corner(c)) == 1)
      ends.push_back(surface.edge_source(c));
  Path_shortening(opened, cost, ends, leaves_disks(opened)).run(most_visits);
  return seams_of(opened);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_IMPL_H
