// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_SKIPPED_H
#define FLATTEN_MESH_REPORT_SKIPPED_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

using CGAL::Texture_atlas::internal::skipped_json;

inline Report_rows skipped_rows(const std::vector<TA::Atlas_report::Skipped>& parts)
{
  std::size_t faces = 0;
  for(const TA::Atlas_report::Skipped& part : parts) {
    faces += part.number_of_faces;
  }
  return faces == 0 ? Report_rows()
                    : Report_rows{{"skipped", count_text(faces, "face"),
                                   "without chart, in " + count_text(parts.size(), "part")}};
}

// The name of the model that lacks a part
inline std::string title_of_model(const Command_line& command, const TA::Atlas_report::Skipped& part)
{
  return command.atlas.is_shared ? in_one_line("'" + command.inputs[part.mesh] + "'") : command.title;
}

} // namespace internal

// On standard error: a line for each diagnosis of a model, in the order of their first parts
inline void tell_skipped_parts(const Command_line& command,
                               const std::vector<TA::Atlas_report::Skipped>& parts)
{
  std::vector<std::vector<const TA::Atlas_report::Skipped*>> groups;
  std::map<std::pair<std::size_t, TA::Diagnosis>, std::size_t> numbers;
  for(const TA::Atlas_report::Skipped& part : parts) {
    const std::size_t number =
        numbers.emplace(std::pair(part.mesh, part.status), groups.size()).first->second;
    groups.resize((std::max)(groups.size(), number + 1));
    groups[number].push_back(&part);
  }
  for(const std::vector<const TA::Atlas_report::Skipped*>& group : groups) {
    const TA::Atlas_report::Skipped& first = *group.front();
    std::size_t faces = 0;
    for(const TA::Atlas_report::Skipped* const part : group) {
      faces += part->number_of_faces;
    }
    std::cerr << "flatten_mesh: " << internal::title_of_model(command, first) << ": no chart for "
              << (group.size() == 1 ? "" : count_text(group.size(), "part") + " with ")
              << count_text(faces, "face") << ", the first is " << face_name(first.first_face) << ": "
              << first.status << ": " << first.message
              << (group.size() == 1 ? "" : "; --json FILE.json lists all") << std::endl;
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_SKIPPED_H
