// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_ARRAYS_H
#define ABF_PYTHON_ARRAYS_H

#include "failures.h"
#include "interface.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

// Arrays of numpy are read where they are, whatever their strides.

namespace abf_python {

// The elements of an array, which has numbers of this type
template <class Number>
class Elements
{
public:
  explicit Elements(const abf_array& array) : m_array(array) {}

  Number operator()(const std::int64_t i, const std::int64_t j = 0) const
  {
    Number number; // which numpy may have put at any address
    std::memcpy(&number,
                static_cast<const char*>(m_array.data) + i * m_array.strides[0] + j * m_array.strides[1],
                sizeof number);
    return number;
  }

private:
  const abf_array& m_array;
};

inline bool is_given(const abf_array& array)
{
  return array.kind != 0;
}

// Calls `f` with the elements of an array of floating point numbers.
template <class Function>
void with_numbers(const abf_array& array, const Function& f)
{
  if(array.kind != 'f' || (array.size != 4 && array.size != 8)) {
    throw Wrong_type("an array has neither float32 nor float64 numbers");
  }
  if(array.size == 4) {
    f(Elements<float>(array));
  } else {
    f(Elements<double>(array));
  }
}

// Calls `f` with the elements of an array of integers.
template <class Function>
void with_integers(const abf_array& array, const Function& f)
{
  const bool is_signed = array.kind == 'i';
  if((!is_signed && array.kind != 'u') || (array.size != 4 && array.size != 8)) {
    throw Wrong_type("an array has no integers of 32 or 64 bits");
  }
  if(array.size == 4) {
    is_signed ? f(Elements<std::int32_t>(array)) : f(Elements<std::uint32_t>(array));
  } else {
    is_signed ? f(Elements<std::int64_t>(array)) : f(Elements<std::uint64_t>(array));
  }
}

// A number that has to be at least 0 and below a bound
template <class Integer>
std::uint32_t index_below(const Integer number, const std::size_t bound, const std::string& place,
                          const char* const what)
{
  if(number < Integer(0) || static_cast<std::uint64_t>(number) >= bound) {
    throw Wrong_value(place + " is " + std::to_string(number) + ", but there are " + std::to_string(bound) +
                      " " + what);
  }
  return static_cast<std::uint32_t>(number);
}

// The entries of an array of integers in the order of its rows, each below a bound
inline std::vector<std::uint32_t> read_indices(const abf_array& array, const std::size_t bound,
                                               const std::string& name, const char* const what)
{
  std::vector<std::uint32_t> result;
  result.reserve(static_cast<std::size_t>(array.shape[0] * array.shape[1]));
  with_integers(array, [&](const auto& elements) {
    for(std::int64_t i = 0; i < array.shape[0]; ++i) {
      for(std::int64_t j = 0; j < array.shape[1]; ++j) {
        const auto number = elements(i, j);
        if(number < 0 || static_cast<std::uint64_t>(number) >= bound) { // only then, its place becomes a text
          const std::string column = array.dimensions == 1 ? "" : ", " + std::to_string(j);
          index_below(number, bound, name + "[" + std::to_string(i) + column + "]", what);
        }
        result.push_back(static_cast<std::uint32_t>(number));
      }
    }
  });
  return result;
}

// Rows of two or three numbers
template <class Point, int Dimension>
std::vector<Point> read_points(const abf_array& array)
{
  std::vector<Point> result;
  result.reserve(static_cast<std::size_t>(array.shape[0]));
  with_numbers(array, [&](const auto& elements) {
    for(std::int64_t i = 0; i < array.shape[0]; ++i) {
      if constexpr(Dimension == 2) {
        result.emplace_back(elements(i, 0), elements(i, 1));
      } else {
        result.emplace_back(elements(i, 0), elements(i, 1), elements(i, 2));
      }
    }
  });
  return result;
}

inline std::vector<double> read_numbers(const abf_array& array)
{
  std::vector<double> result;
  with_numbers(array, [&](const auto& elements) {
    for(std::int64_t i = 0; i < array.shape[0]; ++i) {
      result.push_back(elements(i));
    }
  });
  return result;
}

} // namespace abf_python

#endif // ABF_PYTHON_ARRAYS_H
