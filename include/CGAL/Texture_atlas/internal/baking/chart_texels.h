// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the point of the simple surface that belongs to each texel, in bands of rows that threads take one by one.
// `bake_impl.h` starts its rays from these points.
//
// Continues the textures beyond the borders of charts, so that filters of viewers do not mix in the background at
// seams. The last step of `bake_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_CHART_TEXELS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_CHART_TEXELS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/baking/shaded_surfaces.h>
#include <CGAL/Texture_atlas/internal/packing/visit_texels.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
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

// The point of the simple surface that is baked into a texel
struct Texel_source
{
  int triangle = -1;
  std::array<double, 3> weights = {0, 0, 0};                 // of its corners
  double distance = std::numeric_limits<double>::infinity(); // squared, in texels, from the centre
};

// A triangle in the plane, in texels: the points of it that are closest to centres of texels
class Texel_triangle
{
public:
  Texel_triangle(const std::array<Planar_point, 3>& corners, int number)
      : m_corners(corners), m_number(number), m_area(cross(corners[1] - corners[0], corners[2] - corners[0]))
  {}

  // Replaces the known point if this one is closer.
  void offer(const Planar_point& centre, Texel_source& source) const
  {
    if(source.distance == 0)
      return;
    if(m_area != 0) {
      const double v = cross(centre - m_corners[0], m_corners[2] - m_corners[0]) / m_area,
                   w = cross(m_corners[1] - m_corners[0], centre - m_corners[0]) / m_area;
      if(v >= 0 && w >= 0 && v + w <= 1) {
        source = {m_number, {1 - v - w, v, w}, 0};
        return;
      }
    }
    for(int k = 0; k < 3; ++k)
      offer_side(k, centre, source);
  }

private:
  void offer_side(int k, const Planar_point& centre, Texel_source& source) const
  {
    const Planar_point& p = m_corners[k];
    const Planar_point side = m_corners[(k + 1) % 3] - p;
    const double length = side.squaredNorm(),
                 s = length > 0 ? (std::min)((std::max)(side.dot(centre - p) / length, 0.), 1.) : 0;
    const double distance = (p + s * side - centre).squaredNorm();
    if(distance < source.distance) {
      source = {m_number, {0, 0, 0}, distance};
      source.weights[k] = 1 - s;
      source.weights[(k + 1) % 3] = s;
    }
  }

  std::array<Planar_point, 3> m_corners;
  int m_number;
  double m_area;
};

// Finds what is baked into each texel, for a few rows at a time. Rows count from above.
class Chart_texels
{
public:
  static constexpr int rows_of_band = 8;

  Chart_texels(const Charted_surface& surface, int columns, int rows)
      : m_surface(surface), m_columns(columns), m_rows(rows),
        m_first(static_cast<std::size_t>(number_of_bands()) + 1, 0)
  {
    const int n = surface.number_of_triangles();
    for(int t = 0; t < n; ++t)
      for_each_band(t, [this](int band) { ++m_first[band + 1]; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_triangles.resize(m_first.back());
    std::vector<std::size_t> next(m_first.begin(), m_first.end() - 1);
    for(int t = 0; t < n; ++t)
      for_each_band(t, [&](int band) { m_triangles[next[band]++] = t; });
  }

  int number_of_bands() const { return (m_rows + rows_of_band - 1) / rows_of_band; }
  int first_row(int band) const { return band * rows_of_band; }
  int end_row(int band) const { return (std::min)(m_rows, first_row(band) + rows_of_band); }

  // Of each texel of the rows of a band
  std::vector<Texel_source> sources(int band) const
  {
    const int rows = end_row(band) - first_row(band);
    std::vector<Texel_source> result(static_cast<std::size_t>(rows) * m_columns);
    for(std::size_t i = m_first[band]; i < m_first[band + 1]; ++i) {
      const int t = m_triangles[i];
      const Texel_triangle triangle(corners(t), t);
      visit_texels(corners(t), rounding_tolerance, [&](int from_below, int first, int last) {
        const int row = (std::max)(m_rows - 1 - from_below, 0) - first_row(band);
        if(row < 0 || row >= rows)
          return;
        last = (std::min)(last, m_columns - 1);
        for(int x = (std::max)(first, 0); x <= last; ++x)
          triangle.offer({x + 0.5, (std::max)(from_below, 0) + 0.5},
                         result[static_cast<std::size_t>(row) * m_columns + x]);
      });
    }
    return result;
  }

private:
  std::array<Planar_point, 3> corners(int t) const
  {
    const Planar_point* uv = &m_surface.uv[3 * static_cast<std::size_t>(t)];
    const Planar_point size(m_columns, m_rows);
    return {uv[0].cwiseProduct(size), uv[1].cwiseProduct(size), uv[2].cwiseProduct(size)};
  }

  template <typename Visit>
  void for_each_band(int t, const Visit& visit) const
  {
    const std::array<Planar_point, 3> p = corners(t);
    const double bottom = (std::min)({p[0].y(), p[1].y(), p[2].y()}) - 2 * rounding_tolerance,
                 top = (std::max)({p[0].y(), p[1].y(), p[2].y()}) + 2 * rounding_tolerance;
    const int first = (std::max)(m_rows - 1 - static_cast<int>(std::floor(top)), 0),
              last = (std::min)(m_rows - 1 - static_cast<int>(std::floor(bottom)), m_rows - 1);
    for(int band = first / rows_of_band; band <= last / rows_of_band; ++band)
      visit(band);
  }

  const Charted_surface& m_surface;
  const int m_columns, m_rows;
  std::vector<std::size_t> m_first; // of each band: its first one in `m_triangles`
  std::vector<int> m_triangles;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_CHART_TEXELS_H
