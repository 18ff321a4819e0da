// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sets of texels as bits, 64 of a row in a word, with dilation by the gutter. `chart_shape.h` draws charts into them,
// `place_charts.h` compares them, and `certify_packing_impl.h` checks the result with them.
//
// Turns a set of texels by a right angle, which takes less time than to draw the chart anew. `scaled_charts.h` makes the
// masks of most directions with it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_TEXEL_MASK_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_TEXEL_MASK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <boost/integer/integer_log2.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

struct Texel
{
  int x, y;
};

// A set of texels in a rectangle, 64 of a row in a word
class Texel_mask
{
public:
  typedef std::uint64_t Word;
  static constexpr int word_size = 64;

  Texel_mask(int width, int height)
      : m_width(width), m_height(height), m_stride(width / word_size + 2),
        m_words(static_cast<std::size_t>(m_stride) * height, 0)
  {}

  int width() const { return m_width; }
  int height() const { return m_height; }
  int words_of_row() const { return (m_width + word_size - 1) / word_size; }

  // The words of a row, and one more or two that are zero
  Word* row(int y) { return m_words.data() + static_cast<std::size_t>(m_stride) * y; }
  const Word* row(int y) const { return m_words.data() + static_cast<std::size_t>(m_stride) * y; }

  std::size_t number_of_texels() const
  {
    std::size_t number = 0;
    for(const Word word : m_words)
      number += std::bitset<word_size>(word).count();
    return number;
  }

  bool has(int x, int y) const { return row(y)[x / word_size] >> (x % word_size) & 1; }

  // Adds the texels x, ..., end - 1 of a row.
  void add(int x, int end, int y)
  {
    Word* words = row(y);
    visit_words(x, end, [&](unsigned i, Word bits) { words[i] |= bits; });
  }

  // Whether any of the texels x, ..., end - 1 of a row is in the set
  bool has_any(int x, int end, int y) const
  {
    Word found = 0;
    const Word* words = row(y);
    visit_words(x, end, [&](unsigned i, Word bits) { found |= words[i] & bits; });
    return found != 0;
  }

  // Adds the texels of a mask whose lower left corner is at (x, y), where it must not stick out.
  void add(const Texel_mask& mask, int x, int y)
  {
    const int first = x / word_size, shift = x % word_size;
    for(int j = 0; j < mask.height(); ++j) {
      const Word* from = mask.row(j);
      Word* to = row(y + j) + first;
      for(int i = 0; i < mask.words_of_row(); ++i) {
        to[i] |= from[i] << shift;
        to[i + 1] |= from[i] >> 1 >> (word_size - 1 - shift);
      }
    }
  }

  // The most texels of a row, next to each other, that are all in the set or, if `is_free`, all not in it. There are no
  // more than `most`.
  int longest_run(int y, bool is_free, int most) const
  {
    const Word outside = is_free ? ~Word(0) : Word(0);
    const Word* words = row(y);
    int longest = 0, run = 0;
    for(int first = 0; first < m_width && longest < most; first += word_size, ++words) {
      const int size = (std::min)(word_size, m_width - first);
      const Word word = (*words ^ outside) & ~Word(0) >> (word_size - size);
      if(word == ~Word(0)) {
        run += word_size;
        continue;
      }
      longest = (std::max)(longest, run + lowest_bit(~word));
      if(word != 0)
        longest = longest_run_of(word, longest);
      run = word_size - 1 - highest_bit(~word);
    }
    return (std::max)(longest, run);
  }

  // Of a word that is not 0; a search for bits costs more than most of what is done with them
#ifdef __GNUC__
  static int lowest_bit(Word word)
  {
    return __builtin_ctzll(word);
  }
  static int highest_bit(Word word)
  {
    return word_size - 1 - __builtin_clzll(word);
  }
#else
  static int lowest_bit(Word word)
  {
    return highest_bit(word & (~word + 1));
  }
  static int highest_bit(Word word)
  {
    return static_cast<int>(boost::integer_log2(word));
  }
#endif

private:
  // Of the bits of a word, or `least` if no run is longer. A shift by n shortens all runs by n, if n is not above what
  // they were shortened by before.
  static int longest_run_of(Word word, int least)
  {
    for(int length = 1; length <= least && word != 0;) {
      const int shift = (std::min)(length, least + 1 - length);
      word &= word << shift;
      length += shift;
    }
    for(; word != 0; word &= word << 1)
      ++least;
    return least;
  }

  // Calls `visit(i, bits)` for the words with the texels x, ..., end - 1.
  template <typename Visit>
  static void visit_words(int x, int end, const Visit& visit)
  {
    if(x >= end)
      return;
    const unsigned size = word_size, first = static_cast<unsigned>(x), last = static_cast<unsigned>(end - 1);
    Word bits = ~Word(0) << first % size;
    for(unsigned i = first / size; i < last / size; ++i, bits = ~Word(0))
      visit(i, bits);
    visit(last / size, bits & ~Word(0) >> (size - 1 - last % size));
  }

  int m_width, m_height, m_stride;
  std::vector<Word> m_words;
};

// Texels of a row that are next to each other
struct Row_run
{
  int y, length;
};

// The longest ones of some rows of a mask, the longest first
inline std::vector<Row_run> longest_runs(const Texel_mask& mask)
{
  const int rows = 8;
  std::vector<Row_run> runs;
  for(int i = 0, last = -1; i < rows; ++i)
    if(const int y = (mask.height() - 1) * i / (rows - 1); y != last)
      runs.push_back({last = y, mask.longest_run(y, false, mask.width())});
  std::sort(runs.begin(), runs.end(), [](const Row_run& a, const Row_run& b) { return a.length > b.length; });
  return runs;
}

// Adds each texel of a row a second time, `distance` columns further on.
inline void add_moved(Texel_mask::Word* words, int number_of_words, int distance)
{
  const int skipped = distance / Texel_mask::word_size, shift = distance % Texel_mask::word_size;
  for(int i = number_of_words - 1; i >= skipped; --i) {
    const Texel_mask::Word below = i > skipped ? words[i - skipped - 1] : 0;
    words[i] |= words[i - skipped] << shift | below >> 1 >> (Texel_mask::word_size - 1 - shift);
  }
}

// The texels from which one of the mask is at most `distance` columns and rows away, in a mask that is larger by that
// on all sides. Texels spread over 1, 2, 4, ... columns, and rows.
inline Texel_mask dilated(const Texel_mask& mask, int distance)
{
  Texel_mask result(mask.width() + 2 * distance, mask.height() + 2 * distance);
  const int words = result.words_of_row(), spread = 2 * distance + 1;
  for(int y = 0; y < mask.height(); ++y) {
    std::copy_n(mask.row(y), mask.words_of_row(), result.row(y));
    for(int reached = 1; reached < spread; reached += (std::min)(reached, spread - reached))
      add_moved(result.row(y), words, (std::min)(reached, spread - reached));
  }
  for(int reached = 1; reached < spread; reached += (std::min)(reached, spread - reached))
    for(int y = result.height() - 1, step = (std::min)(reached, spread - reached); y >= step; --y)
      for(int i = 0; i < words; ++i)
        result.row(y)[i] |= result.row(y - step)[i];
  return result;
}

typedef std::array<Texel_mask::Word, Texel_mask::word_size> Block_of_bits;

// Exchanges rows and columns of the lowest bits of the first words, `size` of them, a power of 2: first the halves that
// are off the diagonal, then those of each quarter, and so on.
inline void transpose(Block_of_bits& rows, int size)
{
  for(int half = size / 2; half > 0; half /= 2) {
    const Texel_mask::Word lower_halves = ~Texel_mask::Word(0) / ((Texel_mask::Word(1) << half) + 1);
    for(int first = 0; first < size; first += 2 * half)
      for(Texel_mask::Word* row = rows.data() + first; row != rows.data() + first + half; ++row) {
        const Texel_mask::Word differ = (row[0] >> half ^ row[half]) & lower_halves;
        row[0] ^= differ << half;
        row[half] ^= differ;
      }
  }
}

// Turned counterclockwise: row y becomes the y-th column from the right.
inline Texel_mask quarter_turn(const Texel_mask& mask)
{
  const int word_size = Texel_mask::word_size, width = mask.height(), height = mask.width();
  Texel_mask result(width, height);
  Block_of_bits block;
  for(int first_column = 0; first_column < width; first_column += word_size)
    for(int first_row = 0; first_row < height; first_row += word_size) {
      const int columns = (std::min)(word_size, width - first_column),
                rows = (std::min)(word_size, height - first_row);
      int size = 1;
      while(size < (std::max)(columns, rows))
        size *= 2;
      for(int i = 0; i < columns; ++i)
        block[i] = mask.row(width - 1 - first_column - i)[first_row / word_size];
      std::fill(block.begin() + columns, block.begin() + size, 0);
      transpose(block, size);
      for(int i = 0; i < rows; ++i)
        result.row(first_row + i)[first_column / word_size] = block[i];
    }
  return result;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_TEXEL_MASK_H
