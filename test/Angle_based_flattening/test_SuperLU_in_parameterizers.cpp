// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `SuperLU_solver_traits` as the solver of CGAL's own parameterizers, compared with the default solver of each, which
// is Eigen's.

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/unordered_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <list>
#include <memory>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_SuperLU_in_parameterizers)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex_index;
typedef Surface_mesh::Edge_index Edge_index;
typedef CGAL::SuperLU_solver_traits<> SuperLU;

namespace {

template <typename Parameterizer>
std::vector<Point_2> parameterize(Surface_mesh& mesh)
{
  const auto uv = mesh.add_property_map<Vertex_index, Point_2>("v:uv").first;
  BOOST_TEST(SMP::parameterize(mesh, Parameterizer(), PMP::longest_border(mesh).first, uv) == SMP::OK);
  return {uv.begin(), uv.end()};
}

// Compares relative to the size of the result.
void check_same_points(const std::vector<Point_2>& points, const std::vector<Point_2>& reference)
{
  BOOST_REQUIRE(points.size() == reference.size());
  double difference = 0, size = 0;
  for(std::size_t i = 0; i < points.size(); ++i) {
    difference = (std::max)(difference, CGAL::squared_distance(points[i], reference[i]));
    size = (std::max)(size, CGAL::squared_distance(reference[i], reference[0]));
  }
  BOOST_TEST(size > 0.1);
  BOOST_TEST(std::sqrt(difference / size) < 1e-8);
  BOOST_TEST_MESSAGE("largest relative difference of a point: " << std::sqrt(difference / size));
}

template <template <typename, typename, typename> class Parameterizer>
void check_parameterizer()
{
  Surface_mesh mesh = test_meshes::bump<Surface_mesh>(16);
  check_same_points(parameterize<Parameterizer<Surface_mesh, CGAL::Default, SuperLU>>(mesh),
                    parameterize<Parameterizer<Surface_mesh, CGAL::Default, CGAL::Default>>(mesh));
}

} // namespace

BOOST_AUTO_TEST_CASE(mean_value_coordinates)
{
  check_parameterizer<SMP::Mean_value_coordinates_parameterizer_3>();
}

BOOST_AUTO_TEST_CASE(discrete_conformal_map)
{
  check_parameterizer<SMP::Discrete_conformal_map_parameterizer_3>();
}

BOOST_AUTO_TEST_CASE(discrete_authalic)
{
  check_parameterizer<SMP::Discrete_authalic_parameterizer_3>();
}

BOOST_AUTO_TEST_CASE(barycentric_mapping)
{
  check_parameterizer<SMP::Barycentric_mapping_parameterizer_3>();
}

BOOST_AUTO_TEST_CASE(arap)
{
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

BOOST_AUTO_TEST_SUITE_END()
