// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_RESULTS_H
#define COMPARE_RESULTS_H

#include "../common/Measurement.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace compare {

using namespace benchmarks;

struct Method_title
{
  std::string name, title;
};

struct Mesh_results
{
  std::string name;
  bool resized;
  std::size_t triangles;
  std::map<std::string, Measurement> measurements; // of each method's name

  // NaN if that was not measured.
  double number(const std::string& method, const std::string& name) const
  {
    const auto found = measurements.find(method);
    return found == measurements.end() ? Measurement()[name] : found->second[name];
  }

  // Whether some method leaves nothing but rounding errors of the angles: quotients of these say nothing.
  bool is_flat() const
  {
    for(const auto& [method, measurement] : measurements) {
      if(measurement["angular"] < 1e-8) {
        return true;
      }
    }
    return false;
  }

  std::string title() const
  {
    return name + " (" + (triangles < 1000 ? "" : std::to_string((triangles + 500) / 1000) + "K)") +
           (triangles < 1000 ? std::to_string(triangles) + ")" : "");
  }
};

struct Results
{
  std::vector<Method_title> methods;
  std::vector<Mesh_results> meshes; // small ones first

  std::string title(const std::string& method) const
  {
    for(const Method_title& other : methods) {
      if(other.name == method) {
        return other.title;
      }
    }
    return method;
  }
};

// Of numbers that are positive and finite; NaN of none.
inline double geometric_mean(const std::vector<double>& numbers)
{
  double sum = 0;
  for(const double number : numbers) {
    sum += std::log(number);
  }
  return std::exp(sum / static_cast<double>(numbers.size()));
}

} // namespace compare

#endif // COMPARE_RESULTS_H
