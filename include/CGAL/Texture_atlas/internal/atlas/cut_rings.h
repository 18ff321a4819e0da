// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pairs of chords that cut a ring in two: a ring that is only cut open would cover no more of the page than before.
// `cut_along_chords.h` cuts along them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_RINGS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_RINGS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/chord_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// A chord from the outer border of a piece to the border of a hole
struct Ring_chord
{
  std::size_t outer, inner; // places on the borders
  double score;             // the less, the better
};

// The chords between two borders of a piece
class Ring_chords
{
public:
  // `edges` are pairs of places that an edge joins.
  Ring_chords(const Border_of_piece& outer, const Border_of_piece& hole,
              const std::vector<std::pair<std::size_t, std::size_t>>& edges)
      : m_outer(outer), m_hole(hole)
  {
    for(std::size_t i : outer.sampled_places(most_places))
      for(std::size_t j : hole.sampled_places(most_places))
        m_chords.push_back({i, j, 0});
    for(const auto& [i, j] : edges)
      m_chords.push_back({i, j, 0});
  }

  // The shortest ones first
  std::vector<Ring_chord> first_chords() const
  {
    return sorted([&](const Ring_chord& chord) { return length(chord); });
  }

  // Those that cut the ring in two with another one. The score of both is their length divided by the square root of
  // the smaller area, which is at least `least_area`; it is at most `largest_score`.
  std::vector<Ring_chord> second_chords(const Ring_chord& first, double least_area,
                                        double largest_score) const
  {
    const double whole = m_outer.area() + m_hole.area();
    std::vector<Ring_chord> chords = sorted([&](const Ring_chord& second) {
      const double part = area_between(first, second), area = (std::min)(part, whole - part);
      return area >= least_area && second.outer != first.outer && second.inner != first.inner
                 ? (length(first) + length(second)) / std::sqrt(area)
                 : 2 * largest_score;
    });
    const auto is_good = [&](const Ring_chord& chord) { return chord.score <= largest_score; };
    chords.erase(std::partition_point(chords.begin(), chords.end(), is_good), chords.end());
    return chords;
  }

private:
  static constexpr std::size_t most_places = 64;

  template <typename Score>
  std::vector<Ring_chord> sorted(const Score& score) const
  {
    std::vector<Ring_chord> chords = m_chords;
    for(Ring_chord& chord : chords)
      chord.score = score(chord);
    std::sort(chords.begin(), chords.end(), [](const Ring_chord& p, const Ring_chord& q) {
      return std::tie(p.score, p.outer, p.inner) < std::tie(q.score, q.outer, q.inner);
    });
    return chords;
  }

  double length(const Ring_chord& chord) const
  {
    return distance(m_outer.point(chord.outer), m_hole.point(chord.inner));
  }

  static double sector(const Border_of_piece& border, std::size_t from, std::size_t to)
  {
    return border.area_of_sector(from, to) + (from <= to ? 0 : border.area());
  }

  // Along the outer border to the second chord, and back along the hole
  double area_between(const Ring_chord& first, const Ring_chord& second) const
  {
    const auto across = [&](const auto& p, const auto& q) {
      return Border_of_piece::cross_product(p, q) / 2;
    };
    return sector(m_outer, first.outer, second.outer) +
           across(m_outer.point(second.outer), m_hole.point(second.inner)) +
           sector(m_hole, second.inner, first.inner) +
           across(m_hole.point(first.inner), m_outer.point(first.outer));
  }

  const Border_of_piece &m_outer, &m_hole;
  std::vector<Ring_chord> m_chords;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CUT_RINGS_H
