// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_ARRAYS_H
#define ABF_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Arrays of numpy are read where they are, whatever their strides. The Python side has checked their shapes and kinds.

namespace abf_python {

namespace py = pybind11;

// Calls `f` with a view of an array of floating point numbers.
template <int Dimensions, class Function>
void with_numbers(const py::array& array, const Function& f)
{
  if(py::isinstance<py::array_t<float>>(array)) {
    f(array.unchecked<float, Dimensions>());
  } else if(py::isinstance<py::array_t<double>>(array)) {
    f(array.unchecked<double, Dimensions>());
  } else {
    throw py::type_error("an array has neither float32 nor float64 numbers");
  }
}

// Calls `f` with a view of an array of integers.
template <int Dimensions, class Function>
void with_integers(const py::array& array, const Function& f)
{
  if(py::isinstance<py::array_t<std::int32_t>>(array)) {
    f(array.unchecked<std::int32_t, Dimensions>());
  } else if(py::isinstance<py::array_t<std::uint32_t>>(array)) {
    f(array.unchecked<std::uint32_t, Dimensions>());
  } else if(py::isinstance<py::array_t<std::int64_t>>(array)) {
    f(array.unchecked<std::int64_t, Dimensions>());
  } else if(py::isinstance<py::array_t<std::uint64_t>>(array)) {
    f(array.unchecked<std::uint64_t, Dimensions>());
  } else {
    throw py::type_error("an array has no integers of 32 or 64 bits");
  }
}

// A number that has to be at least 0 and below a bound
template <class Integer>
std::uint32_t index_below(const Integer number, const std::size_t bound, const std::string& place,
                          const char* const what)
{
  if(number < Integer(0) || static_cast<std::uint64_t>(number) >= bound) {
    throw py::value_error(place + " is " + std::to_string(number) + ", but there are " +
                          std::to_string(bound) + " " + what);
  }
  return static_cast<std::uint32_t>(number);
}

// The entries of an array of integers in the order of its rows, each below a bound
inline std::vector<std::uint32_t> read_indices(const py::array& array, const std::size_t bound,
                                               const std::string& name, const char* const what)
{
  std::vector<std::uint32_t> result;
  result.reserve(static_cast<std::size_t>(array.size()));
  if(array.ndim() == 1) {
    with_integers<1>(array, [&](const auto& view) {
      for(py::ssize_t i = 0; i < view.shape(0); ++i) {
        result.push_back(index_below(view(i), bound, name + "[" + std::to_string(i) + "]", what));
      }
    });
  } else {
    with_integers<2>(array, [&](const auto& view) {
      for(py::ssize_t i = 0; i < view.shape(0); ++i) {
        for(py::ssize_t j = 0; j < view.shape(1); ++j) {
          if(view(i, j) < 0 || static_cast<std::uint64_t>(view(i, j)) >= bound) {
            index_below(view(i, j), bound, name + "[" + std::to_string(i) + ", " + std::to_string(j) + "]",
                        what);
          }
          result.push_back(static_cast<std::uint32_t>(view(i, j)));
        }
      }
    });
  }
  return result;
}

// Rows of two or three numbers
template <class Point, int Dimension>
std::vector<Point> read_points(const py::array& array)
{
  std::vector<Point> result;
  result.reserve(static_cast<std::size_t>(array.shape(0)));
  with_numbers<2>(array, [&result](const auto& view) {
    for(py::ssize_t i = 0; i < view.shape(0); ++i) {
      if constexpr(Dimension == 2) {
        result.emplace_back(view(i, 0), view(i, 1));
      } else {
        result.emplace_back(view(i, 0), view(i, 1), view(i, 2));
      }
    }
  });
  return result;
}

// An array that owns the numbers of a vector, without a copy
template <class Number>
py::array_t<Number> array_of(std::vector<Number>&& numbers, std::vector<py::ssize_t> shape)
{
  auto* const owned = new std::vector<Number>(std::move(numbers));
  const py::capsule owner(owned, [](void* const p) { delete static_cast<std::vector<Number>*>(p); });
  return py::array_t<Number>(std::move(shape), owned->data(), owner);
}

template <class Point>
py::array_t<double> array_of_points(const std::vector<Point>& points)
{
  std::vector<double> numbers;
  numbers.reserve(2 * points.size());
  for(const Point& p : points) {
    numbers.push_back(p.x());
    numbers.push_back(p.y());
  }
  return array_of(std::move(numbers), {static_cast<py::ssize_t>(points.size()), 2});
}

// Pairs of numbers, one in each row
inline py::array_t<std::int64_t>
array_of_pairs(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
{
  std::vector<std::int64_t> numbers;
  numbers.reserve(2 * pairs.size());
  for(const auto& [a, b] : pairs) {
    numbers.push_back(a);
    numbers.push_back(b);
  }
  return array_of(std::move(numbers), {static_cast<py::ssize_t>(pairs.size()), 2});
}

} // namespace abf_python

#endif // ABF_PYTHON_ARRAYS_H
