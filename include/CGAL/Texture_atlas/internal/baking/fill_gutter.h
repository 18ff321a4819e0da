// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Continues the textures beyond the borders of charts, so that filters of viewers do not mix in the background at
// seams. The last step of `bake_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FILL_GUTTER_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FILL_GUTTER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Gives the texels around charts the values of the nearest texel of a chart, at most `gutter` rows and columns away. Of
// several texels at the same distance, it takes one in the nearest column, left before right, and above before below.
class Gutter_filler
{
public:
  Gutter_filler(Baked_textures& textures, int gutter)
      : m_textures(textures), m_columns(textures.resolution), m_rows(textures.height), m_gutter(gutter),
        m_above(textures.texels.size(), none)
  {}

  void run()
  {
    if(m_gutter == 0)
      return;
    parallel_for((m_columns + columns_at_once - 1) / columns_at_once,
                 [this](int block) { find_in_columns(block * columns_at_once); });
    std::vector<std::size_t> filled(m_rows, 0);
    parallel_for(m_rows, [&](int row) {
      for(int column = 0; column < m_columns; ++column)
        filled[row] += fill(row, column);
    });
    for(const std::size_t number : filled)
      m_textures.number_of_gutter_texels += number;
  }

private:
  static constexpr int none = (1 << 15) - 1, columns_at_once = 64;

  std::size_t index(int row, int column) const { return static_cast<std::size_t>(row) * m_columns + column; }

  bool is_in_chart(std::size_t i) const { return m_textures.texels[i] > Baked_textures::GUTTER; }

  // How many rows each texel is from the nearest one of a chart in its column: above it negative
  void find_in_columns(int first)
  {
    const int end = (std::min)(first + columns_at_once, m_columns);
    for(int row = 0; row < m_rows; ++row)
      for(int x = first; x < end; ++x) {
        const int before = row > 0 ? m_above[index(row - 1, x)] : none;
        m_above[index(row, x)] =
            static_cast<std::int16_t>(is_in_chart(index(row, x))              ? 0
                                      : before == none || before <= -m_gutter ? none
                                                                              : before - 1);
      }
    for(int row = m_rows - 2; row >= 0; --row)
      for(int x = first; x < end; ++x) {
        const int below = m_above[index(row + 1, x)];
        std::int16_t& here = m_above[index(row, x)];
        if(below >= 0 && below < m_gutter && (here == none || below + 1 < -here))
          here = static_cast<std::int16_t>(below + 1);
      }
  }

  // Returns whether the texel has been filled.
  bool fill(int row, int column)
  {
    const std::size_t i = index(row, column);
    if(is_in_chart(i))
      return false;
    int best = 2 * m_gutter * m_gutter + 1;
    std::size_t nearest = i;
    for(int step = 0; step <= m_gutter && step * step < best; ++step)
      for(const int x : {column - step, column + step})
        if(x >= 0 && x < m_columns) {
          const int rows = m_above[index(row, x)];
          if(rows != none && step * step + rows * rows < best) {
            best = step * step + rows * rows;
            nearest = index(row + rows, x);
          }
        }
    if(nearest == i)
      return false;
    copy(nearest, i);
    return true;
  }

  // Meanwhile, no texel of a chart is written.
  void copy(std::size_t from, std::size_t to)
  {
    m_textures.texels[to] = Baked_textures::GUTTER;
    m_textures.displacements[to] = m_textures.displacements[from];
    std::copy_n(m_textures.normals.begin() + 3 * from, 3, m_textures.normals.begin() + 3 * to);
    if(!m_textures.colors.empty())
      std::copy_n(m_textures.colors.begin() + 3 * from, 3, m_textures.colors.begin() + 3 * to);
  }

  Baked_textures& m_textures;
  const int m_columns, m_rows, m_gutter;
  std::vector<std::int16_t> m_above;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FILL_GUTTER_H
