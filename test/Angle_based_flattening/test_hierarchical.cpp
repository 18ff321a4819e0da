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

namespace {

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

} // namespace

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
      BOOST_TEST_INFO_SCOPE("seed " << seed << ", " << n << " squares along an edge");
      const auto best = flatten(mesh, direct), measures = flatten(mesh, hierarchical);
      BOOST_TEST(measures.flipped_triangles == 0);
      BOOST_TEST(hierarchical.report().relaxed_angles);
      BOOST_TEST(measures.mean_angle_change < 1.2 * best.mean_angle_change);
      BOOST_TEST(measures.angular_distortion < 1.3 * best.angular_distortion);
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
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    BOOST_TEST(flatten(mesh, hierarchical).flipped_triangles == 0);
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
    options.polish_options.barrier = polish ? 0 : SMP::ABF_plus_plus_options().barrier;
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
