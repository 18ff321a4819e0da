// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MEASURE_SUMMARY_H
#define FLATTEN_MESH_MEASURE_SUMMARY_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// A measure of triangles, as the page shows it
struct Measure_of_triangles
{
  std::string name;  // in the data
  std::string title; // to people
  std::string unit;
  double best;                       // both larger and smaller values are worse
  bool has_two_sides;                // values lie on both sides of the best one
  double finest_limit;               // the colours cover at least this distance from the best value
  const std::vector<double>& values; // NaN where there are none
};

// The distribution of a measure over the area of a surface, and its worst triangles
struct Measure_summary
{
  static constexpr std::size_t number_of_worst = 20;

  double low = 0, high = 0;       // ends of the scale of colours
  double first = 0, width = 0;    // of the histogram: where its first bin begins, and how wide all are
  std::vector<double> shares;     // of the area; the first and the last bin also hold what is beyond them
  std::vector<std::size_t> worst; // triangles, the worst one first
};

namespace internal {

// The next larger number of few digits
inline double round_limit(const double value)
{
  const double power = std::pow(10, std::floor(std::log10(value)));
  for(const double digit : {1., 1.5, 2., 3., 5., 7.}) {
    if(value < digit * power * (1 - 1e-9)) {
      return digit * power;
    }
  }
  return 10 * power;
}

// The least distance from the best value that is not exceeded on a share of the area
inline double quantile(const Measure_of_triangles& measure, const std::vector<double>& areas,
                       const double share)
{
  std::vector<std::pair<double, double>> distances; // with areas
  double total = 0;
  for(std::size_t t = 0; t < areas.size(); ++t) {
    if(std::isfinite(measure.values[t])) {
      distances.emplace_back(std::abs(measure.values[t] - measure.best), areas[t]);
      total += areas[t];
    }
  }
  std::sort(distances.begin(), distances.end());
  double sum = 0, result = 0;
  for(auto it = distances.begin(); it != distances.end() && sum < share * total; ++it) {
    result = it->first;
    sum += it->second;
  }
  return result;
}

inline std::vector<std::size_t> worst_triangles(const Measure_of_triangles& measure)
{
  std::vector<std::size_t> all;
  for(std::size_t t = 0; t < measure.values.size(); ++t) {
    if(std::isfinite(measure.values[t])) {
      all.push_back(t);
    }
  }
  const auto middle =
      all.begin() + static_cast<std::ptrdiff_t>((std::min)(all.size(), Measure_summary::number_of_worst));
  std::partial_sort(all.begin(), middle, all.end(), [&measure](const std::size_t a, const std::size_t b) {
    const double distance_of_a = std::abs(measure.values[a] - measure.best),
                 distance_of_b = std::abs(measure.values[b] - measure.best);
    return distance_of_a > distance_of_b || (distance_of_a == distance_of_b && a < b);
  });
  all.erase(middle, all.end());
  return all;
}

inline void add_histogram(const Measure_of_triangles& measure, const std::vector<double>& areas,
                          Measure_summary& summary)
{
  const std::size_t bins = 40; // between the limits
  summary.width = (summary.high - summary.low) / bins;
  summary.first = measure.has_two_sides ? summary.low - summary.width : summary.low;
  summary.shares.assign(bins + (measure.has_two_sides ? 2 : 1), 0);
  double total = 0;
  for(std::size_t t = 0; t < areas.size(); ++t) {
    if(std::isfinite(measure.values[t])) {
      const double bin = std::floor((measure.values[t] - summary.first) / summary.width);
      const double last = static_cast<double>(summary.shares.size() - 1);
      summary.shares[static_cast<std::size_t>(std::clamp(bin, 0., last))] += areas[t];
      total += areas[t];
    }
  }
  for(double& share : summary.shares) {
    share = total > 0 ? share / total : 0;
  }
}

} // namespace internal

// The colours cover the values on all but a hundredth of the area.
inline Measure_summary summarize(const Measure_of_triangles& measure, const std::vector<double>& areas)
{
  Measure_summary summary;
  const double limit =
      (std::max)(measure.finest_limit, internal::round_limit(internal::quantile(measure, areas, 0.99)));
  summary.low = measure.has_two_sides ? measure.best - limit : measure.best;
  summary.high = measure.best + limit;
  summary.worst = internal::worst_triangles(measure);
  internal::add_histogram(measure, areas, summary);
  return summary;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MEASURE_SUMMARY_H
