// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_TAKE_OPTIONS_H
#define ABF_PYTHON_TAKE_OPTIONS_H

#include "failures.h"

#include <CGAL/Texture_atlas/internal/json/report_json.h>
#include <CGAL/Texture_atlas/internal/options/option_table.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <type_traits>

namespace abf_python {

namespace abf = CGAL::Texture_atlas::internal;

using abf::Json;

// Options that have no keyword: `timeout` bounds the time, and coordinates are not rounded.
inline bool has_keyword(const std::string& name)
{
  return name != "time_limit" && name != "float_coordinates";
}

// A value as Python gives it
struct Given_value
{
  std::string name; // of the option
  std::string type; // bool, int, float or str, as for numbers of numpy, too; or another type
  std::string text; // 1 for True

  Given_value(const std::string& name, const Json& value) : name(name), type(value.at(0)), text(value.at(1))
  {}

  [[noreturn]] void fail_on_type(const std::string& expected) const
  {
    throw Wrong_type(name + " is a " + type + ", and must be " + expected);
  }

  double number() const { return std::strtod(text.c_str(), nullptr); }
};

inline void check_value(const std::string& wrong)
{
  if(!wrong.empty()) {
    throw Wrong_value(wrong);
  }
}

template <class Member>
void take(const Given_value& value, Member& member, const abf::Option_range& range)
{
  using Number = typename decltype(std::optional(member))::value_type;
  constexpr bool is_integer = std::is_same_v<Number, int>;
  if(value.type != "int" && (is_integer || value.type != "float")) {
    value.fail_on_type(is_integer ? "an integer" : "a number");
  }
  const double number = value.number(); // integers of any size are compared with the range
  check_value(abf::wrong_value(value.name, number, range));
  member = static_cast<Number>(number);
}

template <class Member>
void take(const Given_value& value, Member& member, const abf::Option_words& known)
{
  if(value.type != "str") {
    value.fail_on_type(known.text());
  }
  const auto found = std::find(known.words.begin(), known.words.end(), value.text);
  if(found == known.words.end()) {
    throw Wrong_value(value.name + " is '" + value.text + "', and must be " + known.text());
  }
  member = static_cast<Member>(found - known.words.begin());
}

template <class Member>
void take(const Given_value& value, Member& member, const abf::Option_switch&)
{
  if(value.type != "bool") {
    value.fail_on_type("True or False");
  }
  member = value.text == "1";
}

// Sets the options that are given, by the table of all options. `owner` is for the error about an unknown name.
template <class Options>
void take_options(const Json& given, const std::string& owner, Options& options)
{
  std::set<std::string> known;
  using abf::visit_options; // of parameterizers; others are found by their argument
  visit_options(options, [&](const std::string& name, auto& member, const auto& values, const char*) {
    if(has_keyword(name)) {
      known.insert(name);
      if(const auto value = given.find(name); value != given.end() && !value->is_null()) {
        take(Given_value(name, *value), member, values);
      }
    }
  });
  for(const auto& item : given.items()) {
    if(known.count(item.key()) == 0) {
      throw Wrong_type("'" + item.key() + "' is not an option of " + owner);
    }
  }
}

// The options of a function, from text
template <class Options>
Options options_of(const char* const given, const std::string& owner)
{
  Options options;
  take_options(Json::parse(given), owner, options);
  return options;
}

// The table for Python: of each option the name, the kind of its values, its default, its values, and what it does
template <class Options>
Json rows_of_options()
{
  Json rows = Json::array();
  Options options;
  using abf::visit_options; // of parameterizers; others are found by their argument
  visit_options(
      options, [&](const std::string& name, auto& member, const auto& values, const char* const help) {
        using Values = std::decay_t<decltype(values)>;
        using Number = typename decltype(std::optional(member))::value_type;
        const char* const kind = std::is_same_v<Values, abf::Option_switch>  ? "bool"
                                 : std::is_same_v<Values, abf::Option_words> ? "str"
                                 : std::is_same_v<Number, int>               ? "int"
                                                                             : "float";
        if(has_keyword(name)) {
          rows.push_back(Json::array({name, kind, abf::text_of_default<Options>(name), values.text(), help}));
        }
      });
  return rows;
}

} // namespace abf_python

#endif // ABF_PYTHON_TAKE_OPTIONS_H
