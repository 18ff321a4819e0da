// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The methods that minimize energies of maps decrease them, find the minimum where it is known, and flip no triangle.

#include <boost/test/unit_test.hpp>

#include "test_charts.h"

#include "../../benchmark/Angle_based_flattening/methods/Relaxed_map.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_chart.h>

#include <boost/mpl/list.hpp>

#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_relaxed_maps)

using namespace ABF_benchmark;

namespace {

double angular_distortion(const Chart& chart, const std::vector<Point_2>& uv)
{
  return abf::Angle_energy{0}.value(test_charts::planar_angles(chart, uv), abf::target_angles(chart)) /
         chart.number_of_corners();
}

Eigen::VectorXd coordinates(const std::vector<Point_2>& uv)
{
  Eigen::VectorXd x(2 * uv.size());
  for(std::size_t v = 0; v < uv.size(); ++v)
    x.segment<2>(2 * v) << uv[v].x(), uv[v].y();
  return x;
}

// A sheared and twisted image, without flips, of a chart that is flat.
std::vector<Point_2> distorted(const Chart& chart)
{
  std::vector<Point_2> uv;
  for(const Point_2& p : test_charts::projected(chart))
    uv.emplace_back(2 * p.x() + 0.5 * p.y(), 0.6 * p.y() + 0.2 * std::sin(3 * p.x()));
  return uv;
}

double surface_area(const Chart& chart)
{
  double sum = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    sum += abf::surface_area(chart, t);
  return sum;
}

typedef boost::mpl::list<MIPS_energy, Stretch_energy> Map_energies;

// The value of each energy for an isometric map.
double least_energy(const Chart& chart, MIPS_energy)
{
  return 2. * chart.number_of_triangles();
}
double least_energy(const Chart& chart, Stretch_energy)
{
  return 2 * surface_area(chart);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(flat_charts_are_undistorted_in_the_end, Energy, Map_energies)
{
  const Chart chart = test_charts::flat_grid(8, 13);
  std::vector<Point_2> uv = distorted(chart);
  BOOST_TEST_REQUIRE(abf::flipped_triangles(chart, uv).empty());
  Run_report report;
  BOOST_TEST_REQUIRE(Relaxed_map<Energy>().relax(chart, uv, report), report.failure);
  const double least = least_energy(chart, Energy());
  BOOST_TEST(std::abs(report.energy - least) <= 1e-6 * least);
  BOOST_TEST(angular_distortion(chart, uv) <= 1e-6);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(map_energies_decrease_without_flips, Energy, Map_energies)
{
  for(const Chart& chart : {test_charts::bump(14, 17, 1), test_charts::bump(9, 18, 3)}) {
    std::vector<Point_2> uv;
    Run_report report;
    BOOST_TEST_REQUIRE(flatten_by_abf_plus_plus(chart, uv, report), report.failure);
    const double before = Map_energy<Energy>(chart).value(coordinates(uv));
    BOOST_TEST_REQUIRE(Relaxed_map<Energy>().flatten(chart, uv, report), report.failure);
    BOOST_TEST(report.energy < 0.999 * before);
    BOOST_TEST(report.energy >= least_energy(chart, Energy()));
    BOOST_TEST(abf::flipped_triangles(chart, uv).empty());
  }
}

// The energy is minimal over all scales of the map, and then equals the measured stretch.
BOOST_AUTO_TEST_CASE(stretch_energy_is_the_measured_stretch)
{
  const Chart chart = test_charts::bump(14, 19, 1);
  std::vector<Point_2> uv;
  Run_report report;
  BOOST_TEST_REQUIRE(Stretch_minimizer().flatten(chart, uv, report), report.failure);
  const double stretch =
      abf::measure_chart(chart, uv, [](int, const SMP::Flattening_face_measures&) {}).l2_stretch;
  BOOST_TEST(std::abs(report.energy / (2 * surface_area(chart)) - stretch) <= 1e-6 * stretch);
}

BOOST_AUTO_TEST_SUITE_END()
