// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_MEASURE_H
#define HIERARCHICAL_MEASURE_H

#include "Task.h"

#include "../common/Measurement.h"

#include <string>
#include <vector>

namespace hierarchical {

using namespace benchmarks;

// A method as the tables and the command line know it
struct Method
{
  const char* name;
  const char* title;
};

// Names that tables and tasks need
constexpr const char* habf = "habf";
constexpr const char* polished = "polished";
constexpr const char* hlscm = "hlscm";
constexpr const char* sequential = "sequential";
constexpr const char* direct = "direct";
constexpr const char* lscm = "lscm";

inline const std::vector<Method>& all_methods()
{
  static const std::vector<Method> methods = {
      {habf, "hierarchical ABF++"}, {polished, "hierarchical ABF++, polished"},
      {hlscm, "hierarchical LSCM"}, {sequential, "sequential hierarchy"},
      {direct, "direct ABF++"},     {lscm, "CGAL's LSCM"}};
  return methods;
}

inline std::string title(const std::string& method)
{
  for(const Method& other : all_methods()) {
    if(method == other.name) {
      return other.title;
    }
  }
  return method;
}

// The stages of the hierarchical methods, whose seconds are among a measurement's numbers
const std::vector<std::string>& stages();

// And those of the direct method
const std::vector<std::string>& direct_stages();

// Runs a method on a mesh, in this process.
Measurement measure(const Task& task);

} // namespace hierarchical

#endif // HIERARCHICAL_MEASURE_H
