// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_OPTION_TAKER_H
#define ABF_PYTHON_OPTION_TAKER_H

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <vector>

namespace abf_python {

namespace py = pybind11;

// Takes options by their names.
class Option_taker
{
public:
  explicit Option_taker(const py::dict& options) : m_options(options) {}

  template <class Value>
  void operator()(const char* const name, Value& value) const
  {
    if(m_options.contains(name)) {
      value = m_options[name].cast<Value>();
    }
  }

  // A word for each value of an enumeration, in their order
  template <class Value>
  void operator()(const char* const name, Value& value, const std::vector<std::string>& words) const
  {
    if(m_options.contains(name)) {
      const auto word = std::find(words.begin(), words.end(), m_options[name].cast<std::string>());
      value = static_cast<Value>(word - words.begin()); // the Python side has checked it
    }
  }

private:
  const py::dict& m_options;
};

} // namespace abf_python

#endif // ABF_PYTHON_OPTION_TAKER_H
