// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `SuperLU_solver_traits` as the solver of CGAL's own algorithms on surfaces, compared with the default solver of
// each, which is Eigen's.

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_SuperLU_in_CGAL)

namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex_index;
typedef CGAL::SuperLU_solver_traits<> SuperLU;

namespace {

// A bumpy sphere of 1280 triangles, of radius 1.
Surface_mesh bumpy_sphere()
{
  Surface_mesh mesh;
  CGAL::make_icosahedron(mesh, Point_3(0, 0, 0), 1);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> factor(0.98, 1.02);
  for(Vertex_index v : vertices(mesh)) {
    const Vector_3 vector = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + vector * (factor(random) / std::sqrt(vector.squared_length()));
  }
  return mesh;
}

// Compares relative to the size of the mesh.
void check_same_points(const Surface_mesh& mesh, const Surface_mesh& reference)
{
  BOOST_REQUIRE(mesh.number_of_vertices() == reference.number_of_vertices());
  double difference = 0, size = 0;
  for(Vertex_index v : vertices(mesh)) {
    difference = (std::max)(difference, CGAL::squared_distance(mesh.point(v), reference.point(v)));
    size = (std::max)(size, CGAL::squared_distance(reference.point(v), Point_3(CGAL::ORIGIN)));
  }
  BOOST_TEST(std::sqrt(difference / size) < 1e-8);
  BOOST_TEST_MESSAGE("largest relative difference of a point: " << std::sqrt(difference / size));
}

double difference_of_points(const Surface_mesh& mesh, const Surface_mesh& other)
{
  double difference = 0;
  for(Vertex_index v : vertices(mesh))
    difference = (std::max)(difference, CGAL::squared_distance(mesh.point(v), other.point(v)));
  return std::sqrt(difference);
}

} // namespace

// What CGAL requires of solver traits beyond the concepts. Each line names the package that requires it.
static_assert(std::is_same<SuperLU::NT, double>::value,
              "`double D`: fair, smooth_shape, Heat_method_3, LSCM");
static_assert(std::is_integral<SuperLU::Index>::value, "`Index`: Heat_method_3");
static_assert(std::is_copy_constructible<SuperLU>::value, "taken by value: fair, the parameterizers");
static_assert(std::is_default_constructible<SuperLU::Matrix>::value, "Heat_method_3");
static_assert(std::is_default_constructible<SuperLU::Vector>::value, "Heat_method_3");
static_assert(std::is_constructible<SuperLU::Matrix, std::size_t>::value, "fair, Surface_mesh_deformation");
static_assert(std::is_constructible<SuperLU::Vector, std::size_t>::value, "fair, Surface_mesh_deformation");
static_assert(std::is_constructible<SuperLU::Matrix, unsigned int>::value, "Poisson_reconstruction_function");
static_assert(std::is_assignable<SuperLU::Matrix&, CGAL::Eigen_sparse_matrix<double>>::value,
              "Heat_method_3");

BOOST_AUTO_TEST_CASE(beyond_the_concepts)
{
  const int n = 5;
  SuperLU solver;
  SuperLU::NT D = 0;
  {
    SuperLU::Matrix mass(n, n), stiffness(n, n), A; // Heat_method_3
    for(int i = 0; i < n; ++i) {
      mass.add_coef(i, i, 1);
      stiffness.add_coef(i, i, 1);
      stiffness.add_coef(i, i, 0.5); // added up: Heat_method_3, Orbifold_Tutte_parameterizer_3, LSCM
      if(i > 0)
        stiffness.add_coef(i, i - 1, -0.5);
    }
    mass.assemble_matrix();
    A = mass + 2 * stiffness;
    BOOST_TEST(solver.factor(A, D));
    SuperLU::Matrix other(n, n);
    A.swap(other);
  } // the matrix is destroyed before the right-hand sides exist: Heat_method_3, Surface_mesh_deformation
  BOOST_TEST(D == 1); // asserted: OpenNL, Orbifold_Tutte_parameterizer_3; not read by the others

  SuperLU::Matrix sparse_column(n, 1); // Heat_method_3
  sparse_column.set_coef(0, 0, 4, true);
  SuperLU::Vector x, column(n);
  BOOST_TEST(solver.linear_solver(sparse_column, x));
  BOOST_TEST(x.dimension() == n);
  column.set(0, 4); // ARAP_parameterizer_3, smooth_shape
  SuperLU::Vector y(n);
  BOOST_TEST(solver.linear_solver(column, y));
  double expected = 1;
  for(int i = 0; i < n; ++i, expected /= 4) {
    BOOST_TEST(std::abs(x(i, 0) - expected) < 1e-15); // Heat_method_3
    BOOST_TEST(std::abs(y(i) - expected) < 1e-15);    // ARAP_parameterizer_3, Orbifold_Tutte_parameterizer_3
    BOOST_TEST(std::abs(y[i] - expected) < 1e-15);    // fair, Surface_mesh_deformation
  }
  x.swap(y); // Heat_method_3
}

namespace {

// Deforms one surface twice: the second time, with another matrix in the same solver.
template <CGAL::Deformation_algorithm_tag tag, typename SolverTraits>
std::vector<Surface_mesh> deform()
{
  typedef CGAL::Surface_mesh_deformation<Surface_mesh, CGAL::Default, CGAL::Default, tag, CGAL::Default,
                                         SolverTraits>
      Deformation;
  Surface_mesh mesh = bumpy_sphere();
  Deformation deformation(mesh);
  std::vector<Vertex_index> left, right;
  for(Vertex_index v : vertices(mesh)) {
    const double x = mesh.point(v).x();
    if(x > -0.9)
      deformation.insert_roi_vertex(v);
    if(x > -0.9 && x < -0.7)
      left.push_back(v);
    if(x > 0.8)
      right.push_back(v);
  }
  deformation.insert_control_vertices(left.begin(), left.end());
  deformation.insert_control_vertices(right.begin(), right.end());

  std::vector<Surface_mesh> results;
  BOOST_TEST(deformation.preprocess());
  deformation.translate(right.begin(), right.end(), Vector_3(0.3, 0.4, 0));
  deformation.deform(10, 0);
  results.push_back(mesh);

  for(Vertex_index v : left)
    deformation.erase_control_vertex(v);
  deformation.insert_control_vertex(left.front());
  BOOST_TEST(deformation.preprocess());
  deformation.translate(right.begin(), right.end(), Vector_3(0, 0, 0.5));
  deformation.deform(10, 0);
  results.push_back(mesh);
  return results;
}

template <CGAL::Deformation_algorithm_tag tag>
void check_deformation()
{
  const std::vector<Surface_mesh> superlu = deform<tag, SuperLU>(), eigen = deform<tag, CGAL::Default>();
  for(std::size_t i = 0; i < superlu.size(); ++i)
    check_same_points(superlu[i], eigen[i]);
  BOOST_TEST(difference_of_points(superlu[0], bumpy_sphere()) > 0.1);
  BOOST_TEST(difference_of_points(superlu[1], superlu[0]) > 0.1);
}

} // namespace

BOOST_AUTO_TEST_CASE(deformation)
{
  check_deformation<CGAL::ORIGINAL_ARAP>();
  check_deformation<CGAL::SPOKES_AND_RIMS>();
}

namespace {

template <typename Mode, typename SolverTraits>
std::vector<double> distances(const Surface_mesh& mesh,
                              const std::vector<std::vector<Vertex_index>>& source_sets)
{
  typedef CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface_mesh, Mode, CGAL::Default,
                                                                 SolverTraits>
      Heat_method;
  Heat_method heat_method(mesh);
  std::vector<double> result;
  for(const std::vector<Vertex_index>& sources : source_sets) {
    heat_method.clear_sources();
    heat_method.add_sources(sources);
    Surface_mesh distances = mesh;
    const auto distance = distances.add_property_map<Vertex_index, double>("v:distance").first;
    heat_method.estimate_geodesic_distances(distance);
    for(Vertex_index v : vertices(mesh))
      result.push_back(distance[v]);
  }
  return result;
}

// The sources change, but the two factorizations stay.
template <typename Mode>
void check_distances(const Surface_mesh& mesh)
{
  const std::vector<std::vector<Vertex_index>> sources = {{Vertex_index(0)},
                                                          {Vertex_index(7), Vertex_index(100)}};
  const std::vector<double> superlu = distances<Mode, SuperLU>(mesh, sources);
  const std::vector<double> eigen = distances<Mode, CGAL::Default>(mesh, sources);
  double difference = 0, size = 0;
  for(std::size_t i = 0; i < superlu.size(); ++i) {
    difference = (std::max)(difference, std::abs(superlu[i] - eigen[i]));
    size = (std::max)(size, eigen[i]);
  }
  BOOST_TEST(size > 0.5);
  BOOST_TEST(difference < 1e-8 * size);
  BOOST_TEST_MESSAGE("largest relative difference of a distance: " << difference / size);
}

} // namespace

// A default constructed `Eigen_sparse_matrix` has a `bool` that nobody sets, and CGAL swaps it into a matrix that it
// then throws away: harmless, but the undefined behavior sanitizer stops there, with any solver.
#ifdef __SANITIZE_ADDRESS__
const bool run_heat_method = false; // unless asked for by name, with -fno-sanitize=bool
#else
const bool run_heat_method = true;
#endif

BOOST_AUTO_TEST_CASE(heat_method, *boost::unit_test::enable_if<run_heat_method>())
{
  check_distances<CGAL::Heat_method_3::Direct>(bumpy_sphere());
  check_distances<CGAL::Heat_method_3::Direct>(test_meshes::bump<Surface_mesh>(16));
  check_distances<CGAL::Heat_method_3::Intrinsic_Delaunay>(test_meshes::bump<Surface_mesh>(16));
}

BOOST_AUTO_TEST_CASE(fair)
{
  const Surface_mesh original = bumpy_sphere();
  for(unsigned int continuity : {0u, 1u, 2u}) {
    Surface_mesh superlu = original, eigen = original;
    std::vector<Vertex_index> patch;
    for(Vertex_index v : vertices(original))
      if(original.point(v).z() > 0.3)
        patch.push_back(v);
    const auto parameters = CGAL::parameters::fairing_continuity(continuity);
    BOOST_TEST(PMP::fair(superlu, patch, parameters.sparse_linear_solver(SuperLU())));
    BOOST_TEST(PMP::fair(eigen, patch, parameters));
    check_same_points(superlu, eigen);
    BOOST_TEST(difference_of_points(superlu, original) > 0.01);
  }
}

BOOST_AUTO_TEST_SUITE_END()
