// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_PACK_RECTANGLES_H
#define ABF_BENCHMARK_PACK_RECTANGLES_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ABF_benchmark {

// Packs rectangles by their skyline: the highest first, each where its upper end is lowest.
class Rectangle_packer
{
public:
  Rectangle_packer(std::vector<std::pair<double, double>> sizes, const int resolution, const int gutter)
      : m_sizes(std::move(sizes)), m_resolution(resolution), m_gutter(gutter)
  {
    for(auto& [width, height] : m_sizes)
      if(width < height)
        std::swap(width, height);
    std::sort(m_sizes.begin(), m_sizes.end(),
              [](const auto& a, const auto& b) { return a.second > b.second; });
  }

  // The largest scale at which all fit: texels for the length 1. 0 if there is none
  double scale() const
  {
    double length = 0;
    for(const auto& [width, height] : m_sizes)
      length = (std::max)(length, width);
    double lower = 0, upper = m_resolution / length;
    for(int i = 0; i < 30; ++i) {
      const double middle = (lower + upper) / 2;
      (fit(middle) ? lower : upper) = middle;
    }
    return lower;
  }

private:
  // The gutter is above and to the right of each rectangle, and half of it is free at the border of the square.
  bool fit(const double scale) const
  {
    const int side = m_resolution - (m_gutter + 1) / 2 * 2 + m_gutter;
    std::vector<int> heights(static_cast<std::size_t>((std::max)(0, side)), 0);
    return std::all_of(m_sizes.begin(), m_sizes.end(), [&](const auto& size) {
      const int width = texels(size.first * scale), height = texels(size.second * scale);
      const auto [x, y] = lowest(heights, width);
      const auto [u, v] = lowest(heights, height);
      const bool is_turned = x < 0 || (u >= 0 && v + width < y + height);
      const int left = is_turned ? u : x, top = is_turned ? v + width : y + height;
      if(left < 0 || top > side)
        return false;
      std::fill_n(heights.begin() + left, is_turned ? height : width, top);
      return true;
    });
  }

  int texels(const double length) const { return static_cast<int>(std::ceil(length)) + 1 + m_gutter; }

  // The place for a rectangle of that width where it is lowest, and the height there; -1 if it is too wide
  static std::pair<int, int> lowest(const std::vector<int>& heights, const int width)
  {
    std::pair<int, int> best(-1, 0);
    std::vector<int> highest; // columns of the window, by falling height
    std::size_t first = 0;
    for(int x = 0; x < static_cast<int>(heights.size()); ++x) {
      while(highest.size() > first && heights[highest.back()] <= heights[x])
        highest.pop_back();
      highest.push_back(x);
      if(highest[first] <= x - width)
        ++first;
      if(x >= width - 1 && (best.first < 0 || heights[highest[first]] < best.second))
        best = {x - width + 1, heights[highest[first]]};
    }
    return best;
  }

  std::vector<std::pair<double, double>> m_sizes;
  int m_resolution, m_gutter;
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_PACK_RECTANGLES_H
