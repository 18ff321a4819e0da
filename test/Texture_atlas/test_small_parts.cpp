// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of thousands of parts with a few triangles each: every part has a chart, nothing overlaps, and the result
// does not depend on the number of threads. The limit of time of this test is what makes slow ones fail.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"
#include "test_options.h"

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <random>
#include <string>

BOOST_AUTO_TEST_SUITE(test_small_parts)

namespace parameters = CGAL::parameters;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::make_atlas_of;
using atlas_check::Wishes;
using CGAL::Texture_atlas::Atlas_options;
using CGAL::Surface_mesh_parameterization::Diagnosis;
using atlas_surfaces::Component;
using atlas_surfaces::component;
using atlas_surfaces::Union;
using CGAL::Texture_atlas::Atlas_report;
typedef CGAL::Surface_mesh<test_charts::Point_3> Mesh;

namespace {

// From one triangle to 80, of different sizes
Component small_part(int kind, std::mt19937& random)
{
  const auto size = [&](int least, int largest) {
    return static_cast<std::size_t>(test_charts::uniform_int(random, least, largest));
  };
  Component part;
  switch(kind % 9) {
  case 0:
    part = atlas_surfaces::single_triangle(random);
    break;
  case 1:
    part = component(seam_surfaces::torus(size(3, 6), size(3, 6)));
    break;
  case 2:
    part = component(seam_surfaces::tube(size(3, 10), size(1, 4)));
    break;
  case 3:
    part = component(seam_surfaces::sphere(1));
    break;
  default:
    part = component(seam_surfaces::platonic_solids()[kind % 9 - 4]);
  }
  const double scale = test_charts::uniform(random, 0.1, 1.5);
  for(test_charts::Point_3& p : part.points)
    p = test_charts::Point_3(scale * p.x(), scale * p.y(), scale * p.z());
  return part;
}

Mesh small_parts(int number)
{
  std::mt19937 random(7);
  Union all;
  for(int i = 0; i < number; ++i)
    all.add(small_part(i, random));
  return all.mesh<Mesh>();
}

} // namespace

BOOST_AUTO_TEST_CASE(ten_thousand_parts_have_charts)
{
  const int number = 10000;
  const Atlas_run run = make_atlas_of(small_parts(number), few_charts(&Atlas_options::gutter, 2));
  BOOST_TEST(run.report.status == Diagnosis::NOTHING_WRONG, run.report.message);
  BOOST_TEST(run.report.number_of_parts == std::size_t(number));
  BOOST_TEST(run.report.charts.size() == std::size_t(number));
  BOOST_TEST(run.report.covered_share > 0.25);
  Wishes wishes;
  wishes.gutter = 2;
  check_atlas(run, wishes);
}

BOOST_AUTO_TEST_CASE(small_parts_need_texels)
{
  const Atlas_run run = make_atlas_of(small_parts(2000),
                                      few_charts(&Atlas_options::resolution, 128, &Atlas_options::gutter, 2));
  BOOST_TEST(run.report.status == Diagnosis::PACKING_FAILED);
  BOOST_TEST(run.report.message.find("2000 charts do not fit into a page of 128 x 128") != std::string::npos,
             run.report.message);
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_small_parts)
{
  const Mesh mesh = small_parts(1000);
  const Atlas_run one = make_atlas_of(mesh, few_charts(&Atlas_options::threads, 1));
  const Atlas_run two = make_atlas_of(mesh, few_charts(&Atlas_options::threads, 2));
  BOOST_TEST_REQUIRE(one.report.has_atlas(), one.report.message);
  BOOST_TEST((one.uv == two.uv && one.chart == two.chart && one.is_seam == two.is_seam));
}

BOOST_AUTO_TEST_SUITE_END()
