// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_SKIPPED_H
#define FLATTEN_MESH_REPORT_SKIPPED_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/json.h"
#include "flatten_mesh/model/Skipped_part.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Faces are counted from 1, in the file of their model.
inline std::string skipped_json(const std::vector<Skipped_part>& parts,
                                const std::vector<std::string>& names_of_models = {})
{
  return json_array(parts, [&](const std::size_t i) {
    Json_object json;
    if(!names_of_models.empty()) {
      json.add("input", json_text(names_of_models[parts[i].model]));
    }
    json.add("first_face", json_number(parts[i].first_face + 1));
    json.add("faces", json_number(parts[i].faces));
    json.add("diagnosis", json_text(parts[i].status));
    json.add("message", json_text(parts[i].message));
    return json.text();
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

// On standard error
inline void tell_skipped_parts(const Command_line& command, const std::vector<Skipped_part>& parts)
{
  const std::size_t most = 10;
  for(std::size_t i = 0; i < (std::min)(most, parts.size()); ++i) {
    const Skipped_part& part = parts[i];
    std::cerr << "flatten_mesh: " << internal::title_of_model(command, part) << ": no chart for "
              << count_text(part.faces, "face") << ", the first is " << face_name(part.first_face) << ": "
              << part.status << ": " << part.message << std::endl;
  }
  if(parts.size() > most) {
    std::cerr << "flatten_mesh: " << command.title << ": no chart for " << parts.size() - most
              << " more parts; --json FILE.json lists all" << std::endl;
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_SKIPPED_H
