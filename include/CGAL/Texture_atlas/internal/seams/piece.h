// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Connected triangles of a chart as a chart of its own, opened along seams, which still knows where it came from.
// `overlaps/` separates charts piece by piece, `atlas/` opens and divides surfaces, and `cones/` opens one along seams.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_PIECE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_PIECE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Some connected triangles of a chart, opened along the seams among them
struct Piece
{
  std::vector<int> triangles; // their numbers in the whole chart, by rising number
  Chart chart;
  std::vector<double> cost; // of the edge that each corner faces
  std::vector<int> origin;  // of each vertex: the one in the whole chart

  int whole_corner(int c) const { return 3 * triangles[c / 3] + c % 3; }

  // The coordinates of its vertices, from those of the whole chart
  template <typename Point>
  std::vector<Point> map_from(const std::vector<Point>& uv) const
  {
    std::vector<Point> result;
    for(int v : origin)
      result.push_back(uv[v]);
    return result;
  }
};

// Cuts triangles, by rising number, out of a chart. `cost` and `is_seam` are those of the edge that each corner of the
// chart faces; no edge is a seam if `is_seam` is empty. The piece knows the other sides of its seams, also of those
// where the chart was open before. The memory is that of the piece, however large the chart is.
inline Piece cut_out(const Chart& whole, const std::vector<double>& cost, std::vector<int> triangles,
                     const std::vector<char>& is_seam = {})
{
  Piece piece;
  piece.triangles = std::move(triangles);
  const int size = static_cast<int>(piece.triangles.size());
  const bool is_whole = size == whole.number_of_triangles();
  // Of two triangles, the numbers in the piece differ by no more than those in the chart.
  const auto local_corner = [&](int c, int whole_corner) {
    if(whole_corner < 0 || is_whole)
      return whole_corner;
    const int t = c / 3, wanted = whole_corner / 3, difference = wanted - piece.triangles[t];
    const auto begin = piece.triangles.begin(), first = begin + (std::max)(0, t + (std::min)(difference, 0)),
               last = begin + (std::min)(size, t + (std::max)(difference, 0) + 1),
               found = std::lower_bound(first, last, wanted);
    return found == last || *found != wanted ? -1 : 3 * static_cast<int>(found - begin) + whole_corner % 3;
  };
  Chart& chart = piece.chart;
  const int corners = 3 * size;
  chart.scale = whole.scale;
  chart.opposite.assign(corners, -1);
  chart.seam.assign(corners, -1);
  for(int c = 0; c < corners; ++c) {
    const int whole_corner = piece.whole_corner(c), across = whole.opposite[whole_corner];
    piece.cost.push_back(cost[whole_corner]);
    if(across >= 0 && (is_seam.empty() || !is_seam[whole_corner]))
      chart.opposite[c] = local_corner(c, across);
    else
      chart.seam[c] = local_corner(c, across >= 0 || whole.seam.empty() ? across : whole.seam[whole_corner]);
  }
  chart.vertex.assign(corners, -1);
  for(int c = 0; c < corners; ++c)
    if(chart.vertex[c] < 0) {
      const int v = whole.vertex[piece.whole_corner(c)];
      for(int around : corners_around(chart, c))
        chart.vertex[around] = chart.number_of_vertices();
      chart.points.push_back(whole.points[v]);
      if(static_cast<std::size_t>(v) < whole.numbers.size())
        chart.numbers.push_back(whole.numbers[v]);
      piece.origin.push_back(v);
    }
  find_borders(chart);
  return piece;
}

// All triangles of a chart, opened along seams
inline Piece opened_along_seams(const Chart& whole, const std::vector<double>& cost,
                                const std::vector<char>& is_seam)
{
  std::vector<int> all(whole.number_of_triangles());
  std::iota(all.begin(), all.end(), 0);
  return cut_out(whole, cost, std::move(all), is_seam);
}

// The vertices minus the edges plus the triangles; 1 for a disk
inline int euler_characteristic(const Chart& chart)
{
  const auto border_edges = std::count(chart.opposite.begin(), chart.opposite.end(), -1);
  return chart.number_of_vertices() - (chart.number_of_corners() + static_cast<int>(border_edges)) / 2 +
         chart.number_of_triangles();
}

// The triangles of a chart in connected pieces, across edges with `is_crossed(corner)`: the number of the piece of
// each, from 0 on
template <typename IsCrossed>
std::vector<int> connected_triangles(const Chart& chart, const IsCrossed& is_crossed)
{
  const int n = chart.number_of_triangles();
  Disjoint_sets sets(static_cast<std::size_t>(n));
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(chart.opposite[c] > c && is_crossed(c))
      sets.union_set(c / 3, chart.opposite[c] / 3);
  std::vector<int> number(n, -1), result(n);
  int count = 0;
  for(int t = 0; t < n; ++t) {
    int& piece = number[sets.find_set(t)];
    if(piece < 0)
      piece = count++;
    result[t] = piece;
  }
  return result;
}

// Triangles that no seam can separate have the same number: what is between them must not become a seam.
inline std::vector<int> inseparable_triangles(const Chart& chart, const std::vector<double>& cost)
{
  return connected_triangles(chart, [&](int c) { return std::isinf(cost[c]); });
}

// The triangles of each of some pieces, which are numbered from 0 on
inline std::vector<std::vector<int>> triangles_by_piece(const std::vector<int>& piece)
{
  std::vector<std::vector<int>> triangles(piece.empty() ? 0
                                                        : 1 + *std::max_element(piece.begin(), piece.end()));
  for(std::size_t t = 0; t < piece.size(); ++t)
    triangles[piece[t]].push_back(static_cast<int>(t));
  return triangles;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_PIECE_H
