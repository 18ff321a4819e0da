// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MATERIAL_FILES_H
#define FLATTEN_MESH_MATERIAL_FILES_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Text_lines.h"
#include "flatten_mesh/model/text_numbers.h"
#include "flatten_mesh/file_names.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The names after 'mtllib'. Blanks separate them, but may also be part of one.
inline std::vector<std::string> material_files_in(const std::string& statement,
                                                  const std::filesystem::path& folder)
{
  const std::string begin = "mtllib ";
  if(statement.compare(0, begin.size(), begin) != 0) {
    return {};
  }
  const std::string rest = statement.substr(begin.size());
  std::error_code ignored;
  if(std::filesystem::exists(folder / rest, ignored)) {
    return {rest};
  }
  std::vector<std::string> names;
  std::istringstream words(rest);
  for(std::string name; words >> name;) {
    names.push_back(name);
  }
  return names;
}

// The folder that the names in a file are relative to
inline std::filesystem::path folder_of(const std::string& file)
{
  return file == standard_output ? std::filesystem::current_path()
                                 : std::filesystem::absolute(file).parent_path();
}

// The colours and opacities in a material file
inline void read_material_colors(const std::string& text, std::map<std::string, Point_color>& colors)
{
  Text_lines lines(text, Text_lines::BACKSLASHES);
  Point_color* color = nullptr;
  const auto read = [&lines](double& number) {
    double value = 0;
    if(read_finite_number(lines.word(), value)) {
      number = (std::min)((std::max)(value, 0.), 1.);
    }
  };
  while(lines.next()) {
    const std::string keyword(lines.word());
    if(keyword == "newmtl") {
      color = &(colors[lines.rest()] = {1, 1, 1, 1});
    } else if(color != nullptr && keyword == "Kd") {
      read((*color)[0]);
      read((*color)[1]);
      read((*color)[2]);
    } else if(color != nullptr && keyword == "d") {
      read((*color)[3]);
    }
  }
}

} // namespace internal

// The diffuse colours of a model's materials, as far as they are known or its material files can be read. White
// otherwise.
inline std::vector<Point_color> material_colors(const Model& model)
{
  if(!model.material_colors.empty()) {
    return model.material_colors;
  }
  const std::filesystem::path folder = internal::folder_of(model.name);
  std::map<std::string, Point_color> all;
  for(const Statement& statement : model.statements) {
    for(const std::string& name : internal::material_files_in(statement.text, folder)) {
      std::error_code ignored;
      if(std::filesystem::is_regular_file(folder / name, ignored)) { // and no device, which may have no end
        std::ifstream file(folder / name, std::ios::binary);
        internal::read_material_colors(std::string(std::istreambuf_iterator<char>(file), {}), all);
      }
    }
  }
  std::vector<Point_color> colors;
  for(const std::string& name : model.material_names) {
    const auto material = all.find(name);
    colors.push_back(material == all.end() ? Point_color{1, 1, 1, 1} : material->second);
  }
  return colors;
}

// A line of an OBJ file as it has to be in another folder: the names of material files lead to where they are. Names
// of files that are not there stay as they are.
inline std::string statement_elsewhere(const Statement& statement, const std::string& from,
                                       const std::string& to)
{
  const std::filesystem::path folder = internal::folder_of(from);
  std::string text;
  for(const std::string& name : internal::material_files_in(statement.text, folder)) {
    std::error_code ignored;
    const bool is_there =
        std::filesystem::exists(folder / name, ignored) && std::filesystem::path(name).is_relative();
    const std::filesystem::path elsewhere =
        is_there ? std::filesystem::proximate(folder / name, internal::folder_of(to), ignored)
                 : std::filesystem::path();
    text += " " + (elsewhere.empty() ? name : elsewhere.generic_string());
  }
  return text.empty() ? statement.text : "mtllib" + text;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MATERIAL_FILES_H
