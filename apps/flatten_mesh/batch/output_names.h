// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OUTPUT_NAMES_H
#define FLATTEN_MESH_OUTPUT_NAMES_H

#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline std::filesystem::path absolute_folder(const std::string& input)
{
  std::error_code ignored;
  return std::filesystem::absolute(input, ignored).lexically_normal().parent_path();
}

} // namespace internal

// The deepest folder that all files are in
inline std::filesystem::path common_folder(const std::vector<std::string>& inputs)
{
  std::filesystem::path common;
  for(const std::string& input : inputs) {
    if(input == standard_input) {
      continue;
    }
    const std::filesystem::path folder = internal::absolute_folder(input);
    if(common.empty()) {
      common = folder;
    }
    const auto end = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end()).first;
    std::filesystem::path shorter;
    std::for_each(common.begin(), end, [&shorter](const std::filesystem::path& part) { shorter /= part; });
    common = shorter;
  }
  return common;
}

// What '%' stands for. With an output folder, that is also the folder of the input below the one in common.
inline std::string name_for_outputs(const Batch_options& batch, const std::string& input)
{
  if(input == standard_input) {
    return "stdin";
  }
  const std::string stem = std::filesystem::path(input).stem().string();
  if(batch.output_folder.empty()) {
    return stem;
  }
  const std::filesystem::path folder =
      internal::absolute_folder(input).lexically_relative(batch.common_folder);
  return folder == "." ? stem : (folder / stem).string();
}

inline std::string in_output_folder(const Batch_options& batch, const std::string& file)
{
  return batch.output_folder.empty() || file.empty() || file == standard_output
             ? file
             : (std::filesystem::path(batch.output_folder) / file).string();
}

// The folder of an output, if the output folder is given
inline void make_folder(const Batch_options& batch, const std::string& file)
{
  if(batch.output_folder.empty() || file.empty() || file == standard_output) {
    return;
  }
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::filesystem::create_directories(folder, error);
  if(error) {
    throw Output_error("cannot make the folder '" + folder.string() + "': " + error.message());
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OUTPUT_NAMES_H
