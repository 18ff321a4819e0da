// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_MEASUREMENT_H
#define BENCHMARKS_COMMON_MEASUREMENT_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace benchmarks {

// What one process measured: numbers with names.
struct Measurement
{
  std::string failure; // empty if there was none
  std::map<std::string, double> numbers;

  bool succeeded() const { return failure.empty(); }
  bool has(const std::string& name) const { return numbers.count(name) > 0; }

  // NaN if that was not measured, as after a failure.
  double operator[](const std::string& name) const
  {
    const auto number = numbers.find(name);
    return number == numbers.end() ? (std::numeric_limits<double>::quiet_NaN)() : number->second;
  }
};

inline Measurement failed_measurement(const std::string& reason)
{
  return {reason, {}};
}

// Libraries may print to the output of a measuring process too: its own line starts with this word.
constexpr const char* measurement_tag = "measurement";

inline std::string to_text(const Measurement& measurement)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << '\n' << measurement_tag << ' ' << measurement.numbers.size();
  for(const auto& [name, number] : measurement.numbers) {
    text << ' ' << name << ' ' << number;
  }
  text << ' ' << measurement.failure << '\n';
  return text.str();
}

inline Measurement measurement_from_text(const std::string& text)
{
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string tag;
    std::size_t size = 0;
    if(!(words >> tag >> size) || tag != measurement_tag) {
      continue;
    }
    Measurement measurement;
    std::string name, number;
    for(; size > 0 && words >> name >> number; --size) {
      measurement.numbers[name] = std::stod(number); // it reads infinity, too
    }
    std::getline(words >> std::ws, measurement.failure);
    return measurement;
  }
  return failed_measurement("the process ended without a result");
}

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// Number by number, the median of measurements that succeeded; the first failure if one did not.
inline Measurement median(const std::vector<Measurement>& measurements)
{
  std::map<std::string, std::vector<double>> values;
  for(const Measurement& measurement : measurements) {
    if(!measurement.succeeded()) {
      return measurement;
    }
    for(const auto& [name, number] : measurement.numbers) {
      values[name].push_back(number);
    }
  }
  Measurement result;
  for(const auto& [name, numbers] : values) {
    result.numbers[name] = median(numbers);
  }
  return result;
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_MEASUREMENT_H
