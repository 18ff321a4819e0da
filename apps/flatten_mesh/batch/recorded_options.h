// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RECORDED_OPTIONS_H
#define FLATTEN_MESH_RECORDED_OPTIONS_H

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The options that the results of an input depend on, in the order of their names. Results are the same for any number
// of threads.
inline std::vector<std::string> recorded_options(const boost::program_options::parsed_options& parsed)
{
  static const std::set<std::string> others = {"input", "list",    "null",    "shard",   "jobs",  "resume",
                                               "quiet", "timeout", "verbose", "threads", "memory"};
  std::vector<std::string> result;
  for(const auto& option : parsed.options) {
    if(others.count(option.string_key) == 0) {
      result.push_back("--" + option.string_key + (option.value.empty() ? "" : "=") +
                       boost::algorithm::join(option.value, " "));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RECORDED_OPTIONS_H
