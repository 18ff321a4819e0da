// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Corners of a rectangle with a given ratio of its sides: how well ratios are predicted, how well maps meet them, how the
// rest is removed, and what is not possible.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include "mesh_of_chart.h"
#include "test_charts.h"
#include "test_data.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/fit_rectangle.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
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

// Maps to the rectangle, and returns the ratio of its sides. Then gives it the ratio `fitted` exactly.
double ratio_of_map(Mesh mesh, const Report& rectangle, double fitted)
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
  const double ratio = std::sqrt(side(0).squared_length() / side(1).squared_length()),
               area = CGAL::determinant(side(0), side(1));

  const auto report = SMP::fit_rectangle(mesh, uv, rectangle.corners, fitted);
  BOOST_TEST_REQUIRE(bool(report), report.message);
  BOOST_TEST(report.ratio == ratio, boost::test_tools::tolerance(1e-9));
  const double bound = 2 * std::asin(std::abs(fitted / ratio - 1) / (fitted / ratio + 1));
  BOOST_TEST(report.largest_angle_change <= bound + 1e-4); // rounding turns very short edges
  BOOST_TEST(report.largest_angle_change >= 0.5 * bound - 1e-4);
  BOOST_TEST(report.mean_angle_change <= report.largest_angle_change);
  const Point_2 far_corner = uv[rectangle.corners[2]];
  BOOST_TEST(far_corner.x() / far_corner.y() == fitted, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(far_corner.x() * far_corner.y() == area, boost::test_tools::tolerance(1e-9));
  BOOST_TEST((uv[rectangle.corners[0]] == Point_2(0, 0)));
  BOOST_TEST((uv[rectangle.corners[1]] == Point_2(far_corner.x(), 0)));
  BOOST_TEST((uv[rectangle.corners[3]] == Point_2(0, far_corner.y())));
  for(Halfedge h : CGAL::halfedges_around_face(border, mesh)) {
    const Point_2 p = uv[mesh.target(h)];
    BOOST_TEST((p.x() == 0 || p.y() == 0 || p.x() == far_corner.x() || p.y() == far_corner.y()));
  }
  BOOST_TEST(SMP::is_locally_injective(mesh, uv));
  return ratio;
}

void check_ratio(const Mesh& mesh, double ratio, double largest_error)
{
  const auto report = SMP::rectangle_angles(mesh, longest_border(mesh), ratio);
  BOOST_TEST_REQUIRE(bool(report), report.message);
  for(Vertex v : report.corners)
    BOOST_TEST(*report.angles[v] == CGAL_PI / 2);
  const double measured = ratio_of_map(mesh, report, ratio);
  BOOST_TEST_MESSAGE("ratio " << ratio << ", predicted " << report.predicted_ratio << ", measured "
                              << measured);
  BOOST_TEST(relative_error(report.predicted_ratio, ratio) < largest_error);
  BOOST_TEST(relative_error(measured, ratio) < largest_error);
}

} // namespace

// Linear functions are harmonic on any triangulation, and a prism is as good as a plane. The first corner is the first
// one from the given halfedge.
BOOST_AUTO_TEST_CASE(of_a_rectangle_are_its_own)
{
  for(double curvature : {0., 1.})
    for(int n : {12, 16}) {
      const Chart chart = two_squares(n, curvature);
      const Mesh mesh = mesh_of_chart<Mesh>(chart);
      const auto corner = [&](int i, int j) { return vertex_at(mesh, chart.points[i * (n + 1) + j]); };
      const std::array<Vertex, 4> corners = {corner(0, 0), corner(2 * n, 0), corner(2 * n, n), corner(0, n)};
      for(int i = 0; i < 4; ++i) {
        const double width = curvature > 0 ? 4 * n * std::sin(curvature / 2 / n) / curvature : 2,
                     ratio = i % 2 == 0 ? width : 1 / width;
        const auto report = SMP::rectangle_angles(mesh, border_to(mesh, corners[i]), ratio);
        BOOST_TEST_CONTEXT("n " << n << ", corner " << i << ", curvature " << curvature)
        {
          BOOST_TEST_REQUIRE(bool(report), report.message);
          for(int k = 0; k < 4; ++k)
            BOOST_TEST((report.corners[k] == corners[(i + k) % 4]));
          BOOST_TEST(report.predicted_ratio == ratio, boost::test_tools::tolerance(1e-9));
        }
      }
    }
}

// As few vertices as possible: one rectangle
BOOST_AUTO_TEST_CASE(of_two_triangles)
{
  const Mesh mesh = mesh_of_chart<Mesh>(make_chart(
      {Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(3, 1, 0), Point_3(0, 1, 0)}, {{0, 1, 2}, {0, 2, 3}}));
  const auto report = SMP::rectangle_angles(mesh, border_to(mesh, Vertex(0)), 3);
  BOOST_TEST_REQUIRE(bool(report), report.message);
  BOOST_TEST((report.corners == std::array<Vertex, 4>{Vertex(0), Vertex(1), Vertex(2), Vertex(3)}));
  const auto other = SMP::rectangle_angles(mesh, border_to(mesh, Vertex(0)), 30);
  BOOST_TEST(other.status == SMP::Diagnosis::WRONG_OPTION);
}

// Of 180 maps of such bumps, none was farther from its ratio than 10 %, and none with 64 border edges than 4 %.
BOOST_AUTO_TEST_CASE(of_bumps_meet_a_ratio)
{
  for(int i = 0; i < (is_quick ? 15 : 60); ++i) {
    const int n = 6 + i % 15;
    BOOST_TEST_CONTEXT("bump " << i)
    for(double ratio : {1., 2., 0.5})
      check_ratio(mesh_of_chart<Mesh>(bump(n, i, 0.2 + 0.02 * (i % 30))), ratio, n < 16 ? 0.1 : 0.04);
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
    check_failure(SMP::rectangle_angles(mesh, border, ratio), Diagnosis::WRONG_OPTION, {});
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

namespace {

// Also of NaN
const auto same = [](const auto& p, const auto& q) { return std::memcmp(&p, &q, sizeof(p)) == 0; };

} // namespace

// Numbers of 32 bits hold two small triangles beside the origin, and not beside the opposite corner.
BOOST_AUTO_TEST_CASE(are_fitted_to_the_number_type)
{
  typedef CGAL::Simple_cartesian<float>::Point_2 Float_point;
  Mesh mesh = mesh_of_chart<Mesh>(two_squares(4));
  const auto uv = mesh.add_property_map<Vertex, Float_point>("v:float").first;
  for(Vertex v : mesh.vertices())
    uv[v] = Float_point(static_cast<float>(mesh.point(v).x()), static_cast<float>(mesh.point(v).y()));
  const auto at = [&](double x, double y) { return vertex_at(mesh, Point_3(x, y, 0)); };
  uv[at(0.25, 0.25)] = Float_point(1e-9F, 1e-9F);
  const std::array<Vertex, 4> corners = {at(0, 0), at(2, 0), at(2, 1), at(0, 1)};
  BOOST_TEST(bool(SMP::fit_rectangle(mesh, uv, corners, 3)));
  const std::vector<Float_point> before(uv.begin(), uv.end());
  const auto report = SMP::fit_rectangle(mesh, uv, {corners[2], corners[3], corners[0], corners[1]}, 2);
  BOOST_TEST(report.status == SMP::Diagnosis::PRECISION_EXCEEDED, report.message);
  BOOST_TEST(report.offending_faces.size() == 2);
  BOOST_TEST(std::equal(uv.begin(), uv.end(), before.begin(), same));
}

// Nothing is written where something is wrong.
BOOST_AUTO_TEST_CASE(that_cannot_be_fitted)
{
  using SMP::Diagnosis;
  Mesh mesh = mesh_of_chart<Mesh>(two_squares(4));
  const auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  for(Vertex v : mesh.vertices())
    uv[v] = Point_2(mesh.point(v).x(), mesh.point(v).y());
  const auto at = [&](double x, double y) { return vertex_at(mesh, Point_3(x, y, 0)); };
  const std::array<Vertex, 4> corners = {at(0, 0), at(2, 0), at(2, 1), at(0, 1)};
  const auto check = [&](const std::array<Vertex, 4>& given, double ratio, Diagnosis status,
                         std::size_t vertices, std::size_t faces) {
    const std::vector<Point_2> before(uv.begin(), uv.end());
    const auto report = SMP::fit_rectangle(mesh, uv, given, ratio);
    BOOST_TEST(report.status == status, report.message);
    BOOST_TEST(!report.message.empty());
    BOOST_TEST(report.offending_vertices.size() == vertices);
    BOOST_TEST(report.offending_faces.size() == faces);
    BOOST_TEST(std::equal(uv.begin(), uv.end(), before.begin(), same));
  };
  for(double ratio : {0., -1., (std::numeric_limits<double>::infinity)(), std::nan("")})
    check(corners, ratio, Diagnosis::WRONG_OPTION, 0, 0);
  check({corners[0], corners[2], corners[1], corners[3]}, 2, Diagnosis::WRONG_OPTION, 1, 0);
  check({corners[0], corners[1], corners[2], at(0.5, 1)}, 2, Diagnosis::WRONG_OPTION, 1, 0);
  check({corners[0], corners[1], corners[1], corners[3]}, 2, Diagnosis::WRONG_OPTION, 1, 0);
  check({corners[0], at(1, 0.5), corners[2], corners[3]}, 2, Diagnosis::NOT_ON_BORDER, 1, 0);
  check({at(1, 0.5), corners[1], corners[2], corners[3]}, 2, Diagnosis::NOT_ON_BORDER, 0, 0);
  uv[at(1, 0.5)] = Point_2(1, 0.2);
  check(corners, 2, Diagnosis::FLIPPED_TRIANGLES, 0, 2);
  uv[at(1, 0.5)] = Point_2(std::nan(""), 0.5);
  check(corners, 2, Diagnosis::FLIPPED_TRIANGLES, 0, 6);
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

// The border of this head has 36 edges, and any four vertices of it are far from the corners of some rectangles.
BOOST_AUTO_TEST_CASE(meet_a_ratio_on_a_coarse_border)
{
  Mesh mesh;
  BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::CGAL_meshes / "lion-head.off", mesh));
  BOOST_TEST(CGAL::halfedges_around_face(longest_border(mesh), mesh).size() == 36);
  for(double ratio : {1., 2., 0.5})
    check_ratio(mesh, ratio, 0.025);
}

BOOST_AUTO_TEST_SUITE_END()

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
      check_ratio(mesh, ratio, 0.025);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
