// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a map that overlaps itself into injective pieces, with seams as cheap as possible.
// `split_charts.h` runs it on the charts of a mesh, `atlas/flatten_part.h` on the charts of an atlas.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_SEPARATE_OVERLAPS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_SEPARATE_OVERLAPS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/overlaps/minimum_cut.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/triangle_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The result of the separation of a chart
struct Separation
{
  enum Status
  {
    DONE,
    FLIPPED, // `triangle` is not positively oriented
    NO_CUT,  // `triangle` overlaps another one from which it must not be cut off
    NOT_CERTIFIED
  };

  Status status = DONE;
  int triangle = -1;
  std::vector<char> is_seam; // of each corner: whether the edge that it faces is a new seam
  std::vector<int> piece;    // of each triangle
  int number_of_pieces = 0;
  std::vector<char> overlaps; // of each triangle: whether it overlaps another one; empty if none does
};

// Cuts a chart into pieces whose maps are injective: while triangles of a piece overlap, the cheapest cut between two
// sheets of it is made. Pieces of a disk are disks.
template <typename Point>
class Overlap_separator
{
  struct Task
  {
    std::vector<int> triangles;
    std::vector<Triangle_pair> pairs; // among them
  };

public:
  // `uv` is that of each vertex, and `cost` that of the edge that each corner faces.
  Overlap_separator(const Chart& chart, const std::vector<double>& cost, const std::vector<Point>& uv)
      : m_chart(chart), m_cost(cost), m_uv(uv)
  {}

  Separation run()
  {
    m_result.is_seam.assign(m_chart.vertex.size(), false);
    m_result.piece.assign(m_chart.number_of_triangles(), 0);
    if(const std::vector<int> flipped = flipped_triangles(m_chart.vertex, m_uv); !flipped.empty())
      return failure(Separation::FLIPPED, flipped.front());
    std::vector<int> all(m_chart.number_of_triangles());
    std::iota(all.begin(), all.end(), 0);
    m_unchecked.push_back(std::move(all));
    for(bool is_whole = true; !m_unchecked.empty() && m_result.status == Separation::DONE; is_whole = false) {
      const Piece piece = cut_out(m_chart, m_cost, std::move(m_unchecked.back()), m_result.is_seam);
      m_unchecked.pop_back();
      m_is_disk = is_whole ? euler_characteristic(piece.chart) == 1 : m_is_disk;
      finish_or_split(piece, is_whole);
    }
    return std::move(m_result);
  }

private:
  // Two triangles with a large angle at a vertex that they share can be apart, and touch there after a cut that runs
  // through the vertex: pieces are looked at again.
  void finish_or_split(const Piece& piece, bool is_whole)
  {
    const std::vector<Point> uv = piece.map_from(m_uv);
    if(bounds_region(border_edges(piece.chart), uv)) {
      if(m_is_disk && euler_characteristic(piece.chart) != 1)
        open_ring(piece);
      else
        finish(piece);
      return;
    }
    std::vector<Triangle_pair> pairs = overlapping_pairs(piece.chart.vertex, piece.chart.opposite, uv,
                                                         pairs_per_triangle * piece.triangles.size());
    if(pairs.empty()) {
      failure(Separation::NOT_CERTIFIED, piece.triangles.front());
      return;
    }
    for(auto& [s, t] : pairs)
      std::tie(s, t) = std::tie(piece.triangles[s], piece.triangles[t]);
    if(is_whole)
      mark_overlaps(pairs);
    split({piece.triangles, std::move(pairs)});
  }

  void finish(const Piece& piece)
  {
    for(int t : piece.triangles)
      m_result.piece[t] = m_result.number_of_pieces;
    ++m_result.number_of_pieces;
  }

  // A piece around another one: the sides of the seam that opens it touch, and so it comes apart in two next time.
  void open_ring(const Piece& piece)
  {
    const Seams seams = find_topological_seams(piece.chart, piece.cost);
    if(seams.status != Seams::DONE) {
      failure(Separation::NO_CUT, piece.triangles.front());
      return;
    }
    for(int c = 0; c < piece.chart.number_of_corners(); ++c)
      if(seams.is_seam[c])
        m_result.is_seam[piece.whole_corner(c)] = true;
    m_unchecked.push_back(piece.triangles);
  }

  void mark_overlaps(const std::vector<Triangle_pair>& pairs)
  {
    m_result.overlaps.assign(m_chart.number_of_triangles(), false);
    for(const auto& [s, t] : pairs)
      m_result.overlaps[s] = m_result.overlaps[t] = true;
  }

  // Until no pair is in one piece
  void split(Task first)
  {
    std::vector<Task> tasks;
    tasks.push_back(std::move(first));
    while(!tasks.empty() && m_result.status == Separation::DONE) {
      Deadline::ask();
      Task task = std::move(tasks.back());
      tasks.pop_back();
      if(task.pairs.empty())
        m_unchecked.push_back(std::move(task.triangles));
      else
        cut(task, tasks);
    }
  }

  void cut(const Task& task, std::vector<Task>& tasks)
  {
    const Piece piece = cut_out(m_chart, m_cost, task.triangles, m_result.is_seam);
    std::vector<Triangle_pair> pairs;
    for(const auto& [s, t] : task.pairs)
      pairs.emplace_back(local_number(piece, s), local_number(piece, t));
    const std::vector<int> block = inseparable_triangles(piece.chart, piece.cost);
    for(const auto& [s, t] : pairs)
      if(block[s] == block[t]) {
        failure(Separation::NO_CUT, piece.triangles[s]);
        return;
      }
    const Minimum_cut cut(piece, Sheet_finder(piece.chart, pairs, block).find(), block);
    const auto is_crossed = [&](int c) {
      return cut.is_on_first_side(c / 3) == cut.is_on_first_side(piece.chart.opposite[c] / 3);
    };
    for(int c = 0; c < piece.chart.number_of_corners(); ++c)
      if(piece.chart.opposite[c] >= 0 && !is_crossed(c))
        m_result.is_seam[piece.whole_corner(c)] = true;
    distribute(task, pairs, connected_triangles(piece.chart, is_crossed), tasks);
  }

  static int local_number(const Piece& piece, int triangle)
  {
    const auto found = std::lower_bound(piece.triangles.begin(), piece.triangles.end(), triangle);
    return static_cast<int>(found - piece.triangles.begin());
  }

  static void distribute(const Task& task, const std::vector<Triangle_pair>& local_pairs,
                         const std::vector<int>& part, std::vector<Task>& tasks)
  {
    std::vector<Task> parts(*std::max_element(part.begin(), part.end()) + 1);
    for(std::size_t t = 0; t < part.size(); ++t)
      parts[part[t]].triangles.push_back(task.triangles[t]);
    for(std::size_t i = 0; i < local_pairs.size(); ++i)
      if(const int p = part[local_pairs[i].first]; p == part[local_pairs[i].second])
        parts[p].pairs.push_back(task.pairs[i]);
    std::move(parts.rbegin(), parts.rend(), std::back_inserter(tasks));
  }

  Separation failure(Separation::Status status, int triangle)
  {
    m_result.status = status;
    m_result.triangle = triangle;
    return m_result;
  }

  // More pairs than this are not stored. Missing pairs are found once the others are separated.
  static constexpr std::size_t pairs_per_triangle = 64;

  const Chart& m_chart;
  const std::vector<double>& m_cost;
  const std::vector<Point>& m_uv;
  Separation m_result;
  bool m_is_disk = false;
  std::vector<std::vector<int>> m_unchecked; // triangles of pieces that may still overlap or be rings
};

// Cuts a chart where its map overlaps itself (see `Overlap_separator`).
template <typename Point>
Separation separate_overlaps(const Chart& chart, const std::vector<double>& cost,
                             const std::vector<Point>& uv)
{
  return Overlap_separator<Point>(chart, cost, uv).run();
}

#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
extern template Separation separate_overlaps(const Chart&, const std::vector<double>&,
                                             const std::vector<Exact_point_2>&);
#endif

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_SEPARATE_OVERLAPS_H
