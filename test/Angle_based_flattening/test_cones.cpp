// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cones: seams that reach given vertices, the choice of cones, and maps with cones.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"

#include <CGAL/Surface_mesh_parameterization/cut_to_disks.h>
#include <CGAL/Surface_mesh_parameterization/is_disk_cut.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cones)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace parameters = CGAL::parameters;
using namespace seam_surfaces;
using SMP::Seam_report;
typedef Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Edge, bool> Seam_map;

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

std::vector<Vertex> random_vertices(const Mesh& mesh, std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  std::set<Vertex> chosen;
  while(chosen.size() < (std::min)(number, static_cast<std::size_t>(mesh.number_of_vertices())))
    chosen.insert(Vertex(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())));
  return {chosen.begin(), chosen.end()};
}

void check_disk(const Mesh& mesh, Seam_map seams, const Seam_report& report)
{
  BOOST_TEST_REQUIRE(report.message == "");
  const auto check = SMP::is_disk_cut(mesh, seams);
  BOOST_TEST(bool(check), check.message);
  BOOST_TEST(report.number_of_disks == report.number_of_components);
}

} // namespace

BOOST_AUTO_TEST_CASE(seams_reach_all_terminals)
{
  for(unsigned seed = 0; seed < 120; ++seed) {
    const Surface surface = random_surface(seed);
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    const std::vector<Vertex> terminals = random_vertices(mesh, seed % 7, seed);
    BOOST_TEST_CONTEXT("seed " << seed << ", " << surface.name << ", " << terminals.size() << " terminals")
    {
      check_disk(mesh, seams, SMP::cut_to_disks(mesh, seams, parameters::terminals(terminals)));
      for(Vertex v : terminals)
        BOOST_TEST((mesh.is_border(v) || seams_at(mesh, seams, v) > 0));
      if(surface.handles == 0 && surface.borders == 0 && terminals.size() >= 2)
        for(Vertex v : mesh.vertices()) // a tree, whose leaves are terminals
          BOOST_TEST((seams_at(mesh, seams, v) != 1 ||
                      std::find(terminals.begin(), terminals.end(), v) != terminals.end()));
    }
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
    const Seam_report report = SMP::cut_to_disks(mesh, seams, parameters::terminals(ends));
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
  const std::vector<Vertex> terminals = random_vertices(mesh, 20, 5);
  const Seam_map seams = add_seams(mesh);
  const Seam_report report = SMP::cut_to_disks(mesh, seams, parameters::terminals(terminals));
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
  SMP::cut_to_disks(mesh, seams);
  std::vector<bool> before;
  std::vector<Vertex> terminals;
  for(Edge e : mesh.edges()) {
    before.push_back(seams[e]);
    if(seams[e])
      terminals.push_back(mesh.target(mesh.halfedge(e)));
  }
  check_disk(mesh, seams, SMP::cut_to_disks(mesh, seams, parameters::terminals(terminals)));
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
    for(const std::vector<Vertex>& terminals : {std::vector<Vertex>{walled}, {other, walled}}) {
      const Seam_report report = SMP::cut_to_disks(
          mesh, seams, parameters::terminals(terminals).edge_is_constrained_map(is_forbidden));
      BOOST_TEST(report.diagnosis == Seam_report::NO_CUT_ALLOWED);
      BOOST_TEST(report.message.find("terminals") != std::string::npos);
      for(Edge e : mesh.edges())
        BOOST_TEST(!seams[e]);
    }
    const std::vector<Vertex> lonely = {other, mesh.add_vertex(Point_3(9, 9, 9))};
    const Seam_report report = SMP::cut_to_disks(mesh, seams, parameters::terminals(lonely));
    BOOST_TEST(report.diagnosis == Seam_report::WRONG_OPTION);
    BOOST_TEST(report.message == "terminal 1 has no face");
  }
}

BOOST_AUTO_TEST_SUITE_END()
