// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts charts in two for the sake of pages: where a page cannot hold them, and where they then cover so much more of
// the page that the longer seams are worth it. `build_atlas_impl.h` runs both. The cuts come from `cut_along_chords.h`,
// and the maps stay as they are.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_FOR_PAGES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_FOR_PAGES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/cut_along_chords.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Cuts the charts of a part that a page cannot hold. What cannot be cut stays too large.
class Page_fitter
{
public:
  // `weight` multiplies the lengths of each triangle of the surface; empty if all are 1.
  Page_fitter(const Surface_part& part, const std::vector<double>& weight, const Packing_options& options,
              Part_atlas& atlas)
      : m_part(part), m_weight(weight), m_options(options), m_atlas(atlas)
  {}

  // The charts must be injective. Returns whether a page can hold each of them then.
  bool run()
  {
    for(;;) {
      const std::vector<int> too_large = too_large_pieces();
      if(too_large.empty())
        return true;
      const std::vector<std::vector<int>> triangles = triangles_by_piece(m_atlas.piece);
      std::vector<char> is_seam(m_atlas.chart.vertex.size(), false);
      for(int piece : too_large)
        cut_in_two(cut_out(m_atlas.chart, m_part.cost, triangles[piece]), is_seam);
      if(std::find(is_seam.begin(), is_seam.end(), true) == is_seam.end())
        return false;
      open_along(is_seam, m_part.cost, m_atlas);
    }
  }

private:
  std::vector<int> too_large_pieces() const
  {
    Planar_triangles triangles;
    triangles.add(m_part, m_weight, m_atlas);
    return charts_too_large(triangles.corners, m_atlas.piece, triangles.areas,
                            static_cast<int>(m_atlas.pieces.size()), m_options);
  }

  // Along a short chord that leaves much on both sides, or else, as around holes, from one side to the other. Marks the
  // seams of the whole chart.
  void cut_in_two(const Piece& piece, std::vector<char>& is_seam) const
  {
    const std::vector<Chart::Point_2> uv = piece.map_from(m_atlas.uv);
    double area = 0;
    for(int t = 0; t < piece.chart.number_of_triangles(); ++t)
      area += std::abs(planar_area(piece.chart, uv, t));
    std::vector<char> cut;
    Chord_cutter chords(piece.chart, uv, piece.cost, least_share * area);
    if(std::isfinite(chords.next_score())) {
      chords.cut();
      cut = chords.seams();
    } else
      cut = seams_across(piece, uv);
    for(int c = 0; c < piece.chart.number_of_corners(); ++c)
      if(cut[c] && piece.chart.opposite[c] >= 0)
        is_seam[piece.whole_corner(c)] = true;
  }

  // Between the two halves of the triangles along the longer side of their box
  static std::vector<char> seams_across(const Piece& piece, const std::vector<Chart::Point_2>& uv)
  {
    const std::vector<int> group = inseparable_triangles(piece.chart, piece.cost);
    const int groups = 1 + *std::max_element(group.begin(), group.end());
    Bbox_2 box;
    for(const Chart::Point_2& p : uv)
      box += p.bbox();
    const int axis = box.x_span() >= box.y_span() ? 0 : 1;
    std::vector<double> area(groups, 0), position(groups, 0);
    for(int t = 0; t < piece.chart.number_of_triangles(); ++t) {
      const double a = std::abs(planar_area(piece.chart, uv, t));
      area[group[t]] += a;
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        position[group[t]] += a * uv[piece.chart.vertex[c]][axis];
    }
    std::vector<int> order(groups);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return position[a] * area[b] < position[b] * area[a]; });
    std::vector<char> is_low(groups, false);
    double rest = std::accumulate(area.begin(), area.end(), 0.) / 2;
    for(int i = 0; i + 1 < groups && (i == 0 || rest > 0); ++i) {
      is_low[order[i]] = true;
      rest -= area[order[i]];
    }
    std::vector<char> is_seam;
    for(int c = 0; c < piece.chart.number_of_corners(); ++c) {
      const int across = piece.chart.opposite[c];
      is_seam.push_back(across >= 0 && is_low[group[c / 3]] != is_low[group[across / 3]]);
    }
    return is_seam;
  }

  static constexpr double least_share = 0.3; // of the area that a chord cuts off

  const Surface_part& m_part;
  const std::vector<double>& m_weight;
  const Packing_options& m_options;
  Part_atlas& m_atlas;
};

// Cuts charts as long as that is worth its price: a page that is covered by a factor f more is worth seams of the
// length log(f) / price, in units of the square root of the area of all charts.
class Page_coverer
{
public:
  // `weight` multiplies the lengths of each triangle in the plane; empty if all are 1.
  Page_coverer(const std::vector<Surface_part>& parts, const std::vector<double>& weight,
               const Chart_options& options, std::vector<Part_atlas>& atlases)
      : m_parts(parts), m_weight(weight), m_options(options), m_atlases(atlases), m_cutters(parts.size()),
        m_best_seams(parts.size())
  {}

  // The charts must be injective. Many charts fill a page anyway.
  void run()
  {
    if(number_of_charts() > most_charts)
      return;
    read();
    if(best_cutter() == m_parts.size())
      return;
    double best = value(-infinity), length = 0, best_length = 0;
    int worse = 0; // values in a row
    const auto is_hopeless = [&] {
      return worse >= most_worse && (length - best_length) * m_options.seam_price > least_waste;
    };
    for(int cuts = 1; cuts <= most_cuts && !is_hopeless(); ++cuts) {
      const std::size_t next = best_cutter();
      if(next == m_parts.size())
        break;
      length += m_cutters[next]->cut() / std::sqrt(m_area);
      if(length * m_options.seam_price > -best) // not even a page without gaps is worth that
        break;
      if(!is_tried(cuts))
        continue;
      const double price = m_options.seam_price * length, now = value(best + price) - price;
      worse = now > best ? 0 : worse + 1;
      if(now > best) {
        best = now;
        best_length = length;
        for(std::size_t i = 0; i < m_parts.size(); ++i)
          if(m_cutters[i])
            m_best_seams[i] = m_cutters[i]->seams();
      }
    }
    open();
  }

private:
  void read()
  {
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(const Part_atlas& atlas = m_atlases[i]; atlas.succeeded()) {
        m_triangles.add(m_parts[i], m_weight, atlas);
        for(int t = 0; t < atlas.chart.number_of_triangles(); ++t)
          m_area += surface_area(atlas.chart, t);
      }
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(m_atlases[i].succeeded()) {
        const double unit =
            m_parts[i].chart.scale; // of the map, whereas `m_area` is that of the scaled points
        m_cutters[i].emplace(m_atlases[i].chart, m_atlases[i].uv, m_parts[i].cost,
                             least_share * m_area * unit * unit);
      }
  }

  int number_of_charts() const
  {
    std::size_t charts = 0;
    for(const Part_atlas& atlas : m_atlases)
      charts += atlas.succeeded() ? atlas.pieces.size() : 0;
    return static_cast<int>(charts);
  }

  // The number of the part with the best cut, or the number of parts if there is none
  std::size_t best_cutter() const
  {
    std::size_t best = m_parts.size();
    double score = (std::numeric_limits<double>::infinity)();
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(m_cutters[i] && m_cutters[i]->next_score() < score) {
        best = i;
        score = m_cutters[i]->next_score();
      }
    return best;
  }

  // The more cuts there are, the fewer numbers of cuts are tried.
  static bool is_tried(int cuts) { return cuts <= 4 || cuts % (cuts <= 8 ? 2 : 4) == 0; }

  // The logarithm of the share that the charts cover on a coarse page, if it is more than `least`
  double value(double least) const
  {
    std::vector<int> chart;
    int charts = 0;
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(m_cutters[i]) {
        const std::vector<char> is_seam = m_cutters[i]->seams();
        const std::vector<int> piece =
            connected_triangles(m_atlases[i].chart, [&](int c) { return !is_seam[c]; });
        for(int p : piece)
          chart.push_back(charts + p);
        charts += piece.empty() ? 0 : 1 + *std::max_element(piece.begin(), piece.end());
      }
    const double aspect = std::clamp(std::sqrt(aspect_ratio(m_options)), 1. / 8, 8.);
    Packing_options coarse;
    coarse.resolution = static_cast<int>(128 * aspect);
    coarse.height = static_cast<int>(128 / aspect);
    coarse.gutter = 0;
    coarse.number_of_rotations = (std::min)(8, m_options.number_of_rotations);
    const Packing packing =
        pack(m_triangles.corners, chart, m_triangles.areas, charts, coarse, std::exp(least));
    return packing.status == Packing::DONE ? std::log(packing.covered_share) : -infinity;
  }

  void open()
  {
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      if(std::find(m_best_seams[i].begin(), m_best_seams[i].end(), true) != m_best_seams[i].end())
        open_along(m_best_seams[i], m_parts[i].cost, m_atlases[i]);
  }

  static constexpr double least_share = 0.01; // of the area that a piece has
  static constexpr double least_waste =
      0.01; // many strips may have to be cut before the page is covered better
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr int most_charts = 256, most_cuts = 64, most_worse = 5;

  const std::vector<Surface_part>& m_parts;
  const std::vector<double>& m_weight;
  const Chart_options& m_options;
  std::vector<Part_atlas>& m_atlases;
  std::vector<std::optional<Chord_cutter>> m_cutters; // of each part with charts
  std::vector<std::vector<char>> m_best_seams;        // of each part: of its corners
  Planar_triangles m_triangles;                       // of all charts
  double m_area = 0;                                  // of all charts, without weights
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_FOR_PAGES_H
