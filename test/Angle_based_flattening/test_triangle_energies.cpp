// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The derivatives of energies of triangles. A wrong one only slows the descent of injective maps, and so no public
// function shows it.

#include <boost/test/unit_test.hpp>

#include "random_charts.h"
#include "test_charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/objectives.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_triangle_energies)

namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
using namespace test_charts;
using abf::Planar_point;

namespace {

std::array<Planar_point, 3> random_triangle(std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(-1, 1);
  for(;;) {
    std::array<Planar_point, 3> x;
    for(Planar_point& p : x)
      p = Planar_point(unit(random), unit(random));
    if(abf::cross(x[1] - x[0], x[2] - x[0]) > 0.1)
      return x;
  }
}

// The gradient against central differences, and that no eigenvalue of the Hessian is negative
template <typename Objective>
void check_derivatives(const Objective& objective, int t, const std::array<Planar_point, 3>& x)
{
  const abf::Triangle_derivatives derivatives = objective.triangle_derivatives(t, x);
  const double h = 1e-6, scale = 1 + derivatives.gradient.norm();
  for(int k = 0; k < 6; ++k) {
    std::array<Planar_point, 3> low = x, high = x;
    low[k / 2][k % 2] -= h;
    high[k / 2][k % 2] += h;
    const double slope = (objective.triangle_energy(t, high) - objective.triangle_energy(t, low)) / (2 * h);
    BOOST_TEST(std::abs(slope - derivatives.gradient[k]) < 1e-6 * scale);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> spectrum(derivatives.hessian);
  BOOST_TEST(spectrum.eigenvalues().minCoeff() > -1e-10 * derivatives.hessian.norm());
}

} // namespace

// From needles to caps, of any size
BOOST_AUTO_TEST_CASE(planar_angles_are_those_of_the_library)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0;
  for(int i = 0; i < 200000; ++i) {
    const double size = std::exp(200 * unit(random) - 100), height = std::pow(10., -14 * unit(random));
    const Planar_point a(0, 0), b(size, 0), c(size * (3 * unit(random) - 1), size * height);
    const std::array<double, 3> alpha = abf::planar_angles({a, b, c});
    const auto angle = [](const Planar_point& p, const Planar_point& q) {
      return std::atan2(abf::cross(p, q), p.dot(q));
    };
    const std::array<double, 3> expected = {angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)};
    for(int k = 0; k < 3; ++k)
      if(alpha[k] < 3) // the largest one is what is left of pi
        worst = (std::max)(worst, std::abs(alpha[k] / expected[k] - 1));
  }
  BOOST_TEST(worst < 2e-15);
}

BOOST_AUTO_TEST_CASE(energies_have_the_derivatives_that_they_tell)
{
  std::mt19937 random(2);
  const Chart chart = random_chart(30, random);
  const std::vector<double> beta = abf::target_angles(chart);
  for(int round = 0; round < 200; ++round) {
    const std::array<Planar_point, 3> x = random_triangle(random);
    const int t = static_cast<int>(random() % chart.number_of_triangles());
    for(double theta : {0., 0.005, 0.5, 1.})
      check_derivatives(abf::Area_objective(chart, theta), t, x);
    check_derivatives(abf::Angle_objective(chart, beta, abf::Angle_energy{0.1}), t, x);
  }
}

// The energies of stars. Only the Hessian of the energy of angles is not the exact one.
template <typename Star>
void check_stars(Star star, bool has_exact_hessian)
{
  typedef typename Star::Energy Energy;
  Chart chart = bump(6, 7, 1);
  const abf::Edge_collapses mesh(chart);
  std::vector<Planar_point> uv;
  for(const Point_3& p : chart.points)
    uv.emplace_back(p.x(), p.y());
  const double h = 1e-6;
  for(int v = 0; v < chart.number_of_vertices(); ++v) {
    star.gather(mesh, uv, v);
    const Energy here(star, uv[v], true);
    BOOST_TEST(here.value == Energy(star, uv[v], false).value);
    for(int i : {0, 1}) {
      const Energy more(star, uv[v] + h * Planar_point::Unit(i), true);
      const Energy less(star, uv[v] - h * Planar_point::Unit(i), true);
      const double scale = here.hessian.norm();
      BOOST_TEST(std::abs((more.value - less.value) / (2 * h) - here.gradient[i]) < 1e-6 * scale);
      if(has_exact_hessian)
        BOOST_TEST(((more.gradient - less.gradient) / (2 * h) - here.hessian.col(i)).norm() < 1e-5 * scale);
    }
  }
}

BOOST_AUTO_TEST_CASE(energies_around_a_vertex_have_the_derivatives_that_they_tell)
{
  check_stars(abf::MIPS_star(), true);
  for(double theta : {0., 0.005, 0.5, 1.})
    check_stars(abf::Area_star(theta), true);
  const std::vector<double> beta = abf::target_angles(bump(6, 7, 1));
  check_stars(abf::Angle_star(beta, abf::Angle_energy{0.1}), false);
  check_stars(abf::Area_angle_star(beta, abf::Angle_energy{0.1}), false);
}

BOOST_AUTO_TEST_SUITE_END()
