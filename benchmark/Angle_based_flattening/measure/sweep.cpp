// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "subcommands.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <vector>

namespace ABF_benchmark {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Surface_mesh<CGAL::Epick::Point_3> Mesh; // polygons are triangulated by predicates
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef CGAL::Epick::Point_2 Point_2;
typedef Mesh::Property_map<Vertex, Point_2> UV_map;

const Point_2 untouched(-17, 42); // never a result: results are in the first quadrant

// The number of interior vertices around which triangles wind more than once, by the sum of their angles. (At the
// border they may exceed a full turn. Then the map is not injective, and the report says so.)
int wound_vertices(const Mesh& mesh, const Halfedge border, const UV_map uv)
{
  std::vector<Mesh::Face_index> component;
  PMP::connected_component(mesh.face(opposite(border, mesh)), mesh, std::back_inserter(component));
  std::map<Vertex, double> sums;
  for(const Mesh::Face_index f : component)
    for(const Halfedge h : halfedges_around_face(mesh.halfedge(f), mesh)) {
      const auto a = uv[mesh.target(mesh.next(h))] - uv[mesh.target(h)];
      const auto b = uv[mesh.source(h)] - uv[mesh.target(h)];
      sums[mesh.target(h)] += std::atan2(CGAL::determinant(a, b), a * b);
    }
  return static_cast<int>(std::count_if(sums.begin(), sums.end(), [&](const auto& sum) {
    return !mesh.is_border(sum.first) && sum.second > 3 * CGAL_PI;
  }));
}

// Contradictions between the returned code and the written map, by exact predicates, or the report
std::string find_fault(const Mesh& mesh, const Halfedge border, const UV_map uv, const SMP::Error_code code,
                       const SMP::Flattening_report& report)
{
  if(code != SMP::OK) {
    for(const Vertex v : mesh.vertices())
      if(uv[v] != untouched)
        return "an error, and the map was changed";
  } else {
    std::vector<Mesh::Face_index> flipped;
    SMP::flipped_faces(mesh, border, uv, std::back_inserter(flipped));
    if(!flipped.empty())
      return "OK with " + std::to_string(flipped.size()) + " flipped triangles";
    if(const int wound = wound_vertices(mesh, border, uv))
      return "OK with triangles that wind around " + std::to_string(wound) + " vertices more than once";
  }
  if(error_code(report.status) != code)
    return "the report has another error code";
  if(report.message.empty() != (code == SMP::OK))
    return code == SMP::OK ? "OK with a message of an error" : "an error without a message";
  return "";
}

template <class Parameterizer>
Measurement flatten(Mesh& mesh, const Halfedge border, Parameterizer parameterizer)
{
  Measurement m;
  UV_map uv = mesh.add_property_map<Vertex, Point_2>("v:sweep_uv", untouched).first;
  std::string fault;
  try {
    SMP::Error_code code = SMP::OK;
    m.add("seconds", seconds_of([&] { code = SMP::parameterize(mesh, parameterizer, border, uv); }));
    fault = find_fault(mesh, border, uv, code, parameterizer.report());
    m.add("result", code == SMP::OK ? "valid" : to_string(parameterizer.report().status));
    m.add("message", parameterizer.report().message);
    m.add("injective", fault.empty() && code == SMP::OK && SMP::is_injective(mesh, border, uv));
  } catch(const std::exception& error) {
    fault = std::string("an exception: ") + error.what();
  }
  m.add("fault", fault);
  mesh.remove_property_map(uv);
  return m;
}

Measurement flatten(Mesh& mesh, const Halfedge border, const std::string& method,
                    const SMP::Flattening_options::Holes holes)
{
  SMP::ABF_plus_plus_options direct;
  direct.holes = holes;
  if(method == "direct")
    return flatten(mesh, border, SMP::ABF_plus_plus_parameterizer_3<Mesh>(direct));
  typedef SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh> Parameterizer;
  SMP::Hierarchical_options options;
  options.holes = holes;
  return flatten(mesh, border, Parameterizer(options, Parameterizer::Coarse_parameterizer(direct)));
}

} // namespace

void sweep(const std::string& file, const std::string& method, const int first_run, Measurement& m)
{
  if(method != "direct" && method != "hierarchical")
    throw std::runtime_error("the method is direct or hierarchical");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0)
    return m.fail("no surface in it that CGAL reads");
  if(!CGAL::is_triangle_mesh(mesh))
    PMP::triangulate_faces(mesh);

  const auto component = mesh.add_property_map<Mesh::Face_index, Mesh::size_type>("f:component").first;
  std::vector<long> triangles(PMP::connected_components(mesh, component));
  for(const Mesh::Face_index f : mesh.faces())
    ++triangles[component[f]];
  std::vector<Halfedge> cycles;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  std::vector<std::vector<Halfedge>> borders(triangles.size()); // of each component, one halfedge of each
  for(const Halfedge h : cycles)
    borders[component[mesh.face(mesh.opposite(h))]].push_back(h);
  const auto is_shorter = [&](const Halfedge g, const Halfedge h) {
    return PMP::face_border_length(g, mesh) < PMP::face_border_length(h, mesh);
  };

  typedef SMP::Flattening_options Holes;
  int run = 0;
  for(std::size_t i = 0; i < borders.size(); ++i)
    for(const bool with_holes : {false, true}) {
      if(borders[i].size() <= std::size_t(with_holes) || run++ < first_run)
        continue;
      Measurement begin;
      begin.add("component", i);
      begin.add("triangles", triangles[i]);
      begin.add("borders", borders[i].size());
      begin.add("holes", with_holes);
      const Halfedge longest = *std::max_element(borders[i].begin(), borders[i].end(), is_shorter);
      std::cout << begin;
      std::cout << flatten(mesh, longest, method, with_holes ? Holes::SOLVE : Holes::REFUSE);
    }
  m.add("closed", std::count(borders.begin(), borders.end(), std::vector<Halfedge>()));
}

} // namespace ABF_benchmark
