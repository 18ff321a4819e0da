// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_INPUT_LIST_H
#define FLATTEN_MESH_INPUT_LIST_H

#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <istream>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline std::vector<std::string> names_in(std::istream& stream, const bool is_null_separated)
{
  std::vector<std::string> names;
  for(std::string name; std::getline(stream, name, is_null_separated ? '\0' : '\n');) {
    if(!is_null_separated && !name.empty() && name.back() == '\r') {
      name.pop_back();
    }
    if(!name.empty()) {
      names.push_back(name);
    }
  }
  return names;
}

} // namespace internal

// The names in a file, one a line, or with null characters between them. Empty lines are left out.
inline std::vector<std::string> names_in_list(const std::string& list, const bool is_null_separated)
{
  std::ifstream file;
  if(list != standard_input) {
    file.open(list, std::ios::binary);
  }
  std::istream& stream = list == standard_input ? std::cin : file;
  std::vector<std::string> names = internal::names_in(stream, is_null_separated);
  if(stream.bad() || (list != standard_input && !file.is_open())) {
    throw Input_error("cannot read --list '" + list + "'");
  }
  if(names.empty()) {
    throw Input_error("--list '" + list + "' has no name of a file");
  }
  for(const std::string& name : names) {
    if(name == standard_input) {
      throw Input_error("--list '" + list + "' contains '-': standard input is not read from a list");
    }
    if(name.find('\0') != std::string::npos) {
      throw Input_error("--list '" + list + "' has null characters between its names: give --null as well");
    }
  }
  return names;
}

// Which inputs are run: each N-th from the I-th on
struct Shard
{
  std::size_t number = 1; // from 1
  std::size_t shards = 1;
};

inline Shard shard_of(const std::string& text)
{
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.number);
  const bool has_slash = first.ptr != end && *first.ptr == '/';
  const auto second = std::from_chars(has_slash ? first.ptr + 1 : end, end, shard.shards);
  if(second.ec != std::errc() || second.ptr != end || shard.number < 1 || shard.number > shard.shards) {
    throw Usage_error("--shard takes I/N with I from 1 to N, as in 3/8, not '" + text + "'");
  }
  return shard;
}

inline std::vector<std::string> inputs_of_shard(const std::vector<std::string>& inputs, const Shard& shard)
{
  std::vector<std::string> result;
  for(std::size_t i = shard.number - 1; i < inputs.size(); i += shard.shards) {
    result.push_back(inputs[i]);
  }
  return result;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_INPUT_LIST_H
