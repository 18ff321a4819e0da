// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts, their diagnosis, and from planar angles to certified coordinates: every stage by itself, on charts made by
// hand.

#include <boost/test/unit_test.hpp>

#include "test_charts.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/least_squares_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>

#include <complex>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_layouts)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::ABF_plus_plus_report Report;
typedef SMP::ABF_plus_plus_options Options;
typedef CGAL::SuperLU_solver_traits<> Solver;

namespace {

// Largest distance between two layouts after the best similarity, relative to the first one's size.
double distance_up_to_similarity(const std::vector<Point_2>& a, const std::vector<Point_2>& b)
{
  typedef std::complex<double> Complex;
  Eigen::VectorXcd p(a.size()), q(a.size());
  for(std::size_t v = 0; v < a.size(); ++v) {
    p[v] = Complex(a[v].x(), a[v].y());
    q[v] = Complex(b[v].x(), b[v].y());
  }
  p.array() -= p.mean();
  q.array() -= q.mean();
  const Complex factor = q.dot(p) / q.squaredNorm();
  return (p - factor * q).cwiseAbs().maxCoeff() / p.cwiseAbs().maxCoeff();
}

Report flatten(const Chart& chart, const Options& options, std::vector<Point_2>& uv)
{
  const auto result = abf::flatten_chart(chart, options, Solver(), [](std::vector<Point_2>&) {});
  uv = result.uv;
  return result.report;
}

} // namespace

BOOST_AUTO_TEST_SUITE(diagnosis)

BOOST_AUTO_TEST_CASE(accepts_what_can_be_flattened)
{
  const std::vector<Point_3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}};
  for(const Chart& chart : {make_chart(p, {{0, 1, 2}}), make_chart(p, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}),
                            pyramid(3, 100), flat_grid(8, 3), bump(8, 3)}) {
    Chart without_unused_points = chart;
    without_unused_points.points.resize(1 + *std::max_element(chart.vertex.begin(), chart.vertex.end()));
    abf::find_borders(without_unused_points);
    BOOST_TEST(abf::diagnose(without_unused_points, false).message == "");
  }
  BOOST_TEST(abf::diagnose(annulus(5), true).message == "");
}

void check_defect(const Chart& chart, SMP::Diagnosis expected, const std::vector<int>& vertices)
{
  const abf::Chart_defect defect = abf::diagnose(chart, false);
  BOOST_TEST(defect.status == expected);
  BOOST_TEST(!defect.message.empty());
  BOOST_TEST(defect.vertices == vertices, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(names_what_cannot)
{
  Chart broken = flat_grid(4, 1);
  broken.points[7] = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  check_defect(broken, SMP::Diagnosis::NON_FINITE_POINT, {7});

  check_defect(torus_with_hole(5), SMP::Diagnosis::NONZERO_GENUS, {});
  BOOST_TEST(abf::diagnose(annulus(5), false).status == SMP::Diagnosis::SEVERAL_BORDERS);

  const std::vector<Point_3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {0, 2, 0}};
  // Two triangles that share vertex 0, joined by a bridge of others.
  check_defect(make_chart(p, {{0, 1, 2}, {0, 4, 5}, {2, 1, 3}, {3, 1, 6}, {3, 6, 4}, {4, 6, 5}}),
               SMP::Diagnosis::NON_MANIFOLD_VERTEX, {0});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(layouts)

BOOST_AUTO_TEST_CASE(reproduce_planar_triangulations)
{
  for(unsigned int seed = 0; seed < 5; ++seed)
    for(const Chart& chart : {flat_grid(3 + 5 * seed, seed), pyramid(3 + 7 * seed, 0)}) {
      const std::vector<Point_2> expected = projected(chart);
      const std::vector<double> alpha = planar_angles(chart, expected);
      const auto exact = abf::exact_layout(chart, alpha, *abf::Linear_solvers(Solver())->low_precision());
      BOOST_REQUIRE(exact.has_value());
      BOOST_TEST(distance_up_to_similarity(expected, exact->uv) < 1e-12);
      BOOST_TEST(exact->closure < 1e-13);
      const auto least_squares = abf::Least_squares_layout(chart, alpha).solve(Solver());
      BOOST_REQUIRE(least_squares.has_value());
      BOOST_TEST(distance_up_to_similarity(expected, *least_squares) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(of_charts_without_interior_vertices)
{
  const std::vector<Point_3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}};
  for(const Triangles& triangles : {Triangles{{0, 1, 2}}, Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}}) {
    std::vector<Point_3> used(p.begin(), p.begin() + 2 + triangles.size());
    std::vector<Point_2> uv;
    for(auto layout : {Options::EXACT_LAYOUT, Options::LEAST_SQUARES_LAYOUT}) {
      Options options;
      options.layout = layout;
      const Chart chart = make_chart(used, triangles);
      BOOST_TEST(flatten(chart, options, uv).status == SMP::Diagnosis::NOTHING_WRONG);
      BOOST_TEST(distance_up_to_similarity(projected(chart), uv) < 1e-12);
    }
  }
}

// The angles of a surface whose coordinates are so large that squares overflow.
BOOST_AUTO_TEST_CASE(of_angles_that_are_not_numbers)
{
  const Chart chart = make_chart({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const std::vector<double> alpha(6, std::numeric_limits<double>::quiet_NaN());
  const auto uv = abf::Least_squares_layout(chart, alpha).solve(Solver());
  BOOST_TEST((!uv || abf::flipped_triangles(chart, *uv).size() == 2u));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(scale_and_measures)

BOOST_AUTO_TEST_CASE(area_is_the_surface_area)
{
  const Chart chart = bump(10, 3, 1);
  std::vector<Point_2> uv;
  BOOST_REQUIRE(flatten(chart, Options(), uv).status == SMP::Diagnosis::NOTHING_WRONG);
  double surface = 0, plane = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    surface += abf::surface_area(chart, t);
    plane += abf::planar_area(chart, uv, t);
  }
  BOOST_TEST(surface == plane, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(angular_distortion_is_the_energy)
{
  const Chart chart = bump(8, 8, 1);
  Options options;
  options.barrier = 0;
  options.tolerance = 1e-10;
  std::vector<Point_2> uv;
  const Report report = flatten(chart, options, uv);
  BOOST_REQUIRE(report.status == SMP::Diagnosis::NOTHING_WRONG);
  const double distortion = abf::measure_chart(chart, uv, [](int, const auto&) {}).angular_distortion;
  BOOST_TEST(distortion * chart.number_of_corners() == report.energy, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(whole_chart)

BOOST_AUTO_TEST_CASE(layouts_agree)
{
  const Chart chart = bump(25, 4, 1);
  Options exact, least_squares;
  exact.layout = Options::EXACT_LAYOUT;
  least_squares.layout = Options::LEAST_SQUARES_LAYOUT;
  std::vector<Point_2> a, b;
  BOOST_TEST(flatten(chart, exact, a).layout == Report::EXACT);
  BOOST_TEST(flatten(chart, least_squares, b).layout == Report::LEAST_SQUARES);
  BOOST_TEST(distance_up_to_similarity(a, b) < 1e-6);
}

BOOST_AUTO_TEST_CASE(steep_charts_come_out_valid)
{
  for(unsigned int seed = 0; seed < 3; ++seed)
    for(const auto& [height, barrier] : {std::pair(1., 0.1), {3., 0.1}, {10., 3.}}) {
      Options options;
      options.barrier = barrier;
      std::vector<Point_2> uv;
      const Report report = flatten(bump(12 + 6 * seed, seed, height), options, uv);
      BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
      BOOST_TEST(report.flipped_triangles == 0);
    }
}

BOOST_AUTO_TEST_CASE(flips_are_never_a_success)
{
  for(unsigned int seed = 0; seed < 10; ++seed) {
    std::vector<Point_2> uv;
    const Report report = flatten(bump(8 + 2 * seed, seed, 10 + 10 * seed), Options(), uv);
    BOOST_TEST((report.status == SMP::Diagnosis::NOTHING_WRONG) == (report.flipped_triangles == 0));
    BOOST_TEST((report.status == SMP::Diagnosis::NOTHING_WRONG) == report.message.empty());
  }

  Options options;
  options.fallbacks = false;
  options.max_iterations = 0; // keeps the angles of a steep cone, which is far from flat
  options.layout = Options::LEAST_SQUARES_LAYOUT;
  std::vector<Point_2> uv;
  const Report report = flatten(bump(20, 1, 20), options, uv);
  BOOST_TEST(report.flipped_triangles > 0);
  BOOST_TEST(error_code(report.status) == SMP::ERROR_NO_1_TO_1_MAPPING);
  BOOST_TEST(report.status == SMP::Diagnosis::NO_CONVERGENCE);
  BOOST_TEST(!report.message.empty());
}

// Without any Newton step, only the last strategy is left, and each of the previous ones reports why it failed.
BOOST_AUTO_TEST_CASE(fallback_strategies_are_tried_and_reported)
{
  Options options;
  options.max_iterations = 0;
  std::vector<Point_2> uv;
  const Report report = flatten(bump(20, 1, 20), options, uv);
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(report.flipped_triangles == 0);
  BOOST_TEST(report.strategy == Report::PROGRESSIVE_EMBEDDING);
  BOOST_REQUIRE(report.failed_strategies.size() == 3);
  const Report::Strategy tried[] = {Report::FROM_TARGET_ANGLES, Report::RAISED_BARRIER,
                                    Report::FROM_PROGRESSIVE_EMBEDDING};
  for(int i = 0; i < 3; ++i) {
    BOOST_TEST(report.failed_strategies[i].strategy == tried[i]);
    BOOST_TEST(!report.failed_strategies[i].message.empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
