// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Corners of a rectangle with a given ratio of its sides: how well ratios are predicted, how well maps meet them, and
// what is not possible.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include "mesh_of_chart.h"
#include "test_charts.h"
#include "test_data.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/rectangle_corners.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/rectangle_ratio.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_rectangle_corners)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef SMP::Rectangle_report<Mesh> Report;

namespace {

const bool is_quick = std::getenv("ABF_TEST_QUICK") != nullptr;

Halfedge longest_border(const Mesh& mesh)
{
  return CGAL::Polygon_mesh_processing::longest_border(mesh).first;
}

Halfedge border_to(const Mesh& mesh, Vertex v)
{
  for(Halfedge h : CGAL::halfedges_around_face(longest_border(mesh), mesh))
    if(mesh.target(h) == v)
      return h;
  return Halfedge();
}

Vertex vertex_at(const Mesh& mesh, const Point_3& p)
{
  for(Vertex v : mesh.vertices())
    if(mesh.point(v) == p)
      return v;
  return Vertex();
}

// The rectangle from (0, 0) to (2, 1) with squares of side 1 / n, bent to a prism if that is asked for
Chart two_squares(int n, double curvature = 0)
{
  std::vector<Point_3> points;
  Triangles triangles;
  for(int i = 0; i <= 2 * n; ++i)
    for(int j = 0; j <= n; ++j) {
      const double x = 1. * i / n, turn = curvature * x;
      points.emplace_back(curvature > 0 ? std::sin(turn) / curvature : x, 1. * j / n,
                          curvature > 0 ? (1 - std::cos(turn)) / curvature : 0);
      if(i < 2 * n && j < n) {
        const int a = i * (n + 1) + j, b = a + n + 1;
        triangles.push_back({a, b, b + 1});
        triangles.push_back({a, b + 1, a + 1});
      }
    }
  return make_chart(points, triangles);
}

double relative_error(double ratio, double wanted)
{
  return std::abs(ratio / wanted - 1);
}

// Maps to the rectangle, and returns the ratio of its sides.
double ratio_of_map(Mesh mesh, const Report& rectangle)
{
  const Halfedge border = longest_border(mesh);
  SMP::split_flat_chords(mesh, border, rectangle.angles);
  SMP::ABF_plus_plus_options options;
  options.holes = SMP::Flattening_options::SOLVE;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  parameterizer.set_angle_sums(rectangle.angles);
  const auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  SMP::parameterize(mesh, parameterizer, border, uv);
  BOOST_TEST(bool(parameterizer.report()), parameterizer.report().message);
  BOOST_TEST(parameterizer.report().side_deviation < 1e-12);
  const auto side = [&](int i) { return uv[rectangle.corners[(i + 1) % 4]] - uv[rectangle.corners[i]]; };
  BOOST_TEST(CGAL::determinant(side(0), side(1)) > 0); // counterclockwise
  return std::sqrt(side(0).squared_length() / side(1).squared_length());
}

void check_ratio(const Mesh& mesh, double ratio, double largest_error)
{
  const Halfedge border = longest_border(mesh);
  const auto report = SMP::rectangle_angles(mesh, border, ratio);
  BOOST_TEST_REQUIRE(bool(report), report.message);
  BOOST_TEST((report.corners[0] == mesh.target(border)));
  for(Vertex v : report.corners)
    BOOST_TEST(*report.angles[v] == CGAL_PI / 2);
  const double measured = ratio_of_map(mesh, report);
  BOOST_TEST_MESSAGE("ratio " << ratio << ", predicted " << report.predicted_ratio << ", measured "
                              << measured);
  BOOST_TEST(relative_error(report.predicted_ratio, ratio) < largest_error);
  BOOST_TEST(relative_error(measured, ratio) < largest_error);
}

} // namespace

// Linear functions are harmonic on any triangulation, and a prism is as good as a plane.
BOOST_AUTO_TEST_CASE(of_a_rectangle_are_its_own)
{
  for(double curvature : {0., 1.})
    for(int n : {1, 2, 5, 16}) {
      const Chart chart = two_squares(n, curvature);
      const Mesh mesh = mesh_of_chart<Mesh>(chart);
      const auto corner = [&](int i, int j) { return vertex_at(mesh, chart.points[i * (n + 1) + j]); };
      const std::array<Vertex, 4> corners = {corner(0, 0), corner(2 * n, 0), corner(2 * n, n), corner(0, n)};
      for(int i = 0; i < 4; ++i) {
        const double width = curvature > 0 ? 4 * n * std::sin(curvature / 2 / n) / curvature : 2,
                     ratio = i % 2 == 0 ? width : 1 / width;
        const auto report = SMP::rectangle_angles(mesh, border_to(mesh, corners[i]), ratio);
        BOOST_TEST_REQUIRE(bool(report), report.message);
        for(int k = 0; k < 4; ++k)
          BOOST_TEST((report.corners[k] == corners[(i + k) % 4]));
        BOOST_TEST(report.predicted_ratio == ratio, boost::test_tools::tolerance(1e-9));
      }
    }
}

// As few vertices as possible: one rectangle, and no system of equations
BOOST_AUTO_TEST_CASE(of_two_triangles)
{
  const Mesh mesh = mesh_of_chart<Mesh>(make_chart(
      {Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(3, 1, 0), Point_3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}));
  const auto report = SMP::rectangle_angles(mesh, border_to(mesh, Vertex(0)), 3);
  BOOST_TEST_REQUIRE(bool(report), report.message);
  BOOST_TEST(report.predicted_ratio == 3, boost::test_tools::tolerance(1e-12));
  const auto other = SMP::rectangle_angles(mesh, border_to(mesh, Vertex(0)), 2);
  BOOST_TEST(other.status == SMP::Diagnosis::WRONG_OPTION);
}

// The bisection needs that, and finds what a look at all rectangles finds.
BOOST_AUTO_TEST_CASE(make_rectangles_wider_one_by_one)
{
  for(int seed = 0; seed < 10; ++seed) {
    const Chart chart = bump(6 + seed, seed, 0.1 * seed);
    const CGAL::SuperLU_solver_traits<> traits;
    const abf::Rectangle_family family(chart);
    BOOST_TEST(family.size() == static_cast<int>(chart.borders.front().size()) - 3);
    const abf::Rectangle_ratio ratio(chart, traits);
    std::vector<double> ratios;
    for(int i = 0; i < family.size(); ++i)
      ratios.push_back(*ratio(family[i]));
    for(std::size_t i = 1; i < ratios.size(); ++i)
      BOOST_TEST(ratios[i - 1] < ratios[i]);
    const auto deviation = [](double r, double other) { return std::abs(std::log(r / other)); };
    for(double wanted : {0.45, 0.7, 1., 1.5, 2.2}) {
      double nearest = (std::numeric_limits<double>::infinity)();
      for(double r : ratios)
        nearest = (std::min)(nearest, deviation(r, wanted));
      const abf::Rectangle_corners chosen = abf::choose_rectangle_corners(chart, wanted, traits);
      BOOST_TEST_REQUIRE(!chosen.defect, chosen.defect.message);
      BOOST_TEST(deviation(chosen.aspect_ratio, wanted) <= nearest);
    }
  }
}

// Of 180 maps of such bumps, none was farther from its ratio than 13 %, and none with 64 border edges than 6 %.
BOOST_AUTO_TEST_CASE(of_bumps_meet_a_ratio)
{
  for(int i = 0; i < (is_quick ? 15 : 60); ++i) {
    const int n = 6 + i % 15;
    BOOST_TEST_CONTEXT("bump " << i)
    for(double ratio : {1., 2., 0.5})
      check_ratio(mesh_of_chart<Mesh>(bump(n, i, 0.2 + 0.02 * (i % 30))), ratio, n < 16 ? 0.13 : 0.06);
  }
}

// The ratio is that of a map, but holes leave it some freedom.
BOOST_AUTO_TEST_CASE(of_bumps_with_holes_meet_a_ratio)
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(16, 3, 0.6));
  for(int v : {60, 61, 200}) // inner vertices
    CGAL::Euler::remove_center_vertex(mesh.halfedge(Vertex(v)), mesh);
  for(auto f : mesh.faces())
    if(mesh.degree(f) > 3)
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  for(double ratio : {1., 2., 0.5})
    check_ratio(mesh, ratio, 0.06);
}

BOOST_AUTO_TEST_CASE(can_be_chosen_with_other_points_and_another_solver)
{
  typedef CGAL::Eigen_solver_traits<
      Eigen::SimplicialLDLT<typename CGAL::Eigen_sparse_matrix<double>::EigenType>>
      Solver;
  const Mesh mesh = mesh_of_chart<Mesh>(bump(12, 4));
  const Halfedge border = longest_border(mesh);
  Mesh stretched = mesh;
  const auto points = stretched.add_property_map<Vertex, Point_3>("v:other").first;
  for(Vertex v : mesh.vertices()) {
    points[v] = mesh.point(v);
    stretched.point(v) = Point_3(3 * mesh.point(v).x(), mesh.point(v).y(), 0);
  }
  const auto report = SMP::rectangle_angles(mesh, border, 1.5);
  BOOST_TEST_REQUIRE(bool(report));
  const auto other = SMP::rectangle_angles(
      stretched, border, 1.5, CGAL::parameters::vertex_point_map(points).sparse_linear_solver(Solver()));
  BOOST_TEST_REQUIRE(bool(other));
  BOOST_TEST((other.corners == report.corners));
  BOOST_TEST(other.predicted_ratio == report.predicted_ratio, boost::test_tools::tolerance(1e-9));
  BOOST_TEST((SMP::rectangle_angles(stretched, border, 1.5).corners != report.corners));
}

// Where the border is a point, vertices count instead of lengths.
BOOST_AUTO_TEST_CASE(of_a_border_without_length)
{
  Mesh mesh = mesh_of_chart<Mesh>(bump(8, 4));
  const Halfedge border = longest_border(mesh);
  for(Vertex v : CGAL::vertices_around_face(border, mesh))
    mesh.point(v) = Point_3(0.5, 0.5, -1);
  const auto report = SMP::rectangle_angles(mesh, border, 1);
  BOOST_TEST_REQUIRE(bool(report), report.message);
  BOOST_TEST(relative_error(report.predicted_ratio, 1) < 0.13);
}

namespace {

struct Failing_traits : CGAL::SuperLU_solver_traits<>
{
  bool factor(const Matrix&, NT&) { return false; }
};

void check_failure(const Report& report, SMP::Diagnosis status, const std::vector<Vertex>& vertices)
{
  BOOST_TEST(report.status == status, report.message);
  BOOST_TEST(!report.message.empty());
  BOOST_TEST((report.offending_vertices == vertices));
  BOOST_TEST(report.predicted_ratio == 0);
}

} // namespace

BOOST_AUTO_TEST_CASE(of_bad_input)
{
  typedef std::numeric_limits<double> Limits;
  using SMP::Diagnosis;
  const Mesh mesh = mesh_of_chart<Mesh>(bump(6, 4));
  const Halfedge border = longest_border(mesh);
  for(double ratio : {0., -1., (Limits::infinity)(), (Limits::quiet_NaN)()})
    check_failure(SMP::rectangle_angles(mesh, border, ratio), Diagnosis::WRONG_OPTION, {});
  for(double ratio : {1e3, 1e-3, (Limits::max)(), (Limits::denorm_min)()})
    check_failure(SMP::rectangle_angles(mesh, border, ratio), Diagnosis::WRONG_OPTION, {mesh.target(border)});
  check_failure(SMP::rectangle_angles(mesh, mesh.opposite(border), 1), Diagnosis::NOT_ON_BORDER, {});
  check_failure(SMP::rectangle_angles(mesh, Mesh::null_halfedge(), 1), Diagnosis::NOT_ON_BORDER, {});
  check_failure(
      SMP::rectangle_angles(mesh, border, 1, CGAL::parameters::sparse_linear_solver(Failing_traits())),
      Diagnosis::LINEAR_SYSTEM_FAILED, {});
  const Mesh torus = mesh_of_chart<Mesh>(torus_with_hole(6));
  BOOST_TEST(SMP::rectangle_angles(torus, longest_border(torus), 1).status == Diagnosis::NONZERO_GENUS);

  const Mesh tent = mesh_of_chart<Mesh>(pyramid(3, 1));
  Report report = SMP::rectangle_angles(tent, longest_border(tent), 1);
  std::sort(report.offending_vertices.begin(), report.offending_vertices.end());
  check_failure(report, Diagnosis::SHORT_BORDER, {Vertex(1), Vertex(2), Vertex(3)});
}

BOOST_AUTO_TEST_SUITE(of_reference_disks, *test_data::needs(test_data::reference_disks))

// The largest error is where a corner can be at a vertex, or at the next one, far from it in the plane.
BOOST_AUTO_TEST_CASE(meet_a_ratio)
{
  std::vector<std::string> disks = {"cow", "dino", "lionhead", "camel"};
  if(is_quick)
    disks.resize(1);
  for(const std::string& disk : disks) {
    Mesh mesh;
    BOOST_REQUIRE(
        CGAL::IO::read_polygon_mesh(test_data::reference_disks / (disk + std::string("_disk.ply")), mesh));
    BOOST_TEST_CONTEXT(disk)
    for(double ratio : {1., 2., 0.5})
      check_ratio(mesh, ratio, 0.065);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
