// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The cells of a page that are taken, and a fast search for the lowest place where a mask is free of them.
// `place_charts.h` places one chart after the other with it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_OCCUPIED_CELLS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_OCCUPIED_CELLS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/texel_mask.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The cells of a page that charts occupy, and the search for places that are free
class Occupied_cells
{
  typedef Texel_mask::Word Word;
  static constexpr int word_size = Texel_mask::word_size;

public:
  // `margin` are the cells around the page that masks of `add()` may reach.
  Occupied_cells(int width, int height, int margin)
      : m_width(width), m_height(height), m_margin(margin), m_cells(width + 2 * margin, height + 2 * margin),
        m_longest_free_run(static_cast<std::size_t>(height) + 2 * margin, -1)
  {}

  // At least those of the page that are free
  std::size_t number_of_free_cells() const
  {
    return static_cast<std::size_t>(m_cells.width()) * m_cells.height() - m_cells.number_of_texels();
  }

  // Adds a mask that is larger by the margin on all sides than the one at (x, y).
  void add(const Texel_mask& mask, int x, int y)
  {
    m_cells.add(mask, x, y);
    std::fill_n(m_longest_free_run.begin() + y, mask.height(), -1);
  }

  // The first place for the lower left corner of a mask, by rows from `first_row` on, and in them from the left; none
  // if `is_stopped(y)` before row y.
  //
  // A cell of the mask that meets an occupied one rules out 64 places at a time. Those cells that did so before come
  // first: they leave few places for which the whole mask is compared.
  template <typename IsStopped>
  std::optional<Texel> find_place(const Texel_mask& mask, int first_row, const IsStopped& is_stopped)
  {
    const int places = m_width - mask.width() + 1, last_row = m_height - mask.height();
    if(places < 1)
      return std::nullopt;
    std::vector<Word> free((places + word_size - 1) / word_size);
    std::vector<Texel> witnesses;
    const std::vector<Row_run> runs = longest_runs(mask);
    for(int y = first_row; y <= last_row && !is_stopped(y); ++y) {
      if(is_too_narrow(runs, y))
        continue;
      std::fill(free.begin(), free.end(), ~Word(0));
      if(places % word_size != 0)
        free.back() >>= word_size - places % word_size;
      for(std::size_t i = 0; i < witnesses.size(); ++i)
        if(!rule_out(free, witnesses[i], y)) {
          std::rotate(witnesses.begin() + i / 2, witnesses.begin() + i, witnesses.begin() + i + 1);
          break;
        }
      for(int x; (x = first_of(free)) >= 0;) {
        const std::optional<Texel> witness = collision(mask, x, y);
        if(!witness)
          return Texel{x, y};
        witnesses.insert(witnesses.begin(), *witness);
        rule_out(free, *witness, y);
      }
    }
    return std::nullopt;
  }

private:
  struct Row_run
  {
    int y, length;
  };

  // Of masks for which it pays to look at free runs, as a share of the width
  static constexpr int least_width_of_page = 32;

  // Of some rows of a mask
  std::vector<Row_run> longest_runs(const Texel_mask& mask) const
  {
    const int number = 8;
    std::vector<Row_run> runs;
    for(int i = 0, last = -1; i < number && mask.width() * least_width_of_page >= m_width; ++i)
      if(const int y = (mask.height() - 1) * i / (number - 1); y != last)
        runs.push_back({last = y, mask.longest_run(y, false)});
    return runs;
  }

  // Whether no place in row y is free, because a row of the mask is wider than all that is free there
  bool is_too_narrow(const std::vector<Row_run>& runs, int y)
  {
    return std::any_of(runs.begin(), runs.end(), [&](const Row_run& run) {
      const int row = y + m_margin + run.y;
      if(m_longest_free_run[row] < 0)
        m_longest_free_run[row] = m_cells.longest_run(row, true);
      return run.length > m_longest_free_run[row];
    });
  }

  // Takes out the places where a cell of the mask would be on an occupied one. Returns whether some are left.
  bool rule_out(std::vector<Word>& free, const Texel& cell, int y) const
  {
    const int x = cell.x + m_margin, shift = x % word_size;
    const Word* words = m_cells.row(y + m_margin + cell.y) + x / word_size;
    Word left = 0;
    for(std::size_t i = 0; i < free.size(); ++i) {
      free[i] &= ~(words[i] >> shift | words[i + 1] << 1 << (word_size - 1 - shift));
      left |= free[i];
    }
    return left != 0;
  }

  static int first_of(const std::vector<Word>& words)
  {
    for(std::size_t i = 0; i < words.size(); ++i)
      if(words[i] != 0)
        return static_cast<int>(i) * word_size + Texel_mask::lowest_bit(words[i]);
    return -1;
  }

  std::optional<Texel> collision(const Texel_mask& mask, int x, int y) const
  {
    for(int j = 0; j < mask.height(); ++j) {
      const Word* row = m_cells.row(y + m_margin + j);
      for(int i = 0; i < mask.words_of_row(); ++i)
        if(const Word both = mask.row(j)[i] & Texel_mask::word_from(row, x + m_margin + i * word_size);
           both != 0)
          return Texel{i * word_size + Texel_mask::lowest_bit(both), j};
    }
    return std::nullopt;
  }

  int m_width, m_height, m_margin;
  Texel_mask m_cells;
  std::vector<int> m_longest_free_run; // of each row; -1 if it is not known
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_OCCUPIED_CELLS_H
