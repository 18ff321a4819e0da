// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_CSV_H
#define COMPARE_CSV_H

#include "Results.h"

#include "../common/format.h"

#include <string>

namespace compare {

// One row for each mesh and method. What was not measured is empty.
inline std::string csv(const Results& results)
{
  const std::vector<std::string> numbers = {"runs",
                                            "seconds",
                                            "bytes",
                                            "shear",
                                            "principal_shear",
                                            "equal_stretch_error",
                                            "stretch",
                                            "linf_stretch",
                                            "angular",
                                            "quasi_conformal",
                                            "area",
                                            "symmetric_dirichlet",
                                            "flips",
                                            "border_is_simple"};
  std::string text = "mesh,faces,method";
  for(const std::string& number : numbers) {
    text += "," + number;
  }
  text += ",failure\n";
  for(const Mesh_results& mesh : results.meshes) {
    for(const Method_title& method : results.methods) {
      const Measurement& m = mesh.measurements.at(method.name);
      text += mesh.name + "," + std::to_string(mesh.triangles) + "," + method.name;
      for(const std::string& number : numbers) {
        text += "," + (m.has(number) ? format_number("%.9g", m[number]) : "");
      }
      text += ",\"" + m.failure + "\"\n";
    }
  }
  return text;
}

} // namespace compare

#endif // COMPARE_CSV_H
