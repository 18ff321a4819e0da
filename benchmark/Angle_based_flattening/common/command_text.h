// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_COMMAND_TEXT_H
#define BENCHMARKS_COMMON_COMMAND_TEXT_H

#include <filesystem>
#include <fstream>
#include <string>

namespace benchmarks {

// The command line of this process as a block of Markdown: what prints a report again, without the folders of this
// machine. Linux only.
inline std::string command_text()
{
  std::ifstream arguments("/proc/self/cmdline");
  std::string text = "   ";
  for(std::string word; std::getline(arguments, word, '\0');) {
    const std::filesystem::path path = word;
    const bool ends_in_slash = path.has_parent_path() && path.filename().empty();
    text += " " + (ends_in_slash ? path.parent_path() : path).filename().string();
  }
  return text + "\n\n";
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_COMMAND_TEXT_H
