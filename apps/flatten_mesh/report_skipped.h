// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_SKIPPED_H
#define FLATTEN_MESH_REPORT_SKIPPED_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Skipped_part.h>

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

// Faces are counted from 1, in the file of their model.
inline Json skipped_json(const std::vector<Skipped_part>& parts,
                         const std::vector<std::string>& names_of_models = {})
{
  return json_array(parts, [&](const Skipped_part& part) {
    Json json;
    if(!names_of_models.empty()) {
      json["input"] = names_of_models[part.model];
    }
    json["first_face"] = part.first_face + 1;
    json["faces"] = part.faces;
    json["diagnosis"] = part.status;
    json["message"] = part.message;
    return json;
  });
}

inline Report_rows skipped_rows(const std::vector<Skipped_part>& parts)
{
  std::size_t faces = 0;
  for(const Skipped_part& part : parts) {
    faces += part.faces;
  }
  return faces == 0 ? Report_rows()
                    : Report_rows{{"skipped", count_text(faces, "face"),
                                   "without chart, in " + count_text(parts.size(), "part")}};
}

// The name of the model that lacks a part
inline std::string title_of_model(const Command_line& command, const Skipped_part& part)
{
  return command.atlas.is_shared ? in_one_line("'" + command.inputs[part.model] + "'") : command.title;
}

} // namespace internal

// On standard error: a line for each diagnosis of a model, in the order of their first parts
inline void tell_skipped_parts(const Command_line& command, const std::vector<Skipped_part>& parts)
{
  std::vector<std::vector<const Skipped_part*>> groups;
  std::map<std::pair<std::size_t, std::string>, std::size_t> numbers;
  for(const Skipped_part& part : parts) {
    const std::size_t number =
        numbers.emplace(std::pair(part.model, part.status), groups.size()).first->second;
    groups.resize((std::max)(groups.size(), number + 1));
    groups[number].push_back(&part);
  }
  for(const std::vector<const Skipped_part*>& group : groups) {
    const Skipped_part& first = *group.front();
    std::size_t faces = 0;
    for(const Skipped_part* const part : group) {
      faces += part->faces;
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
