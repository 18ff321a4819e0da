// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OWN_MATERIALS_H
#define FLATTEN_MESH_OWN_MATERIALS_H

#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/material_files.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace flatten_mesh {

// Throws if a material file of the model would be overwritten by another one.
inline void check_material_file(const std::string& material_file, const Model& model)
{
  const std::filesystem::path folder = internal::folder_of(model.name);
  for(const Statement& statement : model.statements) {
    for(const std::string& name : internal::material_files_in(statement.text, folder)) {
      if(is_same_file((folder / name).string(), material_file)) {
        throw Output_error(
            "'" + material_file +
            "' would overwrite the material file of the input: choose another name for --output");
      }
    }
  }
}

// The material file replaces those of the model. Faces before the first material of the model get `material`.
inline void replace_materials(const std::string& material_file, const std::string& material, Model& model)
{
  auto& statements = model.statements;
  statements.erase(
      std::remove_if(statements.begin(), statements.end(),
                     [](const Statement& statement) { return statement.text.compare(0, 7, "mtllib ") == 0; }),
      statements.end());
  const std::string file = std::filesystem::path(material_file).filename().string();
  statements.insert(statements.begin(), {{0, "mtllib " + file}, {0, "usemtl " + material}});
}

// A material file with the materials of a model, and with `material`. All of them have the same pictures, whose lines
// are given. A picture of colours is multiplied by the colour of its material, which is then white.
inline std::string material_text(const std::string& title, const std::string& material,
                                 const std::string& pictures, const bool has_colors, const Model& model)
{
  std::vector<std::string> names = model.material_names;
  std::vector<Point_color> colors = material_colors(model);
  if(std::find(names.begin(), names.end(), material) == names.end()) {
    names.push_back(material);
    colors.push_back({1, 1, 1, 1});
  }
  std::string text = "# " + title + ", by flatten_mesh\n";
  for(std::size_t i = 0; i < names.size(); ++i) {
    const Point_color color = has_colors ? Point_color{1, 1, 1, colors[i][3]} : colors[i];
    text += "newmtl " + names[i] + "\nKd " + format_number("%.6g", color[0]) + " " +
            format_number("%.6g", color[1]) + " " + format_number("%.6g", color[2]) + "\nd " +
            format_number("%.6g", color[3]) + "\n" + pictures;
  }
  return text;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OWN_MATERIALS_H
