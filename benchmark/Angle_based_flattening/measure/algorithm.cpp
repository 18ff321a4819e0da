// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "subcommands.h"

#include <CGAL/Default.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace ABF_benchmark {

namespace {

typedef Mesh::Vertex_index Vertex;
typedef std::vector<Vertex> Vertices;
typedef Mesh::Property_map<Vertex, double> Distances;

// The vertices with the fewest edges to the first one, up to that share of the mesh
Vertices ball(const Mesh& mesh, const double share)
{
  const std::size_t size = static_cast<std::size_t>(std::ceil(share * mesh.number_of_vertices()));
  std::vector<bool> found(mesh.num_vertices());
  Vertices result = {*mesh.vertices().begin()};
  found[result.front()] = true;
  for(std::size_t i = 0; i < result.size() && result.size() < size; ++i) {
    for(const Vertex v : CGAL::vertices_around_target(mesh.halfedge(result[i]), mesh)) {
      if(!found[v] && result.size() < size) {
        found[v] = true;
        result.push_back(v);
      }
    }
  }
  if(result.size() < size)
    throw std::runtime_error("the component of the first vertex is too small");
  return result;
}

// Those without a neighbor outside, and not on the border of the mesh
Vertices interior(const Mesh& mesh, const Vertices& patch)
{
  std::vector<bool> inside(mesh.num_vertices());
  for(const Vertex v : patch)
    inside[v] = true;
  Vertices result;
  for(const Vertex v : patch) {
    const auto neighbors = CGAL::vertices_around_target(mesh.halfedge(v), mesh);
    if(!mesh.is_border(v) &&
       std::all_of(neighbors.begin(), neighbors.end(), [&](const Vertex w) { return inside[w]; }))
      result.push_back(v);
  }
  return result;
}

// By the heat method as it is by default: on the given triangles
template <class Solver>
void find_distances(const Mesh& mesh, const Vertex source, const Distances distance)
{
  using namespace CGAL::Heat_method_3;
  Surface_mesh_geodesic_distances_3<Mesh, Direct, CGAL::Default, Solver> heat_method(mesh);
  heat_method.add_source(source);
  heat_method.estimate_geodesic_distances(distance);
}

template <class Solver>
void fair(Mesh& mesh, const Vertices& patch)
{
  const auto parameters = CGAL::parameters::fairing_continuity(1);
  bool succeeded = false;
  if constexpr(std::is_same_v<Solver, CGAL::Default>)
    succeeded = CGAL::Polygon_mesh_processing::fair(mesh, patch, parameters);
  else
    succeeded = CGAL::Polygon_mesh_processing::fair(mesh, patch, parameters.sparse_linear_solver(Solver()));
  if(!succeeded)
    throw std::runtime_error("fairing failed");
}

// Moves the handle by a tenth of the diagonal of the bounding box.
template <class Solver>
void deform(Mesh& mesh, const Vertices& region, const Vertices& handle)
{
  constexpr int iterations = 5; // CGAL's default
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, CGAL::SPOKES_AND_RIMS, CGAL::Default,
                                 Solver>
      deformation(mesh);
  deformation.insert_roi_vertices(region.begin(), region.end());
  deformation.insert_control_vertices(handle.begin(), handle.end());
  if(!deformation.preprocess())
    throw std::runtime_error("the deformation cannot be prepared");
  const CGAL::Kernel_traits<Mesh::Point>::Kernel::Vector_3 diagonal(box.x_span(), box.y_span(), box.z_span());
  deformation.translate(handle.begin(), handle.end(), diagonal / 10);
  deformation.deform(iterations, 0);
}

// The largest one and the mean, by which results of two solvers are compared
void add_distances(const Mesh& mesh, const Distances distance, Measurement& m)
{
  double largest = 0, sum = 0;
  for(const Vertex v : mesh.vertices()) {
    largest = (std::max)(largest, distance[v]);
    sum += distance[v];
  }
  if(!(largest > 0 && std::isfinite(sum)))
    throw std::runtime_error("the algorithm did nothing, or its result is not finite");
  m.add("largest", largest);
  m.add("mean", sum / mesh.number_of_vertices());
}

template <class Solver>
void run_algorithm(const std::string& algorithm, Mesh& mesh, Measurement& m)
{
  const Mesh original = mesh;
  const Distances distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  const Vertices region = ball(mesh, algorithm == "fairing" ? 0.1 : 0.3), handle = ball(mesh, 0.01),
                 patch = interior(mesh, region);
  const Gauge gauge;
  if(algorithm == "heat")
    find_distances<Solver>(mesh, handle.front(), distance);
  else if(algorithm == "fairing")
    fair<Solver>(mesh, patch);
  else if(algorithm == "deformation")
    deform<Solver>(mesh, region, handle);
  else
    throw std::runtime_error("there is no algorithm '" + algorithm + "'");
  gauge.add_to(m);
  if(algorithm != "heat") {
    for(const Vertex v : mesh.vertices())
      distance[v] = std::sqrt(CGAL::squared_distance(mesh.point(v), original.point(v)));
  }
  add_distances(mesh, distance, m);
}

} // namespace

void algorithm(const std::string& name, const std::string& solver, const std::string& file, Measurement& m)
{
  Mesh mesh;
  read_mesh(file, mesh);
  m.add("triangles", mesh.number_of_faces());
  if(solver == "superlu")
    run_algorithm<CGAL::SuperLU_solver_traits<>>(name, mesh, m);
  else if(solver == "eigen")
    run_algorithm<CGAL::Default>(name, mesh, m);
  else
    throw std::runtime_error("there is no solver '" + solver + "'");
}

} // namespace ABF_benchmark
