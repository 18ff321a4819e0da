// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_COMMAND_OPTIONS_H
#define BENCHMARKS_COMMON_COMMAND_OPTIONS_H

#include "run_child.h"

#include <boost/program_options.hpp>

#include <sstream>
#include <stdexcept>
#include <string>

namespace benchmarks {

namespace po = boost::program_options;

// For an option whose default is printed with the help
template <class Value>
po::typed_value<Value>* value_with_default(Value& value, const char* name)
{
  return po::value(&value)->value_name(name)->default_value(value);
}

// The options of a benchmark, and those that more than one of them have. They write to variables that must outlive this.
class Command_options
{
public:
  void add(const char* name, const po::value_semantic* value, const char* text)
  {
    m_visible.add_options()(name, value, text);
  }

  // What a process that measures is told, and the help does not mention
  void add_hidden(const char* name, const po::value_semantic* value) { m_hidden.add_options()(name, value); }

  // The option is also what stands alone in the command line, that often (-1: as often as one likes).
  void may_be_left_out(const char* option, const int times) { m_positional.add(option, times); }

  void add_base_mesh(std::string& mesh)
  {
    add("mesh", po::value(&mesh)->value_name("FILE"),
        "a disk, which is simplified or subdivided; the word '--mesh' may be left out. By default the sea "
        "shell of the examples");
    may_be_left_out("mesh", 1);
  }

  void add_repeat(int& repeat)
  {
    add("repeat", value_with_default(repeat, "N"), "of how many processes each the medians are taken");
  }

  void add_limits(Child_limits& limits, const char* seconds_text = "limit of a process; it is killed then")
  {
    add("timeout", value_with_default(limits.seconds, "SECONDS"), seconds_text);
    add("memory", value_with_default(limits.gigabytes, "GB"), "limit of a process");
  }

  void add_output_and_help(std::string& output, bool& help)
  {
    add("output,o", po::value(&output)->value_name("FILE.md"), "write the report there as well");
    add("help,h", po::bool_switch(&help), "print this text");
  }

  // Throws an exception for wrong usage.
  po::variables_map parse(const int argc, char* argv[]) const
  {
    po::options_description all;
    all.add(m_visible).add(m_hidden);
    // No guessing: '--rate' is not short for '--rates'.
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::variables_map values;
    po::store(po::command_line_parser(argc, argv).options(all).positional(m_positional).style(style).run(),
              values);
    po::notify(values);
    return values;
  }

  std::string help_text(const std::string& introduction) const
  {
    std::ostringstream text;
    text << introduction << "\n" << m_visible;
    return text.str();
  }

private:
  po::options_description m_visible{"Options", 100, 60}, m_hidden;
  po::positional_options_description m_positional;
};

// Throws an exception that names the options unless all numbers are above 0.
template <class... Number>
void require_positive(const std::string& options, const Number... numbers)
{
  if(!((numbers > 0) && ...)) {
    throw std::runtime_error(options + " take numbers above 0");
  }
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_COMMAND_OPTIONS_H
