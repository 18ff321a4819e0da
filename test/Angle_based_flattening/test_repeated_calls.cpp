// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Several calls of one parameterizer: what it keeps must not change results, and a warm start must lead to the same map.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_repeated_calls)

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef SMP::ABF_plus_plus_parameterizer_3<Mesh> Parameterizer;
typedef SMP::ABF_plus_plus_options Options;
typedef SMP::ABF_plus_plus_report Report;

namespace {

// A disk, and one with a hole
std::vector<Mesh> surfaces()
{
  Mesh disk = test_meshes::bump<Mesh>(20), punched = disk;
  const std::vector<Mesh::Face_index> faces(punched.faces().begin(), punched.faces().end());
  CGAL::Euler::remove_face(halfedge(faces[faces.size() / 2], punched), punched);
  return {disk, punched};
}

Mesh::Halfedge_index outer_border(const Mesh& mesh)
{
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h) && mesh.point(mesh.target(h)).x() < 0.1)
      return h;
  return Mesh::null_halfedge();
}

// Frame `k` of a morph
void move_points(const Mesh& original, int k, Mesh& mesh)
{
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const Point_3& p = original.point(v);
    mesh.point(v) =
        Point_3(p.x() + 0.003 * k * std::sin(5 * p.y()), p.y(), p.z() * (1 + 0.01 * k) + 0.002 * k * p.x());
  }
}

std::vector<Point_2> flatten(Mesh& mesh, const Parameterizer& parameterizer)
{
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  BOOST_TEST_REQUIRE(SMP::parameterize(mesh, parameterizer, outer_border(mesh), uv) == SMP::OK,
                     parameterizer.report().message);
  return {uv.begin(), uv.end()};
}

Options warm_options(int threads = 0)
{
  Options options;
  options.warm_start = true;
  options.threads = threads;
  return options;
}

bool have_same_step_counts(const Report& a, const Report& b)
{
  if(a.steps.size() != b.steps.size())
    return false;
  for(std::size_t i = 0; i < a.steps.size(); ++i)
    if(a.steps[i].linear_iterations != b.steps[i].linear_iterations)
      return false;
  return true;
}

} // namespace

BOOST_AUTO_TEST_CASE(results_are_those_of_a_fresh_parameterizer)
{
  Parameterizer parameterizer;
  for(int k = 0; k < 4; ++k)
    for(const Mesh& surface : surfaces()) { // in turn, so that each pattern follows another one
      Mesh mesh = surface;
      move_points(surface, k, mesh);
      const Parameterizer fresh;
      BOOST_TEST(flatten(mesh, parameterizer) == flatten(mesh, fresh));
      BOOST_TEST(have_same_step_counts(parameterizer.report(), fresh.report()));
    }
}

BOOST_AUTO_TEST_CASE(warm_starts_lead_to_the_same_map_in_fewer_steps)
{
  for(const Mesh& surface : surfaces()) {
    Mesh mesh = surface;
    const Parameterizer warm(warm_options());
    int cold_steps = 0, warm_steps = 0;
    for(int k = 0; k < 20; ++k) {
      move_points(surface, k, mesh);
      const Parameterizer cold;
      const std::vector<Point_2> expected = flatten(mesh, cold), found = flatten(mesh, warm);
      BOOST_TEST(warm.report().strategy == (k == 0 ? Report::FROM_TARGET_ANGLES : Report::FROM_LAST_ANGLES));
      BOOST_TEST(warm.report().converged);
      BOOST_TEST(warm.report().failed_strategies.empty());
      BOOST_TEST(std::abs(warm.report().energy - cold.report().energy) <= 1e-6 * cold.report().energy);
      double largest = 0;
      for(std::size_t i = 0; i < found.size(); ++i)
        largest = (std::max)(largest, CGAL::squared_distance(found[i], expected[i]));
      BOOST_TEST(std::sqrt(largest) < 1e-3);
      if(k > 0) {
        cold_steps += cold.report().iterations;
        warm_steps += warm.report().iterations;
      }
    }
    BOOST_TEST(2 * warm_steps <= cold_steps + 19);
    BOOST_TEST(warm_steps < cold_steps);
  }
}

BOOST_AUTO_TEST_CASE(warm_starts_are_deterministic)
{
  std::vector<std::vector<Point_2>> results;
  const Mesh surface = surfaces().front();
  for(int threads : {1, 2, 2}) {
    const Parameterizer parameterizer(warm_options(threads));
    Mesh mesh = surface;
    flatten(mesh, parameterizer);
    move_points(surface, 1, mesh);
    // Copies at the same time start from the same angles.
    std::vector<Mesh> meshes(2, mesh);
    std::vector<Parameterizer> copies(2, parameterizer);
    std::vector<std::thread> running;
    std::vector<std::vector<Point_2>> found(2);
    for(int i = 0; i < 2; ++i)
      running.emplace_back([&, i] { found[i] = flatten(meshes[i], copies[i]); });
    for(std::thread& thread : running)
      thread.join();
    BOOST_TEST(found[0] == found[1]);
    BOOST_TEST(copies[0].report().strategy == Report::FROM_LAST_ANGLES);
    results.push_back(found[0]);
  }
  BOOST_TEST(results[0] == results[1]);
  BOOST_TEST(results[1] == results[2]);
}

// Another mesh, another border halfedge, or other prescribed angles: nothing of the last call fits.
BOOST_AUTO_TEST_CASE(other_triangles_start_from_their_targets)
{
  const std::vector<Mesh> meshes = surfaces();
  const Parameterizer parameterizer(warm_options());
  Mesh first = meshes[0], second = meshes[1];
  flatten(first, parameterizer);
  const std::vector<Point_2> found = flatten(second, parameterizer);
  BOOST_TEST(parameterizer.report().strategy == Report::FROM_TARGET_ANGLES);
  BOOST_TEST(found == flatten(second, Parameterizer()));

  flatten(first, parameterizer);
  Parameterizer rectangular = parameterizer;
  rectangular.set_angle_sums(boost::make_function_property_map<Mesh::Vertex_index>(
      [&](Mesh::Vertex_index v) -> std::optional<double> {
        return first.degree(v) == 2 ? std::optional<double>(1.5) : std::nullopt;
      }));
  flatten(first, rectangular);
  BOOST_TEST(rectangular.report().strategy == Report::FROM_TARGET_ANGLES);
  BOOST_TEST(rectangular.report().prescribed_angles > 0);
}

BOOST_AUTO_TEST_CASE(an_error_between_changes_nothing)
{
  const Mesh surface = surfaces().front();
  Mesh mesh = surface;
  const Parameterizer parameterizer(warm_options()), other(warm_options());
  flatten(mesh, parameterizer);
  flatten(mesh, other);
  const Mesh::Vertex_index v(7);
  mesh.point(v) = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, outer_border(mesh), uv) == SMP::ERROR_WRONG_PARAMETER);
  move_points(surface, 1, mesh);
  BOOST_TEST(flatten(mesh, parameterizer) == flatten(mesh, other));
  BOOST_TEST(parameterizer.report().strategy == Report::FROM_LAST_ANGLES);
}

BOOST_AUTO_TEST_SUITE_END()
