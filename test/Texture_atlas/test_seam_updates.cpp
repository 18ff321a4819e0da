// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// While seams grow, predicted scales and shortest paths are updated. They are those that are computed anew, and the
// updates are few: factorizations and visits of nodes are counted.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"
#include "test_options.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/grounded_laplacian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/seams/cut_topology.h>
#include <CGAL/Texture_atlas/internal/seams/log_scale.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_seams.h>
#include <CGAL/Texture_atlas/internal/seams/shorten_paths.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seam_updates)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
namespace parameters = CGAL::parameters;
using seam_surfaces::Surface;
using TA::Seam_options;
using TA::Seam_report;
typedef seam_surfaces::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Property_map<Edge, bool> Seam_map;

namespace {

struct Calls
{
  int factorizations = 0, solutions = 0;
};

// Counts what an object and its copies do.
class Counting_traits : public CGAL::SuperLU_solver_traits<>
{
  typedef CGAL::SuperLU_solver_traits<> Base;

public:
  explicit Counting_traits(Calls& calls) : m_calls(&calls) {}

  using Base::linear_solver;

  bool factor(const Matrix& A, NT& D)
  {
    ++m_calls->factorizations;
    return Base::factor(A, D);
  }

  bool linear_solver(const Vector& B, Vector& X)
  {
    ++m_calls->solutions;
    return Base::linear_solver(B, X);
  }

private:
  Calls* m_calls;
};

// Factors a matrix for each solution.
class Forgetful_traits
{
public:
  typedef CGAL::SuperLU_solver_traits<> Solver;
  typedef Solver::NT NT;
  typedef Solver::Vector Vector;
  typedef Solver::Matrix Matrix;

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    return Solver().linear_solver(A, B, X, D);
  }
};

// Of a connected surface, with costs of edges that make shortest paths unique
ABF::Surface_part part_of(const Mesh& mesh, unsigned seed)
{
  ABF::Surface_reader<Mesh, Mesh::Property_map<Mesh::Vertex_index, Mesh::Point>,
                      SMP::Mesh_report<Mesh, Seam_report>>
      reader(mesh, mesh.points());
  SMP::Mesh_report<Mesh, Seam_report> report;
  BOOST_TEST_REQUIRE(reader.read([](Edge) { return false; }, report));
  BOOST_TEST_REQUIRE(reader.parts().size() == 1u);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> factor(1, 1.5);
  BOOST_TEST_REQUIRE(reader.read_costs([&](Edge, double length) { return length * factor(random); }, report));
  return reader.parts().front();
}

// Symmetric surfaces, and the same ones out of shape
std::vector<Surface> surfaces()
{
  std::vector<Surface> result = {seam_surfaces::sphere(3), seam_surfaces::torus(20, 12),
                                 seam_surfaces::sphere_with_holes(1, 3)};
  for(unsigned seed = 0; seed < 20; ++seed)
    result.push_back(seam_surfaces::random_surface(seed));
  for(std::size_t i = 0, number = result.size(); i < number; ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    std::uniform_real_distribution<double> shift(-0.1, 0.1);
    Surface shaken = result[i];
    shaken.name = "shaken " + shaken.name;
    for(seam_surfaces::Point_3& p : shaken.points)
      p = seam_surfaces::Point_3(2 * p.x() + shift(random), p.y() + shift(random), p.z() + shift(random));
    result.push_back(shaken);
  }
  return result;
}

} // namespace

// Whether seams were predicted by updates or by one factorization for each terminal, they are the same. Where a surface
// is symmetric, rounding does not choose the terminals.
BOOST_AUTO_TEST_CASE(seams_do_not_depend_on_the_way_of_prediction)
{
  for(const Surface& surface : surfaces()) {
    Mesh mesh = surface.mesh();
    const Seam_map updated = mesh.add_property_map<Edge, bool>("e:updated", false).first,
                   anew = mesh.add_property_map<Edge, bool>("e:anew", false).first;
    const auto options = with<Seam_options>(&Seam_options::stretch_bound, 1.03);
    const auto report = TA::select_seams(mesh, updated, options);
    const auto expected =
        TA::select_seams(mesh, anew, options, parameters::sparse_linear_solver(Forgetful_traits()));
    BOOST_TEST_INFO_SCOPE(surface.name);
    BOOST_TEST_REQUIRE(expected.message == "");
    BOOST_TEST(report.number_of_terminals == expected.number_of_terminals);
    BOOST_TEST(report.predicted_stretch == expected.predicted_stretch, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(
        std::all_of(mesh.edges_begin(), mesh.edges_end(), [&](Edge e) { return updated[e] == anew[e]; }));
  }
}

// Exchanges can change many seams at once. Then the matrix is factored again.
BOOST_AUTO_TEST_CASE(few_factorizations_for_many_terminals)
{
  for(const Surface& surface :
      {seam_surfaces::sphere(3), seam_surfaces::sphere(4), seam_surfaces::sphere_with_holes(1, 3),
       seam_surfaces::slab(0), seam_surfaces::torus(40, 20), seam_surfaces::sphere_with_holes(5, 3)})
    for(int terminals : {4, 12, 36}) {
      Mesh mesh = surface.mesh();
      Calls calls;
      const Seam_map seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
      const auto report =
          TA::select_seams(mesh, seams,
                           with<Seam_options>(&Seam_options::stretch_bound, 1.0001,
                                              &Seam_options::maximum_number_of_terminals, terminals),
                           parameters::sparse_linear_solver(Counting_traits(calls)));
      BOOST_TEST_INFO_SCOPE(surface.name << ", " << terminals << " terminals");
      BOOST_TEST_REQUIRE(report.message == "");
      BOOST_TEST(calls.factorizations >= 1);
      BOOST_TEST(calls.factorizations <= (surface.handles == 0 && surface.borders == 1 ? 1 : 3));
    }
}

namespace {

// Opens a surface to a disk.
TA::internal::Sector_graph disk(const ABF::Surface_part& part)
{
  TA::internal::Sector_graph result(part.chart);
  BOOST_TEST_REQUIRE(TA::internal::Topological_cut(result, part.cost).run());
  return result;
}

std::vector<int> key_path(TA::internal::Sector_graph& surface, const ABF::Surface_part& part,
                          const std::vector<int>& terminals, unsigned number)
{
  const auto paths = TA::internal::Path_shortening(surface, part.cost, terminals).key_paths();
  return paths[number % paths.size()];
}

std::vector<bool> marks(const TA::internal::Sector_graph& surface)
{
  std::vector<bool> result;
  for(int c = 0; c < surface.surface().number_of_corners(); ++c)
    result.push_back(surface.is_seam(c));
  return result;
}

std::vector<int> random_vertices(const ABF::Chart& chart, std::size_t number, std::mt19937& random)
{
  std::vector<int> result(chart.number_of_vertices());
  std::iota(result.begin(), result.end(), 0);
  std::shuffle(result.begin(), result.end(), random);
  result.resize((std::min)(number, result.size()));
  return result;
}

} // namespace

// Paths to terminals become seams, and others are no longer seams.
BOOST_AUTO_TEST_CASE(nearest_seams_are_those_found_anew)
{
  for(const Surface& surface : surfaces()) {
    const ABF::Surface_part part = part_of(surface.mesh(), 2);
    TA::internal::Sector_graph opened = disk(part);
    TA::internal::Nearest_seams nearest(opened, part.cost);
    nearest.find();
    std::mt19937 random(3);
    std::vector<int> terminals;
    for(int step = 0; step < 20; ++step) {
      std::vector<int> inside;
      for(int x = 0; x < opened.number_of_nodes(); ++x)
        if(opened.is_node(x) && !opened.is_on_border(x))
          inside.push_back(x);
      if(!inside.empty()) {
        const int terminal = inside[random() % inside.size()];
        terminals.push_back(opened.vertex(terminal));
        nearest.open(nearest.path(terminal));
      }
      const std::vector<int> closed = key_path(opened, part, terminals, random());
      if(step % 3 == 0) {
        nearest.close(closed);
        nearest.open(closed);
      } else {
        nearest.close(closed, step % 3 == 1 ? 0.5 : 2);
        nearest.reopen(closed);
      }
      TA::internal::Nearest_seams expected(opened, part.cost);
      expected.find();
      BOOST_TEST_CONTEXT(surface.name << ", step " << step)
      for(int x = 0; x < opened.number_of_nodes(); ++x)
        if(opened.is_node(x)) {
          BOOST_TEST_REQUIRE(nearest.distance(x) == expected.distance(x));
          BOOST_TEST_REQUIRE(nearest.last_edge(x) == expected.last_edge(x));
          BOOST_TEST_REQUIRE(nearest.source(x) == expected.source(x));
        }
    }
  }
}

// With unique shortest paths, exchanges by regions and by searches from a whole border are the same ones.
BOOST_AUTO_TEST_CASE(exchanges_are_those_of_searches)
{
  int exchanged = 0;
  for(const Surface& surface : surfaces())
    for(std::size_t number : {0, 3, 12}) {
      const ABF::Surface_part part = part_of(surface.mesh(), static_cast<unsigned>(number));
      std::mt19937 random(7);
      const std::vector<int> terminals = random_vertices(part.chart, number, random);
      TA::internal::Sector_graph opened(part.chart);
      BOOST_TEST_REQUIRE(TA::internal::Topological_cut(opened, part.cost, terminals).run());
      BOOST_TEST_REQUIRE(TA::internal::leaves_disks(opened));
      TA::internal::Sector_graph searched = opened;
      const bool is_shorter = TA::internal::Path_shortening(opened, part.cost, terminals).run(1000);
      exchanged += is_shorter;
      BOOST_TEST_INFO_SCOPE(surface.name << ", " << number << " terminals");
      BOOST_TEST(TA::internal::Path_shortening(searched, part.cost, terminals, false).run(1000) ==
                 is_shorter);
      BOOST_TEST((marks(opened) == marks(searched)));
      BOOST_TEST(TA::internal::leaves_disks(opened));
    }
  BOOST_TEST(exchanged > 10);
}

// Exchanges look at each part of a surface as often with many terminals as with few.
BOOST_AUTO_TEST_CASE(visits_do_not_grow_with_terminals)
{
  const ABF::Surface_part part = part_of(seam_surfaces::sphere(6).mesh(), 1);
  for(std::size_t number : {10, 100, 1000}) {
    std::mt19937 random(11);
    const std::vector<int> terminals = random_vertices(part.chart, number, random);
    TA::internal::Sector_graph opened(part.chart);
    BOOST_TEST_REQUIRE(TA::internal::Topological_cut(opened, part.cost, terminals).run());
    TA::internal::Path_shortening shortening(opened, part.cost, terminals);
    BOOST_TEST(shortening.run(100));
    BOOST_TEST_CONTEXT(number << " terminals")
    BOOST_TEST(shortening.number_of_visits() < 12 * std::int64_t(part.chart.number_of_vertices()));
  }
}

BOOST_AUTO_TEST_SUITE_END()
