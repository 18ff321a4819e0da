// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_TABLES_H
#define HIERARCHICAL_TABLES_H

#include "../common/Measurement.h"
#include "../common/Table.h"

#include <cmath>
#include <string>

namespace hierarchical {

using namespace benchmarks;

// Ratios and rises of what was not measured are NaN, and become dashes.
inline double rise(const Measurement& from, const Measurement& to, const char* name)
{
  return to[name] - from[name];
}

// The table of what was to be reached and what was. A number that was not measured misses its target.
class Targets
{
public:
  void at_most(const std::string& what, const char* format, const double number, const double limit)
  {
    add(what, std::string("at most ") + format_number(format, limit), format, number, number <= limit);
  }

  void at_least(const std::string& what, const char* format, const double number, const double limit)
  {
    add(what, std::string("at least ") + format_number(format, limit), format, number, number >= limit);
  }

  std::string text() const { return "\n" + m_table.text(); }

private:
  void add(const std::string& what, const std::string& limit, const char* format, const double number,
           const bool met)
  {
    m_table.add({what, limit, cell(format, number),
                 std::isnan(number) ? "not measured"
                 : met              ? "yes"
                                    : "NO"});
  }

  Table m_table{{"target", "limit", "measured", "met"}, 1};
};

} // namespace hierarchical

#endif // HIERARCHICAL_TABLES_H
