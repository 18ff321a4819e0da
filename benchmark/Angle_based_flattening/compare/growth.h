// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_GROWTH_H
#define COMPARE_GROWTH_H

#include "Results.h"

#include "../common/Table.h"

#include <cmath>
#include <string>
#include <vector>

namespace compare {

// Seconds as factor * triangles^exponent
struct Growth
{
  int points = 0;
  double exponent = 0, factor = 0;

  bool fitted() const { return points >= 3; }
  double seconds(const double triangles) const { return factor * std::pow(triangles, exponent); }
};

// The line of least squares through the logarithms, of one surface in several sizes
inline Growth fit_growth(const Results& results, const std::string& method)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for(const Mesh_results& mesh : results.meshes) {
    const double seconds = mesh.number(method, "seconds");
    if(mesh.resized && seconds > 0) {
      const double u = std::log(static_cast<double>(mesh.triangles)), v = std::log(seconds);
      n += 1;
      x += u;
      y += v;
      xx += u * u;
      xy += u * v;
    }
  }
  Growth growth;
  growth.points = static_cast<int>(n);
  if(growth.fitted()) {
    growth.exponent = (n * xy - x * y) / (n * xx - x * x);
    growth.factor = std::exp((y - growth.exponent * x) / n);
  }
  return growth;
}

inline std::string growth_table(const Results& results)
{
  Table table({"method", "sizes", "exponent", "seconds at 100,000 faces"}, 1);
  for(const Method_title& method : results.methods) {
    const Growth growth = fit_growth(results, method.name);
    if(growth.fitted()) {
      table.add({method.title, std::to_string(growth.points), cell("%.2f", growth.exponent),
                 seconds_cell(growth.seconds(1e5))});
    } else {
      table.add({method.title, std::to_string(growth.points), "–", "–"});
    }
  }
  return table.text();
}

} // namespace compare

#endif // COMPARE_GROWTH_H
