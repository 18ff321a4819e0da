// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The hierarchical method: every stage by itself, and the parameterizer.

#include <boost/test/unit_test.hpp>

#include "hard_charts.h"
#include "test_charts.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/coarse_to_fine.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_hierarchical)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::Hierarchical_report Report;
typedef SMP::Hierarchical_options Options;
typedef abf::Planar_point Planar_point;

namespace {

const double extreme_angle = Options().extreme_angle;

std::vector<Chart> charts()
{
  return {flat_grid(9, 1), bump(25, 2), bump(12, 3, 20), pyramid(50, 3), pyramid(3, 1), annulus(40)};
}

Chart cone(int n)
{
  return grid(n, n,
              [](double x, double y) { return 100 * (std::max)(0., 0.5 - std::hypot(x - 0.5, y - 0.5)); });
}

// A coarse solver that gives up.
struct No_solver
{
  std::optional<std::vector<Point_2>> operator()(const Chart&) const { return std::nullopt; }
};

std::vector<Planar_point> planar_points(const Chart& chart)
{
  std::vector<Planar_point> points;
  for(const Point_3& p : chart.points)
    points.emplace_back(p.x(), p.y());
  return points;
}

} // namespace

BOOST_AUTO_TEST_SUITE(coarsening)

BOOST_AUTO_TEST_CASE(can_be_undone_exactly)
{
  for(const Chart& original : charts())
    for(double angle : {extreme_angle, 0.}) {
      Chart chart = original;
      abf::Coarsening coarsening(chart);
      coarsening.coarsen(3, angle);
      BOOST_TEST(coarsening.number_of_vertices() < original.number_of_vertices());
      while(coarsening.number_of_levels() > 0)
        coarsening.undo_level();
      BOOST_TEST((chart.vertex == original.vertex));
      BOOST_TEST((chart.opposite == original.opposite));
      BOOST_TEST(coarsening.number_of_vertices() == original.number_of_vertices());
    }
}

BOOST_AUTO_TEST_CASE(keeps_a_sound_chart_of_the_same_topology)
{
  for(const Chart& original : charts())
    for(int divisor : {2, 10, 1000}) {
      Chart chart = original;
      abf::Coarsening coarsening(chart);
      coarsening.coarsen(original.number_of_vertices() / divisor, 0);
      const abf::Coarse_chart coarse(coarsening.mesh(), coarsening.alive());
      BOOST_TEST(abf::diagnose(coarse.chart, true).message == "");
      BOOST_TEST(coarse.chart.borders.size() == original.borders.size());
    }
}

BOOST_AUTO_TEST_CASE(ends_at_one_triangle)
{
  for(const Chart& original : charts())
    if(original.borders.size() == 1) {
      Chart chart = original;
      abf::Coarsening coarsening(chart);
      coarsening.coarsen(3, 0);
      BOOST_TEST(coarsening.number_of_vertices() == 3);
    }
}

BOOST_AUTO_TEST_CASE(makes_no_extreme_angles)
{
  Chart chart = bump(30, 5);
  abf::Coarsening coarsening(chart);
  coarsening.coarsen(40, extreme_angle);
  const abf::Coarse_chart coarse(coarsening.mesh(), coarsening.alive());
  for(int c = 0; c < coarse.chart.number_of_corners(); ++c)
    BOOST_TEST(abf::surface_angle(coarse.chart, c) > 0.99 * extreme_angle);
}

// Also where blocks of vertices meet, on the larger chart
BOOST_AUTO_TEST_CASE(removes_independent_vertices_and_border_vertices_along_the_border)
{
  for(Chart chart : {bump(20, 6), bump(190, 6)}) {
    abf::Coarsening_stage stage(chart, abf::border_cycles(chart));
    for(int level = 0; level < 5; ++level)
      stage.add_level(stage.number_of_vertices() / 4 + 1, extreme_angle);
    while(stage.number_of_levels() > 0) {
      std::vector<abf::Edge_collapses::Record> records = stage.mesh().records();
      const std::vector<int> restored = stage.undo_level([](int, int) {});
      BOOST_TEST(restored.size() > 0.15 * stage.number_of_vertices());
      records.erase(records.begin(), records.end() - restored.size());
      std::vector<char> inserted(chart.points.size(), false);
      for(int v : restored)
        inserted[v] = true;
      for(abf::Edge_collapses::Record record : records) {
        const int v = stage.mesh().removed_vertex(record), w = stage.mesh().kept_vertex(record);
        bool is_independent = inserted[v];
        stage.mesh().for_each_corner(v, [&](int c) {
          is_independent &= !inserted[chart.vertex[abf::next_corner(c)]] &&
                            !inserted[chart.vertex[abf::previous_corner(c)]];
        });
        BOOST_TEST(is_independent);
        BOOST_TEST((chart.interior[v] >= 0 || chart.interior[w] < 0));
      }
    }
  }
}

// No part of a large chart becomes coarser than the others.
BOOST_AUTO_TEST_CASE(removes_as_many_as_wanted_everywhere)
{
  Chart chart = bump(200, 6);
  abf::Coarsening_stage stage(chart, abf::border_cycles(chart));
  const int all = stage.number_of_vertices(), quota = all / 10;
  stage.add_level(quota, extreme_angle);
  BOOST_TEST(stage.number_of_vertices() == all - quota);
  const auto last_fifth = std::lower_bound(stage.alive().begin(), stage.alive().end(), all - all / 5);
  const double removed = all / 5 - static_cast<double>(stage.alive().end() - last_fifth);
  BOOST_TEST(removed > 0.1 * quota);
  BOOST_TEST(removed < 0.3 * quota);
}

// Where a chart has been copied into another one with other numbers, values and sums come back to the right vertices.
BOOST_AUTO_TEST_CASE(follows_vertices_from_stage_to_stage)
{
  for(const Chart& original : charts()) {
    Chart chart = original;
    abf::Coarsening coarsening(chart);
    coarsening.coarsen(original.number_of_vertices() / 30, 0);
    const abf::Coarse_chart coarse = coarsening.coarse_chart();
    if(original.number_of_vertices() > 10)
      BOOST_TEST((&coarsening.mesh().chart() != &chart));
    const std::vector<int> sizes = coarsening.merged(std::vector<int>(original.points.size(), 1));
    const std::vector<int> fine = coarsening.original(coarse.vertices);
    for(std::size_t i = 0; i < fine.size(); ++i)
      BOOST_TEST((original.points[fine[i]] == coarse.chart.points[i]));

    std::vector<int> region(sizes.size(), -1), members(sizes.size(), 0);
    for(int v : coarse.vertices)
      region[v] = v;
    while(coarsening.number_of_levels() > 0)
      coarsening.undo_level(region);
    for(int v : region)
      ++members[v];
    for(std::size_t i = 0; i < fine.size(); ++i) {
      BOOST_TEST(region[fine[i]] == coarse.vertices[i]);
      BOOST_TEST(members[coarse.vertices[i]] == sizes[coarse.vertices[i]]);
    }
    BOOST_TEST((chart.vertex == original.vertex));
    BOOST_TEST((chart.node == original.node));
    BOOST_TEST(chart.nodes.size() == original.nodes.size());
  }
}

BOOST_AUTO_TEST_CASE(keeps_borders_and_their_order)
{
  for(const Chart& original : charts()) {
    Chart chart = original;
    abf::Coarsening coarsening(chart);
    coarsening.coarsen(original.number_of_vertices() / 10, 0);
    const abf::Border_cycles borders = coarsening.borders();
    BOOST_TEST(borders.size() == original.borders.size());
    const Chart& coarse = coarsening.mesh().chart();
    for(const std::vector<int>& cycle : borders)
      for(std::size_t i = 0; i < cycle.size(); ++i) {
        const int next = cycle[(i + 1) % cycle.size()];
        bool is_edge = false;
        coarsening.mesh().for_each_corner(cycle[i], [&](int c) {
          is_edge |=
              coarse.vertex[abf::next_corner(c)] == next && coarse.opposite[abf::previous_corner(c)] < 0;
        });
        BOOST_TEST(is_edge);
      }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(positions)

// In a planar chart, a vertex is inserted where it was, also at the border: that is the purpose of Eq. 22.
BOOST_AUTO_TEST_CASE(reproduce_a_planar_chart)
{
  Chart chart = flat_grid(8, 3);
  const abf::Edge_collapses mesh(chart);
  const std::vector<Planar_point> uv = planar_points(chart);
  abf::Planar_star star;
  for(int v = 0; v < chart.number_of_vertices(); ++v) {
    star.gather(mesh, uv, v);
    BOOST_TEST((abf::harmonic_position(star) - uv[v]).norm() < 1e-13);
    if(chart.interior[v] >= 0)
      BOOST_TEST((abf::mean_value_position(star) - uv[v]).norm() < 1e-13);
    BOOST_TEST(abf::is_valid(star, uv[v]));
    BOOST_TEST(abf::is_valid(star, abf::kernel_centre(star)));
  }
}

// A star polygon with a small kernel, and one without a kernel.
abf::Planar_star star_of(const std::vector<Planar_point>& counterclockwise)
{
  abf::Planar_star star;
  for(std::size_t i = 0; i < counterclockwise.size(); ++i)
    star.triangles.push_back(
        {counterclockwise[i], counterclockwise[(i + 1) % counterclockwise.size()], 1, 1, 1, 1});
  return star;
}

BOOST_AUTO_TEST_CASE(kernel_is_the_last_resort)
{
  const abf::Planar_star narrow = star_of({{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}});
  Planar_point position(10, 1);
  BOOST_TEST(abf::insert_vertex(narrow, position) == abf::INSERTED_IN_KERNEL);
  BOOST_TEST((position - Planar_point(0.5, 0.5)).norm() < 1e-12);

  const abf::Planar_star none =
      star_of({{0, 0}, {10, 0}, {10, 10}, {9, 10}, {9, 1}, {1, 1}, {1, 10}, {0, 10}});
  BOOST_TEST(abf::insert_vertex(none, position) == abf::NOT_INSERTED);
}

// Where weights fail, the centre of the kernel is taken unless there is something better on the way from a vertex of
// the ring.
BOOST_AUTO_TEST_CASE(the_best_of_several_positions_is_taken)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  int centres = 0, better = 0;
  for(int i = 0; i < 3000; ++i) {
    std::vector<Planar_point> ring;
    const int n = 5 + i % 4;
    for(int k = 0; k < n; ++k) {
      const double angle = 2 * abf::pi * (k + 0.5 * number(random)) / n,
                   radius = std::pow(0.02, number(random));
      ring.push_back(radius * Planar_point(std::cos(angle), std::sin(angle)));
    }
    const abf::Planar_star star = star_of(ring);
    const Planar_point centre = abf::kernel_centre(star);
    if(!abf::is_valid(star, centre) || abf::is_valid(star, abf::harmonic_position(star)) ||
       abf::is_valid(star, abf::mean_value_position(star)))
      continue;
    Planar_point position = ring.front();
    if(abf::insert_vertex(star, position) == abf::INSERTED_IN_KERNEL) {
      ++centres;
      BOOST_TEST((position == centre));
    } else {
      ++better;
      BOOST_TEST(abf::similarity_energy(star, position) < abf::similarity_energy(star, centre));
    }
  }
  BOOST_TEST(centres > 10);
  BOOST_TEST(better > 10);
}

// Sweeps with rings that are kept do what sweeps without do.
BOOST_AUTO_TEST_CASE(kept_rings_give_the_same_map)
{
  for(bool is_weighted : {false, true}) {
    Chart chart = bump(40, 9, 2);
    std::mt19937 random(1);
    for(int t = 0; is_weighted && t < chart.number_of_triangles(); ++t)
      chart.weight.push_back(std::uniform_real_distribution<double>(0.1, 10)(random));
    abf::Coarsening coarsening(chart);
    coarsening.coarsen(300, extreme_angle);
    const Chart& coarse = coarsening.mesh().chart();
    std::vector<Planar_point> kept = planar_points(coarse), other = kept, before = kept;
    abf::Local_border kept_border(coarsening, kept), other_border(coarsening, other);
    abf::Relaxation with_rings(coarsening, kept, kept_border), without_rings(coarsening, other, other_border);
    abf::relax_level(coarsening, with_rings, 3);
    for(int sweep = 0; sweep < 3; ++sweep)
      without_rings.sweep(abf::MIPS_star());
    double moved = 0;
    for(int v : coarsening.alive()) {
      BOOST_TEST((kept[v] - other[v]).norm() < 1e-5);
      moved = (std::max)(moved, (kept[v] - before[v]).norm());
    }
    BOOST_TEST(moved > 1e-3);
  }
}

// Also of needles, whose angles must stay positive
BOOST_AUTO_TEST_CASE(planar_angles_of_triangles)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for(int i = 0; i < 10000; ++i) {
    const double height = std::pow(10, -12 * std::abs(number(random)));
    const std::array<Planar_point, 3> x = {Planar_point(number(random), height), Planar_point(-1, 0),
                                           Planar_point(1, 0)};
    std::array<double, 3> dots, beta, exact;
    double sum = 0;
    const double twice_area = abf::cross(x[1] - x[0], x[2] - x[0]);
    for(int k = 0; k < 3; ++k) {
      dots[k] = (x[(k + 1) % 3] - x[k]).dot(x[(k + 2) % 3] - x[k]);
      exact[k] = std::atan2(twice_area, dots[k]);
      beta[k] = 1.1 + number(random);
    }
    const std::array<double, 3> alpha = abf::planar_angles(twice_area, dots);
    const abf::Angle_energy energy{0.1};
    for(int k = 0; k < 3; ++k) {
      BOOST_TEST(std::abs(alpha[k] - exact[k]) <= 1e-14 * exact[k]);
      const double t = exact[k] / beta[k];
      sum += (t - 1) * (t - 1) + energy.barrier * (t - 1 - std::log(t));
    }
    BOOST_TEST(std::abs(energy.value(alpha, beta) - sum) < 1e-13 * (1 + sum));
  }
}

// Of the energy of all stars of a map. Only the Hessian of the energy of angles is not the exact one.
template <typename Star>
void check_derivatives(Star star, bool has_exact_hessian)
{
  typedef typename Star::Energy Energy;
  Chart chart = bump(6, 7, 1);
  const abf::Edge_collapses mesh(chart);
  const std::vector<Planar_point> uv = planar_points(chart);
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

BOOST_AUTO_TEST_CASE(derivatives_of_energies_match_finite_differences)
{
  check_derivatives(abf::MIPS_star(), true);
  for(double theta : {0., 0.005, 0.5, 1.})
    check_derivatives(abf::Area_star(theta), true);
  const std::vector<double> beta = abf::target_angles(bump(6, 7, 1));
  check_derivatives(abf::Angle_star(beta, abf::Angle_energy{0.1}), false);
  check_derivatives(abf::Area_angle_star(beta, abf::Angle_energy{0.1}), false);
}

BOOST_AUTO_TEST_CASE(relaxation_keeps_stars_valid_and_lowers_the_energy)
{
  Chart chart = bump(10, 8, 2);
  const abf::Edge_collapses mesh(chart);
  std::vector<Planar_point> uv = planar_points(chart);
  abf::MIPS_star star;
  for(int sweep = 0; sweep < 5; ++sweep)
    for(int v = 0; v < chart.number_of_vertices(); ++v) {
      star.gather(mesh, uv, v);
      const double before = abf::MIPS_star::Energy(star, uv[v], false).value;
      const Planar_point old = uv[v];
      if(abf::relax_vertex(star, uv[v], [](const Planar_point&) { return true; }) < 1)
        BOOST_TEST(abf::MIPS_star::Energy(star, uv[v], false).value < before);
      else
        BOOST_TEST((uv[v] == old));
      BOOST_TEST(abf::is_valid(star, uv[v]));
    }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(whole)

// Without any solver there is a valid map, however steep the surface.
BOOST_AUTO_TEST_CASE(always_valid_start)
{
  std::vector<Chart> all{flat_grid(20, 1), pyramid(3, 100), pyramid(1000, 100), cone(30)};
  for(double height : {1., 10., 100.})
    all.push_back(bump(24, 4, height));
  for(const Chart& original : all) {
    Chart chart = original;
    const auto result = abf::flatten_coarse_to_fine(chart, Options(), No_solver());
    BOOST_TEST(result.succeeded());
    BOOST_TEST(result.report.start == Report::PROGRESSIVE_EMBEDDING);
    BOOST_TEST(abf::flipped_triangles(chart, result.uv).empty());
    BOOST_TEST((chart.vertex == original.vertex));
  }
}

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_2> UV_map;

Mesh mesh_of(const Chart& chart)
{
  Mesh mesh;
  for(const Point_3& p : chart.points)
    mesh.add_vertex({p.x(), p.y(), p.z()});
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    mesh.add_face(Mesh::Vertex_index(chart.vertex[3 * t]), Mesh::Vertex_index(chart.vertex[3 * t + 1]),
                  Mesh::Vertex_index(chart.vertex[3 * t + 2]));
  return mesh;
}

Mesh bump_mesh(int n)
{
  return mesh_of(bump(n, 9, 0.5));
}

// A ramp that winds up around a vertex of its border.
Chart ramp(int rings, int sectors, double turn)
{
  std::vector<Point_3> points{Point_3(0, 0, 0)};
  for(int r = 1; r <= rings; ++r)
    for(int i = 0; i <= sectors; ++i) {
      const double angle = turn * i / sectors;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.1 * r * angle);
    }
  Triangles triangles;
  for(int i = 1; i <= sectors; ++i) {
    triangles.push_back({0, i, i + 1});
    for(int r = 1; r < rings; ++r) {
      const int inner = (r - 1) * (sectors + 1) + i, outer = inner + sectors + 1;
      triangles.push_back({inner, outer, outer + 1});
      triangles.push_back({inner, outer + 1, inner + 1});
    }
  }
  return make_chart(points, triangles);
}

template <typename Parameterizer>
SMP::Flattening_measures flatten(Mesh& mesh, Parameterizer& parameterizer)
{
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const UV_map uv =
      mesh.add_property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_2>("v:uv").first;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, bhd, uv) == SMP::OK);
  BOOST_TEST(parameterizer.report().message == "");
  return SMP::measure_flattening(mesh, bhd, uv);
}

BOOST_AUTO_TEST_CASE(is_nearly_as_good_as_the_direct_method)
{
  Mesh mesh = bump_mesh(60);
  SMP::ABF_plus_plus_parameterizer_3<Mesh> direct;
  SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh> hierarchical;
  const auto best = flatten(mesh, direct), measures = flatten(mesh, hierarchical);
  BOOST_TEST(measures.flipped_triangles == 0);
  BOOST_TEST(measures.l2_stretch < best.l2_stretch + 0.025); // the paper's criteria
  BOOST_TEST(measures.angular_distortion < 2 * best.angular_distortion);
  const Report& report = hierarchical.report();
  BOOST_TEST(report.start == Report::COARSE_PARAMETERIZER);
  BOOST_TEST(report.levels > 5);
  BOOST_TEST(report.coarse_vertices < 0.06 * report.vertices);
  BOOST_TEST(report.seconds.total() > 0);
#ifdef __linux__
  BOOST_TEST(report.peak_memory > num_vertices(mesh) * sizeof(UV_map::value_type));
#endif
}

// Three steep peaks at random places. MIPS would change angles by 1.5 to 2 times as much as the direct method.
Chart peaks(int n, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.2, 0.8), height(0.5, 0.8), width(0.08, 0.15);
  std::vector<std::array<double, 4>> peaks(3);
  for(std::array<double, 4>& peak : peaks)
    for(int i = 0; i < 4; ++i)
      peak[i] = i < 2 ? place(random) : i == 2 ? height(random) : width(random);
  return grid(n, seed, [&](double x, double y) {
    double z = 0;
    for(const auto& [cx, cy, h, w] : peaks)
      z += h * std::exp(-((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (2 * w * w));
    return z;
  });
}

BOOST_AUTO_TEST_CASE(keeps_angles_of_steep_peaks)
{
  const unsigned int seeds = std::getenv("ABF_TEST_QUICK") ? 3 : 12;
  for(unsigned int seed = 0; seed < seeds; ++seed)
    for(int n : {40, 70}) {
      Mesh mesh = mesh_of(peaks(n, seed));
      SMP::ABF_plus_plus_parameterizer_3<Mesh> direct;
      SMP::Hierarchical_parameterizer_3<Mesh> hierarchical;
      BOOST_TEST_CONTEXT("seed " << seed << ", " << n << " squares along an edge")
      {
        const auto best = flatten(mesh, direct), measures = flatten(mesh, hierarchical);
        BOOST_TEST(measures.flipped_triangles == 0);
        BOOST_TEST(hierarchical.report().relaxed_angles);
        BOOST_TEST(measures.mean_angle_change < 1.2 * best.mean_angle_change);
        BOOST_TEST(measures.angular_distortion < 1.3 * best.angular_distortion);
      }
    }
}

// MIPS is several times faster, and good enough where triangles are not long.
BOOST_AUTO_TEST_CASE(relaxes_angles_only_where_that_is_needed)
{
  Mesh plane = mesh_of(flat_grid(40, 1)), ramps = mesh_of(ramp(20, 60, CGAL_PI));
  for(Mesh* mesh : {&plane, &ramps}) {
    SMP::Hierarchical_parameterizer_3<Mesh> hierarchical;
    flatten(*mesh, hierarchical);
    BOOST_TEST(!hierarchical.report().relaxed_angles);
  }
  Options options;
  options.sweeps = 0;
  Mesh steep = mesh_of(peaks(40, 0));
  SMP::Hierarchical_parameterizer_3<Mesh> without_sweeps(options);
  flatten(steep, without_sweeps);
  BOOST_TEST(!without_sweeps.report().relaxed_angles);
}

// A coarse chart that overlaps itself at its border is refined, not replaced.
BOOST_AUTO_TEST_CASE(more_than_a_full_turn_at_the_border)
{
  const double pi = 3.14159265358979323846;
  Mesh mesh = mesh_of(ramp(20, 60, 2.5 * pi));
  SMP::Hierarchical_parameterizer_3<Mesh> hierarchical;
  const SMP::Flattening_measures measures = flatten(mesh, hierarchical);
  BOOST_TEST(measures.flipped_triangles == 0);
  BOOST_TEST(!measures.border_is_simple);
  BOOST_TEST(hierarchical.report().start == Report::COARSE_PARAMETERIZER);
}

// Corners at random points of a square: coarse charts overlap themselves, and angles at the border are nearly full
// turns.
BOOST_AUTO_TEST_CASE(flattens_disks_with_random_corners)
{
  const unsigned int seeds = std::getenv("ABF_TEST_QUICK") ? 30 : 300;
  for(unsigned int seed = 0; seed < seeds; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate;
    Chart chart = flat_grid(12, 0);
    for(Point_3& p : chart.points) {
      const double x = coordinate(random);
      p = Point_3(x, coordinate(random), 0);
    }
    Mesh mesh = mesh_of(chart);
    Options options;
    options.polish = seed % 2 == 1;
    SMP::Hierarchical_parameterizer_3<Mesh> hierarchical(options);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      BOOST_TEST(flatten(mesh, hierarchical).flipped_triangles == 0);
    }
  }
}

// On noise, as relaxation lowers the energy of angles itself on some smooth surfaces.
BOOST_AUTO_TEST_CASE(angle_sweeps_lower_the_angular_distortion)
{
  std::mt19937 random(2);
  Mesh mesh = mesh_of(patch(40, 40, [&](int i, int j) {
    return Point_3(i, j, std::uniform_real_distribution<double>(-0.5, 0.5)(random));
  }));
  std::vector<double> distortions;
  for(int sweeps : {0, 1, 3}) {
    Options options;
    options.angle_sweeps = sweeps;
    SMP::Hierarchical_parameterizer_3<Mesh> hierarchical(options);
    distortions.push_back(flatten(mesh, hierarchical).angular_distortion);
  }
  BOOST_TEST(distortions[1] < 0.97 * distortions[0]);
  BOOST_TEST(distortions[2] < 0.99 * distortions[1]);
}

// Also where the noise has the effect of a stretch in one direction, as diagonals that are all parallel have.
BOOST_AUTO_TEST_CASE(angle_sweeps_come_close_to_the_direct_method)
{
  std::mt19937 random(1);
  const int n = 60;
  Mesh mesh = mesh_of(patch(n, n, [&](int i, int j) {
    return Point_3(i, j, std::uniform_real_distribution<double>(-0.7, 0.7)(random));
  }));
  SMP::ABF_plus_plus_parameterizer_3<Mesh> direct;
  flatten(mesh, direct);
  Options options;
  options.angle_sweeps = 50;
  options.energy_tolerance = 0.01;
  SMP::Hierarchical_parameterizer_3<Mesh> hierarchical(options);
  flatten(mesh, hierarchical);
  BOOST_TEST(hierarchical.report().angle_sweeps < 50);
  BOOST_TEST(hierarchical.report().energy >= direct.report().energy);
  BOOST_TEST(hierarchical.report().energy < 1.2 * direct.report().energy);
}

BOOST_AUTO_TEST_CASE(energy_after_angle_sweeps_and_polishing)
{
  Mesh mesh = bump_mesh(20);
  Options options;
  options.barrier = 0;
  SMP::Hierarchical_parameterizer_3<Mesh> without(options);
  flatten(mesh, without);
  BOOST_TEST(std::isnan(without.report().energy));
  BOOST_TEST(without.report().angle_sweeps == 0);
  options.angle_sweeps = 4;
  for(bool polish : {false, true}) {
    options.polish = polish;
    options.polish_options.barrier = 0;
    SMP::Hierarchical_parameterizer_3<Mesh> hierarchical(options);
    const double corners = 3. * mesh.number_of_faces();
    const double energy = corners * flatten(mesh, hierarchical).angular_distortion;
    BOOST_TEST(hierarchical.report().energy == energy, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(hierarchical.report().angle_sweeps == 4);
  }
}

BOOST_AUTO_TEST_CASE(polished_it_is_the_direct_method)
{
  Mesh mesh = bump_mesh(30);
  SMP::ABF_plus_plus_parameterizer_3<Mesh> direct;
  Options options;
  options.polish = true;
  SMP::Hierarchical_parameterizer_3<Mesh> polished(options);
  const auto a = flatten(mesh, direct), b = flatten(mesh, polished);
  BOOST_TEST(polished.report().polished);
  BOOST_TEST(a.angular_distortion == b.angular_distortion, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(a.l2_stretch == b.l2_stretch, boost::test_tools::tolerance(1e-4));
}

// CGAL's parameterizer has no report of its own, and needs none.
BOOST_AUTO_TEST_CASE(any_coarse_parameterizer)
{
  typedef SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh> LSCM;
  Mesh mesh = bump_mesh(30);
  SMP::Hierarchical_parameterizer_3<Mesh, LSCM> hierarchical;
  BOOST_TEST(flatten(mesh, hierarchical).flipped_triangles == 0);
  BOOST_TEST(hierarchical.report().start == Report::COARSE_PARAMETERIZER);
}

// Large enough to be split into several blocks in each stage
BOOST_AUTO_TEST_CASE(same_bits_whatever_the_number_of_threads)
{
  Mesh mesh = bump_mesh(80);
  std::vector<UV_map::value_type> first;
  for(int threads : {1, 1, 2, 3, 0}) {
    Options options;
    options.threads = threads;
    options.angle_sweeps = 2;
    SMP::Hierarchical_parameterizer_3<Mesh> hierarchical(options);
    flatten(mesh, hierarchical);
    const UV_map uv = mesh.add_property_map<Mesh::Vertex_index, UV_map::value_type>("v:uv").first;
    const std::vector<UV_map::value_type> points(uv.begin(), uv.end());
    if(first.empty())
      first = points;
    BOOST_TEST((points == first));
  }
}

BOOST_AUTO_TEST_CASE(refuses_what_the_direct_method_refuses)
{
  Mesh mesh = bump_mesh(5);
  Options refusing;
  refusing.holes = Options::REFUSE;
  SMP::Hierarchical_parameterizer_3<Mesh> hierarchical(refusing);
  std::map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_2> uv;
  std::map<Mesh::Vertex_index, bool> parameterized;
  const auto run = [&] {
    return hierarchical.parameterize(mesh, CGAL::Polygon_mesh_processing::longest_border(mesh).first,
                                     boost::make_assoc_property_map(uv), get(boost::vertex_index, mesh),
                                     boost::make_assoc_property_map(parameterized));
  };
  CGAL::Euler::remove_face(mesh.halfedge(Mesh::Face_index(24)), mesh);
  BOOST_TEST(run() == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  BOOST_TEST(hierarchical.report().status == SMP::Diagnosis::SEVERAL_BORDERS);
  mesh.point(Mesh::Vertex_index(8)) = {0, 0, std::numeric_limits<double>::infinity()};
  BOOST_TEST(run() == SMP::ERROR_WRONG_PARAMETER);
  BOOST_TEST(hierarchical.report().offending_vertices.front() == Mesh::Vertex_index(8));
  Options wrong;
  wrong.simplification_rate = 1;
  hierarchical = SMP::Hierarchical_parameterizer_3<Mesh>(wrong);
  BOOST_TEST(run() == SMP::ERROR_WRONG_PARAMETER);
  BOOST_TEST(hierarchical.report().status == SMP::Diagnosis::WRONG_OPTION);
  wrong = Options();
  wrong.energy_tolerance = 1;
  hierarchical = SMP::Hierarchical_parameterizer_3<Mesh>(wrong);
  BOOST_TEST(run() == SMP::ERROR_WRONG_PARAMETER);
  wrong = Options();
  wrong.sweeps = 1000000000;
  hierarchical = SMP::Hierarchical_parameterizer_3<Mesh>(wrong);
  BOOST_TEST(run() == SMP::ERROR_WRONG_PARAMETER);
  BOOST_TEST(uv.empty());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
