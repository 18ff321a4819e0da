// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_PRINT_REPORT_H
#define BENCHMARKS_COMMON_PRINT_REPORT_H

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace benchmarks {

inline void write_file(const std::string& name, const std::string& text)
{
  std::ofstream file(name);
  if(!(file << text << std::flush)) {
    throw std::runtime_error("cannot write '" + name + "'");
  }
}

// To standard output, and to a file if it has a name.
inline void print_report(const std::string& text, const std::string& file)
{
  std::cout << text << std::flush;
  if(!file.empty()) {
    write_file(file, text);
  }
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_PRINT_REPORT_H
