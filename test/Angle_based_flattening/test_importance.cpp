// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The weights of triangles, from the energy to the parameterizers' property map.

#include <boost/test/unit_test.hpp>

#include "test_charts.h"
#include "test_meshes.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_importance)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Face_index Face;
typedef SMP::ABF_plus_plus_options Options;
typedef SMP::ABF_plus_plus_parameterizer_3<Mesh> Direct;
typedef SMP::Hierarchical_parameterizer_3<Mesh> Hierarchical;

namespace {

std::vector<double> random_weights(int triangles)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> logarithm(std::log(0.1), std::log(10));
  std::vector<double> weight(triangles);
  for(double& w : weight)
    w = std::exp(logarithm(random));
  return weight;
}

abf::Angle_solution solve(const Chart& chart)
{
  const std::vector<double> beta = abf::target_angles(chart);
  Options options;
  options.tolerance = options.energy_tolerance = 1e-10;
  return abf::solve_angles(chart, beta, options, CGAL::SuperLU_solver_traits<>(), abf::starting_angles(beta));
}

Mesh bump_mesh(int n)
{
  Mesh mesh;
  test_meshes::make_bump(n, mesh);
  return mesh;
}

// Faces around the middle of the mesh
bool is_in_patch(Face f, const Mesh& mesh)
{
  const Point_3 p = mesh.point(mesh.target(mesh.halfedge(f)));
  return std::hypot(p.x() - 0.5, p.y() - 0.5) < 0.25;
}

struct Distortions
{
  double patch = 0, others = 0;
};

// Of the angles of a patch with some importance and of the rest of the surface
template <typename Parameterizer>
Distortions distortions(Mesh& mesh, double importance, Parameterizer parameterizer)
{
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  parameterizer.set_importance(
      boost::make_function_property_map<Face>([&](Face f) { return is_in_patch(f, mesh) ? importance : 1; }));
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, border, uv) == SMP::OK);
  Distortions result;
  const auto add = [&](Face f, const SMP::Flattening_face_measures& measures) {
    (is_in_patch(f, mesh) ? result.patch : result.others) += measures.angular_distortion;
  };
  SMP::measure_flattening(mesh, border, uv, CGAL::parameters::visitor(add));
  return result;
}

template <typename Parameterizer>
void check_refused(double importance)
{
  Mesh mesh = bump_mesh(4);
  const Face wrong(5);
  const auto map = mesh.add_property_map<Face, double>("f:importance", 1.).first;
  map[wrong] = importance;
  Parameterizer parameterizer;
  parameterizer.set_importance(map);
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv", Point_2(-1, -1)).first;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, CGAL::Polygon_mesh_processing::longest_border(mesh).first,
                               uv) == SMP::ERROR_WRONG_PARAMETER);
  BOOST_TEST(parameterizer.report().status == SMP::Diagnosis::WRONG_WEIGHT);
  BOOST_TEST(!parameterizer.report().message.empty());
  BOOST_REQUIRE(parameterizer.report().offending_faces.size() == 1);
  BOOST_TEST(parameterizer.report().offending_faces.front() == wrong);
  BOOST_TEST(uv[Mesh::Vertex_index(0)] == Point_2(-1, -1));
}

} // namespace

// The first derivative of the merit function along a step, and the step itself, which stationary angles have none of.
BOOST_AUTO_TEST_CASE(stationary_angles_are_those_of_the_weighted_energy)
{
  Chart chart = bump(8, 3);
  chart.weight = random_weights(chart.number_of_triangles());
  const std::vector<double> beta = abf::target_angles(chart);
  const abf::Angle_solution solution = solve(chart);
  BOOST_TEST(solution.converged);
  const abf::Angle_energy energy{0.1};
  double sum = 0;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    sum += chart.weight[c / 3] * energy.value(solution.alpha[c], beta[c]);
  BOOST_TEST(solution.energy == sum, boost::test_tools::tolerance(1e-12));

  // No other feasible angles have less energy: those of maps near to the solution's.
  const Options options;
  std::vector<Point_2> uv =
      abf::flatten_chart(chart, options, CGAL::SuperLU_solver_traits<>(), [](std::vector<Point_2>&) {}).uv;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-1e-4, 1e-4);
  for(int i = 0; i < 20; ++i) {
    std::vector<Point_2> moved = uv;
    for(Point_2& p : moved)
      p = Point_2(p.x() + jitter(random), p.y() + jitter(random));
    double moved_energy = 0;
    for(int c = 0; c < chart.number_of_corners(); ++c)
      moved_energy += chart.weight[c / 3] * energy.value(abf::planar_angle(chart, moved, c), beta[c]);
    BOOST_TEST(moved_energy > solution.energy);
  }
}

// A factor of four changes exponents only, a factor of two also roots.
BOOST_AUTO_TEST_CASE(common_factors_do_not_matter)
{
  Chart chart = bump(10, 5);
  const abf::Angle_solution plain = solve(chart);
  for(const double factor : {1., 4., 0.25, 2., 8., 10.}) {
    chart.weight.assign(chart.number_of_triangles(), factor);
    const abf::Angle_solution weighted = solve(chart);
    double difference = 0;
    for(std::size_t c = 0; c < plain.alpha.size(); ++c)
      difference = (std::max)(difference, std::abs(plain.alpha[c] - weighted.alpha[c]));
    BOOST_TEST(difference <= (factor == 1 || factor == 4 || factor == 0.25 ? 0 : 1e-9));
    BOOST_TEST(weighted.energy == factor * plain.energy, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(important_faces_change_less)
{
  Mesh mesh = bump_mesh(30);
  const Distortions less = distortions(mesh, 0.1, Direct()), plain = distortions(mesh, 1, Direct()),
                    more = distortions(mesh, 10, Direct());
  BOOST_TEST(more.patch < 0.95 * plain.patch);
  BOOST_TEST(more.others > 1.02 * plain.others);
  BOOST_TEST(less.patch > 1.1 * plain.patch);
  BOOST_TEST(less.others < 0.98 * plain.others);
}

BOOST_AUTO_TEST_CASE(important_faces_change_less_hierarchically)
{
  Mesh mesh = bump_mesh(40);
  SMP::Hierarchical_options sweeping, polishing;
  sweeping.angle_sweeps = 5;
  polishing.polish = true;
  for(const auto& options : {SMP::Hierarchical_options(), sweeping, polishing}) {
    const Distortions plain = distortions(mesh, 1, Hierarchical(options)),
                      more = distortions(mesh, 10, Hierarchical(options));
    BOOST_TEST(more.patch < 0.97 * plain.patch);
    BOOST_TEST(more.others > plain.others);
  }
  typedef SMP::Hierarchical_parameterizer_3<Mesh, SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh>>
      LSCM;
  BOOST_TEST(distortions(mesh, 10, LSCM(sweeping)).patch < distortions(mesh, 1, LSCM(sweeping)).patch);
}

BOOST_AUTO_TEST_CASE(importance_out_of_range_is_refused)
{
  for(const double importance : {0., -1., 0.09, 10.1, std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()}) {
    check_refused<Direct>(importance);
    check_refused<Hierarchical>(importance);
  }
}

BOOST_AUTO_TEST_SUITE_END()
