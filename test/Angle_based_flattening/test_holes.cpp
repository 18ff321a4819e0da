// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts with several borders: the four equations of a hole, alone and in the solver, and the layout that closes the
// holes.

#include <boost/test/unit_test.hpp>

#include "charts_with_holes.h"
#include "hard_charts.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/predict_scale.h>

#include <cstdlib>

BOOST_AUTO_TEST_SUITE(test_holes)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::ABF_plus_plus_report Report;
typedef SMP::ABF_plus_plus_options Options;
typedef CGAL::SuperLU_solver_traits<> Solver;

namespace {

Chart flat_chart_with_holes(int holes, unsigned int seed)
{
  std::mt19937 random(seed);
  return punched(flat_grid(20, seed), holes, 1, random);
}

Chart hilly_chart_with_holes(int holes, unsigned int seed)
{
  std::mt19937 random(seed);
  return punched(bump(20, seed), holes, 1, random);
}

// A bump, a saddle, a sphere with a border, or a terrain whose noise is up to two edge lengths
Chart random_disk(std::mt19937& random)
{
  switch(uniform_int(random, 0, 3)) {
  case 0:
    return bump(uniform_int(random, 12, 30), random(), uniform(random, 0, 0.8));
  case 1:
    return saddle(uniform_int(random, 8, 16), uniform(random, 0.2, 1));
  case 2:
    return sphere_without_caps(3, 1, uniform_int(random, 1, 4), random);
  default:
    return noisy_terrain(uniform_int(random, 12, 30), uniform(random, 0, 2), random);
  }
}

SMP::internal::ABF::Flattening<Report> flatten(const Chart& chart, const Options& options = Options())
{
  return abf::flatten_chart(chart, options, Solver(), [](std::vector<Point_2>&) {});
}

// The gaps of holes are less than a tenth of the tolerance; that of the outer border is not an equation, and about as
// large as what all others violate.
void check_valid(const Chart& chart)
{
  Options options;
  options.tolerance = 1e-6;
  const auto result = flatten(chart, options);
  const Report& report = result.report;
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(report.converged);
  BOOST_TEST(report.flipped_triangles == 0);
  BOOST_TEST(report.constraint_residual <= options.tolerance);
  BOOST_TEST(report.layout == Report::EXACT);
  BOOST_TEST(report.closure <= 1e-6);
}

} // namespace

BOOST_AUTO_TEST_SUITE(flattening)

BOOST_AUTO_TEST_CASE(leaves_a_planar_chart_as_it_is)
{
  const Chart chart = flat_chart_with_holes(5, 8);
  for(const auto layout : {Options::EXACT_LAYOUT, Options::LEAST_SQUARES_LAYOUT}) {
    Options options;
    options.layout = layout;
    const auto result = flatten(chart, options);
    BOOST_REQUIRE(result.succeeded());
    BOOST_TEST(result.report.iterations == 1);
    for(int c = 0; c < chart.number_of_corners(); ++c)
      BOOST_TEST(std::abs(abf::planar_angle(chart, result.uv, c) - abf::surface_angle(chart, c)) < 1e-9);
  }
}

// Where all four equations hold, the angles are those of a map: the exact layout has them, and closes every hole.
BOOST_AUTO_TEST_CASE(layout_has_the_angles_that_were_found)
{
  Options options;
  options.tolerance = 1e-11;
  const Chart chart = hilly_chart_with_holes(6, 9);
  const std::vector<double> beta = abf::target_angles(chart);
  const abf::Angle_solution solution =
      abf::solve_angles(chart, beta, options, Solver(), abf::starting_angles(beta));
  BOOST_REQUIRE(solution.converged);
  const auto layout =
      abf::exact_layout(chart, solution.alpha, *abf::Linear_solvers(Solver())->low_precision());
  BOOST_REQUIRE(layout.has_value());
  BOOST_TEST(layout->closure < 1e-11);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    BOOST_TEST(std::abs(abf::planar_angle(chart, layout->uv, c) - solution.alpha[c]) < 1e-8);
}

BOOST_AUTO_TEST_CASE(of_random_charts_is_valid)
{
  const unsigned int charts = std::getenv("ABF_TEST_QUICK") ? 40 : 500;
  for(unsigned int seed = 0; seed < charts; ++seed) {
    std::mt19937 random(seed);
    const int holes = uniform_int(random, 1, 20);
    const Chart whole = random_disk(random);
    const Chart chart = punched(whole, holes, uniform_int(random, 0, 1), random);
    BOOST_TEST_INFO_SCOPE("seed " << seed << ", " << chart.number_of_holes() << " holes");
    BOOST_TEST(chart.number_of_holes() > 0);
    check_valid(chart);
  }
}

BOOST_AUTO_TEST_CASE(of_spheres_without_caps_is_valid)
{
  for(int caps = 2; caps <= 6; ++caps) {
    std::mt19937 random(caps);
    const Chart chart = sphere_without_caps(3, caps, 2, random);
    BOOST_TEST(chart.number_of_holes() > 0);
    check_valid(chart);
  }
}

// That needs a few steps only, however far it is from flat: the defects are spread.
BOOST_AUTO_TEST_CASE(of_rings_and_tubes_takes_few_steps)
{
  for(const auto& [outer, height] : {std::pair(2., 0.), {1.1, 0.}, {1., 1.}, {1., 2 * CGAL_PI}, {2., 3.}}) {
    const Chart chart = tube(48, 30, 1, outer, height);
    const auto result = flatten(chart);
    BOOST_REQUIRE(result.succeeded());
    BOOST_TEST(result.report.converged);
    BOOST_TEST(result.report.iterations <= 4);
    BOOST_TEST(result.report.closure <= 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(is_the_same_in_every_way)
{
  const Chart chart = hilly_chart_with_holes(5, 12);
  const std::vector<double> beta = abf::target_angles(chart);
  Options newton, direct, sequential;
  direct.linear_solver = Options::DIRECT;
  sequential.step = Options::SEQUENTIAL_LINEARLY_CONSTRAINED;
  std::vector<std::vector<double>> alpha;
  for(Options options : {newton, direct, sequential}) {
    options.energy_tolerance = 1e-14;
    options.tolerance = 1e-9;
    abf::Angle_solution solution =
        abf::solve_angles(chart, beta, options, Solver(), abf::starting_angles(beta));
    BOOST_TEST(solution.converged);
    alpha.push_back(std::move(solution.alpha));
  }
  for(std::size_t c = 0; c < beta.size(); ++c) {
    BOOST_TEST(std::abs(alpha[0][c] - alpha[1][c]) < 1e-6);
    BOOST_TEST(std::abs(alpha[0][c] - alpha[2][c]) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(does_not_depend_on_threads)
{
  const Chart chart = hilly_chart_with_holes(8, 13);
  std::vector<std::vector<Point_2>> uv;
  for(int threads : {1, 4})
    abf::with_threads(threads, [&]() { uv.push_back(flatten(chart).uv); });
  BOOST_TEST((uv[0] == uv[1]));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(strategies)

BOOST_AUTO_TEST_CASE(predict_the_scale_of_tubes)
{
  for(double length : {0.5, 1., 2.}) {
    const Chart chart = tube(48, static_cast<int>(50 * length), 1, 1, 2 * CGAL_PI * length);
    const auto prediction = abf::predict_scale(chart, Solver());
    BOOST_REQUIRE(prediction.has_value());
    BOOST_TEST(prediction->log_range == 2 * CGAL_PI * length, boost::test_tools::tolerance(0.02));
    BOOST_TEST(prediction->far_border == 1);
    const Report report = flatten(chart).report;
    BOOST_TEST(report.predicted_scale_range == std::exp(prediction->log_range));
    BOOST_TEST(std::log(report.scale_range) == prediction->log_range, boost::test_tools::tolerance(0.1));
  }
}

BOOST_AUTO_TEST_CASE(refuse_too_large_a_range_of_scale)
{
  const Chart chart = tube(24, 120, 1, 1, 2 * CGAL_PI * 5);
  const auto result = flatten(chart);
  BOOST_TEST(result.report.status == SMP::Diagnosis::SCALE_TOO_LARGE);
  BOOST_TEST(result.report.predicted_scale_range > 1e10);
  BOOST_TEST(result.invalid.size() == chart.hole(0).size());
  BOOST_TEST(flatten(flat_chart_with_holes(3, 1)).report.predicted_scale_range < 2);
  BOOST_TEST(flatten(flat_grid(5, 1)).report.predicted_scale_range == 1);
}

// Without Newton steps all fail but the last.
BOOST_AUTO_TEST_CASE(are_tried_in_turn)
{
  Options options;
  options.holes = Options::SOLVE;
  options.max_iterations = 0;
  std::mt19937 random(3);
  const Chart chart = punched(noisy_terrain(20, 6, random), 3, 1, random);
  const Report report = flatten(chart, options).report;
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(report.flipped_triangles == 0);
  BOOST_REQUIRE(report.failed_strategies.size() >= 3u);
  BOOST_TEST(report.failed_strategies[0].strategy == Report::FROM_TARGET_ANGLES);
  BOOST_TEST(report.failed_strategies[1].strategy == Report::SOFT_PATCHES);
  BOOST_TEST(report.failed_strategies[2].strategy == Report::STIFF_PATCHES);
  options.fallbacks = false;
  BOOST_TEST(flatten(chart, options).report.status == SMP::Diagnosis::NO_CONVERGENCE);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
