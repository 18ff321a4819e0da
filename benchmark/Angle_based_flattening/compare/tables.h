// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_TABLES_H
#define COMPARE_TABLES_H

#include "Results.h"

#include "../common/Table.h"
#include "../common/format.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace compare {

// Up to which the paper's tables go, roughly
constexpr std::size_t most_of_table_1 = 60000, most_of_table_2 = 300000;

inline std::string failure_cell(const Measurement& m)
{
  const bool expected = m.failure == "not tried" || m.failure.rfind("stopped", 0) == 0;
  return (expected ? "" : "FAILED: ") + m.failure;
}

// Run times: a row for each method, a column for each mesh
inline std::string times_table(const Results& results)
{
  std::vector<std::string> titles = {"method"};
  std::vector<const Mesh_results*> meshes;
  for(const Mesh_results& mesh : results.meshes) {
    if(mesh.triangles <= most_of_table_1) {
      meshes.push_back(&mesh);
      titles.push_back(mesh.title());
    }
  }
  Table table(titles, 1);
  for(const Method_title& method : results.methods) {
    std::vector<std::string> cells = {method.title};
    for(const Mesh_results* mesh : meshes) {
      cells.push_back(seconds_cell(mesh->number(method.name, "seconds")));
    }
    table.add(cells);
  }
  return table.text();
}

// Run time, distortion, flips and memory: a row for each mesh and method
inline std::string distortions_table(const Results& results, const std::size_t least, const std::size_t most)
{
  Table table({"mesh", "faces", "method", "seconds", "shear", "principal shear", "stretch",
               "angular distortion", "flips", "memory, MB", "note"},
              3);
  bool empty = true;
  for(const Mesh_results& mesh : results.meshes) {
    if(mesh.triangles <= least || mesh.triangles > most) {
      continue;
    }
    empty = false;
    for(const Method_title& method : results.methods) {
      const Measurement& m = mesh.measurements.at(method.name);
      const std::vector<std::string> cells = {mesh.name, std::to_string(mesh.triangles), method.title};
      if(m.succeeded()) {
        table.add({cells[0], cells[1], cells[2], seconds_cell(m["seconds"]), cell("%.4f", m["shear"]),
                   cell("%.4f", m["principal_shear"]), cell("%.5g", m["stretch"]), cell("%.3e", m["angular"]),
                   count_cell(m["flips"]), cell("%.1f", m["bytes"] / 1e6),
                   m["border_is_simple"] == 1 ? "" : "the border crosses itself"});
      } else {
        table.add({cells[0], cells[1], cells[2], "–", "–", "–", "–", "–", "–", "–", failure_cell(m)});
      }
    }
  }
  return empty ? "There was no such mesh.\n" : table.text();
}

// Geometric means over the meshes that both methods could do, without those where the one or the other is infinite
inline std::string ratios_table(const Results& results, const std::string& reference)
{
  Table table(
      {"method", "meshes", "time", "memory", "principal shear", "stretch", "of meshes", "angular distortion"},
      1);
  for(const Method_title& method : results.methods) {
    const auto ratio = [&](const std::string& name) {
      std::vector<double> ratios;
      for(const Mesh_results& mesh : results.meshes) {
        const double ratio = mesh.number(method.name, name) / mesh.number(reference, name);
        if(std::isfinite(ratio) && ratio > 0 && !mesh.is_flat()) {
          ratios.push_back(ratio);
        }
      }
      return ratios;
    };
    const auto mean = [&](const std::string& name) { return cell("%.3g", geometric_mean(ratio(name))); };
    table.add({method.title, std::to_string(ratio("seconds").size()), mean("seconds"), mean("bytes"),
               mean("principal_shear"), mean("stretch"), std::to_string(ratio("stretch").size()),
               mean("angular")});
  }
  return table.text();
}

} // namespace compare

#endif // COMPARE_TABLES_H
