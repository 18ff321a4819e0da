// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_OPTION_TAKER_H
#define ABF_PYTHON_OPTION_TAKER_H

#include <CGAL/Texture_atlas/internal/options/option_table.h>

#include <pybind11/pybind11.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <type_traits>

namespace abf_python {

namespace py = pybind11;
namespace abf = CGAL::Texture_atlas::internal;

// Options that have no keyword: `timeout` bounds the time, and coordinates are not rounded.
inline bool has_keyword(const std::string& name)
{
  return name != "time_limit" && name != "float_coordinates";
}

[[noreturn]] inline void fail_on_type(const std::string& name, const py::handle value,
                                      const std::string& expected)
{
  throw py::type_error(name + " is a " + py::type::of(value).attr("__name__").cast<std::string>() +
                       ", and must be " + expected);
}

inline void check_value(const std::string& wrong)
{
  if(!wrong.empty()) {
    throw py::value_error(wrong);
  }
}

inline double number_of(const std::string& name, const py::handle value)
{
  if(py::isinstance<py::bool_>(value) || !py::hasattr(value, "__float__")) {
    fail_on_type(name, value, "a number");
  }
  return py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>();
}

// As a `double`, so that integers of any size are compared with the range
inline double integer_of(const std::string& name, const py::handle value)
{
  if(py::isinstance<py::bool_>(value) || !py::hasattr(value, "__index__")) {
    fail_on_type(name, value, "an integer");
  }
  return number_of(name, value.attr("__index__")());
}

template <class Member>
void take(const std::string& name, const py::handle value, Member& member, const abf::Option_range& range)
{
  using Number = typename decltype(std::optional(member))::value_type;
  const double number = std::is_same_v<Number, int> ? integer_of(name, value) : number_of(name, value);
  check_value(abf::wrong_value(name, number, range));
  member = static_cast<Number>(number);
}

template <class Member>
void take(const std::string& name, const py::handle value, Member& member, const abf::Option_words& known)
{
  if(!py::isinstance<py::str>(value)) {
    fail_on_type(name, value, known.text());
  }
  const std::string word = value.cast<std::string>();
  const auto found = std::find(known.words.begin(), known.words.end(), word);
  if(found == known.words.end()) {
    throw py::value_error(name + " is '" + word + "', and must be " + known.text());
  }
  member = static_cast<Member>(found - known.words.begin());
}

template <class Member>
void take(const std::string& name, const py::handle value, Member& member, const abf::Option_switch&)
{
  if(!py::isinstance<py::bool_>(value) &&
     !py::isinstance(value, py::module_::import("numpy").attr("bool_"))) {
    fail_on_type(name, value, "True or False");
  }
  member = value.cast<bool>();
}

// Sets the options that are given, by the table of all options; None stands for the default. `owner` is for the error
// about an unknown name.
template <class Options>
void take_options(const py::dict& given, const std::string& owner, Options& options)
{
  std::set<std::string> known;
  using abf::visit_options; // of parameterizers; others are found by their argument
  visit_options(options, [&](const std::string& name, auto& member, const auto& values, const char*) {
    if(has_keyword(name) && given.contains(name)) {
      known.insert(name);
      if(!given[name.c_str()].is_none()) {
        take(name, given[name.c_str()], member, values);
      }
    }
  });
  for(const auto& item : given) {
    const std::string name = py::str(item.first);
    if(known.count(name) == 0) {
      throw py::type_error("'" + name + "' is not an option of " + owner);
    }
  }
}

// A row of the table for Python: the name, the kind of its values, its default, its values, and what it does
template <class Options>
py::list rows_of_options()
{
  py::list rows;
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
          rows.append(py::make_tuple(name, kind, abf::text_of_default<Options>(name), values.text(), help));
        }
      });
  return rows;
}

} // namespace abf_python

#endif // ABF_PYTHON_OPTION_TAKER_H
