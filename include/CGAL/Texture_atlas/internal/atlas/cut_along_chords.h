// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds seams across the maps of charts: along chords that are short compared with what they cut off, the best first.
// `cut_for_pages.h` decides how many of them are worth their length. The maps stay as they are.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_ALONG_CHORDS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_ALONG_CHORDS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/chords.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Cuts the maps of disks, and of flat pieces with holes, along chords. The score of a cut is its length divided by the
// square root of the area that it cuts off. The map stays as it is.
class Chord_cutter
{
  typedef Chart::Point_2 Point_2;

  // On the border of a piece
  struct Chord
  {
    std::size_t from, to;
    double score;
  };

  struct Cut
  {
    std::vector<int> path; // the corners that face its edges
    double score = (std::numeric_limits<double>::infinity)();
  };

public:
  // The maps of the pieces of `chart` are injective, and `cost` is that of the edge that each corner faces. Pieces get
  // at least the given area in the plane, those of long strips less.
  Chord_cutter(const Chart& chart, const std::vector<Point_2>& uv, const std::vector<double>& cost,
               double least_area)
      : m_chart(chart), m_uv(uv), m_least_area(least_area), m_graph(chart), m_paths(m_graph, uv, cost)
  {
    std::vector<int> outer;
    for(const std::vector<int>& border : chart.borders)
      (Border_of_piece(m_graph, m_uv, border.front()).area() < 0 ? m_holes : outer).push_back(border.front());
    for(int corner : outer)
      find_cut(corner);
  }

  // The score of the next cut; infinity if there is none
  double next_score() const { return m_cuts.empty() ? Cut().score : m_cuts.front().score; }

  // Makes the next cut, and returns its length on the surface.
  double cut()
  {
    std::pop_heap(m_cuts.begin(), m_cuts.end(), is_worse);
    const std::vector<int> path = std::move(m_cuts.back().path);
    m_cuts.pop_back();
    set_seams(path, true);
    double length = 0;
    for(int c : path)
      length += edge_length(m_chart, c);
    find_cut(path.front());
    find_cut(m_chart.opposite[path.front()]);
    return length;
  }

  // Returns of each corner whether the edge that it faces is a new seam.
  std::vector<char> seams() const
  {
    std::vector<char> is_seam;
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      is_seam.push_back(m_graph.is_seam(c));
    return is_seam;
  }

private:
  static bool is_worse(const Cut& a, const Cut& b) { return a.score > b.score; }

  void set_seams(const std::vector<int>& path, bool are_seams)
  {
    for(int c : path)
      m_graph.set_seam(c, are_seams);
  }

  // Finds the best cut of a piece. `corner` faces its outer border.
  void find_cut(int corner)
  {
    const std::vector<Border_of_piece> borders = borders_of(corner);
    Cut best = cut_along_chord(borders);
    for(std::size_t i = 1; i < borders.size(); ++i)
      if(-borders[i].area() >= m_least_area)
        if(Cut cut = cut_of_ring(borders, borders[i]); cut.score < best.score)
          best = std::move(cut);
    if(best.path.empty())
      return;
    m_cuts.push_back(std::move(best));
    std::push_heap(m_cuts.begin(), m_cuts.end(), is_worse);
  }

  // The outer border of a piece, and those of its holes
  std::vector<Border_of_piece> borders_of(int corner)
  {
    std::vector<Border_of_piece> borders;
    borders.emplace_back(m_graph, m_uv, corner);
    if(m_holes.empty())
      return borders;
    m_search.resize(m_chart.number_of_triangles(), 0);
    ++m_number_of_searches;
    const auto is_found = [&](int t) { return m_search[t] == m_number_of_searches; };
    std::vector<int> found;
    const auto find = [&](int t) {
      if(!is_found(t))
        found.push_back(t);
      m_search[t] = m_number_of_searches;
    };
    for(find(corner / 3); !found.empty();) {
      const int t = found.back();
      found.pop_back();
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(!m_graph.is_open(c))
          find(m_chart.opposite[c] / 3);
    }
    for(int hole : m_holes)
      if(is_found(hole / 3))
        if(Border_of_piece border(m_graph, m_uv, hole); border.area() < 0) // others were cut open
          borders.push_back(std::move(border));
    return borders;
  }

  Cut cut_along_chord(const std::vector<Border_of_piece>& borders)
  {
    const Border_of_piece& border = borders.front();
    std::size_t tried = 0;
    for(const Chord& chord : good_chords(border)) {
      if(!Chord_paths::is_within(borders, border.point(chord.from), border.point(chord.to)))
        continue;
      std::vector<int> path = m_paths.path_along(border, chord.from, border, chord.to);
      if(!path.empty())
        return {std::move(path), chord.score};
      if(++tried == most_paths)
        break;
    }
    return {};
  }

  // Along two chords from the outer border to that of a hole
  Cut cut_of_ring(const std::vector<Border_of_piece>& borders, const Border_of_piece& hole)
  {
    const Ring_chords chords(borders.front(), hole, m_paths.edges_between(borders.front(), hole));
    const double least =
        least_area((borders.front().length() + hole.length()) / 2, borders.front().area() + hole.area());
    const std::vector<Ring_chord> first_chords = chords.first_chords();
    for(std::size_t i = 0; i < (std::min)(most_paths, first_chords.size()); ++i) {
      const std::vector<int> path = path_along(borders, hole, first_chords[i]);
      if(path.empty())
        continue;
      set_seams(path, true);
      Cut cut = cut_of_open_ring(borders, hole, chords.second_chords(first_chords[i], least, largest_score));
      set_seams(path, false);
      if(!cut.path.empty())
        cut.path.insert(cut.path.end(), path.begin(), path.end());
      return cut;
    }
    return {};
  }

  Cut cut_of_open_ring(const std::vector<Border_of_piece>& borders, const Border_of_piece& hole,
                       const std::vector<Ring_chord>& chords)
  {
    for(std::size_t i = 0; i < (std::min)(most_paths, chords.size()); ++i) {
      std::vector<int> path = path_along(borders, hole, chords[i]);
      if(!path.empty())
        return {std::move(path), chords[i].score};
    }
    return {};
  }

  std::vector<int> path_along(const std::vector<Border_of_piece>& borders, const Border_of_piece& hole,
                              const Ring_chord& chord)
  {
    return Chord_paths::is_within(borders, borders.front().point(chord.outer), hole.point(chord.inner))
               ? m_paths.path_along(borders.front(), chord.outer, hole, chord.inner)
               : std::vector<int>();
  }

  // A piece of a long strip may be small: as long as it is, it leaves much of the page empty.
  double least_area(double length, double area) const
  {
    const bool is_strip =
        length * length > (std::max)(least_aspect * area, least_strip * least_strip * m_least_area);
    return is_strip ? (std::min)(m_least_area, area / 5) : m_least_area;
  }

  // The best chords come first. On a border with many vertices, only some places are tried.
  std::vector<Chord> good_chords(const Border_of_piece& border) const
  {
    std::vector<Chord> chords;
    const double least = least_area(border.length() / 2, border.area());
    if(border.area() < 2 * least)
      return chords;
    const auto add = [&](std::size_t from, std::size_t to) {
      const Point_2 &p = border.point(from), &q = border.point(to);
      const double part = border.area_of_sector(from, to) + Border_of_piece::cross_product(q, p) / 2,
                   area = (std::min)(part, border.area() - part);
      if(area >= least && distance(p, q) < largest_score * std::sqrt(area))
        chords.push_back({from, to, distance(p, q) / std::sqrt(area)});
    };
    const std::vector<std::size_t> places = border.sampled_places(most_places);
    for(std::size_t a = 0; a < places.size(); ++a)
      for(std::size_t b = a + 1; b < places.size(); ++b)
        add(places[a], places[b]);
    for(const auto& [from, to] : m_paths.edges_between(border, border))
      if(from < to)
        add(from, to);
    std::sort(chords.begin(), chords.end(), [](const Chord& p, const Chord& q) {
      return std::tie(p.score, p.from, p.to) < std::tie(q.score, q.from, q.to);
    });
    return chords;
  }

  static constexpr double largest_score = 1.8;
  static constexpr double least_aspect = 20; // of strips: their length divided by their width, and
  static constexpr double least_strip = 5;   // their length, in units of the square root of the least area
  static constexpr std::size_t most_places = 128, most_paths = 8;

  const Chart& m_chart;
  const std::vector<Point_2>& m_uv;
  const double m_least_area; // of a piece
  Sector_graph m_graph;
  Chord_paths m_paths;
  std::vector<int> m_holes;  // a corner at the border of each
  std::vector<int> m_search; // of each triangle: the number of the last search for borders that found it
  int m_number_of_searches = 0;
  std::vector<Cut> m_cuts; // a heap
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_ALONG_CHORDS_H
