// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The bodies of the three functions of `find_seams.h`: topological cut, greedy terminals and shortening, on a coarse
// copy if large. `apply_seams.h` and `atlas/flatten_part.h` include it; the compiled library has it in
// `angle_based_flattening_seams.cpp`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_FIND_SEAMS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/coarse_seams.h>
#include <CGAL/Texture_atlas/internal/seams/cut_topology.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/internal/seams/greedy_seams.h>
#include <CGAL/Texture_atlas/internal/seams/log_scale.h>
#include <CGAL/Texture_atlas/internal/seams/shorten_paths.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

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
