// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_REPORT_H
#define FLATTEN_MESH_READ_REPORT_H

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>

namespace flatten_mesh {

using Report_tree = boost::property_tree::ptree;

namespace internal {

// Whether arrays and objects are in more others than those of any report. The parser calls itself for each of them, and
// files of other kinds might use up its stack.
inline bool is_nested_deeply(const std::string& json)
{
  const std::size_t most = 100;
  std::size_t depth = 0;
  bool is_in_text = false;
  for(std::size_t i = 0; i < json.size() && depth <= most; ++i) {
    const char c = json[i];
    if(is_in_text) {
      i += c == '\\' ? 1 : 0;
      is_in_text = c != '"';
    } else if(c == '"') {
      is_in_text = true;
    } else if(c == '[' || c == '{') {
      ++depth;
    } else if((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return depth > most;
}

} // namespace internal

// A report for programs, if the file is one.
inline std::optional<Report_tree> read_report(const std::string& file)
{
  std::ifstream input(file, std::ios::binary);
  const std::string json(std::istreambuf_iterator<char>(input), {});
  if(internal::is_nested_deeply(json)) {
    return std::nullopt;
  }
  std::istringstream stream(json);
  Report_tree tree;
  try {
    boost::property_tree::read_json(stream, tree);
  } catch(const boost::property_tree::json_parser_error&) {
    return std::nullopt;
  }
  const bool is_report = !tree.get<std::string>("status", "").empty() &&
                         tree.get_optional<std::string>("input") && tree.get_optional<int>("exit_status");
  return is_report ? std::optional<Report_tree>(tree) : std::nullopt;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_REPORT_H
