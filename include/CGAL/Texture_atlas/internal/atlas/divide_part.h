// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The atlas of a connected surface: in one piece if that is good enough, otherwise of pieces around triangles that are
// far apart, whose atlases are joined here. `build_atlas_impl.h` calls it for each part. `flatten_part.h` flattens the
// pieces.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDE_PART_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDE_PART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/atlas/atlas_progress.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/flatten_part.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>

#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Divides a connected surface that cannot be flattened well into pieces that can: some triangles, far apart, are seeds,
// and a piece contains the triangles that are nearest to its seed. Distances run from triangle to triangle. Edges that
// must not become seams do not separate pieces.
class Surface_division
{
public:
  // `cost` is that of the edge that each corner faces.
  Surface_division(const Chart& surface, const std::vector<double>& cost) : m_surface(surface), m_cost(cost)
  {
    for(int t = 0; t < surface.number_of_triangles(); ++t)
      m_center.push_back(CGAL::centroid(point(3 * t), point(3 * t + 1), point(3 * t + 2)));
  }

  // Returns the piece of each triangle, from 0 on. There are as many as asked for if so many triangles have area.
  std::vector<int> run(int number_of_pieces)
  {
    int seed = 0;
    spread(seed, 0);
    seed = farthest_triangle();
    m_distance.clear();
    for(int piece = 0; piece < number_of_pieces && seed >= 0; ++piece) {
      spread(seed, piece);
      seed = farthest_triangle();
    }
    unite_blocks();
    return connected_pieces();
  }

private:
  const Chart::Point_3& point(int c) const { return m_surface.points[m_surface.vertex[c]]; }

  double length_across(int c) const
  {
    return std::isinf(m_cost[c])
               ? 0
               : std::sqrt(CGAL::squared_distance(m_center[c / 3], m_center[m_surface.opposite[c] / 3]));
  }

  // Gives the piece all triangles that are nearer to its seed than to all earlier seeds.
  void spread(int seed, int piece)
  {
    typedef std::pair<double, int> Entry; // distance, triangle
    m_distance.resize(m_center.size(), std::numeric_limits<double>::infinity());
    m_piece.resize(m_center.size(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](int t, double distance) {
      if(distance < m_distance[t]) {
        m_distance[t] = distance;
        m_piece[t] = piece;
        queue.emplace(distance, t);
      }
    };
    reach(seed, 0);
    while(!queue.empty()) {
      Deadline::ask();
      const auto [distance, t] = queue.top();
      queue.pop();
      if(distance > m_distance[t])
        continue;
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(m_surface.opposite[c] >= 0)
          reach(m_surface.opposite[c] / 3, distance + length_across(c));
    }
  }

  // The triangle farthest from all seeds; -1 if no other triangle has an area. A triangle without area cannot be
  // flattened alone.
  int farthest_triangle() const
  {
    int farthest = -1;
    for(int t = 0; t < m_surface.number_of_triangles(); ++t)
      if(m_distance[t] > (farthest < 0 ? 0 : m_distance[farthest]) && surface_area(m_surface, t) > 0)
        farthest = t;
    return farthest;
  }

  // Equal distances could divide connected triangles.
  void unite_blocks()
  {
    const auto is_block = [this](int c) { return std::isinf(m_cost[c]); };
    const std::vector<int> block = connected_triangles(m_surface, is_block);
    std::vector<int> piece_of_block(block.size(), -1);
    for(std::size_t t = 0; t < block.size(); ++t) {
      int& piece = piece_of_block[block[t]];
      piece = piece < 0 ? m_piece[t] : piece;
      m_piece[t] = piece;
    }
  }

  std::vector<int> connected_pieces() const
  {
    return connected_triangles(
        m_surface, [this](int c) { return m_piece[c / 3] == m_piece[m_surface.opposite[c] / 3]; });
  }

  const Chart& m_surface;
  const std::vector<double>& m_cost;
  std::vector<Chart::Point_3> m_center; // of each triangle
  std::vector<double> m_distance;
  std::vector<int> m_piece;
};

// Joins the atlases of all pieces of a surface, in their order, to one of the surface. `triangles` are those of each
// piece.
inline Part_atlas joined_atlas(const Chart& surface, const std::vector<double>& cost,
                               const std::vector<std::vector<int>>& triangles, std::vector<Part_atlas> pieces)
{
  Part_atlas whole;
  std::vector<char> is_seam(surface.vertex.size(), false);
  std::vector<Chart::Point_2> uv(surface.vertex.size()); // of each corner
  whole.piece.resize(surface.number_of_triangles());
  for(std::size_t i = 0; i < pieces.size(); ++i) {
    const Part_atlas& piece = pieces[i];
    for(int c = 0; c < piece.chart.number_of_corners(); ++c) {
      const int corner = 3 * triangles[i][c / 3] + c % 3;
      is_seam[corner] = piece.chart.opposite[c] < 0 && surface.opposite[corner] >= 0;
      uv[corner] = piece.uv[piece.chart.vertex[c]];
      whole.piece[corner / 3] = static_cast<int>(whole.pieces.size()) + piece.piece[c / 3];
    }
    whole.pieces.insert(whole.pieces.end(), piece.pieces.begin(), piece.pieces.end());
    whole.number_of_terminals += piece.number_of_terminals;
  }
  whole.chart = opened_along_seams(surface, cost, is_seam).chart;
  whole.uv.resize(whole.chart.points.size());
  for(int c = 0; c < whole.chart.number_of_corners(); ++c)
    whole.uv[whole.chart.vertex[c]] = uv[c];
  renumber_pieces(whole);
  return whole;
}

// Makes the atlas of a connected surface: in one piece if that is good, and else of several.
class Part_divider
{
public:
  // How a piece of an atlas should be divided
  struct Division
  {
    int number_of_pieces = 8; // 1 if it is good
    bool is_isometric = true; // conformal maps stretch it too much
  };

  // `cost` is that of the edge that each corner of the surface faces.
  Part_divider(const Chart& surface, const std::vector<double>& cost, const Chart_options& options,
               const Linear_solvers& solvers, const Part_progress& progress)
      : m_surface(surface), m_cost(cost), m_options(options), m_solvers(solvers), m_progress(progress)
  {}

  Part_atlas run() const
  {
    Part_atlas atlas = Part_flattener(m_surface, m_cost, m_options, m_solvers, m_progress).run();
    if(!atlas.succeeded()) {
      if(!is_failure_of_computation(atlas.status))
        return atlas;
      const int pieces =
          (std::max)(Division().number_of_pieces, m_surface.number_of_triangles() / size_of_piece);
      Part_atlas divided = this->divided({pieces, true});
      return divided.succeeded() ? divided : atlas;
    }
    const std::vector<Division> divisions = wanted_divisions(atlas);
    const auto is_kept = [](const Division& division) { return division.number_of_pieces == 1; };
    return std::all_of(divisions.begin(), divisions.end(), is_kept) ? atlas
                                                                    : with_divided_pieces(atlas, divisions);
  }

  // The atlas of the surface in several pieces
  Part_atlas divided(const Division& division) const
  {
    const std::vector<std::vector<int>> triangles =
        triangles_by_piece(Surface_division(m_surface, m_cost).run(division.number_of_pieces));
    if(triangles.size() < 2) {
      Part_atlas failure;
      failure.status = Diagnosis::PRECISION_EXCEEDED;
      failure.message = "the part of the surface with " + vertex_text(m_surface, 0) + " cannot be divided";
      return failure;
    }
    Chart_options options = m_options;
    options.is_isometric = options.is_isometric || division.is_isometric;
    Part_atlas atlas =
        joined(triangles, [&](int, const Piece& piece) { return divider_of(piece, options).run(); });
    for(Atlas_report::Chart& piece : atlas.pieces)
      piece.strategy = Atlas_report::MORE_CHARTS;
    return atlas;
  }

private:
  static constexpr int size_of_piece = 50000; // at most so many triangles, if there is no map of the whole

  Part_divider divider_of(const Piece& piece, const Chart_options& options) const
  {
    return Part_divider(piece.chart, piece.cost, options, m_solvers, m_progress);
  }

  std::vector<Division> wanted_divisions(const Part_atlas& atlas) const
  {
    const double most = m_options.longest_chart / m_surface.scale;
    std::vector<Division> result;
    for(const Stretch_sums& sums : stretch_of_pieces(atlas)) {
      const Map_stretch stretch = sums.stretch();
      if(stretch.length > most)
        result.push_back({static_cast<int>((std::min)(std::ceil(3 * stretch.length / most), 64.)), false});
      else if(stretch.is_mendable(m_options.stretch_bound))
        result.push_back(Division());
      else
        result.push_back({1, false});
    }
    return result;
  }

  // Good pieces, and pieces that cannot be divided, stay as they are.
  Part_atlas with_divided_pieces(const Part_atlas& atlas, const std::vector<Division>& divisions) const
  {
    Part_atlas result = joined(triangles_by_piece(atlas.piece), [&](int number, const Piece& piece) {
      if(divisions[number].number_of_pieces > 1)
        if(Part_atlas divided = divider_of(piece, m_options).divided(divisions[number]); divided.succeeded())
          return divided;
      Piece kept = cut_out(atlas.chart, m_cost, piece.triangles);
      Part_atlas result_of_piece;
      result_of_piece.uv = kept.map_from(atlas.uv);
      result_of_piece.chart = std::move(kept.chart);
      result_of_piece.piece.assign(piece.triangles.size(), 0);
      result_of_piece.pieces = {atlas.pieces[number]};
      return result_of_piece;
    });
    result.number_of_terminals += atlas.number_of_terminals;
    return result;
  }

  // Calls `make(number, piece)` for all pieces in parallel, and joins their atlases. If one has failed, returns its
  // failure.
  template <typename Make>
  Part_atlas joined(const std::vector<std::vector<int>>& triangles, const Make& make) const
  {
    std::vector<Part_atlas> pieces(triangles.size());
    parallel_for(static_cast<int>(pieces.size()),
                 [&](int i) { pieces[i] = make(i, cut_out(m_surface, m_cost, triangles[i])); });
    for(Part_atlas& piece : pieces)
      if(!piece.succeeded())
        return std::move(piece);
    return joined_atlas(m_surface, m_cost, triangles, std::move(pieces));
  }

  const Chart& m_surface;
  const std::vector<double>& m_cost;
  const Chart_options& m_options;
  const Linear_solvers& m_solvers;
  Part_progress m_progress;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDE_PART_H
