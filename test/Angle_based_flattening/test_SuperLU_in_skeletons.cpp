// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `SuperLU_solver_traits` as the solver of CGAL's skeletonization by mean curvature flow, compared with the default solver,
// which is Eigen's. CGAL solves normal equations there.

#include <boost/test/unit_test.hpp>

#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_SuperLU_in_skeletons)

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;

// A bent ellipsoid of 1280 triangles, with the curve (4t, t^2, 0) in its middle
Surface_mesh banana()
{
  Surface_mesh mesh;
  CGAL::make_icosahedron(mesh, Point_3(0, 0, 0), 1);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  for(auto v : vertices(mesh)) {
    const Point_3 p = mesh.point(v);
    mesh.point(v) = Point_3(4 * p.x(), p.y() + p.x() * p.x(), 0.9 * p.z());
  }
  return mesh;
}

template <typename SolverTraits>
using Skeletonization =
    CGAL::Mean_curvature_flow_skeletonization<Surface_mesh, CGAL::Default, CGAL::Default, SolverTraits>;

// Contracts the surface without changes of its mesh, whose order in CGAL depends on addresses.
template <typename SolverTraits>
std::vector<Point_3> contracted_points()
{
  Skeletonization<SolverTraits> skeletonization(banana());
  for(int i = 0; i < 3; ++i)
    skeletonization.contract_geometry();
  std::vector<Point_3> points;
  for(auto v : vertices(skeletonization.meso_skeleton()))
    points.push_back(v->point());
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(contraction)
{
  const std::vector<Point_3> superlu = contracted_points<CGAL::SuperLU_solver_traits<>>(),
                             eigen = contracted_points<CGAL::Default>();
  BOOST_TEST_REQUIRE(superlu.size() == eigen.size());
  double difference = 0, thickness = 0;
  for(std::size_t i = 0; i < eigen.size(); ++i) {
    difference = (std::max)(difference, std::sqrt(CGAL::squared_distance(superlu[i], eigen[i])));
    thickness = (std::max)(thickness, std::abs(superlu[i].z()));
  }
  BOOST_TEST(thickness < 0.45); // it was 0.9
  BOOST_TEST(difference < 1e-8);
  BOOST_TEST_MESSAGE("thickness " << thickness << ", largest difference of a point: " << difference);
}

BOOST_AUTO_TEST_CASE(skeleton)
{
  typedef Skeletonization<CGAL::SuperLU_solver_traits<>> Superlu;
  Superlu::Skeleton skeleton;
  Superlu skeletonization(banana());
  skeletonization(skeleton);
  double least_x = 0, largest_x = 0;
  for(auto v : CGAL::make_range(vertices(skeleton))) {
    const Point_3 p = skeleton[v].point;
    BOOST_TEST(std::abs(p.z()) < 0.1);
    BOOST_TEST(std::abs(p.y() - p.x() * p.x() / 16) < 0.2);
    least_x = (std::min)(least_x, p.x());
    largest_x = (std::max)(largest_x, p.x());
  }
  BOOST_TEST(least_x < -1);
  BOOST_TEST(largest_x > 1);
  BOOST_TEST_MESSAGE(num_vertices(skeleton) << " vertices from " << least_x << " to " << largest_x);
}

BOOST_AUTO_TEST_SUITE_END()
