// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cones: seams that reach given vertices, the choice of cones, and maps with cones.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"
#include "test_data.h"
#include "test_options.h"

#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/select_cones.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cones)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using namespace seam_surfaces;
using TA::Seam_report;
using TA::Cone_options;
using SMP::Diagnosis;
typedef Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Edge, bool> Seam_map;
typedef TA::Cone_selection<Mesh> Selection;
typedef TA::Cone_report Cone_report;
typedef TA::Cone_flattening<Mesh> Cone_flattening;
typedef Mesh::Property_map<Halfedge, Kernel::Point_2> UV_map;

namespace {

Seam_map add_seams(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:seam", false).first;
}

std::size_t seams_at(const Mesh& mesh, Seam_map seams, Vertex v)
{
  std::size_t number = 0;
  for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    number += seams[mesh.edge(h)];
  return number;
}

std::set<Vertex> random_vertices(const Mesh& mesh, std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  std::set<Vertex> chosen;
  while(chosen.size() < (std::min)(number, static_cast<std::size_t>(mesh.number_of_vertices())))
    chosen.insert(Vertex(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())));
  return chosen;
}

// The set must live as long as the parameters.
auto through(const std::set<Vertex>& terminals)
{
  return parameters::vertex_is_constrained_map(CGAL::make_boolean_property_map(terminals));
}

std::vector<Vertex> in_order(const Selection& selection)
{
  std::vector<Vertex> result;
  for(const auto& cone : selection.cones)
    result.push_back(cone.first);
  return result;
}

void check_disk(const Mesh& mesh, Seam_map seams, const Seam_report& report)
{
  BOOST_TEST_REQUIRE(report.message == "");
  const auto check = TA::is_disk_cut(mesh, seams);
  BOOST_TEST(bool(check), check.message);
  BOOST_TEST(report.number_of_disks == report.number_of_components);
}

// Bends a surface, so that no two vertices are alike.
Surface bent(Surface surface, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  double a[3][5];
  for(auto& row : a)
    for(double& x : row)
      x = number(random);
  for(Point_3& p : surface.points) {
    double q[3] = {p.x(), p.y(), p.z()};
    for(int i = 0; i < 3; ++i)
      q[i] += 0.25 * std::sin(2 * (a[i][0] * p.x() + a[i][1] * p.y() + a[i][2] * p.z()) + 3 * a[i][3]) +
              a[i][4] * 0.1 * p[(i + 1) % 3];
    p = Point_3(q[0], q[1], q[2]);
  }
  surface.name += " bent by " + std::to_string(seed);
  return surface;
}

// The half of a sphere: a disk
Surface cap(int levels)
{
  Surface result = sphere(levels);
  std::vector<Polygon> faces;
  for(const Polygon& f : result.faces)
    if(result.points[f[0]].z() + result.points[f[1]].z() + result.points[f[2]].z() > -0.3)
      faces.push_back(f);
  result.faces = std::move(faces);
  result.name = "cap";
  result.borders = 1;
  return result;
}

std::vector<Surface> surfaces_for_cones()
{
  std::vector<Surface> all = {sphere(3), torus(24, 16),           slab(2),    slab(3),
                              cap(3),    sphere_with_holes(3, 1), tube(12, 9)};
  subdivide(all[2], 2);
  subdivide(all[3], 2);
  std::vector<Surface> result;
  for(const Surface& surface : all)
    for(unsigned seed = 0; seed < 3; ++seed)
      result.push_back(bent(surface, seed));
  return result;
}

double characteristic(const Surface& surface)
{
  return 2 - 2 * static_cast<double>(surface.handles) - static_cast<double>(surface.borders);
}

// The scale of conformal maps, by a factorization for each system
class Slow_scale
{
public:
  explicit Slow_scale(const Mesh& mesh)
      : m_mesh(mesh), m_curvature(Eigen::VectorXd::Constant(size(), 2 * CGAL_PI)),
        m_area(Eigen::VectorXd::Zero(size())), m_laplacian(size(), size())
  {
    std::vector<Eigen::Triplet<double>> entries;
    for(auto f : mesh.faces())
      for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        const Vertex v = mesh.target(h), a = mesh.source(h), b = mesh.target(mesh.next(h));
        const Vector_3 p = mesh.point(a) - mesh.point(v), q = mesh.point(b) - mesh.point(v);
        const double twice_area = std::sqrt(CGAL::cross_product(p, q).squared_length()),
                     weight = (p * q) / twice_area / 2;
        m_curvature[v] -= std::atan2(twice_area, p * q);
        m_area[v] += twice_area / 6;
        for(const auto& [i, j] : {std::pair(a, b), std::pair(b, a)}) {
          entries.emplace_back(i, i, weight);
          entries.emplace_back(i, j, -weight);
        }
      }
    m_laplacian.setFromTriplets(entries.begin(), entries.end());
  }

  int size() const { return static_cast<int>(m_mesh.number_of_vertices()); }
  const Eigen::VectorXd& curvature() const { return m_curvature; }
  const Eigen::VectorXd& area() const { return m_area; }

  // L u = sources where vertices are not fixed, u = 0 where they are
  Eigen::VectorXd solve(const Eigen::VectorXd& sources, const std::vector<Vertex>& fixed) const
  {
    std::vector<char> is_fixed(m_mesh.number_of_vertices(), false);
    for(Vertex v : m_mesh.vertices())
      is_fixed[v] = m_mesh.is_border(v) || std::find(fixed.begin(), fixed.end(), v) != fixed.end();
    Eigen::SparseMatrix<double> matrix = m_laplacian;
    matrix.prune([&](int i, int j, double) { return i == j || (!is_fixed[i] && !is_fixed[j]); });
    Eigen::VectorXd right_hand_side = sources;
    for(int v = 0; v < size(); ++v)
      if(is_fixed[v]) {
        matrix.coeffRef(v, v) = 1;
        right_hand_side[v] = 0;
      }
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right_hand_side);
  }

  // What the scale leaves of the curvature: at cones their charges
  Eigen::VectorXd left(const Eigen::VectorXd& u) const { return m_curvature + m_laplacian * u; }

  // Mean square of the scale that charges give, without its mean
  double variance(const std::vector<Vertex>& cones, const std::vector<double>& charges) const
  {
    Eigen::VectorXd sources = -m_curvature;
    for(std::size_t i = 0; i < cones.size(); ++i)
      sources[cones[i]] += charges[i];
    const Eigen::VectorXd u =
        solve(sources, CGAL::is_closed(m_mesh) ? std::vector<Vertex>{Vertex(7)} : std::vector<Vertex>());
    const double mean = m_area.dot(u) / m_area.sum();
    return m_area.dot(u.cwiseProduct(u)) / m_area.sum() - mean * mean;
  }

private:
  const Mesh& m_mesh;
  Eigen::VectorXd m_curvature, m_area;
  Eigen::SparseMatrix<double> m_laplacian;
};

void check_angles(const Mesh& mesh, const Surface& surface, const Selection& selection)
{
  double charge = 0;
  std::set<Vertex> different;
  for(const auto& [v, angle] : selection.cones) {
    BOOST_TEST(angle > 0);
    BOOST_TEST(angle < static_cast<double>(mesh.degree(v)) * CGAL_PI);
    BOOST_TEST(!mesh.is_border(v));
    charge += 2 * CGAL_PI - angle;
    different.insert(v);
  }
  BOOST_TEST(different.size() == selection.cones.size());
  if(surface.borders == 0)
    BOOST_TEST(std::abs(charge - 2 * CGAL_PI * characteristic(surface)) < 1e-12);
}

UV_map add_coordinates(Mesh& mesh)
{
  return mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv", Kernel::Point_2(7, 7)).first;
}

// A surface with a map, as the caller sees it
struct Mapped_surface
{
  const Mesh& mesh;
  Seam_map seams;
  UV_map uv;

  std::complex<double> at(Halfedge h) const { return {uv[h].x(), uv[h].y()}; }

  // The similarity from the left side of a seam to its right side, but for a translation
  std::complex<double> across(Halfedge h) const
  {
    const Halfedge g = mesh.opposite(h);
    return (at(mesh.prev(g)) - at(g)) / (at(h) - at(mesh.prev(h)));
  }

  double angle_sum(Vertex v) const
  {
    double sum = 0;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(!mesh.is_border(h))
        sum += std::arg((at(mesh.prev(h)) - at(h)) / (at(mesh.next(h)) - at(h)));
    return sum;
  }

  void check_orientations() const
  {
    typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact;
    for(auto f : mesh.faces()) {
      const Halfedge h = mesh.halfedge(f);
      const auto point = [&](Halfedge g) { return Exact::Point_2(uv[g].x(), uv[g].y()); };
      BOOST_TEST((CGAL::orientation(point(h), point(mesh.next(h)), point(mesh.prev(h))) == CGAL::LEFT_TURN));
    }
  }

  // Lengths are equal everywhere; with rigid motions, turns too, from each cone or branch to the next.
  void check_seams(const Cone_flattening& result, bool is_rigid) const
  {
    const auto angles = result.cones.angles();
    double jump = 0, turn = 0, error = 0;
    for(Edge e : mesh.edges())
      if(seams[e])
        jump = (std::max)(jump, std::abs(std::log(std::abs(across(mesh.halfedge(e))))));
    for(Vertex v : mesh.vertices()) {
      if(mesh.is_border(v))
        continue;
      const std::size_t number = seams_at(mesh, seams, v);
      BOOST_TEST((!angles[v] || number > 0));
      if(is_rigid || number == 0)
        error = (std::max)(error, std::abs(angle_sum(v) - angles[v].value_or(2 * CGAL_PI)));
      std::vector<Halfedge> in;
      for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
        if(seams[mesh.edge(h)])
          in.push_back(h);
      if(in.size() == 2 && !angles[v])
        turn = (std::max)(turn, std::abs(std::arg(across(in[0]) / across(mesh.opposite(in[1])))));
    }
    BOOST_TEST(jump < 1e-5);
    BOOST_TEST(error < 1e-5);
    BOOST_TEST(std::abs(result.map.largest_seam_jump - jump) < 1e-12);
    if(is_rigid) {
      BOOST_TEST(turn < 1e-5);
      BOOST_TEST(result.map.largest_seam_turn > turn - 1e-12); // also counts branches
      BOOST_TEST(result.map.prescribed_angles == static_cast<int>(result.cones.cones.size()));
    }
  }
};

TA::Cone_angles angles(bool are_free)
{
  return are_free ? TA::Cone_angles::FREE : TA::Cone_angles::PREDICTED;
}

Cone_flattening check_map(Mesh& mesh, const Surface& surface, std::size_t n, bool is_free)
{
  const Mapped_surface map{mesh, add_seams(mesh), add_coordinates(mesh)};
  const Cone_flattening result = TA::flatten_with_cones(
      mesh, n, map.seams, map.uv, with<Cone_options>(&Cone_options::angles, angles(is_free)));
  BOOST_TEST_REQUIRE(result.message == "");
  BOOST_TEST(to_string(result.status) == "NOTHING_WRONG");
  BOOST_TEST(result.cones.cones.size() == n);
  BOOST_TEST(result.map.converged);
  if(!is_free)
    check_angles(mesh, surface, result.cones);
  check_disk(mesh, map.seams, result.seams);
  map.check_orientations();
  map.check_seams(result, !is_free);
  const auto cut = TA::make_seam_mesh(mesh, map.seams).mesh;
  BOOST_TEST(SMP::measure_flattening(cut, TA::border_halfedge(cut), map.uv).flipped_triangles == 0);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(seams_reach_all_terminals)
{
  for(unsigned seed = 0; seed < 120; ++seed) {
    const Surface surface = random_surface(seed);
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    const std::set<Vertex> terminals = random_vertices(mesh, seed % 7, seed);
    BOOST_TEST_INFO_SCOPE("seed " << seed << ", " << surface.name << ", " << terminals.size()
                                  << " terminals");
    check_disk(mesh, seams, TA::cut_to_disks(mesh, seams, through(terminals)));
    for(Vertex v : terminals)
      BOOST_TEST((mesh.is_border(v) || seams_at(mesh, seams, v) > 0));
    if(surface.handles == 0 && surface.borders == 0 && terminals.size() >= 2)
      for(Vertex v : mesh.vertices()) // a tree, whose leaves are terminals
        BOOST_TEST((seams_at(mesh, seams, v) != 1 || terminals.count(v) == 1));
  }
}

// All vertices are alike at first.
BOOST_AUTO_TEST_CASE(of_regular_polyhedra)
{
  for(const Surface& surface : {tetrahedron(), octahedron(), icosahedron()}) {
    BOOST_TEST_INFO_SCOPE(surface.name);
    const Mesh mesh = surface.mesh();
    const auto cones = TA::select_cones(mesh, 4);
    BOOST_TEST(cones.status == Diagnosis::NOTHING_WRONG, cones.message);
    double total = 0;
    for(const auto& cone : cones.cones)
      total += 2 * CGAL_PI - cone.second;
    BOOST_TEST(std::abs(total - 4 * CGAL_PI) < 1e-12);
  }
}

// On a sphere, the shortest path between two vertices joins them, or the second shortest if the former is an edge.
BOOST_AUTO_TEST_CASE(seams_between_two_terminals)
{
  for(const Surface& surface : {tetrahedron(), icosahedron(), sphere(2)}) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    const Halfedge h = mesh.halfedge(Edge(static_cast<Mesh::size_type>(mesh.number_of_edges() / 3)));
    const std::vector<Vertex> ends = {mesh.source(h), mesh.target(h)};
    const std::set<Vertex> both(ends.begin(), ends.end());
    const auto report = TA::cut_to_disks(mesh, seams, through(both));
    check_disk(mesh, seams, report);
    BOOST_TEST(report.number_of_terminals == 2u);
    BOOST_TEST(seams_at(mesh, seams, ends[0]) == 1u);
    BOOST_TEST(seams_at(mesh, seams, ends[1]) == 1u);
    const std::vector<Vertex> opposite = {mesh.target(mesh.next(h)),
                                          mesh.target(mesh.next(mesh.opposite(h)))};
    BOOST_TEST(seams_at(mesh, seams, opposite[0]) + seams_at(mesh, seams, opposite[1]) == 2u);
  }
}

BOOST_AUTO_TEST_CASE(seams_of_several_parts)
{
  Mesh mesh = sphere(2).mesh();
  CGAL::copy_face_graph(slab(2).mesh(), mesh);
  CGAL::copy_face_graph(sphere_with_holes(2, 3).mesh(), mesh);
  const std::set<Vertex> terminals = random_vertices(mesh, 20, 5);
  const Seam_map seams = add_seams(mesh);
  const auto report = TA::cut_to_disks(mesh, seams, through(terminals));
  check_disk(mesh, seams, report);
  BOOST_TEST(report.number_of_components == 3u);
  for(Vertex v : terminals)
    BOOST_TEST((mesh.is_border(v) || seams_at(mesh, seams, v) > 0));
}

// Seams that are there already stay, and are not left for a terminal on them.
BOOST_AUTO_TEST_CASE(terminals_on_seams)
{
  Mesh mesh = torus(12, 8).mesh();
  const Seam_map seams = add_seams(mesh);
  TA::cut_to_disks(mesh, seams);
  std::vector<bool> before;
  std::set<Vertex> terminals;
  for(Edge e : mesh.edges()) {
    before.push_back(seams[e]);
    if(seams[e])
      terminals.insert(mesh.target(mesh.halfedge(e)));
  }
  check_disk(mesh, seams, TA::cut_to_disks(mesh, seams, through(terminals)));
  for(Edge e : mesh.edges())
    BOOST_TEST(seams[e] == before[e.idx()]);
}

BOOST_AUTO_TEST_CASE(terminals_that_cannot_be_reached)
{
  for(const Surface& surface : {sphere(2), torus(12, 8), sphere_with_holes(2, 1)}) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    const auto is_forbidden = mesh.add_property_map<Edge, bool>("e:forbidden", false).first;
    Vertex walled(0);
    while(mesh.is_border(walled))
      ++walled;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(walled)))
      is_forbidden[mesh.edge(h)] = true;
    const Vertex other = mesh.target(mesh.next(mesh.next(mesh.opposite(mesh.next(mesh.halfedge(walled))))));
    for(const std::set<Vertex>& terminals : {std::set<Vertex>{walled}, {other, walled}}) {
      const auto report =
          TA::cut_to_disks(mesh, seams, through(terminals).edge_is_constrained_map(is_forbidden));
      BOOST_TEST(report.status == Diagnosis::NO_CUT_ALLOWED);
      BOOST_TEST(report.message.find("must be reached") != std::string::npos);
      for(Edge e : mesh.edges())
        BOOST_TEST(!seams[e]);
    }
    const std::set<Vertex> lonely = {other, mesh.add_vertex(Point_3(9, 9, 9))};
    const auto report = TA::cut_to_disks(mesh, seams, through(lonely));
    BOOST_TEST(report.status == Diagnosis::WRONG_OPTION);
    BOOST_TEST(report.message.find("vertex " + std::to_string(mesh.number_of_vertices() - 1) +
                                   " (9, 9, 9) has no face") == 0u);
  }
}

// The same as with a factorization for each cone
BOOST_AUTO_TEST_CASE(cones_are_those_of_the_slow_rule)
{
  for(const Surface& surface : surfaces_for_cones()) {
    BOOST_TEST_INFO_SCOPE(surface.name);
    const Mesh mesh = surface.mesh();
    const Slow_scale slow(mesh);
    std::vector<Vertex> cones;
    Eigen::VectorXd u;
    for(int i = 0; i < 24; ++i) {
      if(i > 0 || surface.borders > 0)
        u = slow.solve(-slow.curvature(), cones);
      else {
        u = slow.solve(slow.curvature().sum() / slow.area().sum() * slow.area() - slow.curvature(),
                       {Vertex(3)});
        u.array() -= slow.area().dot(u) / slow.area().sum();
      }
      int largest = 0;
      u.cwiseAbs().maxCoeff(&largest);
      cones.emplace_back(static_cast<Mesh::size_type>(largest));
    }
    u = slow.solve(-slow.curvature(), cones);
    const Eigen::VectorXd charges = slow.left(u);
    const Selection selection = TA::select_cones(mesh, 24);
    BOOST_TEST_REQUIRE(selection.message == "");
    check_angles(mesh, surface, selection);
    BOOST_TEST((in_order(selection) == cones));
    for(const auto& [v, angle] : selection.cones)
      BOOST_TEST(std::abs(2 * CGAL_PI - angle - charges[v]) < 1e-9);
    const Eigen::VectorXd shrunk = (-2 * u).array().exp(), grown = (2 * u).array().exp();
    BOOST_TEST(selection.predicted_stretch ==
                   std::sqrt(slow.area().dot(shrunk) * slow.area().dot(grown)) / slow.area().sum(),
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(least_squares_vary_least)
{
  int found = 0;
  for(const Surface& surface : surfaces_for_cones()) {
    BOOST_TEST_INFO_SCOPE(surface.name);
    const Mesh mesh = surface.mesh();
    const Selection predicted = TA::select_cones(mesh, 12),
                    least = TA::select_cones(
                        mesh, 12, with<Cone_options>(&Cone_options::angles, TA::Cone_angles::LEAST_SQUARES));
    BOOST_TEST_REQUIRE(predicted.message == "");
    if(least.status == Diagnosis::INFEASIBLE_ANGLE_SUMS)
      continue;
    BOOST_TEST_REQUIRE(least.message == "");
    ++found;
    check_angles(mesh, surface, least);
    BOOST_TEST((in_order(least) == in_order(predicted)));
    const Slow_scale slow(mesh);
    const auto charges = [](const Selection& selection) {
      std::vector<double> result;
      for(const auto& cone : selection.cones)
        result.push_back(2 * CGAL_PI - cone.second);
      return result;
    };
    const double best = slow.variance(in_order(least), charges(least));
    BOOST_TEST(best < slow.variance(in_order(least), charges(predicted)));
    for(std::size_t i = 0; i < least.cones.size(); ++i)
      for(double step : {-0.1, 0.1}) {
        std::vector<double> others = charges(least);
        others[i] += step;
        if(surface.borders == 0)
          others[(i + 1) % others.size()] -= step;
        BOOST_TEST(best < slow.variance(in_order(least), others));
      }
  }
  BOOST_TEST(found > 15);
}

BOOST_AUTO_TEST_CASE(angles_are_multiples_of_a_quantum)
{
  int found = 0;
  for(int turn : {3, 4, 6, 12})
    for(unsigned seed = 0; seed < 8; ++seed)
      for(const Surface& surface : {bent(sphere(3), seed), bent(cap(3), seed)}) {
        BOOST_TEST_INFO_SCOPE(surface.name << ", 2 pi / " << turn);
        const Mesh mesh = surface.mesh();
        const double quantum = 2 * CGAL_PI / turn;
        const Selection any = TA::select_cones(mesh, 8),
                        selection = TA::select_cones(
                            mesh, 8, with<Cone_options>(&Cone_options::angle_multiple, quantum));
        if(selection.status == Diagnosis::INFEASIBLE_ANGLE_SUMS)
          continue;
        BOOST_TEST_REQUIRE(selection.message == "");
        ++found;
        check_angles(mesh, surface, selection);
        const auto angles = any.angles();
        for(const auto& [v, angle] : selection.cones) {
          BOOST_TEST(std::abs(std::remainder(angle, quantum)) < 1e-12);
          BOOST_TEST(std::abs(angle - 2 * CGAL_PI) > 1e-6);
          BOOST_TEST_REQUIRE(angles[v].has_value());
          BOOST_TEST(std::abs(*angles[v] - angle) < (surface.borders == 1 ? 0.5 : 1.) * quantum + 1e-9);
        }
      }
  BOOST_TEST(found > 40);
}

BOOST_AUTO_TEST_CASE(what_has_no_cones)
{
  const auto check = [](const Mesh& mesh, std::size_t n, const Cone_options& options, Diagnosis diagnosis,
                        const std::string& part) {
    const Selection selection = TA::select_cones(mesh, n, options);
    BOOST_TEST(to_string(selection.status) == to_string(diagnosis));
    BOOST_TEST(selection.message.find(part) != std::string::npos, selection.message);
    BOOST_TEST(selection.cones.empty());
    return selection;
  };
  const Cone_options none;
  const Mesh ball = bent(sphere(2), 1).mesh(), ring = torus(12, 8).mesh(), pipe = tube(12, 9).mesh();
  check(Mesh(), 8, none, Diagnosis::EMPTY_MESH, "no faces");
  check(ball, 1001, none, Diagnosis::WRONG_OPTION, "1001 cones");
  for(double wrong :
      {-1., 1., 7., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    check(ball, 8, with<Cone_options>(&Cone_options::angle_multiple, wrong), Diagnosis::WRONG_OPTION,
          "2 pi is not a multiple");
  }
  check(ring, 8, with<Cone_options>(&Cone_options::angle_multiple, CGAL_PI / 2), Diagnosis::WRONG_TOPOLOGY,
        "only on a sphere or a disk");
  check(pipe, 8, with<Cone_options>(&Cone_options::angle_multiple, CGAL_PI / 2), Diagnosis::WRONG_TOPOLOGY,
        "only on a sphere or a disk");
  check(ball, 0, none, Diagnosis::INFEASIBLE_ANGLE_SUMS, "needs cones");
  for(std::size_t n : {1, 2})
    BOOST_TEST(check(ball, n, none, Diagnosis::INFEASIBLE_ANGLE_SUMS, "the cone at vertex ")
                   .offending_vertices.size() >= 1u);
  check(ball, 3, with<Cone_options>(&Cone_options::angle_multiple, 2 * CGAL_PI),
        Diagnosis::INFEASIBLE_ANGLE_SUMS, "no multiples");
  BOOST_TEST(TA::select_cones(ring, 0).message == "");
  BOOST_TEST(TA::select_cones(pipe, 0).message == "");

  Mesh two = ball;
  CGAL::copy_face_graph(ring, two);
  BOOST_TEST(check(two, 8, none, Diagnosis::SEVERAL_COMPONENTS, "the face at vertex ")
                 .offending_faces.front()
                 .idx() == ball.number_of_faces());

  Mesh pinched = ball;
  const Halfedge last = pinched.halfedge(Vertex(pinched.number_of_vertices() - 1));
  const Vertex gone = pinched.target(last);
  for(Halfedge h : pinched.halfedges_around_target(last))
    pinched.set_target(h, Vertex(0));
  pinched.remove_vertex(gone);
  BOOST_TEST((check(pinched, 8, none, Diagnosis::NON_MANIFOLD_VERTEX, "vertex 0 (").offending_vertices ==
              std::vector<Vertex>{Vertex(0)}));

  Mesh infinite = ball;
  infinite.point(Vertex(3)) = Point_3(0, std::numeric_limits<double>::infinity(), 0);
  check(infinite, 8, none, Diagnosis::NON_FINITE_POINT, "inf");

  Mesh quad;
  quad.add_face(quad.add_vertex({0, 0, 0}), quad.add_vertex({1, 0, 0}), quad.add_vertex({1, 1, 0}),
                quad.add_vertex({0, 1, 0}));
  check(quad, 8, none, Diagnosis::NOT_TRIANGULATED, "not a triangle");
}

// A disk in the plane needs no cone.
BOOST_AUTO_TEST_CASE(flat_disks_get_no_cones)
{
  Surface plane;
  for(int i = 0; i < 100; ++i)
    plane.points.emplace_back(i / 10, i % 10, 0);
  for(std::size_t i = 0; i < 9; ++i)
    for(std::size_t j = 0; j < 9; ++j)
      plane.faces.push_back({10 * i + j, 10 * i + j + 10, 10 * i + j + 11, 10 * i + j + 1});
  triangulate(plane);
  const Selection selection = TA::select_cones(plane.mesh(), 8);
  BOOST_TEST(selection.message == "");
  BOOST_TEST(selection.cones.empty());
}

BOOST_AUTO_TEST_CASE(maps_go_on_across_seams)
{
  for(const Surface& surface : surfaces_for_cones())
    for(bool is_free : {false, true}) {
      BOOST_TEST_INFO_SCOPE(surface.name << (is_free ? ", free" : ""));
      Mesh mesh = surface.mesh();
      check_map(mesh, surface, 16, is_free);
    }
}

// A torus and a tube need no cones.
BOOST_AUTO_TEST_CASE(maps_without_cones)
{
  for(const Surface& surface : {torus(24, 16), bent(torus(24, 16), 1), cap(2), tube(12, 9)}) {
    BOOST_TEST_INFO_SCOPE(surface.name);
    Mesh mesh = surface.mesh();
    check_map(mesh, surface, 0, false);
  }
}

BOOST_AUTO_TEST_CASE(quarter_turns)
{
  int found = 0;
  for(unsigned seed = 0; seed < 8; ++seed)
    for(const Surface& surface : {bent(sphere(3), seed), bent(cap(3), seed)}) {
      BOOST_TEST_INFO_SCOPE(surface.name);
      Mesh mesh = surface.mesh();
      const Mapped_surface map{mesh, add_seams(mesh), add_coordinates(mesh)};
      const Cone_flattening result = TA::flatten_with_cones(
          mesh, 12, map.seams, map.uv, with<Cone_options>(&Cone_options::angle_multiple, CGAL_PI / 2));
      if(result.cones.status == Diagnosis::INFEASIBLE_ANGLE_SUMS)
        continue;
      ++found;
      BOOST_TEST_REQUIRE(result.message == "");
      map.check_orientations();
      map.check_seams(result, true);
      for(Edge e : mesh.edges())
        if(map.seams[e])
          BOOST_TEST(std::abs(std::remainder(std::arg(map.across(mesh.halfedge(e))), CGAL_PI / 2)) < 1e-5);
    }
  BOOST_TEST(found > 12);
}

BOOST_AUTO_TEST_CASE(what_has_no_map)
{
  Mesh mesh = bent(sphere(2), 1).mesh();
  const Seam_map seams = add_seams(mesh);
  const UV_map uv = add_coordinates(mesh);
  seams[Edge(5)] = true;
  enum Stage
  {
    CONES,
    SEAMS,
    MAP
  };
  const auto check_with = [&](std::size_t n, const Cone_options& options, const auto& np, Stage stage,
                              Diagnosis diagnosis, const std::string& part) {
    const Cone_flattening result = TA::flatten_with_cones(mesh, n, seams, uv, options, np);
    BOOST_TEST(result.status == diagnosis);
    BOOST_TEST(bool(result.cones) == (stage > CONES));
    BOOST_TEST(bool(result.seams) == (stage != SEAMS));
    BOOST_TEST(bool(result.map) == (stage < MAP));
    BOOST_TEST(result.message.find(part) != std::string::npos, result.message);
    for(Edge e : mesh.edges())
      BOOST_TEST(seams[e] == (e == Edge(5)));
    for(Halfedge h : mesh.halfedges())
      BOOST_TEST(uv[h] == Kernel::Point_2(7, 7));
  };
  const auto check = [&](std::size_t n, const Cone_options& options, Stage stage, Diagnosis diagnosis,
                         const std::string& part) {
    check_with(n, options, parameters::default_values(), stage, diagnosis, part);
  };
  check(1, Cone_options(), CONES, Diagnosis::INFEASIBLE_ANGLE_SUMS, "the cone at vertex ");
  check(8, with<Cone_options>(&Cone_options::angle_multiple, 1), CONES, Diagnosis::WRONG_OPTION,
        "2 pi is not a multiple");
  check(8,
        with<Cone_options>(&Cone_options::angle_multiple, CGAL_PI, &Cone_options::angles,
                           TA::Cone_angles::FREE),
        CONES, Diagnosis::WRONG_OPTION, "free angles");
  const auto forbidden = boost::make_function_property_map<Edge>([](Edge) { return true; });
  check_with(8, Cone_options(), parameters::edge_is_constrained_map(forbidden), SEAMS,
             Diagnosis::NO_CUT_ALLOWED, "cannot be cut to a disk");
  SMP::ABF_plus_plus_options options;
  options.equal_seam_lengths = false;
  check(8, with<Cone_options>(&Cone_options::parameterizer, options), MAP, Diagnosis::WRONG_OPTION,
        "equal lengths");
  options.equal_seam_lengths.reset();
  options.tolerance = -1;
  check(8, with<Cone_options>(&Cone_options::parameterizer, options), CONES, Diagnosis::WRONG_OPTION,
        "tolerance");
}

BOOST_AUTO_TEST_CASE(points_threads_and_coordinates)
{
  Mesh mesh = bent(sphere(3), 4).mesh(), twice = mesh;
  for(Vertex v : twice.vertices())
    twice.point(v) = CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN);
  const Seam_map seams = add_seams(mesh);
  const UV_map uv = add_coordinates(mesh),
               other = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:other").first;
  SMP::ABF_plus_plus_options options;
  options.threads = 1;
  BOOST_TEST(
      TA::flatten_with_cones(mesh, 8, seams, uv, with<Cone_options>(&Cone_options::parameterizer, options))
          .message == "");
  options.threads = 2;
  BOOST_TEST(
      TA::flatten_with_cones(mesh, 8, seams, other, with<Cone_options>(&Cone_options::parameterizer, options))
          .message == "");
  for(Halfedge h : mesh.halfedges())
    BOOST_TEST(uv[h] == other[h]);
  BOOST_TEST(TA::flatten_with_cones(mesh, 8, seams, other, Cone_options(),
                                    parameters::vertex_point_map(twice.points()))
                 .message == "");
  double area = 0, least_x = 1, least_y = 1;
  for(Halfedge h : mesh.halfedges()) {
    BOOST_TEST(std::abs(other[h].x() - 2 * uv[h].x()) + std::abs(other[h].y() - 2 * uv[h].y()) < 1e-12);
    least_x = (std::min)(least_x, uv[h].x());
    least_y = (std::min)(least_y, uv[h].y());
  }
  for(auto f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    area += CGAL::area(uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]);
  }
  BOOST_TEST(area == CGAL::Polygon_mesh_processing::area(mesh), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(least_x == 0);
  BOOST_TEST(least_y == 0);
}

// Other meshes, maps and solvers lead to the same cones.
BOOST_AUTO_TEST_CASE(polyhedra_and_other_solvers)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  typedef boost::graph_traits<Polyhedron> Traits;
  typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>
      Solver;
  const Surface surface = bent(sphere(3), 6);
  const Mesh mesh = surface.mesh();
  const Polyhedron polyhedron = surface.mesh<Polyhedron>();
  std::map<Traits::edge_descriptor, bool> seams;
  std::map<Traits::halfedge_descriptor, Kernel::Point_2> uv;
  const auto result = TA::flatten_with_cones(polyhedron, 8, boost::make_assoc_property_map(seams),
                                             boost::make_assoc_property_map(uv));
  BOOST_TEST_REQUIRE(result.message == "");
  BOOST_TEST(uv.size() == 3 * mesh.number_of_faces());
  BOOST_TEST(seams.size() == mesh.number_of_edges());
  const Selection expected = TA::select_cones(mesh, 8),
                  other =
                      TA::select_cones(mesh, 8, Cone_options(), parameters::sparse_linear_solver(Solver()));
  for(std::size_t i = 0; i < 8; ++i) {
    BOOST_TEST(mesh.point(expected.cones[i].first) == result.cones.cones[i].first->point());
    BOOST_TEST(std::abs(expected.cones[i].second - result.cones.cones[i].second) < 1e-9);
    BOOST_TEST((expected.cones[i].first == other.cones[i].first));
    BOOST_TEST(std::abs(expected.cones[i].second - other.cones[i].second) < 1e-9);
  }
}

// Faces without area, and vertices in one place: not all of these surfaces can be flattened.
BOOST_AUTO_TEST_CASE(degenerate_surfaces)
{
  int flattened = 0;
  for(double z : {0., 1e-200, 1e-9})
    for(unsigned seed = 0; seed < 6; ++seed) {
      Mesh mesh = bent(seed % 2 == 0 ? sphere(2) : cap(2), seed).mesh();
      std::mt19937 random(seed);
      for(Vertex v : mesh.vertices()) {
        const Point_3 p = mesh.point(v);
        if(seed < 4 ? random() % 3 == 0 : true)
          mesh.point(v) = Point_3(seed < 2 ? 0 : p.x(), seed < 4 ? 0 : p.y(), z * p.z());
      }
      const Seam_map seams = add_seams(mesh);
      const UV_map uv = add_coordinates(mesh);
      const Cone_flattening result = TA::flatten_with_cones(mesh, 6, seams, uv);
      BOOST_TEST(bool(result) == (result.message == ""));
      if(result.message == "") {
        ++flattened;
        Mapped_surface{mesh, seams, uv}.check_orientations();
      }
    }
  BOOST_TEST(flattened >= 12);
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

// The angles change as little as with a cut, and the surface fits together again.
BOOST_AUTO_TEST_CASE(models_with_cones)
{
  struct Model
  {
    const char* name;
    std::size_t cones;
    double largest_ratio;
  };
  std::vector<Model> models{{"cow.off", 8, 1.25}};
  if(std::getenv("ABF_TEST_QUICK") == nullptr)
    models.push_back({"camel.off", 16, 1.08});
  for(const Model& model : models) {
    Mesh mesh;
    BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::CGAL_meshes / model.name, mesh));
    const Surface ball = tetrahedron();
    const auto measures = [&](bool is_free, bool is_equal) {
      const Seam_map seams = add_seams(mesh);
      const UV_map uv = add_coordinates(mesh);
      SMP::ABF_plus_plus_options options;
      options.equal_seam_lengths = is_equal;
      const auto result = TA::flatten_with_cones(
          mesh, model.cones, seams, uv,
          with<Cone_options>(&Cone_options::angles, angles(is_free), &Cone_options::parameterizer, options));
      BOOST_TEST_REQUIRE(result.message == "");
      const auto cut = TA::make_seam_mesh(mesh, seams).mesh;
      return SMP::measure_flattening(cut, TA::border_halfedge(cut), uv);
    };
    BOOST_TEST_INFO_SCOPE(model.name);
    const SMP::Flattening_measures cut = measures(true, false), free = measures(true, true),
                                   rigid = measures(false, true);
    BOOST_TEST(free.angular_distortion <= 1.02 * cut.angular_distortion);
    BOOST_TEST(rigid.mean_quasi_conformal_ratio <= model.largest_ratio);
    BOOST_TEST(rigid.flipped_triangles == 0);
    check_map(mesh, ball, model.cones, true);
    check_map(mesh, ball, model.cones, false);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
