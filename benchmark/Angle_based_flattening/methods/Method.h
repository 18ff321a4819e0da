// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_METHOD_H
#define ABF_BENCHMARK_METHOD_H

#include "Run_report.h"

#include <functional>
#include <stdexcept>
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

// The parameterizers of our package, the hierarchical one with another of CGAL, those of CGAL, and the methods that are
// implemented here: each list in a file of its own.
std::vector<Method> package_methods();
std::vector<Method> hierarchical_methods();
std::vector<Method> free_border_methods();
std::vector<Method> fixed_border_methods();
std::vector<Method> own_methods();

inline std::vector<Method> all_methods()
{
  std::vector<Method> methods;
  for(const auto list :
      {package_methods, own_methods, hierarchical_methods, free_border_methods, fixed_border_methods})
    for(Method& method : list())
      methods.push_back(std::move(method));
  return methods;
}

// Throws an exception if there is none of that name.
inline Method find_method(const std::string& name)
{
  for(Method& method : all_methods())
    if(method.name == name)
      return std::move(method);
  throw std::runtime_error("there is no method '" + name + "'");
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_METHOD_H
