// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts with holes: how they are filled, and flattened with fillings.

#include <boost/test/unit_test.hpp>

#include "mesh_of_chart.h"
#include "test_charts.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/holes/patch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/hole_strategies.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_filled_holes)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::ABF_plus_plus_options Options;
typedef SMP::ABF_plus_plus_report Report;

namespace {

// The chart without the triangles where `is_hole` is true of all three vertices, in the plane.
Chart punched(const Chart& chart, const std::function<bool(double, double)>& is_hole)
{
  std::vector<int> rank(chart.points.size(), -1);
  std::vector<Point_3> points;
  Triangles triangles;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    bool is_inside = true;
    for(int c = 3 * t; c < 3 * t + 3; ++c) {
      const Point_3& p = chart.points[chart.vertex[c]];
      is_inside = is_inside && is_hole(p.x(), p.y());
    }
    if(is_inside)
      continue;
    triangles.emplace_back();
    for(int k = 0; k < 3; ++k) {
      int& v = rank[chart.vertex[3 * t + k]];
      if(v < 0) {
        v = static_cast<int>(points.size());
        points.push_back(chart.points[chart.vertex[3 * t + k]]);
      }
      triangles.back()[k] = v;
    }
  }
  Chart result = make_chart(points, triangles);
  std::sort(result.borders.begin(), result.borders.end(), [&](const auto& a, const auto& b) {
    const auto is_outer = [&](const std::vector<int>& border) {
      return std::any_of(border.begin(), border.end(), [&](int c) {
        const Point_3& p = result.points[result.edge_source(c)];
        return std::abs(p.x() - 0.5) > 0.49 || std::abs(p.y() - 0.5) > 0.49;
      });
    };
    return is_outer(a) > is_outer(b);
  });
  return result;
}

bool is_near(double x, double y, double cx, double cy, double radius)
{
  return std::hypot(x - cx, y - cy) < radius;
}

std::vector<Chart> punched_disks()
{
  const auto one = [](double x, double y) { return is_near(x, y, 0.5, 0.5, 0.2); };
  const auto three = [](double x, double y) {
    return is_near(x, y, 0.3, 0.3, 0.13) || is_near(x, y, 0.7, 0.35, 0.1) || is_near(x, y, 0.5, 0.7, 0.16);
  };
  const auto slot = [](double x, double y) { return std::abs(x - 0.5) < 0.3 && std::abs(y - 0.5) < 0.06; };
  const auto almost_all = [](double x, double y) { return is_near(x, y, 0.5, 0.5, 0.4); };
  std::vector<Chart> charts;
  for(const auto& is_hole :
      {std::function<bool(double, double)>(one), std::function<bool(double, double)>(three),
       std::function<bool(double, double)>(slot), std::function<bool(double, double)>(almost_all)}) {
    charts.push_back(punched(bump(30, 1, 0.5), is_hole));
    charts.push_back(punched(flat_grid(25, 2), is_hole));
  }
  return charts;
}

abf::Flattening<Report> flatten(const Chart& chart, Options options = Options())
{
  options.holes = Options::FILL;
  return abf::flatten_chart(chart, options, CGAL::SuperLU_solver_traits<>(), [](std::vector<Point_2>&) {});
}

// What fans of ordinary triangles make of the chart
Chart with_fans(const Chart& chart)
{
  std::vector<Point_3> points = chart.points;
  Triangles triangles;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    triangles.push_back({chart.vertex[3 * t], chart.vertex[3 * t + 1], chart.vertex[3 * t + 2]});
  for(std::size_t i = 1; i < chart.borders.size(); ++i) {
    std::vector<Point_3> ring;
    for(int c : chart.borders[i]) {
      triangles.push_back({chart.edge_target(c), chart.edge_source(c), static_cast<int>(points.size())});
      ring.push_back(chart.points[chart.edge_source(c)]);
    }
    points.push_back(CGAL::centroid(ring.begin(), ring.end()));
  }
  return make_chart(points, triangles);
}

double angular_distortion(const Chart& chart, const std::vector<Point_2>& uv)
{
  const std::vector<double> beta = abf::target_angles(chart);
  double sum = 0;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    sum += abf::Angle_energy{0}.value(abf::planar_angle(chart, uv, c), beta[c]);
  return sum / chart.number_of_corners();
}

void check_filled(const Chart& chart, const Chart& filled)
{
  BOOST_TEST(filled.borders.size() == 1);
  BOOST_TEST(filled.borders.front().size() == chart.borders.front().size());
  BOOST_TEST(!abf::diagnose(filled, false));
  BOOST_TEST(std::equal(chart.vertex.begin(), chart.vertex.end(), filled.vertex.begin()));
  for(int c = 0; c < filled.number_of_corners(); ++c)
    if(const int across = filled.opposite[c]; across >= 0) {
      BOOST_TEST(filled.opposite[across] == c);
      BOOST_TEST(filled.edge_source(across) == filled.edge_target(c));
    }
  const std::vector<double> beta = abf::target_angles(chart);
  BOOST_TEST(std::equal(beta.begin(), beta.end(), filled.targets.begin()));
}

} // namespace

// An edge without length around the hole, wherever the ring begins
BOOST_AUTO_TEST_CASE(takes_vertices_at_one_point)
{
  const Chart chart = punched(bump(12, 5), [](double x, double y) { return is_near(x, y, 0.5, 0.5, 0.2); });
  BOOST_REQUIRE_EQUAL(chart.borders.size(), 2u);
  for(int c : chart.borders[1]) {
    Chart degenerate = chart;
    degenerate.points[chart.edge_source(c)] = chart.points[chart.edge_target(c)];
    BOOST_TEST(abf::fill_holes(degenerate, abf::soft_patch_weight).borders.size() == 1u);
    BOOST_TEST(flatten(degenerate).succeeded());
  }
}

// Collinear vertices have no triangles, and too many take too long.
BOOST_AUTO_TEST_CASE(fans_are_the_way_out)
{
  Chart slit = punched(flat_grid(10, 1), [](double x, double y) { return is_near(x, y, 0.5, 0.5, 0.2); });
  for(int c : slit.borders[1]) {
    Point_3& p = slit.points[slit.edge_source(c)];
    p = Point_3(p.x(), 0.5, 0);
  }
  for(const Chart& chart : {slit, annulus(abf::largest_patch + 1)}) {
    const Chart filled = abf::fill_holes(chart, abf::soft_patch_weight);
    check_filled(chart, filled);
    BOOST_TEST(filled.number_of_vertices() == chart.number_of_vertices() + 1);
    BOOST_TEST(flatten(chart).succeeded());
  }
  const Chart ring = annulus(20);
  BOOST_TEST(abf::fill_holes(ring, abf::soft_patch_weight).number_of_vertices() == ring.number_of_vertices());
}

// A square hole, one of whose diagonals is an edge of the surface around it
BOOST_AUTO_TEST_CASE(edges_of_the_surface_are_not_repeated)
{
  const std::vector<Point_3> points{{1, 0, 0},   {0, 1, 0},    {-1, 0, 0},    {0, -1, 0},
                                    {3, 3, 0.5}, {-3, 3, 0.5}, {-3, -3, 0.5}, {3, -3, 0.5}};
  // Triangle (0, 2, 1) covers a corner of the hole.
  const Triangles triangles{{0, 2, 1}, {0, 4, 2}};
  Triangles all = triangles;
  for(const auto& t : Triangles{{4, 5, 2}, {5, 6, 2}, {6, 3, 2}, {6, 7, 3}, {7, 0, 3}, {7, 4, 0}})
    all.push_back(t);
  Chart chart = make_chart(points, all);
  BOOST_TEST_REQUIRE(chart.borders.size() == 2);
  if(chart.borders[0].size() > chart.borders[1].size())
    std::swap(chart.borders[0], chart.borders[1]);
  std::swap(chart.borders[0], chart.borders[1]);
  BOOST_TEST_REQUIRE(!abf::diagnose(chart, true));
  const Chart filled = abf::fill_holes(chart, abf::soft_patch_weight);
  check_filled(chart, filled);
}

BOOST_AUTO_TEST_CASE(filled_charts_come_out_injective)
{
  for(const Chart& chart : punched_disks()) {
    const auto result = flatten(chart);
    BOOST_TEST(result.succeeded());
    BOOST_TEST(result.report.strategy == Report::SOFT_PATCHES);
    BOOST_TEST(result.report.failed_strategies.empty());
    BOOST_TEST(result.report.converged);
    BOOST_TEST(result.report.layout == Report::EXACT);
    BOOST_TEST(result.report.border_is_simple);
    BOOST_TEST(result.report.borders == static_cast<int>(chart.borders.size()));
    BOOST_TEST(result.report.triangles == chart.number_of_triangles());
    BOOST_TEST(result.uv.size() == chart.points.size());
  }
}

BOOST_AUTO_TEST_CASE(soft_patches_bend_less_than_fans)
{
  for(const Chart& chart : punched_disks()) {
    const auto soft = flatten(chart), stiff = flatten(with_fans(chart));
    std::vector<Point_2> uv = stiff.uv;
    uv.resize(chart.points.size());
    const double e = angular_distortion(chart, soft.uv), f = angular_distortion(chart, uv);
    BOOST_TEST_MESSAGE("E of the surface: " << e << " with soft patches, " << f << " with fans");
    BOOST_TEST(e < (std::max)(0.85 * f, 1e-12));
  }
}

BOOST_AUTO_TEST_CASE(hierarchically_too)
{
  for(const Chart& punched_disk : punched_disks()) {
    Chart chart = punched_disk;
    SMP::Hierarchical_options options;
    options.holes = SMP::Hierarchical_options::FILL;
    const auto flatten_coarse = [](const Chart& coarse) -> std::optional<std::vector<Point_2>> {
      BOOST_TEST(coarse.borders.size() == 1);
      return flatten(coarse).uv;
    };
    for(const bool polish : {false, true}) {
      options.polish = polish;
      const auto result = abf::flatten_chart_hierarchically(
          chart, options, flatten_coarse, CGAL::SuperLU_solver_traits<>(), [](std::vector<Point_2>&) {});
      BOOST_TEST(result.succeeded());
      BOOST_TEST(result.report.border_is_simple);
      BOOST_TEST(result.report.borders == static_cast<int>(chart.borders.size()));
      BOOST_TEST(result.report.vertices == chart.number_of_vertices());
      BOOST_TEST(result.uv.size() == chart.points.size());
      BOOST_TEST(chart.vertex == punched_disk.vertex);
      if(polish) {
        const double direct = angular_distortion(chart, flatten(chart).uv);
        BOOST_TEST(std::abs(angular_distortion(chart, result.uv) - direct) < 1e-3 * direct + 1e-12);
      }
    }
  }
}

// The coarse charts have the holes too, with the same outer border, unless these are too many.
BOOST_AUTO_TEST_CASE(hierarchically_solved)
{
  for(const bool is_small : {false, true}) {
    for(const Chart& punched_disk : punched_disks()) {
      Chart chart = punched_disk;
      SMP::Hierarchical_options options;
      options.holes = SMP::Hierarchical_options::SOLVE;
      options.coarse_triangles = is_small ? 20 : chart.number_of_triangles() / 4;
      Options coarse_options;
      coarse_options.holes = Options::SOLVE;
      std::size_t borders = 0;
      const auto flatten_coarse = [&](const Chart& coarse) {
        borders = coarse.borders.size();
        return std::optional<std::vector<Point_2>>(abf::flatten_chart(coarse, coarse_options,
                                                                      CGAL::SuperLU_solver_traits<>(),
                                                                      [](std::vector<Point_2>&) {})
                                                       .uv);
      };
      const auto result = abf::flatten_chart_hierarchically(
          chart, options, flatten_coarse, CGAL::SuperLU_solver_traits<>(), [](std::vector<Point_2>&) {});
      BOOST_TEST(result.succeeded());
      BOOST_TEST(result.report.flipped_triangles == 0);
      BOOST_TEST(result.report.holes_filled == (borders == 1));
      BOOST_TEST(borders == (is_small && chart.number_of_holes() > 1 ? 1u : chart.borders.size()));
    }
  }
}

// Newton's method alone is not enough for steep charts, whatever the patches.
BOOST_AUTO_TEST_CASE(fallbacks_are_tried_and_reported)
{
  const Chart steep =
      punched(bump(24, 3, 20), [](double x, double y) { return is_near(x, y, 0.3, 0.5, 0.1); });
  const auto result = flatten(steep);
  BOOST_TEST(result.succeeded());
  Options options;
  options.max_iterations = 0;
  const auto unsolved = flatten(steep, options);
  BOOST_TEST(unsolved.succeeded());
  BOOST_REQUIRE(unsolved.report.failed_strategies.size() >= 2);
  BOOST_TEST(unsolved.report.failed_strategies[0].strategy == Report::SOFT_PATCHES);
  BOOST_TEST(unsolved.report.failed_strategies[1].strategy == Report::STIFF_PATCHES);
  options.fallbacks = false;
  BOOST_TEST(!flatten(steep, options).succeeded());
}

BOOST_AUTO_TEST_CASE(charts_without_holes_are_the_same_whatever_the_option)
{
  const Chart chart = bump(12, 1);
  std::vector<std::vector<Point_2>> maps;
  for(const auto holes : {Options::SOLVE, Options::FILL, Options::REFUSE}) {
    Options options;
    options.holes = holes;
    maps.push_back(
        abf::flatten_chart(chart, options, CGAL::SuperLU_solver_traits<>(), [](std::vector<Point_2>&) {}).uv);
  }
  BOOST_TEST((maps[0] == maps[1]));
  BOOST_TEST((maps[0] == maps[2]));
}

BOOST_AUTO_TEST_CASE(parameterizers_take_the_option)
{
  typedef SMP::Hierarchical_coarse_mesh Mesh;
  Mesh mesh;
  make_mesh(punched_disks().front(), mesh);
  const auto run = [&](auto parameterizer) {
    const auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
    const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
    SMP::parameterize(mesh, parameterizer, border, uv);
    return parameterizer.report().status;
  };
  Options options;
  SMP::Hierarchical_options hierarchical;
  BOOST_TEST(options.holes == Options::SOLVE);
  options.holes = hierarchical.holes = Options::REFUSE;
  BOOST_TEST(run(SMP::ABF_plus_plus_parameterizer_3<Mesh>(options)) == SMP::Diagnosis::SEVERAL_BORDERS);
  BOOST_TEST(run(SMP::Hierarchical_parameterizer_3<Mesh>(hierarchical)) == SMP::Diagnosis::SEVERAL_BORDERS);
  options.holes = hierarchical.holes = Options::FILL;
  BOOST_TEST(run(SMP::ABF_plus_plus_parameterizer_3<Mesh>(options)) == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(run(SMP::Hierarchical_parameterizer_3<Mesh>(hierarchical)) == SMP::Diagnosis::NOTHING_WRONG);
  options.holes = hierarchical.holes = Options::SOLVE;
  BOOST_TEST(run(SMP::ABF_plus_plus_parameterizer_3<Mesh>(options)) == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(run(SMP::Hierarchical_parameterizer_3<Mesh>(hierarchical)) == SMP::Diagnosis::NOTHING_WRONG);
  options.holes = static_cast<Options::Holes>(3);
  BOOST_TEST(run(SMP::ABF_plus_plus_parameterizer_3<Mesh>(options)) == SMP::Diagnosis::WRONG_OPTION);
}

BOOST_AUTO_TEST_SUITE_END()
