// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Mirror planes of surfaces, and seams that are symmetric there.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"

#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/symmetrize_seams.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_symmetric_seams)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using seam_surfaces::Point_3;
using seam_surfaces::Vector_3;
typedef seam_surfaces::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Property_map<Edge, bool> Marks;

namespace {

Vector_3 random_direction(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return Vector_3(x, y, z) / std::sqrt(x * x + y * y + z * z);
}

Vector_3 mirrored(const Vector_3& v, const Vector_3& normal)
{
  return v - 2 * (v * normal) * normal;
}

// A ball with horns. If it is symmetric, each has a mirror image, and the triangles still have none.
struct Horned_ball
{
  Vector_3 normal;
  double offset;
  Mesh mesh;

  Horned_ball(unsigned seed, bool is_symmetric)
  {
    std::mt19937 random(seed);
    normal = random_direction(random);
    const Vector_3 shift = 5 * random_direction(random);
    offset = normal * shift;
    std::vector<Vector_3> horns;
    for(int i = 0; i < 5; ++i) {
      horns.push_back(random_direction(random));
      if(is_symmetric)
        horns.push_back(mirrored(horns.back(), normal));
    }
    seam_surfaces::Surface surface = seam_surfaces::sphere(4);
    for(Point_3& p : surface.points) {
      const Vector_3 v = p - CGAL::ORIGIN;
      double radius = 1;
      for(const Vector_3& horn : horns)
        radius += std::exp(-6 * (v - horn).squared_length());
      p = CGAL::ORIGIN + shift + radius * v;
    }
    mesh = surface.mesh();
  }

  Marks marks() { return mesh.add_property_map<Edge, bool>("", false).first; }
};

} // namespace

BOOST_AUTO_TEST_CASE(plane_of_symmetric_surfaces)
{
  for(unsigned seed = 1; seed <= 4; ++seed) {
    const Horned_ball ball(seed, true);
    const auto plane = TA::find_mirror_plane(ball.mesh);
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    BOOST_TEST(static_cast<bool>(plane));
    BOOST_TEST(plane.deviation < 2e-3);
    const Vector_3 n(plane.normal[0], plane.normal[1], plane.normal[2]);
    BOOST_TEST(std::abs(n * ball.normal) > 1 - 1e-4);
    BOOST_TEST(std::abs(plane.offset - (n * ball.normal > 0 ? 1 : -1) * ball.offset) < 0.1);
    BOOST_TEST(n.squared_length() == 1, boost::test_tools::tolerance(1e-12));
    BOOST_TEST((std::max)({n.x(), n.y(), n.z()}) >= -(std::min)({n.x(), n.y(), n.z()}));
  }
}

BOOST_AUTO_TEST_CASE(deviation_of_other_surfaces)
{
  for(unsigned seed = 1; seed <= 4; ++seed)
    BOOST_TEST(TA::find_mirror_plane(Horned_ball(seed, false).mesh).deviation > 0.01, "seed " << seed);
}

BOOST_AUTO_TEST_CASE(seams_become_symmetric)
{
  for(unsigned seed = 1; seed <= 4; ++seed) {
    Horned_ball ball(seed, true);
    const auto plane = TA::find_mirror_plane(ball.mesh);
    for(bool is_upper_side : {false, true}) {
      const Marks seams = ball.marks();
      TA::select_seams(ball.mesh, seams);
      const auto before = TA::measure_symmetry(ball.mesh, seams, plane);
      const auto after = TA::symmetrize_seams(ball.mesh, seams, plane, is_upper_side);
      BOOST_TEST_INFO_SCOPE("seed " << seed << " " << is_upper_side);
      BOOST_TEST(static_cast<bool>(before));
      BOOST_TEST(static_cast<bool>(after));
      BOOST_TEST(before.asymmetry > 0.02);
      BOOST_TEST(after.asymmetry < 0.01);
      BOOST_TEST(after.seam_length > 0);
      const auto measured = TA::measure_symmetry(ball.mesh, seams, plane);
      BOOST_TEST(measured.asymmetry == after.asymmetry);
      BOOST_TEST(measured.seam_length == after.seam_length);
      BOOST_TEST(static_cast<bool>(TA::cut_to_disks(ball.mesh, seams)));
      BOOST_TEST(static_cast<bool>(TA::is_disk_cut(ball.mesh, seams)));
    }
  }
}

// On the side that is kept, they are where they were, but for those beside the plane.
BOOST_AUTO_TEST_CASE(kept_side)
{
  Horned_ball ball(3, true);
  const auto plane = TA::find_mirror_plane(ball.mesh);
  const Vector_3 n(plane.normal[0], plane.normal[1], plane.normal[2]);
  const auto is_far_above = [&](Edge e, double sign) {
    const auto height = [&](std::size_t i) {
      return sign * (n * (ball.mesh.point(ball.mesh.vertex(e, static_cast<unsigned>(i))) - CGAL::ORIGIN) -
                     plane.offset);
    };
    return height(0) > 0.3 && height(1) > 0.3;
  };
  for(double sign : {-1., 1.}) {
    const Marks before = ball.marks(), seams = ball.marks();
    TA::select_seams(ball.mesh, before);
    for(Edge e : ball.mesh.edges())
      seams[e] = before[e];
    TA::symmetrize_seams(ball.mesh, seams, plane, sign > 0);
    std::size_t kept = 0;
    for(Edge e : ball.mesh.edges())
      if(is_far_above(e, sign)) {
        BOOST_TEST(seams[e] == before[e]);
        kept += before[e];
      }
    BOOST_TEST(kept > 0u);
  }
}

BOOST_AUTO_TEST_CASE(constrained_edges_are_no_seams)
{
  Horned_ball ball(2, true);
  const auto plane = TA::find_mirror_plane(ball.mesh);
  const Marks seams = ball.marks(), is_constrained = ball.marks();
  std::mt19937 random(1);
  for(Edge e : ball.mesh.edges())
    is_constrained[e] = random() % 5 == 0;
  TA::select_seams(ball.mesh, seams, {}, parameters::edge_is_constrained_map(is_constrained));
  TA::symmetrize_seams(ball.mesh, seams, plane, true, parameters::edge_is_constrained_map(is_constrained));
  for(Edge e : ball.mesh.edges())
    BOOST_TEST((!seams[e] || !is_constrained[e]));
}

BOOST_AUTO_TEST_CASE(edges_on_the_plane_become_cheap)
{
  Mesh mesh = seam_surfaces::octahedron().mesh();
  TA::Mirror_plane_report plane; // x = 0
  auto weights = mesh.add_property_map<Edge, double>("", 2.).first;
  BOOST_TEST(static_cast<bool>(TA::favor_mirror_plane(mesh, plane, weights)));
  for(Edge e : mesh.edges()) {
    const bool is_on_plane = mesh.point(mesh.vertex(e, 0)).x() == 0 && mesh.point(mesh.vertex(e, 1)).x() == 0;
    BOOST_TEST(weights[e] == (is_on_plane ? 0.6 * 2 : 2));
  }
}

BOOST_AUTO_TEST_CASE(wrong_input)
{
  Horned_ball ball(1, true);
  const auto plane = TA::find_mirror_plane(ball.mesh);
  const Marks seams = ball.marks();
  TA::select_seams(ball.mesh, seams);
  const double length = TA::measure_symmetry(ball.mesh, seams, plane).seam_length;
  auto wrong = plane, none = plane;
  wrong.normal[0] += 1;
  none.normal = {0, 0, 0};
  for(const auto& p : {wrong, none}) {
    const auto report = TA::symmetrize_seams(ball.mesh, seams, p);
    BOOST_TEST(report.status == SMP::Diagnosis::WRONG_OPTION);
    BOOST_TEST((report.message.find("normal") != std::string::npos));
    BOOST_TEST(TA::measure_symmetry(ball.mesh, seams, p).status == SMP::Diagnosis::WRONG_OPTION);
  }
  BOOST_TEST(TA::measure_symmetry(ball.mesh, seams, plane).seam_length == length); // unchanged

  Mesh quadrangle;
  quadrangle.add_face(quadrangle.add_vertex(Point_3(0, 0, 0)), quadrangle.add_vertex(Point_3(1, 0, 0)),
                      quadrangle.add_vertex(Point_3(1, 1, 0)), quadrangle.add_vertex(Point_3(0, 1, 0)));
  const auto of_quadrangle = TA::find_mirror_plane(quadrangle);
  BOOST_TEST(of_quadrangle.status == SMP::Diagnosis::NOT_TRIANGULATED);
  BOOST_TEST((of_quadrangle.offending_faces == std::vector<Mesh::Face_index>{Mesh::Face_index(0)}));
  BOOST_TEST(TA::find_mirror_plane(Mesh()).status == SMP::Diagnosis::NO_AREA);
  const Mesh::Vertex_index v(7);
  ball.mesh.point(v) = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  const auto of_nan = TA::symmetrize_seams(ball.mesh, seams, plane);
  BOOST_TEST(of_nan.status == SMP::Diagnosis::NON_FINITE_POINT);
  BOOST_TEST((of_nan.offending_vertices == std::vector<Mesh::Vertex_index>{v}));
}

BOOST_AUTO_TEST_SUITE_END()
