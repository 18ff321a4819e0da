// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_METHOD_H
#define ABF_BENCHMARK_METHOD_H

#include "Run_report.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ABF_benchmark {

// A method of flattening by its name.
struct Method
{
  std::string name;  // on command lines
  std::string title; // in tables
  std::function<bool(const Chart&, std::vector<Point_2>&, Run_report&)> flatten;
};

template <typename Flattening>
Method make_method(const char* name, const char* title, const Flattening& flattening = Flattening())
{
  return {name, title, [flattening](const Chart& chart, std::vector<Point_2>& uv, Run_report& report) {
            return flattening.flatten(chart, uv, report);
          }};
}

// Those that are implemented here, and those that CGAL and our package offer as parameterizers.
std::vector<Method> own_methods();
std::vector<Method> parameterizer_methods();

inline std::vector<Method> all_methods()
{
  std::vector<Method> methods = parameterizer_methods();
  for(Method& method : own_methods())
    methods.push_back(std::move(method));
  return methods;
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_METHOD_H
