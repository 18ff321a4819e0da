// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The other angle-based methods, with which ABF++ is compared, find the same minimum.

#include <boost/test/unit_test.hpp>

#include "test_charts.h"

#include "../../benchmark/Angle_based_flattening/methods/angle_methods.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>

#include <algorithm>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_baselines)

using namespace ABF_benchmark;

namespace {

std::vector<Chart> charts()
{
  return {test_charts::pyramid(5, 1), test_charts::pyramid(9, 0.3), test_charts::bump(6, 1),
          test_charts::bump(14, 2, 0.4)};
}

// ABF++ with the paper's energy, as accurately as doubles allow.
std::vector<double> our_angles(const Chart& chart)
{
  SMP::ABF_plus_plus_options options;
  options.barrier = 0;
  options.tolerance = 1e-12;
  options.energy_tolerance = 1e-18;
  const std::vector<double> beta = abf::target_angles(chart);
  abf::Angle_solution solution =
      abf::solve_angles(chart, beta, options, Solver(), abf::starting_angles(beta));
  BOOST_TEST_REQUIRE(solution.converged);
  return solution.alpha;
}

template <typename Method>
std::vector<double> angles_of(const Method& method, const Chart& chart)
{
  std::vector<double> alpha;
  Run_report report;
  BOOST_TEST_REQUIRE(method.solve_angles(chart, alpha, report), report.failure);
  return alpha;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  BOOST_TEST_REQUIRE(a.size() == b.size());
  double largest = 0;
  for(std::size_t c = 0; c < a.size(); ++c)
    largest = (std::max)(largest, std::abs(a[c] - b[c]));
  return largest;
}

double angular_distortion(const Chart& chart, const std::vector<Point_2>& uv)
{
  return abf::Angle_energy{0}.value(test_charts::planar_angles(chart, uv), abf::target_angles(chart)) /
         chart.number_of_corners();
}

double least_distortion(const Chart& chart)
{
  return abf::Angle_energy{0}.value(our_angles(chart), abf::target_angles(chart)) / chart.number_of_corners();
}

} // namespace

BOOST_AUTO_TEST_CASE(all_methods_of_angles_find_the_same_minimum)
{
  for(const Chart& chart : charts()) {
    const std::vector<double> ours = our_angles(chart);
    BOOST_TEST(largest_difference(ours, angles_of(Original_ABF{1e-10}, chart)) <= 1e-8);
    BOOST_TEST(largest_difference(ours, angles_of(Paper_ABF_plus_plus{1e-10, 1000}, chart)) <= 1e-8);
    BOOST_TEST(largest_difference(ours, angles_of(Logarithmic_ABF{1e-9, 50, 1e-10}, chart)) <= 1e-8);
  }
}

// The paper stops at ||grad F|| <= 1. After at least one step, this costs almost nothing.
BOOST_AUTO_TEST_CASE(paper_s_stopping_rule_costs_little_distortion)
{
  for(const double height : {1., 1.5, 2.}) {
    const Chart chart = test_charts::bump(10, 10, height);
    std::vector<Point_2> uv;
    Run_report report;
    BOOST_TEST_REQUIRE(Paper_ABF_plus_plus().flatten(chart, uv, report), report.failure);
    BOOST_TEST(report.iterations > 0);
    BOOST_TEST(abf::flipped_triangles(chart, uv).empty());
    BOOST_TEST(angular_distortion(chart, uv) >= least_distortion(chart) * (1 - 1e-9));
    BOOST_TEST(angular_distortion(chart, uv) <= least_distortion(chart) * 1.001);
  }
}

// But the rule depends on the number of triangles. A nearly flat chart meets it before the first step. The result is
// then the linear conformal map, as the paper says.
BOOST_AUTO_TEST_CASE(paper_s_stopping_rule_may_hold_at_the_start)
{
  const Chart chart = test_charts::bump(10, 10, 0.6);
  std::vector<Point_2> uv;
  Run_report report;
  BOOST_TEST_REQUIRE(Paper_ABF_plus_plus().flatten(chart, uv, report), report.failure);
  BOOST_TEST(report.iterations == 0);
  BOOST_TEST(angular_distortion(chart, uv) > 1.1 * least_distortion(chart));
}

// The terms that linear ABF neglects are of second order in the curvature, hence of fourth order in the height.
BOOST_AUTO_TEST_CASE(linear_abf_is_close_where_the_surface_is_nearly_flat)
{
  const auto difference = [](double height) {
    const Chart chart = test_charts::bump(12, 6, height);
    return largest_difference(our_angles(chart), angles_of(Linear_ABF(), chart));
  };
  const double high = difference(0.1), low = difference(0.05);
  BOOST_TEST(high <= 1e-4);
  BOOST_TEST(low <= high / 12);
  BOOST_TEST(low > 0);
}

BOOST_AUTO_TEST_SUITE_END()
