// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_MEASUREMENT_H
#define SOLVERS_MEASUREMENT_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace solvers {

// What one process measured of one solver on one matrix.
struct Measurement
{
  static constexpr double largest_residual = 1e-8; // a solution that is further off does not count

  std::string failure;                     // empty if there was none
  double order = 0, factor = 0, solve = 0; // seconds
  double again = -1;                       // seconds of a second factorization, negative: not measured
  double again_solve = 0;                  // seconds
  double nonzeros = 0;                     // of the factors
  double bytes = 0;                        // largest use of memory beyond the matrix
  double residual = 0;                     // relative, the larger one of two solutions
  bool ordering_reused = false;            // by the second factorization

  double first() const { return order + factor; }
  double total() const { return first() + solve; }
};

// The numbers of a measurement, in the order in which they are written
inline std::vector<double Measurement::*> numbers_of_measurement()
{
  typedef Measurement M;
  return {&M::order,       &M::factor,   &M::solve, &M::again,
          &M::again_solve, &M::nonzeros, &M::bytes, &M::residual};
}

// Libraries may print to the output of a measuring process too: its own line starts with this word.
constexpr const char* measurement_tag = "measurement";

inline std::string to_text(const Measurement& measurement)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << '\n' << measurement_tag;
  for(double Measurement::*number : numbers_of_measurement()) {
    text << ' ' << measurement.*number;
  }
  text << ' ' << measurement.ordering_reused << ' ' << measurement.failure << '\n';
  return text.str();
}

inline Measurement failed_measurement(const std::string& reason)
{
  Measurement measurement;
  measurement.failure = reason;
  return measurement;
}

inline Measurement measurement_from_text(const std::string& text)
{
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string tag;
    if(!(words >> tag) || tag != measurement_tag) {
      continue;
    }
    Measurement measurement;
    for(double Measurement::*number : numbers_of_measurement()) {
      words >> measurement.*number;
    }
    if(words >> measurement.ordering_reused) {
      std::getline(words >> std::ws, measurement.failure);
      return measurement;
    }
  }
  return failed_measurement("the process ended without a result");
}

// Number by number, the median of measurements that succeeded; the first failure if one did not.
inline Measurement median(const std::vector<Measurement>& measurements)
{
  for(const Measurement& measurement : measurements) {
    if(!measurement.failure.empty()) {
      return measurement;
    }
  }
  Measurement result;
  for(double Measurement::*number : numbers_of_measurement()) {
    std::vector<double> values;
    for(const Measurement& measurement : measurements) {
      values.push_back(measurement.*number);
    }
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    result.*number = values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  }
  result.ordering_reused = std::all_of(measurements.begin(), measurements.end(),
                                       [](const Measurement& m) { return m.ordering_reused; });
  return result;
}

} // namespace solvers

#endif // SOLVERS_MEASUREMENT_H
