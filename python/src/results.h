// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_RESULTS_H
#define ABF_PYTHON_RESULTS_H

#include "failures.h"
#include "interface.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace abf_python {

// The numbers of an array that Python takes without a copy
struct Owned_numbers
{
  virtual ~Owned_numbers() = default;
};

template <class Number>
struct Owned_vector : Owned_numbers
{
  std::vector<Number> numbers;
  explicit Owned_vector(std::vector<Number>&& numbers) : numbers(std::move(numbers)) {}
};

struct Result_array
{
  abf_array view;
  std::unique_ptr<Owned_numbers> owned;
};

} // namespace abf_python

// What a function returns: arrays and a text, or a failure
struct abf_result
{
  int kind = 0; // as in _core.py
  std::string text;
  std::vector<abf_python::Result_array> arrays;
  std::size_t taken = 0; // of the arrays

  template <class Number>
  void add(std::vector<Number>&& numbers, const std::int64_t columns = 1)
  {
    numbers.reserve(1); // numpy wants an address for empty arrays, too
    constexpr char kind_of_number = std::is_floating_point_v<Number> ? 'f'
                                    : std::is_signed_v<Number>       ? 'i'
                                                                     : 'u';
    auto owned = std::make_unique<abf_python::Owned_vector<Number>>(std::move(numbers));
    const std::vector<Number>& kept = owned->numbers;
    constexpr std::int64_t size = sizeof(Number);
    arrays.push_back({{kept.data(),
                       {static_cast<std::int64_t>(kept.size()) / columns, columns},
                       {size * columns, size},
                       kind_of_number,
                       size,
                       static_cast<std::int8_t>(columns == 1 ? 1 : 2)},
                      std::move(owned)});
  }

  template <class Point>
  void add_points(const std::vector<Point>& points)
  {
    std::vector<double> numbers;
    numbers.reserve(2 * points.size());
    for(const Point& p : points) {
      numbers.push_back(p.x());
      numbers.push_back(p.y());
    }
    add(std::move(numbers), 2);
  }

  // Pairs of numbers, one in each row
  void add_pairs(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs)
  {
    std::vector<std::int64_t> numbers;
    numbers.reserve(2 * pairs.size());
    for(const auto& [a, b] : pairs) {
      numbers.push_back(a);
      numbers.push_back(b);
    }
    add(std::move(numbers), 2);
  }
};

namespace abf_python {

// Calls `f` with an empty result, and turns what it throws into a failure. No exception gets into Python.
template <class Function>
abf_result* result_of(const Function& f) noexcept
{
  const auto failure = [](const int kind, const char* const text) {
    auto* const result = new abf_result;
    result->kind = kind;
    result->text = text;
    return result;
  };
  try {
    auto result = std::make_unique<abf_result>();
    f(*result);
    return result.release();
  } catch(const Wrong_value& error) {
    return failure(1, error.what());
  } catch(const Wrong_type& error) {
    return failure(2, error.what());
  } catch(Mesh_failure& error) {
    auto* const result = failure(3, error.what());
    result->text = error.status + "\n" + std::to_string(error.mesh) + "\n" + error.message;
    result->add(std::move(error.faces));
    result->add(std::move(error.vertices));
    return result;
  } catch(const std::bad_alloc&) {
    return failure(4, "not enough memory");
  } catch(const std::exception& error) {
    return failure(5, error.what());
  }
}

} // namespace abf_python

#endif // ABF_PYTHON_RESULTS_H
