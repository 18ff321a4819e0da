// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prescribed angles at border vertices: rectangles, polygons, what is feasible, and what is not.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include "mesh_of_chart.h"
#include "random_charts.h"
#include "test_charts.h"
#include "test_data.h"
#include "test_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_angle_sums.h>
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
#include <numeric>
#include <optional>
#include <random>
#include <string>
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

const bool is_quick = std::getenv("ABF_TEST_QUICK") != nullptr;

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
    offending = parameterizer.report().offending_vertices;
    BOOST_TEST(code == error_code(report.status));
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

// The angles that a map has, and the largest distance of a vertex from its side, looked at in another way than the
// report does
void check_angles(const Prescribed& map, const Angles& angles)
{
  BOOST_TEST(map.report.status == SMP::Diagnosis::NOTHING_WRONG, map.report.message);
  if(map.report.status != SMP::Diagnosis::NOTHING_WRONG)
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

// The unit square, bent around a circle by an angle
std::vector<Point_2> bent(std::vector<Point_2> points, double angle, double width)
{
  for(Point_2& p : points) {
    const double radius = 1 + width * p.y(), direction = -angle * p.x();
    p = Point_2(radius * std::cos(direction), radius * std::sin(direction));
  }
  return points;
}

} // namespace

BOOST_AUTO_TEST_SUITE(rectangles)

void check_rectangle_of(Mesh mesh, const std::array<Vertex, 4>& corners, const Options& options = Options())
{
  const Angles angles = SMP::rectangle_angles(mesh, corners).angles;
  SMP::split_flat_chords(mesh, longest_border(mesh), angles);
  const Prescribed map(mesh, angles, options);
  check_angles(map, angles);
  if(map.report.status == SMP::Diagnosis::NOTHING_WRONG)
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
  const Angles angles = SMP::rectangle_angles(mesh, corners).angles;
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
  const Angles angles = SMP::rectangle_angles(mesh, corners).angles;
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

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(feasible_angles)

// The angles of one map of a triangulation, prescribed for the surface of another one
BOOST_AUTO_TEST_CASE(are_found)
{
  std::mt19937 random(12);
  int charts = 0, above_pi = 0;
  for(int i = 0; charts < (is_quick ? 40 : 200); ++i) {
    const int n = uniform_int(random, 4, 12);
    const Chart flat = flat_grid(n, i), chart = grid(n, i, [&](double x, double y) {
                                          return 0.3 * std::sin(3 * x + i) * std::cos(4 * y - i);
                                        });
    const std::vector<Point_2> uv = bent(projected(flat), uniform(random, 0.1, 4), uniform(random, 0.5, 3));
    BOOST_REQUIRE(i < 2000);
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
  BOOST_TEST(above_pi > 5 * charts);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(any_angles)

// Adds `change`, equally, to `length` border vertices in a row, and subtracts it from all others.
void bend_part(const Chart& chart, double change, int length, std::mt19937& random, std::vector<double>& sums)
{
  const std::vector<int>& border = chart.borders.front();
  const int n = static_cast<int>(border.size()), first = uniform_int(random, 0, n - 1);
  for(int i = 0; i < n; ++i)
    sums[chart.edge_source(border[(first + i) % n])] += i < length ? change / length : -change / (n - length);
}

// Random angles, which sum to those of a polygon. Some have a deep notch.
std::vector<double> random_sums(const Chart& chart, std::mt19937& random)
{
  std::vector<double> sums = border_angles(chart, projected(chart));
  const int n = static_cast<int>(chart.borders.front().size());
  for(int i = 0; i < 3; ++i)
    bend_part(chart, uniform(random, -5, 5), uniform_int(random, n / 8 + 1, n / 2), random, sums);
  if(random() % 3 == 0)
    bend_part(chart, uniform(random, 8, 16), 4, random, sums);
  return sums;
}

Chart random_grid_with_angles(int seed, std::mt19937& random)
{
  Chart chart = flat_grid(uniform_int(random, 2, 7), seed);
  while(has_flips(chart, projected(chart)))
    chart = flat_grid(uniform_int(random, 2, 7), seed += 1000);
  const std::vector<double> sums = random_sums(chart, random);
  chart.angle_sums.assign(chart.points.size(), (std::numeric_limits<double>::quiet_NaN)());
  for(int c : chart.borders.front())
    chart.angle_sums[chart.edge_source(c)] = sums[chart.edge_source(c)];
  abf::find_nodes(chart);
  return chart;
}

// The verdict on whether there is such a map is that of the solver, which is asked without the check.
BOOST_AUTO_TEST_CASE(are_feasible_or_not_as_the_solver_finds)
{
  std::mt19937 random(12);
  std::map<SMP::Diagnosis, int> verdicts;
  Options options;
  options.fallbacks = false;
  for(int i = 0; i < 400; ++i) {
    const Chart chart = random_grid_with_angles(i, random);
    const abf::Chart_defect defect = abf::Angle_sum_check(chart).run();
    ++verdicts[defect.status];
    const auto flattening =
        abf::flatten_chart(chart, options, CGAL::SuperLU_solver_traits<>(), [](std::vector<Point_2>&) {});
    BOOST_TEST_CONTEXT("chart " << i << " " << to_string(defect.status) << ": " << defect.message)
    BOOST_TEST(flattening.succeeded() == !defect);
    if(defect) {
      BOOST_TEST(!defect.message.empty());
      BOOST_TEST(!defect.vertices.empty());
    }
  }
  for(SMP::Diagnosis verdict : {SMP::Diagnosis::NOTHING_WRONG, SMP::Diagnosis::WRONG_ANGLE_SUM,
                                SMP::Diagnosis::FLAT_CHORD, SMP::Diagnosis::INFEASIBLE_ANGLE_SUMS}) {
    BOOST_TEST_MESSAGE(to_string(verdict) << ": " << verdicts[verdict]);
    BOOST_TEST(verdicts[verdict] >= 5, to_string(verdict));
  }
}

// Some vertices need more than their triangles have: the certificate of a verdict that nothing else but the flow finds
BOOST_AUTO_TEST_CASE(are_named_where_they_are_infeasible)
{
  std::mt19937 random(14);
  int conflicts = 0;
  for(int i = 0; i < 400; ++i) {
    const Chart chart = random_grid_with_angles(i, random);
    const abf::Chart_defect defect = abf::Angle_sum_check(chart).run();
    if(defect.status != SMP::Diagnosis::INFEASIBLE_ANGLE_SUMS)
      continue;
    ++conflicts;
    std::vector<int> itself(chart.points.size());
    std::iota(itself.begin(), itself.end(), 0);
    const abf::Angle_flow flow(chart, itself, chart.angle_sums);
    double sum = 0;
    std::vector<int> named;
    for(int c : chart.borders.front())
      if(flow.is_in_conflict(chart.edge_source(c)))
        named.push_back(chart.edge_source(c));
    BOOST_TEST(named == defect.vertices, boost::test_tools::per_element());
    for(int v = 0; v < chart.number_of_vertices(); ++v)
      if(flow.is_in_conflict(v))
        sum += chart.interior[v] < 0 ? chart.angle_sums[v] : 2 * CGAL_PI;
    int triangles = 0;
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      triangles += flow.is_in_conflict(chart.vertex[3 * t]) || flow.is_in_conflict(chart.vertex[3 * t + 1]) ||
                   flow.is_in_conflict(chart.vertex[3 * t + 2]);
    BOOST_TEST(triangles < chart.number_of_triangles());
    BOOST_TEST(sum > CGAL_PI * triangles - 1e-4);
  }
  BOOST_TEST(conflicts >= 10);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(wrong_angles)

struct Grid
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(6, 4));
  std::vector<Vertex> border = border_vertices(mesh, longest_border(mesh));
  Angles angles = SMP::rectangle_angles(mesh, {border[0], border[6], border[12], border[18]}).angles;

  Grid() { SMP::split_flat_chords(mesh, longest_border(mesh), angles); }

  // With one more angle
  Prescribed map(Vertex v, double angle) const
  {
    Angles others;
    for(Vertex w : border)
      others.set(w, angles[w]);
    others.set(v, angle);
    return Prescribed(mesh, others);
  }
};

BOOST_AUTO_TEST_CASE(at_single_vertices)
{
  const Grid grid;
  const auto check = [](const Prescribed& map, Vertex v) {
    BOOST_TEST(map.report.status == SMP::Diagnosis::WRONG_ANGLE_SUM);
    BOOST_TEST(!map.report.message.empty());
    BOOST_REQUIRE(map.offending.size() == 1);
    BOOST_TEST(map.offending.front() == v);
  };
  for(double angle :
      {0., -1., (std::numeric_limits<double>::quiet_NaN)(), (std::numeric_limits<double>::infinity)()})
    check(grid.map(grid.border[3], angle), grid.border[3]);
  for(Vertex v : grid.mesh.vertices())
    if(!grid.mesh.is_border(v)) {
      check(grid.map(v, 6), v); // cones are not there yet
      break;
    }
  // As much as all triangles have, made up for by the others
  const Vertex v = grid.border[4];
  const double angle = (grid.mesh.degree(v) - 1) * CGAL_PI;
  Angles angles;
  for(Vertex w : grid.border)
    angles.set(w, CGAL_PI - (2 * CGAL_PI + angle - CGAL_PI) / static_cast<double>(grid.border.size() - 1));
  angles.set(v, angle);
  check(Prescribed(grid.mesh, angles), v);
}

BOOST_AUTO_TEST_CASE(at_holes)
{
  const Chart chart = annulus(12);
  const Mesh mesh = mesh_of_chart<Mesh>(chart);
  Angles angles;
  Options options;
  options.holes = Options::SOLVE;
  for(Vertex v : mesh.vertices())
    angles.set(v, 2.5);
  const Prescribed map(mesh, angles, options);
  BOOST_TEST(map.report.status == SMP::Diagnosis::WRONG_ANGLE_SUM);
  BOOST_TEST(map.offending.size() == 12);
}

BOOST_AUTO_TEST_CASE(in_total)
{
  const Grid grid;
  for(double change : {-0.5, -1e-5, 1e-5, 0.5}) {
    const Prescribed map = grid.map(grid.border[6], CGAL_PI / 2 + change);
    BOOST_TEST(map.report.status == SMP::Diagnosis::WRONG_ANGLE_TOTAL);
    BOOST_TEST(map.report.message.find("22 pi") != std::string::npos, map.report.message);
  }
  Angles rounded = grid.angles; // to digits as in a file
  for(Vertex v : grid.border)
    rounded.set(v, std::round(1e8 * *rounded[v]) / 1e8);
  BOOST_TEST(Prescribed(grid.mesh, rounded).report.status == SMP::Diagnosis::NOTHING_WRONG);

  Angles angles; // all but one, which would need a negative angle
  for(Vertex v : grid.border)
    angles.set(v, CGAL_PI);
  angles.set(grid.border[5], std::nullopt);
  const Prescribed map(grid.mesh, angles);
  BOOST_TEST(map.report.status == SMP::Diagnosis::WRONG_ANGLE_TOTAL);
  BOOST_REQUIRE(map.offending.size() == 1);
  BOOST_TEST(map.offending.front() == grid.border[5]);
}

// A triangle with two border edges on a straight side
BOOST_AUTO_TEST_CASE(beside_an_edge_between_border_vertices)
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(6, 4));
  const Halfedge border = longest_border(mesh);
  const std::vector<Vertex> vertices = border_vertices(mesh, border);
  std::size_t ear = 0;
  while(mesh.degree(vertices[ear]) > 2)
    ++ear;
  const auto vertex = [&](std::size_t i) { return vertices[(ear + i) % vertices.size()]; };
  const Angles angles = SMP::rectangle_angles(mesh, {vertex(3), vertex(9), vertex(15), vertex(21)}).angles;
  const Prescribed map(mesh, angles);
  BOOST_TEST(map.report.status == SMP::Diagnosis::FLAT_CHORD);
  const std::size_t chords = map.offending.size() / 2;
  BOOST_REQUIRE(chords >= 1);
  bool is_named = false;
  for(std::size_t i = 0; i < chords; ++i) {
    const Vertex v = map.offending[2 * i], w = map.offending[2 * i + 1];
    BOOST_TEST(mesh.halfedge(v, w).is_valid());
    BOOST_TEST((mesh.is_border(v) && mesh.is_border(w)));
    is_named = is_named || std::minmax(v, w) == std::minmax(vertex(1), vertex(vertices.size() - 1));
  }
  BOOST_TEST(is_named);

  const double area = CGAL::Polygon_mesh_processing::area(mesh);
  const auto old_faces = mesh.number_of_faces();
  const auto added = SMP::split_flat_chords(mesh, border, angles);
  BOOST_TEST(bool(added));
  BOOST_TEST(added.edges.size() == chords);
  BOOST_TEST(mesh.number_of_faces() == old_faces + 2 * chords);
  BOOST_TEST(CGAL::is_triangle_mesh(mesh));
  BOOST_TEST(mesh.is_valid());
  BOOST_TEST(CGAL::Polygon_mesh_processing::area(mesh) == area, boost::test_tools::tolerance(1e-12));
  const auto again = SMP::split_flat_chords(mesh, border, angles);
  BOOST_TEST(bool(again));
  BOOST_TEST(again.edges.empty());
  check_angles(Prescribed(mesh, angles), angles);
}

BOOST_AUTO_TEST_CASE(of_polygons)
{
  const Mesh mesh = mesh_of_chart<Mesh>(annulus(12));
  const std::vector<Vertex> border = border_vertices(mesh, longest_border(mesh));
  Vertex other;
  for(Vertex v : mesh.vertices())
    if(std::find(border.begin(), border.end(), v) == border.end())
      other = v;
  const Mesh disk = mesh_of_chart<Mesh>(bump(4, 1));
  Vertex inner;
  for(Vertex v : disk.vertices())
    if(!disk.is_border(v))
      inner = v;
  const auto check = [](const SMP::Polygon_report<Mesh>& report, SMP::Diagnosis status,
                        const std::vector<Vertex>& corners, const std::string& message) {
    BOOST_TEST(report.status == status);
    BOOST_TEST((report.offending_vertices == corners));
    BOOST_TEST((report.message.find(message) != std::string::npos), report.message);
    if(!corners.empty())
      BOOST_TEST((report.message.find("vertex " + std::to_string(corners[0].idx()) + " ") == 0));
  };
  using SMP::Diagnosis;
  check(SMP::polygon_angles(mesh, {}), Diagnosis::WRONG_OPTION, {}, "needs corners");
  check(SMP::polygon_angles(mesh, {{border[0], 1.}, {border[1], 1.}, {border[0], 1.}}),
        Diagnosis::WRONG_OPTION, {border[0]}, "twice");
  check(SMP::polygon_angles(mesh, {{border[0], 1.}, {other, 1.}}), Diagnosis::NOT_ON_BORDER, {other},
        "border of the first corner");
  check(SMP::polygon_angles(disk, {{inner, 1.}}), Diagnosis::NOT_ON_BORDER, {inner}, "not on a border");
}

BOOST_AUTO_TEST_CASE(chords_of_bad_input)
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(4, 1));
  const auto border = longest_border(mesh);
  Angles angles;
  angles.set(target(border, mesh), -1.);
  const auto old_faces = mesh.number_of_faces();
  const auto negative = SMP::split_flat_chords(mesh, border, angles);
  BOOST_TEST(negative.status == SMP::Diagnosis::WRONG_ANGLE_SUM);
  BOOST_TEST((negative.offending_vertices == std::vector<Vertex>{target(border, mesh)}));
  BOOST_TEST(SMP::split_flat_chords(mesh, opposite(border, mesh), angles).status ==
             SMP::Diagnosis::NOT_ON_BORDER);
  BOOST_TEST(mesh.number_of_faces() == old_faces);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(meshes)

BOOST_AUTO_TEST_CASE(without_angles_the_map_is_that_without)
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(10, 4));
  const auto uv = mesh.add_property_map<Vertex, Point_2>("v:plain").first;
  Parameterizer parameterizer;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, longest_border(mesh), uv) == SMP::OK);
  const Prescribed map(mesh, Angles());
  BOOST_TEST(map.report.prescribed_angles == 0);
  for(Vertex v : mesh.vertices())
    BOOST_TEST(map.uv[v] == uv[v]);
}

// A square of another mesh type, with numbers of its own for vertices
template <typename TriangleMesh>
void check_square(TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  std::vector<vertex_descriptor> vertices;
  for(auto h : CGAL::halfedges_around_face(border, mesh))
    vertices.push_back(target(h, mesh));
  std::array<vertex_descriptor, 4> corners;
  for(std::size_t i = 0, next = 0; i < vertices.size() && next < 4; ++i)
    if(CGAL::halfedges_around_target(vertices[i], mesh).size() > 2 && i >= next * (vertices.size() / 4))
      corners[next++] = vertices[i];
  std::map<vertex_descriptor, Point_2> uv;
  SMP::ABF_plus_plus_parameterizer_3<TriangleMesh> parameterizer;
  // With the sides free, there is nothing to split.
  SMP::Vertex_angles<TriangleMesh> angles;
  const auto polygon = SMP::rectangle_angles(mesh, corners).angles;
  for(const vertex_descriptor& v : corners)
    angles.set(v, get(polygon, v));
  parameterizer.set_angle_sums(angles);
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, border,
                               boost::associative_property_map<std::map<vertex_descriptor, Point_2>>(uv)) ==
             SMP::OK);
  BOOST_TEST(parameterizer.report().prescribed_angles == 4);
  BOOST_TEST(parameterizer.report().largest_angle_error < 1e-10);
}

BOOST_AUTO_TEST_CASE(of_other_meshes)
{
  typedef CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel> Polyhedron;
  Polyhedron polyhedron = test_meshes::bump<Polyhedron>(8);
  check_square(polyhedron, test_meshes::border(polyhedron));
}

BOOST_AUTO_TEST_CASE(of_a_seam_mesh)
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(8, 4));
  auto is_seam_edge = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  auto is_seam_vertex = mesh.add_property_map<Vertex, bool>("v:seam", false).first;
  typedef CGAL::Seam_mesh<Mesh, decltype(is_seam_edge), decltype(is_seam_vertex)> Seam_mesh;
  Seam_mesh seam_mesh(mesh, is_seam_edge, is_seam_vertex);
  const Halfedge border = longest_border(mesh);
  Halfedge cut; // from the border inwards
  for(Halfedge h : CGAL::halfedges_around_face(border, mesh))
    for(Halfedge g : CGAL::halfedges_around_target(h, mesh))
      if(!mesh.is_border(mesh.source(g)))
        cut = g;
  for(int i = 0; i < 2; ++i) {
    seam_mesh.add_seam(mesh.source(cut), mesh.target(cut));
    for(Halfedge g : CGAL::halfedges_around_target(mesh.opposite(cut), mesh))
      if(!mesh.is_border(mesh.source(g)) && mesh.source(g) != mesh.target(cut)) {
        cut = g;
        break;
      }
  }
  check_square(seam_mesh, typename Seam_mesh::halfedge_descriptor(border));
}

// Where the prescribed border overlaps itself, so does the map.
BOOST_AUTO_TEST_CASE(overlaps_are_an_error_of_injective_maps)
{
  const int n = 30;
  const Chart flat = flat_grid(n, 3);
  std::vector<Point_2> uv;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      uv.emplace_back(1. * i / n, 1. * j / n);
  uv = bent(uv, 7, 3);
  BOOST_REQUIRE(!has_flips(flat, uv));
  const Angles angles = angles_of(flat, border_angles(flat, uv));
  const Mesh mesh = mesh_of_chart<Mesh>(flat);
  Options options;
  const Prescribed map(mesh, angles, options);
  check_angles(map, angles);
  BOOST_TEST(!map.report.border_is_simple);
  options.injective = true;
  const Prescribed injective(mesh, angles, options);
  BOOST_TEST(injective.report.status == SMP::Diagnosis::OVERLAPPING);
  BOOST_TEST(!injective.report.injective);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(of_reference_disks, *test_data::needs(test_data::reference_disks))

using rectangles::check_rectangle_of;

struct Disk
{
  const char* file;
  int triangles;
};

BOOST_AUTO_TEST_CASE(become_rectangles)
{
  const int most = is_quick ? 6000 : 1000000;
  std::mt19937 random(9);
  for(const Disk& disk :
      {Disk{"cow", 5804}, Disk{"dino", 7828}, Disk{"lionhead", 16674}, Disk{"camel", 19536},
       Disk{"armadillo", 52000}, Disk{"bunny", 75408}, Disk{"horse", 96966}})
    if(disk.triangles <= most) {
      Mesh mesh;
      BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(
          test_data::reference_disks / (disk.file + std::string("_disk.ply")), mesh));
      for(int i = 0; i < (disk.triangles < 20000 ? 5 : 1); ++i)
        BOOST_TEST_CONTEXT(disk.file << " " << i)
      check_rectangle_of(mesh, random_corners(border_vertices(mesh, longest_border(mesh)), random));
    }
}

// A face with corners a quarter of its border apart
BOOST_AUTO_TEST_CASE(the_lion_head_is_hardly_distorted)
{
  Mesh mesh;
  BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::reference_disks / "lionhead_disk.ply", mesh));
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
  const Angles angles = SMP::rectangle_angles(mesh, corners).angles;
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

BOOST_AUTO_TEST_SUITE_END()
