// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces whose usual atlas nobody would call good: noise, hyperbolic disks, ribbons, rolls, spikes. Areas get a
// larger weight there, or the surface several charts; and if nothing helps, the report says so.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"
#include "hard_charts.h"
#include "test_options.h"

#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_atlas_strategies)

namespace parameters = CGAL::parameters;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::make_atlas_of;
using atlas_check::Wishes;
using CGAL::Texture_atlas::Atlas_options;
using CGAL::Surface_mesh_parameterization::Diagnosis;
using atlas_surfaces::component;
using atlas_surfaces::Component;
using CGAL::Texture_atlas::Atlas_report;
using test_charts::Chart;
using test_charts::Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

namespace {

Mesh mesh_of(const Component& component)
{
  atlas_surfaces::Union all;
  all.add(component);
  return all.mesh<Mesh>();
}

Mesh mesh_of(const Chart& chart)
{
  return mesh_of(component("", chart));
}

bool has_strategy(const Atlas_run& run, Atlas_report::Strategy strategy)
{
  const auto& charts = run.report.charts;
  return std::any_of(charts.begin(), charts.end(),
                     [&](const Atlas_report::Chart& chart) { return chart.strategy == strategy; });
}

Atlas_run good_atlas_of(const Mesh& mesh)
{
  Wishes wishes;
  wishes.resolution = 256;
  const Atlas_run run = make_atlas_of(mesh, few_charts(&Atlas_options::resolution, 256));
  check_atlas(run, wishes);
  BOOST_TEST(bool(run.report), run.report.message);
  return run;
}

// Rings of vertices, each of `growth` times as many as the one before, which wave more and more
Chart hyperbolic_disk(int rings, double growth)
{
  std::vector<Point_3> points{Point_3(0, 0, 0)};
  test_charts::Triangles triangles;
  std::vector<int> inner{0};
  for(int k = 1; k <= rings; ++k) {
    const int n = static_cast<int>(7 * std::pow(growth, k - 1)), m = static_cast<int>(inner.size());
    std::vector<int> outer;
    for(int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * i / n;
      outer.push_back(static_cast<int>(points.size()));
      points.emplace_back(k * std::cos(angle), k * std::sin(angle), std::sin(n / 7 * angle));
    }
    for(int i = 0, j = 0; i < (m > 1 ? m : 0) || j < n;)
      if(m == 1 || i == m || (j < n && (j + 1.) * m <= (i + 1.) * n)) {
        triangles.push_back({inner[i % m], outer[j], outer[(j + 1) % n]});
        ++j;
      } else {
        triangles.push_back({inner[i], outer[j % n], inner[(i + 1) % m]});
        ++i;
      }
    inner = outer;
  }
  return test_charts::make_chart(points, triangles);
}

// A sphere without a triangle, through which all of it would have to be turned inside out
Mesh punctured_sphere()
{
  Component sphere = component(seam_surfaces::sphere(3));
  sphere.triangles.pop_back();
  return mesh_of(sphere);
}

} // namespace

BOOST_AUTO_TEST_CASE(hyperbolic_disks_are_good)
{
  good_atlas_of(mesh_of(hyperbolic_disk(9, 1.9)));
}

// They would cover less than a hundredth of the square.
BOOST_AUTO_TEST_CASE(ribbons_and_rolls_are_divided)
{
  const Chart helix = test_charts::patch(1500, 2, [](int i, int j) {
    return Point_3((5 + 0.1 * j) * std::cos(0.02 * i), (5 + 0.1 * j) * std::sin(0.02 * i), 0.01 * i);
  });
  const Chart roll = test_charts::patch(500, 4, [](int i, int j) {
    const double radius = 1 + 0.02 * i;
    return Point_3(radius * std::cos(0.1 * i), radius * std::sin(0.1 * i), j);
  });
  for(const Chart& chart : {helix, roll}) {
    const Atlas_run run = good_atlas_of(mesh_of(chart));
    BOOST_TEST(has_strategy(run, Atlas_report::MORE_CHARTS));
    BOOST_TEST(run.report.covered_share > 0.05);
    const Atlas_run unpacked =
        make_atlas_of(mesh_of(chart), few_charts(&Atlas_options::pack_into_square, false));
    BOOST_TEST(unpacked.report.charts.size() == 1u); // there is no square that it could leave empty
  }
}

BOOST_AUTO_TEST_CASE(spikes_are_good)
{
  good_atlas_of(mesh_of(test_charts::patch(40, 40, [](int i, int j) {
    const double x = i / 20. - 1, y = j / 20. - 1;
    return Point_3(x, y,
                   30 * std::exp(-200 * ((x - 0.4) * (x - 0.4) + y * y)) +
                       30 * std::exp(-200 * ((x + 0.3) * (x + 0.3) + (y - 0.2) * (y - 0.2))));
  })));
}

// A slab with so many holes bends its border in so many places that branches of a conformal map shrink to nothing.
BOOST_AUTO_TEST_CASE(handles_and_noise_are_good)
{
  std::mt19937 random(1);
  for(int handles : {10, 30}) {
    Component slab = component(seam_surfaces::slab(handles));
    for(Point_3& p : slab.points)
      p = Point_3(p.x() + test_charts::uniform(random, -0.2, 0.2),
                  p.y() + test_charts::uniform(random, -0.2, 0.2),
                  p.z() + test_charts::uniform(random, -0.2, 0.2));
    good_atlas_of(mesh_of(slab));
  }
}

// Without a bound, a part is cut to a disk and no further.
BOOST_AUTO_TEST_CASE(an_infinite_bound_takes_any_stretch)
{
  Wishes wishes;
  wishes.stretch_bound = std::numeric_limits<double>::infinity();
  const Atlas_run run =
      make_atlas_of(punctured_sphere(), few_charts(&Atlas_options::stretch_bound, wishes.stretch_bound));
  check_atlas(run, wishes);
  BOOST_TEST(bool(run.report));
  BOOST_TEST(run.report.charts.size() == 1u);
  BOOST_TEST((run.report.charts[0].strategy == Atlas_report::USUAL));
  BOOST_TEST(run.report.charts[0].l2_stretch > 2);
}

// What must not be cut cannot be mended: the report says that it is bad.
BOOST_AUTO_TEST_CASE(a_bad_chart_is_not_called_good)
{
  const auto all = boost::make_function_property_map<Mesh::Edge_index>([](Mesh::Edge_index) { return true; });
  const Mesh finger = mesh_of(test_charts::finger(24, 24, 40));
  const Atlas_run run = make_atlas_of(finger, few_charts(), parameters::edge_is_constrained_map(all));
  check_atlas(run, Wishes());
  BOOST_TEST((run.report.status == Diagnosis::STRETCH_BOUND_MISSED));
  BOOST_TEST(!run.report);
  BOOST_TEST(run.report.has_atlas());
  BOOST_TEST(run.report.charts[0].l2_stretch > 2);
  BOOST_TEST(run.report.message.find("chart 0 ") != std::string::npos, run.report.message);
}

BOOST_AUTO_TEST_SUITE_END()
