// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prescribed angles at border vertices: rectangles, polygons, what is feasible, and what is not.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Surface_mesh_parameterization/split_flat_chords.h>

#include "mesh_of_chart.h"
#include "random_charts.h"
#include "test_charts.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_angle_sums)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef SMP::ABF_plus_plus_options Options;
typedef SMP::ABF_plus_plus_report Report;
typedef SMP::ABF_plus_plus_parameterizer_3<Mesh> Parameterizer;
typedef SMP::Vertex_angles<Mesh> Angles;

namespace {

Halfedge longest_border(const Mesh& mesh)
{
  return CGAL::Polygon_mesh_processing::longest_border(mesh).first;
}

// The vertices of a border, against the direction of the map's border
std::vector<Vertex> border_vertices(const Mesh& mesh, Halfedge border)
{
  std::vector<Vertex> vertices;
  for(Vertex v : CGAL::vertices_around_face(border, mesh))
    vertices.push_back(v);
  return vertices;
}

// A flattening with prescribed angles
struct Prescribed
{
  Mesh mesh;
  Halfedge border;
  Mesh::Property_map<Vertex, Point_2> uv;
  Report report;
  std::vector<Vertex> offending;

  template <typename AngleMap>
  Prescribed(const Mesh& surface, const AngleMap& angles, const Options& options = Options())
      : mesh(surface), border(longest_border(mesh)),
        uv(mesh.add_property_map<Vertex, Point_2>("v:uv", Point_2(-1, -1)).first)
  {
    Parameterizer parameterizer(options);
    parameterizer.set_angle_sums(angles);
    const auto code = SMP::parameterize(mesh, parameterizer, border, uv);
    report = parameterizer.report();
    offending = parameterizer.offending_vertices();
    BOOST_TEST(code == error_code(report.diagnosis));
    if(code != SMP::OK)
      for(Vertex v : mesh.vertices())
        BOOST_REQUIRE(uv[v] == Point_2(-1, -1));
  }

  double planar_angle(Vertex v) const
  {
    double sum = 0;
    for(Halfedge h : CGAL::halfedges_around_target(v, mesh))
      if(!mesh.is_border(h)) {
        const auto a = uv[mesh.target(mesh.next(h))] - uv[v], b = uv[mesh.source(h)] - uv[v];
        sum += std::atan2(CGAL::determinant(a, b), a * b);
      }
    return sum;
  }
};

// The angles that a map has, and the largest distance of a vertex from its side, looked at in another way than the report does
void check_angles(const Prescribed& map, const Angles& angles)
{
  BOOST_TEST(map.report.diagnosis == Report::NOTHING_WRONG, map.report.message);
  if(map.report.diagnosis != Report::NOTHING_WRONG)
    return;
  BOOST_TEST(map.report.converged);
  BOOST_TEST(SMP::is_locally_injective(map.mesh, map.uv));
  double largest = 0;
  int prescribed = 0;
  for(Vertex v : map.mesh.vertices())
    if(const auto angle = angles[v]) {
      largest = (std::max)(largest, std::abs(map.planar_angle(v) - *angle));
      ++prescribed;
    }
  BOOST_TEST(map.report.prescribed_angles == prescribed);
  BOOST_TEST(largest < 1e-8);
  BOOST_TEST(std::abs(map.report.largest_angle_error - largest) < 1e-8);
}

// Every vertex of a rectangle is within rounding of its box, and each corner is one of the box.
void check_rectangle(const Prescribed& map, const std::array<Vertex, 4>& corners)
{
  const std::complex<double> origin(map.uv[corners[0]].x(), map.uv[corners[0]].y());
  const auto relative = [&](Vertex v) {
    const std::complex<double> x(map.uv[corners[1]].x(), map.uv[corners[1]].y());
    return (std::complex<double>(map.uv[v].x(), map.uv[v].y()) - origin) / (x - origin);
  };
  const double height = relative(corners[2]).imag();
  double deviation = std::abs(relative(corners[2]).real() - 1) + std::abs(relative(corners[3]).real()) +
                     std::abs(relative(corners[3]).imag() - height);
  for(Vertex v : border_vertices(map.mesh, map.border)) {
    const std::complex<double> p = relative(v);
    deviation = (std::max)(deviation, (std::min)({std::abs(p.real()), std::abs(p.real() - 1),
                                                  std::abs(p.imag()), std::abs(p.imag() - height)}));
  }
  BOOST_TEST(deviation < 1e-12);
  BOOST_TEST(map.report.side_deviation < 1e-12);
  BOOST_TEST(map.report.border_is_simple);
  BOOST_TEST(SMP::is_injective(map.mesh, map.uv));
}

std::array<Vertex, 4> random_corners(const std::vector<Vertex>& border, std::mt19937& random)
{
  std::array<std::size_t, 4> ranks;
  do {
    for(std::size_t& rank : ranks)
      rank = random() % border.size();
    std::sort(ranks.begin(), ranks.end());
  } while(std::adjacent_find(ranks.begin(), ranks.end()) != ranks.end());
  return {border[ranks[0]], border[ranks[1]], border[ranks[2]], border[ranks[3]]};
}

// The angles at the border of a map of a chart
std::vector<double> border_angles(const Chart& chart, const std::vector<Point_2>& uv)
{
  std::vector<double> sums(chart.points.size(), 0);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    sums[chart.vertex[c]] += abf::planar_angle(chart, uv, c);
  return sums;
}

Angles angles_of(const Chart& chart, const std::vector<double>& sums)
{
  Angles angles;
  for(int c : chart.borders.front())
    angles.set(Vertex(chart.edge_source(c)), sums[chart.edge_source(c)]);
  return angles;
}

bool has_flips(const Chart& chart, const std::vector<Point_2>& uv)
{
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    if(CGAL::orientation(uv[chart.vertex[3 * t]], uv[chart.vertex[3 * t + 1]], uv[chart.vertex[3 * t + 2]]) !=
       CGAL::COUNTERCLOCKWISE)
      return true;
  return false;
}

// The flat chart, bent around a circle by an angle, and shaken
std::vector<Point_2> bent(const Chart& chart, double angle, double width)
{
  std::vector<Point_2> uv;
  for(const Point_3& p : chart.points) {
    const double radius = 1 + width * p.y(), direction = -angle * p.x();
    uv.emplace_back(radius * std::cos(direction), radius * std::sin(direction));
  }
  for(Point_2& p : uv) // clockwise around the circle, outwards: the orientation is that of the chart
    p = Point_2(p.y(), p.x());
  return uv;
}

} // namespace

BOOST_AUTO_TEST_SUITE(nodes)

BOOST_AUTO_TEST_CASE(are_border_vertices_with_an_angle)
{
  Chart chart = bump(6, 2);
  const int inner = chart.number_of_interior_vertices;
  chart.angle_sums.assign(chart.points.size(), (std::numeric_limits<double>::quiet_NaN)());
  const int v = chart.edge_source(chart.borders.front()[3]);
  chart.angle_sums[v] = 2;
  abf::find_nodes(chart);
  BOOST_TEST(chart.number_of_nodes() == inner + 1);
  BOOST_TEST(chart.number_of_bound_nodes == 0);
  BOOST_TEST(chart.nodes[chart.node[v]].angle_sum == 2);
  BOOST_TEST(chart.nodes[chart.node[v]].has_planarity);
  BOOST_TEST(!chart.nodes[chart.node[v]].has_reconstruction);

  for(int c : chart.borders.front())
    chart.angle_sums[chart.edge_source(c)] = 3;
  abf::find_nodes(chart); // the sum of all equations is that of all triangles
  BOOST_TEST(std::count_if(chart.nodes.begin(), chart.nodes.end(),
                           [](const abf::Constraint_node& node) { return !node.has_planarity; }) == 1);
}

BOOST_AUTO_TEST_CASE(of_holes_are_the_last_ones)
{
  Chart chart = annulus(12);
  chart.angle_sums.assign(chart.points.size(), (std::numeric_limits<double>::quiet_NaN)());
  for(int c : chart.borders.front())
    chart.angle_sums[chart.edge_source(c)] = 3;
  abf::find_nodes(chart);
  BOOST_TEST(chart.number_of_bound_nodes == 12);
  BOOST_TEST(chart.number_of_free_nodes() == 12);
  for(int c : chart.hole(0))
    BOOST_TEST(chart.node[chart.edge_source(c)] >= 12);
}

BOOST_AUTO_TEST_CASE(scale_the_target_angles)
{
  Chart chart = bump(6, 2);
  chart.angle_sums.assign(chart.points.size(), (std::numeric_limits<double>::quiet_NaN)());
  for(int c : chart.borders.front())
    chart.angle_sums[chart.edge_source(c)] = 2.5;
  abf::find_nodes(chart);
  const std::vector<double> beta = abf::target_angles(chart);
  std::vector<double> sums(chart.points.size(), 0);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    sums[chart.vertex[c]] += beta[c];
  for(int c : chart.borders.front()) // also where there is no equation
    BOOST_TEST(sums[chart.edge_source(c)] == 2.5, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(rectangles)

void check_rectangle_of(Mesh mesh, const std::array<Vertex, 4>& corners, const Options& options = Options())
{
  const Angles angles = SMP::rectangle_angles(mesh, corners);
  SMP::split_flat_chords(mesh, longest_border(mesh), angles);
  const Prescribed map(mesh, angles, options);
  check_angles(map, angles);
  if(map.report.diagnosis == Report::NOTHING_WRONG)
    check_rectangle(map, corners);
}

BOOST_AUTO_TEST_CASE(of_bumps_with_any_corners)
{
  std::mt19937 random(1);
  for(int i = 0; i < 40; ++i) {
    const Mesh mesh = mesh_of_chart<Mesh>(bump(6 + i % 9, i, 0.2 + 0.02 * i));
    check_rectangle_of(mesh, random_corners(border_vertices(mesh, longest_border(mesh)), random));
  }
}

// Straight whatever the tolerance is, with each solver and each start of the border
BOOST_AUTO_TEST_CASE(in_every_way)
{
  const Mesh mesh = mesh_of_chart<Mesh>(bump(12, 3, 0.6));
  std::mt19937 random(5);
  const auto corners = random_corners(border_vertices(mesh, longest_border(mesh)), random);
  for(double tolerance : {1e-3, 1e-5, 1e-9})
    for(auto solver : {Options::ITERATIVE, Options::DIRECT})
      for(auto step : {Options::NEWTON, Options::SEQUENTIAL_LINEARLY_CONSTRAINED}) {
        Options options;
        options.tolerance = tolerance;
        options.linear_solver = solver;
        options.step = step;
        check_rectangle_of(mesh, corners, options);
      }
}

// Which equation is left out does not matter.
BOOST_AUTO_TEST_CASE(do_not_depend_on_the_start_of_the_border)
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(8, 3, 0.6));
  std::mt19937 random(6);
  const auto corners = random_corners(border_vertices(mesh, longest_border(mesh)), random);
  const Angles angles = SMP::rectangle_angles(mesh, corners);
  SMP::split_flat_chords(mesh, longest_border(mesh), angles);
  Options options;
  options.tolerance = options.energy_tolerance = 1e-12;
  std::optional<double> ratio;
  for(Halfedge h : CGAL::halfedges_around_face(longest_border(mesh), mesh)) {
    const auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
    Parameterizer parameterizer(options);
    parameterizer.set_angle_sums(angles);
    BOOST_TEST(SMP::parameterize(mesh, parameterizer, h, uv) == SMP::OK);
    const double squared = CGAL::squared_distance(uv[corners[0]], uv[corners[1]]) /
                           CGAL::squared_distance(uv[corners[1]], uv[corners[2]]);
    if(!ratio)
      ratio = squared;
    BOOST_TEST(squared == *ratio, boost::test_tools::tolerance(1e-8));
  }
}

// Corners alone: the sides between them are free.
BOOST_AUTO_TEST_CASE(with_free_sides)
{
  const Mesh mesh = mesh_of_chart<Mesh>(bump(12, 3, 0.6));
  std::mt19937 random(8);
  Angles angles;
  for(Vertex v : random_corners(border_vertices(mesh, longest_border(mesh)), random))
    angles.set(v, CGAL_PI / 2);
  const Prescribed map(mesh, angles);
  check_angles(map, angles);
  BOOST_TEST(map.report.prescribed_angles == 4);
  BOOST_TEST(map.report.side_deviation == 0); // there are no sides
}

BOOST_AUTO_TEST_CASE(with_holes)
{
  Chart chart = bump(12, 3, 0.6);
  Mesh mesh = mesh_of_chart<Mesh>(chart);
  for(int v : {42, 43, 100}) // inner vertices
    CGAL::Euler::remove_center_vertex(mesh.halfedge(Vertex(v)), mesh);
  for(auto f : mesh.faces())
    if(mesh.degree(f) > 3)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  std::mt19937 random(8);
  const auto corners = random_corners(border_vertices(mesh, longest_border(mesh)), random);
  const Angles angles = SMP::rectangle_angles(mesh, corners);
  SMP::split_flat_chords(mesh, longest_border(mesh), angles);
  for(auto holes : {Options::SOLVE, Options::FILL}) {
    Options options;
    options.holes = holes;
    const Prescribed map(mesh, angles, options);
    BOOST_TEST(map.report.borders > 1);
    check_angles(map, angles);
    check_rectangle(map, corners);
  }
}

struct Disk
{
  const char* file;
  int triangles;
};

BOOST_AUTO_TEST_CASE(of_reference_disks)
{
  const char* directory = std::getenv("ABF_SHARED_DATA_DIR");
  const int most = std::getenv("ABF_TEST_QUICK") ? 20000 : 1000000;
  if(directory == nullptr) {
    BOOST_TEST_MESSAGE("skipped: no reference disks");
    return;
  }
  std::mt19937 random(9);
  for(const Disk& disk :
      {Disk{"cow", 5804}, Disk{"dino", 7828}, Disk{"lionhead", 16674}, Disk{"camel", 19536},
       Disk{"armadillo", 52000}, Disk{"bunny", 75408}, Disk{"horse", 96966}})
    if(disk.triangles <= most) {
      Mesh mesh;
      BOOST_REQUIRE(
          CGAL::IO::read_polygon_mesh(std::string(directory) + "/" + disk.file + "_disk.ply", mesh));
      for(int i = 0; i < (disk.triangles < 20000 ? 5 : 1); ++i)
        BOOST_TEST_CONTEXT(disk.file << " " << i)
      check_rectangle_of(mesh, random_corners(border_vertices(mesh, longest_border(mesh)), random));
    }
}

// A face with corners a quarter of its border apart
BOOST_AUTO_TEST_CASE(of_the_lion_head_is_hardly_distorted)
{
  const char* directory = std::getenv("ABF_SHARED_DATA_DIR");
  if(directory == nullptr)
    return;
  Mesh mesh;
  BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(std::string(directory) + "/lionhead_disk.ply", mesh));
  const Halfedge border = longest_border(mesh);
  std::array<Vertex, 4> corners;
  double length = 0;
  const double whole = CGAL::Polygon_mesh_processing::face_border_length(border, mesh);
  int next = 0;
  for(Halfedge h : CGAL::halfedges_around_face(border, mesh)) {
    if(next < 4 && length >= next * whole / 4)
      corners[next++] = mesh.source(h);
    length += CGAL::Polygon_mesh_processing::edge_length(h, mesh);
  }
  const Angles angles = SMP::rectangle_angles(mesh, corners);
  SMP::split_flat_chords(mesh, border, angles);
  Options options;
  options.tolerance = 1e-9;
  const Prescribed map(mesh, angles, options);
  check_angles(map, angles);
  check_rectangle(map, corners);
  BOOST_TEST(map.report.iterations <= 6);
  BOOST_TEST(SMP::measure_flattening(map.mesh, map.border, map.uv).angular_distortion < 0.0057);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(feasible_angles)

// The angles of one map of a triangulation, prescribed for the surface of another one
BOOST_AUTO_TEST_CASE(are_found)
{
  std::mt19937 random(12);
  int charts = 0, above_pi = 0;
  for(int i = 0; charts < 200; ++i) {
    const int n = uniform_int(random, 4, 12);
    const Chart flat = flat_grid(n, i), chart = grid(n, i, [&](double x, double y) {
                                          return 0.3 * std::sin(3 * x + i) * std::cos(4 * y - i);
                                        });
    const std::vector<Point_2> uv = bent(flat, uniform(random, 0.1, 4), uniform(random, 0.5, 3));
    if(has_flips(flat, uv))
      continue;
    ++charts;
    const std::vector<double> sums = border_angles(flat, uv);
    for(int c : flat.borders.front())
      above_pi += sums[flat.edge_source(c)] > CGAL_PI;
    const Angles angles = angles_of(chart, sums);
    BOOST_TEST_CONTEXT("chart " << i)
    check_angles(Prescribed(mesh_of_chart<Mesh>(chart), angles), angles);
  }
  BOOST_TEST(above_pi > 1000);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(any_angles)

// Angles at random, which sum to those of a polygon
std::vector<double> random_sums(const Chart& chart, double amplitude, std::mt19937& random)
{
  const std::vector<int>& border = chart.borders.front();
  std::vector<double> sums = border_angles(chart, projected(chart));
  double missing = 0;
  for(std::size_t i = 0; i < border.size(); ++i) {
    const double change = uniform(random, -amplitude, amplitude);
    sums[chart.edge_source(border[i])] += change - missing;
    missing = change;
  }
  sums[chart.edge_source(border.front())] -= missing;
  return sums;
}

// The verdict on whether there is such a map is that of the solver, which is asked without the check.
BOOST_AUTO_TEST_CASE(are_feasible_or_not_as_the_solver_finds)
{
  std::mt19937 random(12);
  int feasible = 0;
  std::map<Report::Diagnosis, int> diagnoses;
  for(int i = 0; i < 400; ++i) {
    Chart chart = flat_grid(uniform_int(random, 2, 7), i);
    const std::vector<double> sums = random_sums(chart, uniform(random, 0.2, 3), random);
    chart.angle_sums.assign(chart.points.size(), (std::numeric_limits<double>::quiet_NaN)());
    for(int c : chart.borders.front())
      chart.angle_sums[chart.edge_source(c)] = sums[chart.edge_source(c)];
    const abf::Chart_defect defect = abf::Angle_sum_check(chart).run();
    abf::find_nodes(chart);
    const auto solution =
        abf::flatten_chart(chart, Options(), CGAL::SuperLU_solver_traits<>(), [](std::vector<Point_2>&) {});
    ++diagnoses[defect.diagnosis];
    feasible += !defect;
    BOOST_TEST_CONTEXT("chart " << i << " " << to_string(defect.diagnosis) << ": " << defect.message << " "
                                << solution.report.message)
    BOOST_TEST(solution.succeeded() == !defect);
  }
  for(auto [d, n] : diagnoses)
    BOOST_TEST_MESSAGE(to_string(d) << " " << n);
  BOOST_TEST(feasible > 30);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
