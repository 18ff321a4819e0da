// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options that would have no effect, because another option says so, must have their defaults: the checks of all
// functions with options refuse other values by name.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_IDLE_OPTIONS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_IDLE_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/option_table.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

typedef std::vector<std::string> Option_names;

// The names of options whose values are not those of any of the `defaults`, in the order of the table
template <class Options>
Option_names changed_options(Options options, std::vector<Options> defaults = {Options()})
{
  std::vector<std::pair<std::string, bool>> changes; // and whether no default was equal so far
  visit_options(options, [&](const char* name, const auto&, const auto&, const char*) {
    changes.emplace_back(name, true);
  });
  for(Options& other : defaults) {
    std::vector<std::string> values;
    visit_options(other, [&](const char*, const auto& value, const auto& range, const char*) {
      values.push_back(range.value_text(value));
    });
    std::size_t i = 0;
    visit_options(options, [&](const char*, const auto& value, const auto& range, const char*) {
      changes[i].second = changes[i].second && range.value_text(value) != values[i];
      ++i;
    });
  }
  Option_names names;
  for(const auto& [name, is_changed] : changes)
    if(is_changed)
      names.push_back(name);
  return names;
}

// Finds the first option that was changed but has no effect.
class Idle_options
{
public:
  explicit Idle_options(Option_names changed) : m_changed(std::move(changed)) {}

  // `reason` says why these options have no effect, or what to set for them.
  Idle_options& check(bool are_idle, const Option_names& names, const std::string& reason)
  {
    const auto found = std::find_if(m_changed.begin(), m_changed.end(), [&](const std::string& name) {
      return std::count(names.begin(), names.end(), name) > 0;
    });
    if(are_idle && m_wrong.empty() && found != m_changed.end())
      m_wrong = *found + " would have no effect: " + reason;
    return *this;
  }

  // A sentence on that option, or nothing
  const std::string& wrong() const { return m_wrong; }

private:
  const Option_names m_changed;
  std::string m_wrong;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_IDLE_OPTIONS_H
