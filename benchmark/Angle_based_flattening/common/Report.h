// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_REPORT_H
#define BENCHMARKS_COMMON_REPORT_H

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

// Text that goes to standard output, and to a file if that has a name. What was added is not lost if the program is
// stopped.
class Report
{
public:
  explicit Report(const std::string& file) : m_file(file) {}

  void add(const std::string& text)
  {
    m_text += text;
    std::cout << text << std::flush;
    if(!m_file.empty()) {
      write_file(m_file, m_text);
    }
  }

private:
  std::string m_file, m_text;
};

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_REPORT_H
