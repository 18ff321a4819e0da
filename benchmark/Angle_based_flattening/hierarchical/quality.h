// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_QUALITY_H
#define HIERARCHICAL_QUALITY_H

#include "Command_line.h"
#include "Runner.h"
#include "measure.h"
#include "tables.h"
#include "test_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace hierarchical {

namespace internal {

struct Quality
{
  std::string name;
  Measurement direct, hierarchical;

  double shear_rise() const { return rise(direct, hierarchical, "shear"); }
  double stretch_rise() const { return rise(direct, hierarchical, "stretch"); }
  double kernel_percent() const { return 100 * hierarchical["kernel_insertions"] / hierarchical["vertices"]; }
};

// The meshes as they are, and the one mesh subdivided
inline std::vector<Quality> measure_quality(const Command_line& command)
{
  const Temporary_folder folder;
  std::vector<std::string> files = command.compared_files();
  const std::vector<std::size_t> sizes = triangles_of_list(command.sizes, "--sizes");
  if(sizes.size() > 1) {
    files.push_back(resized_mesh(command, folder, sizes[1]));
  }
  std::vector<Quality> results;
  for(const std::string& file : files) {
    const std::vector<Measurement> m = Runner(command).run({{direct, file}, {habf, file}});
    results.push_back({name_of_file(file), m[0], m[1]});
  }
  return results;
}

inline std::string quality_table(const std::vector<Quality>& meshes)
{
  Table table({"mesh", "triangles", "shear, direct", "hierarchical", "rise", "stretch, direct",
               "hierarchical", "rise", "shear as returned, direct", "hierarchical", "kernel insertions",
               "% of vertices", "retries", "flips"},
              1);
  for(const Quality& mesh : meshes) {
    const Measurement &d = mesh.direct, &h = mesh.hierarchical;
    if(!d.succeeded() || !h.succeeded()) {
      table.add_failure({mesh.name}, d.succeeded() ? h : d);
      continue;
    }
    table.add({mesh.name, count_cell(h["triangles"]), cell("%.4f", d["shear"]), cell("%.4f", h["shear"]),
               cell("%+.4f", mesh.shear_rise()), cell("%.4f", d["stretch"]), cell("%.4f", h["stretch"]),
               cell("%+.4f", mesh.stretch_rise()), cell("%.4f", d["shear_as_returned"]),
               cell("%.4f", h["shear_as_returned"]), count_cell(h["kernel_insertions"]),
               cell("%.4f", mesh.kernel_percent()), count_cell(h["retries"]), count_cell(h["flips"])});
  }
  return table.text();
}

// NaN if the mesh has no target: these go by the names of well-known meshes.
inline double largest_shear_rise(const std::string& name)
{
  const std::vector<std::pair<std::string, double>> limits = {
      {"bunny", 0.002}, {"lionhead", 0.002}, {"horse", 0.002}, {"armadillo", 0.004}, {"camel", 0.008}};
  for(const auto& [mesh, limit] : limits) {
    if(name.find(mesh) != std::string::npos) {
      return limit;
    }
  }
  return (std::numeric_limits<double>::quiet_NaN)();
}

inline std::string quality_targets(const std::vector<Quality>& meshes)
{
  Targets targets;
  double most_kernel_insertions = 0, flips = 0;
  for(const Quality& mesh : meshes) {
    const double limit = largest_shear_rise(mesh.name);
    if(!std::isnan(limit)) {
      targets.at_most("rise of shear, " + mesh.name, "%.4f", mesh.shear_rise(), limit);
      targets.at_most("rise of stretch, " + mesh.name, "%.4f", mesh.stretch_rise(), 0.015);
    }
    if(mesh.hierarchical.succeeded()) {
      most_kernel_insertions = (std::max)(most_kernel_insertions, mesh.kernel_percent());
      flips += mesh.hierarchical["flips"];
    }
  }
  targets.at_most("kernel insertions, % of the vertices of any mesh", "%.4f", most_kernel_insertions, 0.02);
  targets.at_most("flips of all", "%.0f", flips, 0);
  return targets.text();
}

} // namespace internal

inline std::string quality_part(const Command_line& command)
{
  const std::vector<internal::Quality> meshes = internal::measure_quality(command);
  return "Direct ABF++ and the hierarchical one at the default rate. The shear of Eq. 24 depends on the "
         "direction of the axes; the rise is that of its root mean square over all directions, and the "
         "shear as returned is the one along the axes of the coordinates.\n\n" +
         internal::quality_table(meshes) + internal::quality_targets(meshes);
}

} // namespace hierarchical

#endif // HIERARCHICAL_QUALITY_H
