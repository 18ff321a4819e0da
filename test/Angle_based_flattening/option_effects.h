// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_OPTION_EFFECTS_H
#define ANGLE_BASED_FLATTENING_OPTION_EFFECTS_H

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/option_table.h>

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Changes each option of a struct, alone and in situations that other options make. The result changes, or the option
// is refused by name. Names come from the tables of options: a new option without another value here is an error.
namespace option_effects {

// What a caller sees of a run. The clock and memory do not count.
struct Outcome
{
  CGAL::Surface_mesh_parameterization::Diagnosis status;
  std::string message;
  std::string text; // the rest

  bool is_refusal() const { return status == CGAL::Surface_mesh_parameterization::Diagnosis::WRONG_OPTION; }
  bool names(const std::string& option) const { return message.find(option) != std::string::npos; }
  bool differs_from(const Outcome& other) const
  {
    return status != other.status || message != other.message || text != other.text;
  }
};

// Other values of options, by their names
template <typename Options>
using Changes = std::multimap<std::string, std::function<void(Options&)>>;

template <typename Options, typename Class, typename Value>
std::function<void(Options&)> set(Value Class::*member, Value value)
{
  return [member, value](Options& options) { options.*member = value; };
}

template <typename Options>
struct Checks
{
  Changes<Options> changes;
  std::map<std::string, std::function<void(Options&)>> situations;
  std::function<std::vector<Outcome>(const Options&)> run; // on several surfaces
  std::function<std::map<std::string, std::string>(const Options&)> values_of;

  // Whether an option may have no effect in a situation. It must have one in another.
  std::function<bool(const std::string&, const std::string&)> may_be_idle;
  std::set<std::string> always_idle;  // without any effect
  std::set<std::string> only_refused; // values that are never accepted

  void check() const
  {
    const auto defaults = values_of(Options());
    for(const auto& [name, value] : defaults)
      BOOST_TEST(changes.count(name) > 0, "there is no other value for the option " << name);
    std::set<std::string> effective, refused;
    for(const auto& [situation, prepare] : situations) {
      Options base;
      prepare(base);
      const std::vector<Outcome> before = run(base);
      for(const auto& [name, change] : changes) {
        Options options = base;
        change(options);
        if(values_of(options) == values_of(base))
          continue;
        const std::vector<Outcome> after = run(options);
        bool differs = false;
        for(std::size_t i = 0; i < after.size(); ++i)
          if(after[i].differs_from(before[i])) {
            differs = true;
            (after[i].is_refusal() ? refused : effective).insert(name);
          }
        BOOST_TEST((differs || may_be_idle(name, situation) || always_idle.count(name) > 0),
                   "with " << situation << ", the option " << name << " has no effect, and is not refused");
      }
    }
    for(const auto& [name, value] : defaults) {
      const std::set<std::string>& expected = only_refused.count(name) > 0 ? refused : effective;
      BOOST_TEST((expected.count(name) > 0 || always_idle.count(name) > 0),
                 "the option " << name << " has no effect in any situation");
    }
  }
};

// The values of options in the table, by their names. The table says how they are written.
template <typename Options>
void add_values(Options options, const std::string& prefix, std::map<std::string, std::string>& values)
{
  using CGAL::Surface_mesh_parameterization::internal::ABF::
      visit_options; // others are found by their argument
  visit_options(options, [&](const std::string& name, const auto& value, const auto& range, const char*) {
    values[prefix + name] = range.value_text(value);
  });
}

} // namespace option_effects

#endif // ANGLE_BASED_FLATTENING_OPTION_EFFECTS_H
