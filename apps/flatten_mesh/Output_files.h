// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OUTPUT_FILES_H
#define FLATTEN_MESH_OUTPUT_FILES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/Unfinished_files.h"
#include "flatten_mesh/batch/output_names.h"
#include "flatten_mesh/bake/baked_files.h"
#include "flatten_mesh/check_outputs.h"
#include "flatten_mesh/commands_of_inputs.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texture_option.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace flatten_mesh {

// The files that are written for an input, first under temporary names.
class Output_files
{
public:
  // No output may have the name of one of these.
  void keep(const std::vector<std::string>& files)
  {
    m_kept.insert(m_kept.end(), files.begin(), files.end());
  }

  Output_file& open(const std::string& name)
  {
    const auto is_kept = [&name](const std::string& file) { return is_same_file(file, name); };
    if(name != standard_output && std::any_of(m_kept.begin(), m_kept.end(), is_kept)) {
      throw Output_error("'" + name +
                         "' would overwrite a file that the input refers to: choose another name");
    }
    m_files.push_back(std::make_unique<Output_file>(name));
    m_names.push_back(name == standard_output ? "standard output" : name);
    return *m_files.back();
  }

  // What people call them
  const std::vector<std::string>& names() const { return m_names; }

  // All files appear together, and only when all of them are complete.
  void publish()
  {
    Unfinished_files::defer_interruptions();
    for(const std::unique_ptr<Output_file>& file : m_files) {
      file->publish();
    }
    Unfinished_files::heed_interruptions();
    remove_abandoned_files();
  }

private:
  // The files that killed runs left in the folders of these outputs
  void remove_abandoned_files() const
  {
    std::set<std::filesystem::path> folders;
    for(const std::unique_ptr<Output_file>& file : m_files) {
      if(!file->target().empty() && !is_other_file(file->target())) {
        folders.insert(file->target().parent_path());
      }
    }
    for(const std::filesystem::path& folder : folders) {
      Unfinished_file::remove_abandoned(folder);
    }
  }

  std::vector<std::unique_ptr<Output_file>> m_files;
  std::vector<std::string> m_names;
  std::vector<std::string> m_kept;
};

// Throws unless everything can be written that is asked for.
inline void check_writable(const Command_line& command)
{
  for(const Command_line& each : commands_of_models(command)) {
    for(const internal::Output_option& option : internal::output_options()) {
      make_folder(each.batch, each.*option.file);
      Output_file::check(each.*option.file);
    }
    for(const std::string& file : files_of_texture(each)) {
      Output_file::check(file);
    }
  }
  for(const std::string& file : baked_files(command)) {
    Output_file::check(file);
  }
}

// The report for people, on standard error if a file takes standard output.
inline void tell_report(const Command_line& command, const std::string& text)
{
  if(command.quiet) {
    return;
  }
  if(takes_standard_output(command)) {
    std::cerr << text << std::flush;
  } else {
    Output_file(standard_output).write(text);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OUTPUT_FILES_H
