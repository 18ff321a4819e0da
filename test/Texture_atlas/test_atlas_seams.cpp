// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Both sides of the seams within a chart that ABF++ maps have the same lengths.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"
#include "test_options.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_atlas_seams)

namespace parameters = CGAL::parameters;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::make_atlas_of;
using atlas_check::Wishes;
using CGAL::Texture_atlas::Atlas_options;
using atlas_surfaces::component;
using atlas_surfaces::random_union;
using atlas_surfaces::Union;
using CGAL::Texture_atlas::Atlas_report;
typedef CGAL::Surface_mesh<test_charts::Point_3> Mesh;

namespace {

Mesh mesh_of(const atlas_surfaces::Component& part)
{
  Union all;
  all.add(part);
  return all.mesh<Mesh>();
}

Mesh bumpy_sphere(unsigned seed)
{
  std::mt19937 random(seed);
  return mesh_of(atlas_surfaces::bumpy_sphere(random));
}

Mesh ellipsoid(double x, double y, double z)
{
  atlas_surfaces::Component part = component(seam_surfaces::sphere(3));
  for(test_charts::Point_3& p : part.points)
    p = test_charts::Point_3(x * p.x(), y * p.y(), z * p.z());
  return mesh_of(part);
}

std::size_t count(const Atlas_run& run, Atlas_report::Seam_lengths lengths)
{
  return static_cast<std::size_t>(
      std::count_if(run.report.charts.begin(), run.report.charts.end(),
                    [&](const Atlas_report::Chart& chart) { return chart.seam_lengths == lengths; }));
}

// The largest jump at the seams with `is_meant(corner)` whose sides are in the same chart, from the coordinates; -1
// without such seams
template <typename IsMeant>
double largest_jump(const Atlas_run& run, const IsMeant& is_meant)
{
  double largest = -1;
  for(std::size_t c = 0; c < run.across.size(); ++c)
    if(run.is_inner_seam(c) && is_meant(c))
      largest = (std::max)(largest, run.seam_jump(c));
  return largest;
}

} // namespace

BOOST_AUTO_TEST_CASE(random_surfaces_have_equal_seams)
{
  std::size_t equal = 0;
  for(unsigned seed = 0; seed < 60; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const Mesh mesh = random_union(seed, 4).mesh<Mesh>();
    const Atlas_run run = make_atlas_of(mesh);
    if(!run.report.has_atlas())
      continue;
    check_atlas(run, Wishes());
    equal += count(run, Atlas_report::EQUAL_LENGTHS);
    BOOST_TEST(count(run, Atlas_report::NOT_WANTED) == 0u);
    BOOST_TEST(count(run, Atlas_report::NO_EQUATIONS) == 0u);
  }
  BOOST_TEST(equal > 40u);
}

BOOST_AUTO_TEST_CASE(they_can_be_left_out)
{
  int different = 0;
  for(unsigned seed = 0; seed < 12; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const Mesh mesh = seed < 6 ? bumpy_sphere(seed) : ellipsoid(1, 1, 1 + 0.1 * seed);
    const Atlas_run equal = make_atlas_of(mesh),
                    free = make_atlas_of(mesh, few_charts(&Atlas_options::equal_seam_lengths, false));
    check_atlas(free, Wishes());
    BOOST_TEST(count(free, Atlas_report::NOT_WANTED) == free.report.charts.size());
    BOOST_TEST(free.report.largest_equal_seam_jump == 0);
    BOOST_TEST_REQUIRE(equal.report.charts[0].has_equal_seams);
    different += free.report.charts[0].largest_seam_jump > 1e-2;
    // what they cost
    if(equal.report.charts[0].method == free.report.charts[0].method && equal.is_seam == free.is_seam)
      BOOST_TEST(equal.report.measures.angular_distortion <=
                 1.2 * free.report.measures.angular_distortion + 1e-9);
  }
  BOOST_TEST(different > 8); // of others, cut open in the middle of a symmetry, lengths are equal anyway
}

// Charts without seams are not changed by the option.
BOOST_AUTO_TEST_CASE(charts_without_seams_are_the_same_bits)
{
  std::mt19937 random(5);
  Union all;
  for(int i = 0; i < 8; ++i)
    all.add(component("hills", test_charts::bump(8, static_cast<unsigned>(i), 0.3)));
  const Mesh mesh = all.mesh<Mesh>();
  const Atlas_run equal = make_atlas_of(mesh),
                  free = make_atlas_of(mesh, few_charts(&Atlas_options::equal_seam_lengths, false));
  BOOST_TEST(count(equal, Atlas_report::NO_SEAMS) == 8u);
  BOOST_TEST(count(free, Atlas_report::NO_SEAMS) == 8u);
  BOOST_TEST((equal.uv == free.uv));
}

// Seams that the caller draws, between faces that hang together elsewhere
BOOST_AUTO_TEST_CASE(given_seams_are_equal)
{
  int tested = 0;
  for(unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    std::mt19937 random(seed);
    const Mesh mesh = ellipsoid(1, 1 + 0.02 * seed, 1.2);
    // a path of edges that does not close
    std::vector<char> is_given(mesh.num_edges(), false), is_met(mesh.num_vertices(), false);
    auto h = *std::next(mesh.halfedges_begin(), static_cast<long>(random() % mesh.num_halfedges()));
    for(int steps = 0; steps < 12; ++steps) {
      is_met[mesh.source(h)] = true;
      if(is_met[mesh.target(h)])
        break;
      is_given[mesh.edge(h)] = true;
      for(unsigned turns = 2 + random() % 2; turns > 0; --turns)
        h = mesh.opposite(mesh.next(h));
      h = mesh.next(h);
    }
    const Atlas_run run = make_atlas_of(
        mesh, few_charts(), parameters::default_values(), [&](auto e) { return bool(is_given[e]); },
        get(CGAL::vertex_point, mesh));
    check_atlas(run, Wishes());
    if(!run.report.charts[0].has_equal_seams)
      continue;
    const double given = largest_jump(run, [&](std::size_t c) { return run.was_seam[c]; });
    BOOST_TEST(given >= 0);
    BOOST_TEST(given <= 1e-5);
    ++tested;
  }
  BOOST_TEST(tested > 10);
}

// Two given seams that leave several parts have a side in each.
BOOST_AUTO_TEST_CASE(seams_between_parts_do_not_count)
{
  const Mesh mesh = ellipsoid(1, 1, 2);
  const auto is_upper = [&](auto f) {
    double z = 0;
    for(auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      z += mesh.point(v).z();
    return z > 0.3;
  };
  const Atlas_run run = make_atlas_of(
      mesh, few_charts(&Atlas_options::stretch_bound, std::numeric_limits<double>::infinity()),
      parameters::default_values(),
      [&](auto e) {
        return is_upper(mesh.face(mesh.halfedge(e, 0))) != is_upper(mesh.face(mesh.halfedge(e, 1)));
      },
      get(CGAL::vertex_point, mesh));
  Wishes wishes;
  wishes.stretch_bound = std::numeric_limits<double>::infinity();
  check_atlas(run, wishes);
  BOOST_TEST(run.report.charts.size() == 2u);
  BOOST_TEST(run.report.seam_length > 0);
  BOOST_TEST(count(run, Atlas_report::NO_SEAMS) == 2u);
}

BOOST_AUTO_TEST_CASE(pieces_keep_equal_seams)
{
  std::size_t separated = 0, cut = 0;
  for(unsigned seed = 0; seed < 24; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const Mesh mesh = bumpy_sphere(100 + seed);
    const Atlas_run run = make_atlas_of(
        mesh, few_charts(&Atlas_options::separate_overlaps, true, &Atlas_options::seam_price, 0.04));
    check_atlas(run, Wishes());
    for(const Atlas_report::Chart& chart : run.report.charts) {
      separated += chart.has_equal_seams && chart.method == Atlas_report::SEPARATED;
      cut += chart.has_equal_seams && chart.method == Atlas_report::ABF_PLUS_PLUS &&
             run.report.charts.size() > 1;
    }
  }
  BOOST_TEST_MESSAGE(separated << " separated, " << cut << " cut");
  BOOST_TEST(separated > 0u);
  BOOST_TEST(cut > 0u);
}

BOOST_AUTO_TEST_CASE(injective_maps_have_none)
{
  std::size_t injective = 0;
  for(unsigned seed = 0; seed < 12; ++seed) {
    const Atlas_run run = make_atlas_of(bumpy_sphere(100 + seed));
    for(const Atlas_report::Chart& chart : run.report.charts)
      if(chart.method == Atlas_report::INJECTIVE) {
        ++injective;
        BOOST_TEST((chart.seam_lengths == Atlas_report::OTHER_METHOD));
        BOOST_TEST(chart.largest_seam_jump > 1e-3);
      }
  }
  BOOST_TEST(injective > 0u);
}

BOOST_AUTO_TEST_CASE(any_number_of_threads_gives_the_same_bits)
{
  for(unsigned seed = 0; seed < 6; ++seed)
    for(const bool separates : {false, true}) {
      const Mesh mesh = bumpy_sphere(100 + seed);
      const auto run_with = [&](int threads) {
        return make_atlas_of(
            mesh, few_charts(&Atlas_options::threads, threads, &Atlas_options::separate_overlaps, separates));
      };
      const Atlas_run one = run_with(1);
      for(int threads : {0, 2, 3}) {
        const Atlas_run other = run_with(threads);
        BOOST_TEST((one.uv == other.uv));
        BOOST_TEST(one.report.largest_equal_seam_jump == other.report.largest_equal_seam_jump);
        BOOST_TEST_REQUIRE(one.report.charts.size() == other.report.charts.size());
        for(std::size_t i = 0; i < one.report.charts.size(); ++i) {
          BOOST_TEST(one.report.charts[i].largest_seam_jump == other.report.charts[i].largest_seam_jump);
          BOOST_TEST((one.report.charts[i].seam_lengths == other.report.charts[i].seam_lengths));
        }
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
