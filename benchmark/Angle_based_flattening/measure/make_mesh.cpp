// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "subcommands.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_on_sphere.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace ABF_benchmark {

namespace {

typedef CGAL::Surface_mesh<CGAL::Epick::Point_3> Test_mesh; // simplification needs predicates

// Stops a simplification at a number of faces.
struct Face_count
{
  std::size_t faces;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_faces() <= faces;
  }
};

// Simplifies to a size from which subdivisions lead to about that many triangles.
void resize(Test_mesh& mesh, const std::size_t triangles)
{
  int subdivisions = 0;
  std::size_t coarse = triangles;
  for(; coarse > 1.05 * static_cast<double>(mesh.number_of_faces()); coarse /= 4)
    ++subdivisions;
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, Face_count{coarse});
  mesh.collect_garbage();
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
}

// Moves every vertex by a tenth of its shortest edge, so that subdivided meshes do not only have regular angles.
void add_noise(Test_mesh& mesh)
{
  boost::random::mt19937 generator; // the same noise in every run
  boost::random::uniform_on_sphere<double> direction(3);
  const Test_mesh smooth = mesh;
  for(const Test_mesh::Vertex_index v : mesh.vertices()) {
    double shortest = (std::numeric_limits<double>::max)();
    for(const Test_mesh::Vertex_index w : vertices_around_target(smooth.halfedge(v), smooth))
      shortest = (std::min)(shortest, CGAL::squared_distance(smooth.point(v), smooth.point(w)));
    const std::vector<double> d = direction(generator);
    mesh.point(v) = smooth.point(v) + std::sqrt(shortest) / 10 * CGAL::Epick::Vector_3(d[0], d[1], d[2]);
  }
}

// The vertices at most `rings` edges away from `v`, ring by ring
std::vector<Test_mesh::Vertex_index> neighbourhood(const Test_mesh& mesh, const Test_mesh::Vertex_index v,
                                                   const int rings)
{
  std::vector<Test_mesh::Vertex_index> found = {v};
  std::set<Test_mesh::Vertex_index> known = {v};
  std::size_t begin = 0;
  for(int ring = 0; ring < rings; ++ring) {
    const std::size_t end = found.size();
    for(; begin < end; ++begin)
      for(const Test_mesh::Vertex_index w : vertices_around_target(mesh.halfedge(found[begin]), mesh))
        if(known.insert(w).second)
          found.push_back(w);
  }
  return found;
}

// Removes `rings` rings of triangles around random vertices. Holes keep a distance from each other and from the border.
// Returns their number, which is less than `holes` where there is no room.
int punch(Test_mesh& mesh, const int holes, const int rings)
{
  boost::random::mt19937 generator;
  std::vector<bool> is_taken(mesh.number_of_vertices(), false);
  for(const Test_mesh::Vertex_index v : mesh.vertices())
    is_taken[v] = CGAL::is_border(v, mesh).has_value();
  std::set<Test_mesh::Face_index> removed;
  int punched = 0;
  for(int attempt = 0; attempt < 200 * holes && punched < holes; ++attempt) {
    const Test_mesh::Vertex_index centre(
        boost::random::uniform_int_distribution<unsigned>(0, mesh.number_of_vertices() - 1)(generator));
    const auto all = neighbourhood(mesh, centre, rings + 1);
    if(std::any_of(all.begin(), all.end(), [&](const Test_mesh::Vertex_index v) { return is_taken[v]; }))
      continue;
    ++punched;
    for(const Test_mesh::Vertex_index v : all)
      is_taken[v] = true;
    for(const Test_mesh::Vertex_index v : neighbourhood(mesh, centre, rings - 1))
      for(const Test_mesh::Face_index f : faces_around_target(mesh.halfedge(v), mesh))
        removed.insert(f);
  }
  for(const Test_mesh::Face_index f : removed)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  return punched;
}

} // namespace

void make_mesh(const std::string& file, const Mesh_changes& changes, const std::string& output,
               Measurement& m)
{
  Test_mesh mesh;
  read_mesh(file, mesh);
  if(changes.triangles > 0)
    resize(mesh, changes.triangles);
  if(changes.noise)
    add_noise(mesh);
  if(changes.holes > 0)
    m.add("holes", punch(mesh, changes.holes, changes.rings));
  if(!output.empty() && !CGAL::IO::write_polygon_mesh(
                            output, mesh, CGAL::parameters::use_binary_mode(true).stream_precision(17)))
    throw std::runtime_error("cannot write '" + output + "'");
  if(changes.any_topology)
    return m.add("triangles", mesh.number_of_faces());
  const abf::Chart chart = read_chart(mesh);
  m.add("triangles", chart.number_of_triangles());
  if(const auto defect = abf::diagnose(chart, changes.holes > 0))
    m.fail("the mesh cannot be flattened: " + defect.message);
}

} // namespace ABF_benchmark
