// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Turns a set of texels by a right angle, which takes less time than to draw the chart anew. `scaled_charts.h` makes the
// masks of most directions with it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_TURNED_MASK_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_TURNED_MASK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>

#include <algorithm>
#include <array>

namespace CGAL::Texture_atlas::internal {

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

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_TURNED_MASK_H
