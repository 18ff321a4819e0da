// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prescribed angle sums at the vertices of a surface before it is cut: cones, and transitions across seams that are
// rigid motions.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"
#include "test_options.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cone_sums)

using namespace seam_surfaces;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef Surface_mesh Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Seams;
typedef Mesh::Property_map<Halfedge, Kernel::Point_2> UV_map;
typedef TA::Cut_mesh<Mesh> Seam_mesh;
typedef SMP::ABF_plus_plus_report Report;
using TA::Seam_options;
typedef SMP::ABF_plus_plus_options Options;
typedef SMP::Vertex_angles<Mesh> Angles;

namespace {

const double pi = CGAL_PI;

struct Map
{
  Report report;
  std::vector<Vertex> offending;   // vertices of the mesh
  std::vector<Kernel::Point_2> uv; // of the corner that each halfedge leads to
};

template <typename Angle_map>
Map flatten(Mesh& mesh, const Seams& seams, const Angle_map& angles, const Options& options = Options())
{
  Seam_mesh cut = TA::make_seam_mesh(mesh, seams).mesh;
  const UV_map uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Seam_mesh> parameterizer(options);
  parameterizer.set_angle_sums(angles);
  SMP::parameterize(cut, parameterizer, TA::border_halfedge(cut), uv);
  Map map;
  map.report = parameterizer.report();
  for(const auto& v : parameterizer.report().offending_vertices)
    map.offending.push_back(mesh.target(Halfedge(v)));
  const boost::graph_traits<Seam_mesh>::halfedge_descriptor null;
  for(Halfedge h : mesh.halfedges())
    map.uv.push_back(mesh.is_border(h)
                         ? Kernel::Point_2(0, 0)
                         : get(uv, target(boost::graph_traits<Seam_mesh>::halfedge_descriptor(h), cut)));
  return map;
}

std::complex<double> edge(const Mesh& mesh, const Map& map, Halfedge h)
{
  const auto d = map.uv[h.idx()] - map.uv[mesh.prev(h).idx()];
  return {d.x(), d.y()};
}

double angle(const Mesh& mesh, const Map& map, Halfedge h)
{
  return std::arg(-edge(mesh, map, h) / edge(mesh, map, mesh.next(h)));
}

// The sum of the planar angles at a vertex
double angle_sum(const Mesh& mesh, const Map& map, Vertex v)
{
  double sum = 0;
  for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    if(!mesh.is_border(h))
      sum += angle(mesh, map, h);
  return sum;
}

// What turns and scales a side of a seam into the other one
std::complex<double> transition(const Mesh& mesh, const Map& map, Halfedge h)
{
  return -edge(mesh, map, mesh.opposite(h)) / edge(mesh, map, h);
}

bool is_cone(const Angles& angles, Vertex v)
{
  return angles[v].has_value();
}

void check_map(const Mesh& mesh, const Seams& seams, const Angles& angles, const Map& map,
               double tolerance = 2e-5)
{
  BOOST_TEST(map.report.status == SMP::Diagnosis::NOTHING_WRONG, map.report.message);
  if(map.report.status != SMP::Diagnosis::NOTHING_WRONG)
    return;
  BOOST_TEST(map.report.largest_angle_error < tolerance);
  BOOST_TEST(map.report.largest_seam_turn < tolerance);
  for(Mesh::Face_index f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    BOOST_TEST(CGAL::orientation(map.uv[h.idx()], map.uv[mesh.next(h).idx()], map.uv[mesh.prev(h).idx()]) ==
               CGAL::LEFT_TURN);
  }
  double jump = 0;
  for(Mesh::Edge_index e : mesh.edges())
    if(seams[e])
      jump = (std::max)(jump, std::abs(std::log(std::abs(transition(mesh, map, mesh.halfedge(e))))));
  BOOST_TEST(jump < tolerance);
  BOOST_TEST(std::abs(jump - map.report.largest_seam_jump) < 1e-10);
  for(Vertex v : mesh.vertices()) {
    std::vector<Halfedge> in;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(seams[mesh.edge(h)])
        in.push_back(h);
    const std::optional<double> prescribed = angles[v];
    if(prescribed && std::isfinite(*prescribed))
      BOOST_TEST(std::abs(angle_sum(mesh, map, v) - *prescribed) < tolerance);
    else if(!prescribed && !mesh.is_border(v))
      BOOST_TEST(std::abs(angle_sum(mesh, map, v) - 2 * pi) < tolerance);
    if(in.size() == 2 && !mesh.is_border(v) && !is_cone(angles, v)) {
      const auto turn = transition(mesh, map, in[0]) / transition(mesh, map, mesh.opposite(in[1]));
      BOOST_TEST(std::abs(std::arg(turn)) < tolerance);
    }
  }
}

Seams add_seams(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
}

// The vertices of the mesh in an order by chance
std::vector<Vertex> shuffled_vertices(const Mesh& mesh, std::mt19937& random)
{
  std::vector<Vertex> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for(std::size_t i = vertices.size(); i > 1; --i)
    std::swap(vertices[i - 1], vertices[random() % i]);
  return vertices;
}

bool is_on_seam(const Mesh& mesh, const Seams& seams, Vertex v)
{
  const auto halfedges = mesh.halfedges_around_target(mesh.halfedge(v));
  return std::any_of(halfedges.begin(), halfedges.end(), [&](Halfedge h) { return seams[mesh.edge(h)]; });
}

// Seams of a surface that lead to ends enough for cones
Seams cut(Mesh& mesh, double stretch)
{
  const Seams seams = add_seams(mesh);
  BOOST_REQUIRE(
      TA::select_seams(mesh, seams, with<Seam_options>(&Seam_options::stretch_bound, stretch)).status ==
      SMP::Diagnosis::NOTHING_WRONG);
  return seams;
}

// `n` cones by chance on the seams, whose sums have the right total and are near to one another
Angles random_cones(const Mesh& mesh, const Seams& seams, int handles, std::size_t n, std::mt19937& random)
{
  std::vector<Vertex> cones;
  for(Vertex v : shuffled_vertices(mesh, random))
    if(cones.size() < n && !mesh.is_border(v) && is_on_seam(mesh, seams, v) && mesh.degree(v) >= 4)
      cones.push_back(v);
  BOOST_REQUIRE(!cones.empty());
  std::uniform_real_distribution<double> uniform(0.8, 1.2);
  std::vector<double> share;
  double total = 0;
  for(std::size_t i = 0; i < cones.size(); ++i) {
    share.push_back(uniform(random));
    total += share.back();
  }
  Angles angles;
  for(std::size_t i = 0; i < cones.size(); ++i)
    angles.set(cones[i], 2 * pi - share[i] / total * 2 * pi * (2 - 2 * handles));
  return angles;
}

Mesh bumpy_sphere(int levels, unsigned seed)
{
  Mesh mesh = sphere(levels).mesh();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.8, 1.2);
  for(Vertex v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + uniform(random) * (mesh.point(v) - CGAL::ORIGIN);
  return mesh;
}

} // namespace

BOOST_AUTO_TEST_CASE(of_spheres_are_met)
{
  for(unsigned seed = 0; seed < 10; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    std::mt19937 random(seed);
    Mesh mesh = bumpy_sphere(2, seed);
    const Seams seams = cut(mesh, 1.1);
    const Angles angles = random_cones(mesh, seams, 0, 6 + seed, random);
    check_map(mesh, seams, angles, flatten(mesh, seams, angles));
  }
}

// A torus needs no cone. Surfaces with more handles have cones of more than a full turn.
BOOST_AUTO_TEST_CASE(of_surfaces_with_handles_are_met)
{
  for(const Surface& surface : {torus(12, 8), torus(5, 9), slab(2), slab(3)})
    for(std::size_t cones : {0, 4, 8}) {
      const int handles = static_cast<int>(surface.handles);
      if(handles > 1 && cones == 0)
        continue;
      BOOST_TEST_INFO_SCOPE(surface.name << ", " << cones << " cones");
      std::mt19937 random(3);
      Mesh mesh = surface.mesh();
      const Seams seams = cut(mesh, 1.2);
      const Angles angles = cones == 0 ? Angles() : random_cones(mesh, seams, handles, cones, random);
      check_map(mesh, seams, angles, flatten(mesh, seams, angles));
    }
}

// A disk whose border is free, with a cone inside, and then with a border that is a square
BOOST_AUTO_TEST_CASE(of_disks_are_met)
{
  Mesh mesh;
  const int n = 12;
  std::vector<Vertex> grid;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= n; ++i)
      grid.push_back(
          mesh.add_vertex(Point_3(i, j, 3 * std::exp(-0.1 * ((i - 6) * (i - 6) + (j - 6) * (j - 6))))));
  const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(j * (n + 1) + i)]; };
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  const Seams seams = add_seams(mesh);
  for(int i = 0; i < 6; ++i)
    seams[mesh.edge(mesh.halfedge(at(i, 6), at(i + 1, 6)))] = true;
  Angles angles;
  angles.set(at(6, 6), 1.5 * pi);
  check_map(mesh, seams, angles, flatten(mesh, seams, angles));
  angles.set(at(6, 6), SMP::free_cone_angle);
  check_map(mesh, seams, angles, flatten(mesh, seams, angles));

  // Corners of a triangle at (0, 0), (n, 0) and (0, n): with the cone, the border turns by three quarters of a full
  // turn.
  for(int i = 0; i <= n; ++i)
    for(Vertex v : {at(i, 0), at(n, i), at(i, n), at(0, i)})
      angles.set(v, pi);
  angles.set(at(6, 6), 1.5 * pi);
  for(Vertex v : {at(0, 0), at(n, 0), at(0, n)})
    angles.set(v, pi / 2);
  check_map(mesh, seams, angles, flatten(mesh, seams, angles));
}

// What free cones get is what the others leave
BOOST_AUTO_TEST_CASE(of_free_cones_are_found)
{
  std::mt19937 random(5);
  Mesh mesh = bumpy_sphere(2, 5);
  const Seams seams = cut(mesh, 1.1);
  Angles angles = random_cones(mesh, seams, 0, 8, random);
  std::vector<Vertex> cones;
  for(Vertex v : mesh.vertices())
    if(angles[v])
      cones.push_back(v);
  const double sum = *angles[cones[0]] + *angles[cones[1]];
  angles.set(cones[0], SMP::free_cone_angle);
  angles.set(cones[1], SMP::free_cone_angle);
  const Map map = flatten(mesh, seams, angles);
  check_map(mesh, seams, angles, map);
  BOOST_TEST(std::abs(angle_sum(mesh, map, cones[0]) + angle_sum(mesh, map, cones[1]) - sum) < 1e-4);
  BOOST_TEST(map.report.prescribed_angles == 6);
}

// The verdict before anything is solved, and what the solver finds
BOOST_AUTO_TEST_CASE(are_recognized_as_feasible_or_not)
{
  std::mt19937 random(6);
  int feasible = 0, infeasible = 0;
  for(unsigned i = 0; i < 60; ++i) {
    Mesh mesh = bumpy_sphere(1, i);
    const Seams seams = cut(mesh, 1.05);
    std::vector<Vertex> cones;
    for(Vertex v : mesh.vertices())
      if(is_on_seam(mesh, seams, v))
        cones.push_back(v);
    std::uniform_real_distribution<double> uniform(-0.1 * i * pi, 0.1 * i * pi);
    Angles angles;
    double left = 2 * pi * (static_cast<double>(cones.size()) - 2);
    for(std::size_t k = 0; k + 1 < cones.size(); ++k) {
      const double mean = left / static_cast<double>(cones.size() - k);
      const double sum =
          (std::min)((std::max)(mean + uniform(random), 0.1), (mesh.degree(cones[k]) - 0.1) * pi);
      angles.set(cones[k], sum);
      left -= sum;
    }
    angles.set(cones.back(), left);
    const Map map = flatten(mesh, seams, angles);
    if(map.report.status == SMP::Diagnosis::NOTHING_WRONG) {
      ++feasible;
      check_map(mesh, seams, angles, map);
    } else {
      ++infeasible;
      BOOST_TEST_INFO_SCOPE(i << " " << map.report.message);
      BOOST_TEST((map.report.status == SMP::Diagnosis::WRONG_ANGLE_SUM ||
                  map.report.status == SMP::Diagnosis::INFEASIBLE_ANGLE_SUMS));
      BOOST_TEST(!map.offending.empty());
    }
  }
  BOOST_TEST_MESSAGE(feasible << " feasible, " << infeasible << " not");
  BOOST_TEST(feasible > 10);
  BOOST_TEST(infeasible > 10);
}

struct Sphere_with_cones
{
  Sphere_with_cones() : mesh(bumpy_sphere(2, 1)), seams(cut(mesh, 1.1))
  {
    std::mt19937 random(1);
    angles = random_cones(mesh, seams, 0, 6, random);
    for(Vertex v : mesh.vertices())
      if(angles[v])
        cone = v;
  }

  Mesh mesh;
  Seams seams;
  Angles angles;
  Vertex cone;
};

BOOST_FIXTURE_TEST_CASE(that_are_wrong_are_refused, Sphere_with_cones)
{
  const double right = *angles[cone];
  const auto diagnosis = [&](double angle) {
    angles.set(cone, angle);
    const Map map = flatten(mesh, seams, angles);
    if(map.report.status == SMP::Diagnosis::WRONG_ANGLE_SUM)
      BOOST_TEST((map.offending == std::vector<Vertex>{cone}));
    BOOST_TEST(!map.report.message.empty());
    return map.report.status;
  };
  BOOST_TEST(diagnosis(-1) == SMP::Diagnosis::WRONG_ANGLE_SUM);
  BOOST_TEST(diagnosis(0) == SMP::Diagnosis::WRONG_ANGLE_SUM);
  BOOST_TEST(diagnosis(std::nan("")) == SMP::Diagnosis::WRONG_ANGLE_SUM);
  BOOST_TEST(diagnosis(-SMP::free_cone_angle) == SMP::Diagnosis::WRONG_ANGLE_SUM);
  BOOST_TEST(diagnosis(mesh.degree(cone) * pi) == SMP::Diagnosis::WRONG_ANGLE_SUM);
  BOOST_TEST(diagnosis(right + 2e-6) == SMP::Diagnosis::WRONG_ANGLE_TOTAL);
  BOOST_TEST(diagnosis(right - 2e-6) == SMP::Diagnosis::WRONG_ANGLE_TOTAL);
  angles.set(cone, right + 5e-7);
  check_map(mesh, seams, angles, flatten(mesh, seams, angles));
  angles.set(cone, right);
  for(Vertex v : mesh.vertices())
    if(!is_on_seam(mesh, seams, v)) {
      cone = v;
      break;
    }
  BOOST_TEST(diagnosis(6) == SMP::Diagnosis::WRONG_ANGLE_SUM);
}

BOOST_FIXTURE_TEST_CASE(that_leave_nothing_to_a_free_cone_are_refused, Sphere_with_cones)
{
  Vertex other = cone;
  for(Vertex v : mesh.vertices())
    if(angles[v] && v != cone)
      other = v;
  angles.set(other, *angles[other] + *angles[cone] + 0.01);
  angles.set(cone, SMP::free_cone_angle);
  const Map map = flatten(mesh, seams, angles);
  BOOST_TEST((map.report.status == SMP::Diagnosis::WRONG_ANGLE_TOTAL ||
              map.report.status == SMP::Diagnosis::WRONG_ANGLE_SUM));
  BOOST_TEST(!map.offending.empty());
}

BOOST_FIXTURE_TEST_CASE(need_equal_seams, Sphere_with_cones)
{
  Options options;
  options.equal_seam_lengths = false;
  BOOST_TEST(flatten(mesh, seams, angles, options).report.status == SMP::Diagnosis::WRONG_OPTION);
}

// Copies of a vertex have keys of their own, and must have the same sum.
BOOST_FIXTURE_TEST_CASE(of_copies_agree, Sphere_with_cones)
{
  typedef boost::graph_traits<Seam_mesh>::vertex_descriptor Copy;
  Options options;
  options.equal_seam_lengths = true;
  const auto of_copies = boost::make_function_property_map<Copy>(
      [&](const Copy& v) { return angles[mesh.target(Halfedge(v))]; });
  const Map map = flatten(mesh, seams, of_copies, options);
  check_map(mesh, seams, angles, map);
  BOOST_TEST((map.uv == flatten(mesh, seams, angles).uv));

  Vertex inner = cone;
  for(Vertex v : mesh.vertices()) {
    int degree = 0;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      degree += seams[mesh.edge(h)];
    if(angles[v] && degree > 1)
      inner = v;
  }
  std::optional<Copy> first;
  const auto of_one = boost::make_function_property_map<Copy>([&](const Copy& v) {
    std::optional<double> sum = angles[mesh.target(Halfedge(v))];
    if(mesh.target(Halfedge(v)) == inner && !first)
      first = v;
    if(first && *first == v)
      sum = *sum + 0.01;
    return sum;
  });
  BOOST_TEST(flatten(mesh, seams, of_one, options).report.status == SMP::Diagnosis::WRONG_ANGLE_SUM);
}

BOOST_FIXTURE_TEST_CASE(are_an_error_without_convergence, Sphere_with_cones)
{
  for(bool fallbacks : {false, true}) {
    Options options;
    options.max_iterations = 1;
    options.fallbacks = fallbacks;
    const Map map = flatten(mesh, seams, angles, options);
    BOOST_TEST((map.report.status == SMP::Diagnosis::NO_CONVERGENCE ||
                map.report.status == SMP::Diagnosis::FLIPPED_TRIANGLES));
  }
}

namespace {

// Fails at a call of the solver.
struct Faulty_traits : CGAL::SuperLU_solver_traits<>
{
  typedef CGAL::SuperLU_solver_traits<> Base;

  bool factor(const Matrix& a, NT& d) { return --*calls_left != 0 && Base::factor(a, d); }
  bool linear_solver(const Vector& b, Vector& x) { return --*calls_left != 0 && Base::linear_solver(b, x); }

  std::shared_ptr<int> calls_left = std::make_shared<int>(0);
};

} // namespace

// A failure at any call is an error or does no harm, and no coordinates are written.
BOOST_FIXTURE_TEST_CASE(survive_failures_of_the_solver, Sphere_with_cones)
{
  int failures = 0;
  for(int call = 1; call < 100; ++call) {
    Seam_mesh cut = TA::make_seam_mesh(mesh, seams).mesh;
    const UV_map uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:faulty_uv").first;
    for(Halfedge h : mesh.halfedges())
      put(uv, h, Kernel::Point_2(7, 7));
    Faulty_traits traits;
    *traits.calls_left = call;
    SMP::ABF_plus_plus_parameterizer_3<Seam_mesh, Faulty_traits> parameterizer(Options(), traits);
    parameterizer.set_angle_sums(angles);
    const SMP::Error_code code = SMP::parameterize(cut, parameterizer, TA::border_halfedge(cut), uv);
    const auto all = mesh.halfedges();
    const bool is_written =
        std::any_of(all.begin(), all.end(), [&](Halfedge h) { return get(uv, h) != Kernel::Point_2(7, 7); });
    BOOST_TEST(is_written == (code == SMP::OK));
    if(code == SMP::OK) {
      BOOST_TEST(parameterizer.report().largest_angle_error < 2e-5);
      BOOST_TEST(parameterizer.report().largest_seam_jump < 2e-5);
    } else {
      BOOST_TEST(parameterizer.report().status == SMP::Diagnosis::LINEAR_SYSTEM_FAILED);
      ++failures;
    }
    if(*traits.calls_left > 0)
      break;
  }
  BOOST_TEST(failures > 0);
}

// Of the property map
BOOST_FIXTURE_TEST_CASE(pass_exceptions_through, Sphere_with_cones)
{
  int calls_left = 5;
  const auto throwing = boost::make_function_property_map<Vertex>([&](Vertex v) {
    if(--calls_left == 0)
      throw std::runtime_error("get");
    return angles[v];
  });
  BOOST_CHECK_THROW(flatten(mesh, seams, throwing), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
