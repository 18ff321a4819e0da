// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The cells of a page that are taken, and a fast search for the lowest place where a mask is free of them.
// `place_charts.h` places one chart after the other with it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_OCCUPIED_CELLS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_OCCUPIED_CELLS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The cells of a page that charts occupy, and the search for places that are free
class Occupied_cells
{
  typedef Texel_mask::Word Word;
  static constexpr int word_size = Texel_mask::word_size;

public:
  // `margin` are the cells around the page that masks of `add()` may reach.
  Occupied_cells(int width, int height, int margin)
      : m_width(width), m_height(height), m_margin(margin), m_cells(width + 2 * margin, height + 2 * margin),
        m_longest_free_run(static_cast<std::size_t>(height) + 2 * margin, width + 2 * margin)
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
    for(int row = y; row < y + mask.height(); ++row)
      m_longest_free_run[row] = m_cells.longest_run(row, true, m_longest_free_run[row]);
  }

  // The first place for the lower left corner of a mask, by rows from `first_row` to `last_row`, and in them from the
  // left. `runs` are of rows of the mask, the longest first.
  //
  // A cell of the mask that meets an occupied one rules out 64 places at a time. Those cells that did so before come
  // first: they leave few places for which the whole mask is compared.
  std::optional<Texel> find_place(const Texel_mask& mask, const std::vector<Row_run>& runs, int first_row,
                                  int last_row)
  {
    const int places = m_width - mask.width() + 1;
    if(places < 1)
      return std::nullopt;
    m_free.resize((places + word_size - 1) / word_size);
    m_witnesses.clear();
    last_row = (std::min)(last_row, m_height - mask.height());
    for(int y = first_row; (y = next_wide_row(runs, y, last_row)) <= last_row; ++y) {
      std::fill(m_free.begin(), m_free.end(), ~Word(0));
      if(places % word_size != 0)
        m_free.back() >>= word_size - places % word_size;
      for(std::size_t i = 0; i < m_witnesses.size(); ++i)
        if(!rule_out(m_free, m_witnesses[i], y)) {
          std::rotate(m_witnesses.begin() + i / 2, m_witnesses.begin() + i, m_witnesses.begin() + i + 1);
          break;
        }
      for(int x; (x = first_of(m_free)) >= 0;) {
        const std::optional<Texel> witness = collision(mask, x, y);
        if(!witness)
          return Texel{x, y};
        m_witnesses.insert(m_witnesses.begin(), *witness);
        rule_out(m_free, *witness, y);
      }
    }
    return std::nullopt;
  }

private:
  // The first row from y on where no row of the mask is wider than all that is free there, or one behind `last_row`
  int next_wide_row(const std::vector<Row_run>& runs, int y, int last_row) const
  {
    const int longest = runs.front().length;
    const int* free_run = m_longest_free_run.data() + m_margin;
    const int* free_of_longest = free_run + runs.front().y;
    for(;; ++y) {
      while(y <= last_row && free_of_longest[y] < longest)
        ++y;
      if(y > last_row || std::none_of(runs.begin() + 1, runs.end(),
                                      [&](const Row_run& run) { return free_run[y + run.y] < run.length; }))
        return y;
    }
  }

  // Takes out the places where a cell of the mask would be on an occupied one. Returns whether some are left.
  bool rule_out(std::vector<Word>& free, const Texel& cell, int y) const
  {
    const unsigned x = static_cast<unsigned>(cell.x + m_margin), shift = x % word_size;
    const Word* words = m_cells.row(y + m_margin + cell.y) + x / word_size;
    Word left = 0;
    for(Word& places : free) {
      places &= ~(words[0] >> shift | words[1] << 1 << (word_size - 1 - shift));
      left |= places;
      ++words;
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

  // A cell of the mask at (x, y) that is on an occupied one. What is occupied is large mostly: every eighth row comes
  // first.
  std::optional<Texel> collision(const Texel_mask& mask, int x, int y) const
  {
    const unsigned left = static_cast<unsigned>(x + m_margin), shift = left % word_size;
    const int words = mask.words_of_row();
    for(const int first : {0, 4, 2, 6, 1, 5, 3, 7})
      for(int j = first; j < mask.height(); j += 8) {
        const Word *row = m_cells.row(y + m_margin + j) + left / word_size, *cells = mask.row(j);
        for(int i = 0; i < words; ++i)
          if(const Word both = cells[i] & (row[i] >> shift | row[i + 1] << 1 << (word_size - 1 - shift));
             both != 0)
            return Texel{i * word_size + Texel_mask::lowest_bit(both), j};
      }
    return std::nullopt;
  }

  int m_width, m_height, m_margin;
  Texel_mask m_cells;
  std::vector<int> m_longest_free_run; // of each row
  std::vector<Word> m_free;            // places in the row of the search
  std::vector<Texel> m_witnesses;      // of the search
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_OCCUPIED_CELLS_H
