// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `SuperLU_solver_traits` as the solver of CGAL's Poisson reconstruction, compared with the default solver, which is Eigen's
// conjugate gradients. CGAL constructs the matrix from `unsigned int`.

#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_SuperLU_in_reconstruction)

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef std::pair<Point_3, Vector_3> Oriented_point;
typedef CGAL::Poisson_reconstruction_function<Kernel> Function;

// Points of an ellipsoid with half axes 1, 0.8 and 0.6, along a spiral
std::vector<Oriented_point> ellipsoid(int n)
{
  std::vector<Oriented_point> points;
  for(int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, radius = std::sqrt(1 - z * z), angle = 2.4 * i;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    const Vector_3 normal(x, y / 0.8, z / 0.6);
    points.emplace_back(Point_3(x, 0.8 * y, 0.6 * z), normal / std::sqrt(normal.squared_length()));
  }
  return points;
}

template <typename... Solver>
std::vector<double> values(const Solver&... solver)
{
  const std::vector<Oriented_point> points = ellipsoid(500);
  Function function(points.begin(), points.end(), CGAL::First_of_pair_property_map<Oriented_point>(),
                    CGAL::Second_of_pair_property_map<Oriented_point>());
  BOOST_TEST(function.compute_implicit_function(solver...));
  std::vector<double> result;
  for(double x = -1.15; x < 1.2; x += 0.1)
    for(double y = -0.9; y < 1; y += 0.2)
      result.push_back(function(Point_3(x, y, 0.1)));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(poisson)
{
  const std::vector<double> superlu = values(CGAL::SuperLU_solver_traits<>()), eigen = values();
  double difference = 0, size = 0;
  for(std::size_t i = 0; i < eigen.size(); ++i) {
    difference = (std::max)(difference, std::abs(superlu[i] - eigen[i]));
    size = (std::max)(size, std::abs(eigen[i]));
  }
  BOOST_TEST(*std::min_element(superlu.begin(), superlu.end()) < -0.1 * size); // inside
  BOOST_TEST(*std::max_element(superlu.begin(), superlu.end()) > 0.1 * size);
  BOOST_TEST(difference < 1e-8 * size);
  BOOST_TEST_MESSAGE("largest relative difference of a value: " << difference / size);
}

BOOST_AUTO_TEST_SUITE_END()
