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
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/Mean_curvature_flow_skeletonization.h>

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <list>
#include <memory>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_SuperLU_in_CGAL)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex_index;
typedef Surface_mesh::Edge_index Edge_index;
typedef CGAL::SuperLU_solver_traits<> SuperLU;

namespace {

// Compares numbers relative to the largest one.
void check_same_numbers(const std::vector<double>& numbers, const std::vector<double>& reference)
{
  BOOST_REQUIRE(numbers.size() == reference.size());
  double difference = 0, size = 0;
  for(std::size_t i = 0; i < numbers.size(); ++i) {
    difference = (std::max)(difference, std::abs(numbers[i] - reference[i]));
    size = (std::max)(size, std::abs(reference[i]));
  }
  BOOST_TEST(size > 0.1);
  BOOST_TEST(difference < 2e-9 * size);
}

template <typename Point>
void check_same_points(const std::vector<Point>& points, const std::vector<Point>& reference)
{
  std::vector<double> numbers, expected;
  for(const auto& [all, result] : {std::pair(&points, &numbers), std::pair(&reference, &expected)})
    for(const Point& p : *all)
      result->insert(result->end(), p.cartesian_begin(), p.cartesian_end());
  check_same_numbers(numbers, expected);
}

std::vector<Point_3> points_of(const Surface_mesh& mesh)
{
  return {mesh.points().begin(), mesh.points().end()};
}

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
    check_same_points(points_of(superlu[i]), points_of(eigen[i]));
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
  check_same_numbers(distances<Mode, SuperLU>(mesh, sources), distances<Mode, CGAL::Default>(mesh, sources));
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
    check_same_points(points_of(superlu), points_of(eigen));
    BOOST_TEST(difference_of_points(superlu, original) > 0.01);
  }
}

namespace {

template <typename Parameterizer>
std::vector<Point_2> parameterize(Surface_mesh& mesh)
{
  const auto uv = mesh.add_property_map<Vertex_index, Point_2>("v:uv").first;
  BOOST_TEST(SMP::parameterize(mesh, Parameterizer(), PMP::longest_border(mesh).first, uv) == SMP::OK);
  return {uv.begin(), uv.end()};
}

template <template <typename, typename, typename> class Parameterizer>
void check_parameterizer()
{
  Surface_mesh mesh = test_meshes::bump<Surface_mesh>(16);
  check_same_points(parameterize<Parameterizer<Surface_mesh, CGAL::Default, SuperLU>>(mesh),
                    parameterize<Parameterizer<Surface_mesh, CGAL::Default, CGAL::Default>>(mesh));
}

} // namespace

BOOST_AUTO_TEST_CASE(parameterizers)
{
  check_parameterizer<SMP::Mean_value_coordinates_parameterizer_3>();
  check_parameterizer<SMP::Discrete_conformal_map_parameterizer_3>();
  check_parameterizer<SMP::Discrete_authalic_parameterizer_3>();
  check_parameterizer<SMP::Barycentric_mapping_parameterizer_3>();
  check_parameterizer<SMP::ARAP_parameterizer_3>();
}

namespace {

struct Counting_traits : SuperLU
{
  static inline int calls = 0;

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    ++calls;
    return SuperLU::linear_solver(A, B, X, D);
  }
};

} // namespace

// A comment in CGAL 5.5 says that LSCM ignores its traits. It ignores only the object: OpenNL makes one of the type.
BOOST_AUTO_TEST_CASE(lscm)
{
  check_parameterizer<SMP::LSCM_parameterizer_3>();
  Surface_mesh mesh = test_meshes::bump<Surface_mesh>(4);
  parameterize<SMP::LSCM_parameterizer_3<Surface_mesh, CGAL::Default, Counting_traits>>(mesh);
  BOOST_TEST(Counting_traits::calls == 1);
}

namespace {

struct Seamed_sphere
{
  typedef Surface_mesh::Property_map<Edge_index, bool> Seam_edges;
  typedef Surface_mesh::Property_map<Vertex_index, bool> Seam_vertices;
  typedef CGAL::Seam_mesh<Surface_mesh, Seam_edges, Seam_vertices> Mesh;
  typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

  // Four cones make a parallelogram, three any of the other orbifolds.
  explicit Seamed_sphere(int number_of_cones)
  {
    CGAL::make_icosahedron(sphere, Point_3(0, 0, 0), 1);
    CGAL::Subdivision_method_3::Loop_subdivision(sphere, CGAL::parameters::number_of_iterations(2));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> factor(0.95, 1.05);
    for(Vertex_index v : vertices(sphere))
      sphere.point(v) = CGAL::ORIGIN + factor(random) * (sphere.point(v) - CGAL::ORIGIN);

    // The icosahedron's corners are still the first vertices. In this order they are neighbors.
    std::vector<Vertex_index> cones_of_sphere = {Vertex_index(0), Vertex_index(4), Vertex_index(9),
                                                 Vertex_index(5)};
    cones_of_sphere.resize(number_of_cones);
    std::list<Edge_index> seam;
    SMP::compute_shortest_paths_between_cones(sphere, cones_of_sphere.begin(), cones_of_sphere.end(), seam);
    mesh = std::make_unique<Mesh>(sphere, sphere.add_property_map<Edge_index, bool>("e:on_seam", false).first,
                                  sphere.add_property_map<Vertex_index, bool>("v:on_seam", false).first);
    for(Edge_index e : seam)
      mesh->add_seam(source(e, sphere), target(e, sphere));
    BOOST_REQUIRE(SMP::locate_cones(*mesh, cones_of_sphere.begin(), cones_of_sphere.end(), cones));
  }

  template <typename SolverTraits>
  std::vector<Point_2> flatten(SMP::Orbifold_type type, SMP::Weight_type weights)
  {
    boost::unordered_map<vertex_descriptor, int> indices;
    for(vertex_descriptor v : vertices(*mesh))
      indices.emplace(v, static_cast<int>(indices.size()));
    const auto uv = sphere.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first;
    SMP::Orbifold_Tutte_parameterizer_3<Mesh, SolverTraits> parameterizer(type, weights);
    BOOST_TEST(parameterizer.parameterize(*mesh, PMP::longest_border(*mesh).first, cones, uv,
                                          boost::make_assoc_property_map(indices)) == SMP::OK);
    std::vector<Point_2> result;
    for(vertex_descriptor v : vertices(*mesh))
      result.push_back(get(uv, v));
    return result;
  }

  Surface_mesh sphere;
  std::unique_ptr<Mesh> mesh;
  boost::unordered_map<vertex_descriptor, SMP::Cone_type> cones;
};

} // namespace

// A saddle point system: symmetric and indefinite with one kind of weights, unsymmetric with the other.
BOOST_AUTO_TEST_CASE(orbifold_tutte)
{
  for(SMP::Orbifold_type type : {SMP::Square, SMP::Diamond, SMP::Triangle, SMP::Parallelogram})
    for(SMP::Weight_type weights : {SMP::Cotangent, SMP::Mean_value}) {
      Seamed_sphere sphere(type == SMP::Parallelogram ? 4 : 3);
      check_same_points(sphere.flatten<SuperLU>(type, weights), sphere.flatten<CGAL::Default>(type, weights));
    }
}

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact_kernel;
typedef std::pair<Exact_kernel::Point_3, Exact_kernel::Vector_3> Oriented_point;
typedef CGAL::Poisson_reconstruction_function<Exact_kernel> Function;

// Points of an ellipsoid with half axes 1, 0.8 and 0.6, along a spiral
std::vector<Oriented_point> ellipsoid(int n)
{
  std::vector<Oriented_point> points;
  for(int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, radius = std::sqrt(1 - z * z), angle = 2.4 * i;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    const Exact_kernel::Vector_3 normal(x, y / 0.8, z / 0.6);
    points.emplace_back(Exact_kernel::Point_3(x, 0.8 * y, 0.6 * z),
                        normal / std::sqrt(normal.squared_length()));
  }
  return points;
}

template <typename... Solver>
std::vector<double> values(const Solver&... solver)
{
  const std::vector<Oriented_point> points = ellipsoid(500);
  Function function(points.begin(), points.end(), CGAL::First_of_pair_property_map<Oriented_point>(),
                    CGAL::Second_of_pair_property_map<Oriented_point>());
  BOOST_TEST(function.compute_implicit_function(solver...));
  std::vector<double> result;
  for(double x = -1.15; x < 1.2; x += 0.1)
    for(double y = -0.9; y < 1; y += 0.2)
      result.push_back(function(Exact_kernel::Point_3(x, y, 0.1)));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(poisson)
{
  const std::vector<double> superlu = values(SuperLU()), eigen = values();
  const auto [least, largest] = std::minmax_element(superlu.begin(), superlu.end());
  BOOST_TEST(*least < -0.1 * *largest); // inside
  BOOST_TEST(*largest > -0.1 * *least);
  check_same_numbers(superlu, eigen);
}

namespace {

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
  const std::vector<Point_3> superlu = contracted_points<SuperLU>(),
                             eigen = contracted_points<CGAL::Default>();
  check_same_points(superlu, eigen);
  for(const Point_3& p : superlu)
    BOOST_TEST(std::abs(p.z()) < 0.45); // it was 0.9
}

BOOST_AUTO_TEST_CASE(skeleton)
{
  typedef Skeletonization<SuperLU> Superlu;
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
}

BOOST_AUTO_TEST_SUITE_END()
