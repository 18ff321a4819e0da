// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_GREEDY_UNFOLDING_H
#define ABF_BENCHMARK_GREEDY_UNFOLDING_H

#include "chart_method.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <queue>
#include <vector>

namespace ABF_benchmark {

typedef std::complex<double> Complex;

// Eq. 19: the position of the vertex of corner `l`, from the other two vertices of its triangle.
inline Complex third_point(const std::vector<double>& alpha, int l, const Complex& next,
                           const Complex& previous)
{
  const int j = abf::next_corner(l), k = abf::previous_corner(l);
  return next + std::polar(std::sin(alpha[k]) / std::sin(alpha[l]), alpha[j]) * (previous - next);
}

// The unfolding of the original ABF (Sheffer and de Sturler 2001): lays out an edge, and then one vertex after the
// other by an advancing front that starts there, each by the triangle through which the front first reaches it.
inline std::vector<Point_2> unfold_greedily(const Chart& chart, const std::vector<double>& alpha)
{
  std::vector<Complex> z(chart.points.size());
  std::vector<char> placed(chart.points.size(), false), reached(chart.number_of_triangles(), false);
  std::queue<int> front; // corners that face the edge through which their triangle was reached
  front.push(0);
  reached[0] = true;
  z[chart.edge_target(0)] = 1;
  placed[chart.edge_source(0)] = placed[chart.edge_target(0)] = true;
  while(!front.empty()) {
    const int c = front.front(), v = chart.vertex[c];
    front.pop();
    if(!placed[v])
      z[v] = third_point(alpha, c, z[chart.edge_source(c)], z[chart.edge_target(c)]);
    placed[v] = true;
    for(int d : {c, abf::next_corner(c), abf::previous_corner(c)}) {
      const int across = chart.opposite[d];
      if(across >= 0 && !reached[across / 3]) {
        reached[across / 3] = true;
        front.push(across);
      }
    }
  }
  std::vector<Point_2> uv;
  for(const Complex& p : z)
    uv.emplace_back(p.real(), p.imag());
  return uv;
}

// How far the worst triangle is from having the angles `alpha`: the distance of its vertex of the largest sine from
// where the other two want it (Eq. 20), relative to its longest edge.
inline double largest_closing_error(const Chart& chart, const std::vector<double>& alpha,
                                    const std::vector<Point_2>& uv)
{
  const auto point = [&](int c) {
    const Point_2& p = uv[chart.vertex[c]];
    return Complex(p.x(), p.y());
  };
  double largest = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    int l = 3 * t;
    double longest = 0;
    for(int c = 3 * t; c < 3 * t + 3; ++c) {
      if(std::sin(alpha[c]) > std::sin(alpha[l]))
        l = c;
      longest = (std::max)(longest, std::abs(point(abf::next_corner(c)) - point(c)));
    }
    const Complex wanted = third_point(alpha, l, point(abf::next_corner(l)), point(abf::previous_corner(l)));
    largest = (std::max)(largest, std::abs(point(l) - wanted) / longest);
  }
  return largest;
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_GREEDY_UNFOLDING_H
