// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_file.h"

#include "Run.h"
#include "components.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace sweep {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef CGAL::Epick::Point_2 Point_2;
typedef Mesh::Property_map<Vertex, Point_2> UV_map;

const Point_2 untouched(-17, 42); // no result: those are in the first quadrant

// The number of interior vertices around which triangles wind more than once, by the sum of their angles. (At the border
// they may take more than a turn: then the map is not injective, and the report says so.)
int wound_vertices(const Mesh& mesh, const Halfedge border, const UV_map uv)
{
  std::vector<Mesh::Face_index> component;
  PMP::connected_component(mesh.face(opposite(border, mesh)), mesh, std::back_inserter(component));
  std::map<Vertex, double> sums;
  for(const Mesh::Face_index f : component) {
    for(const Halfedge h : halfedges_around_face(mesh.halfedge(f), mesh)) {
      const auto a = uv[mesh.target(mesh.next(h))] - uv[mesh.target(h)];
      const auto b = uv[mesh.source(h)] - uv[mesh.target(h)];
      sums[mesh.target(h)] += std::atan2(CGAL::determinant(a, b), a * b);
    }
  }
  int wound = 0;
  for(const auto& [v, sum] : sums) {
    wound += !mesh.is_border(v) && sum > 3 * CGAL_PI;
  }
  return wound;
}

// What contradicts the returned code in the map that was written, by exact predicates.
std::string fault_of_map(const Mesh& mesh, const Halfedge border, const UV_map uv, const SMP::Error_code code)
{
  if(code != SMP::OK) {
    for(const Vertex v : mesh.vertices()) {
      if(uv[v] != untouched) {
        return "an error, and the map was changed";
      }
    }
    return "";
  }
  std::vector<Mesh::Face_index> flipped;
  SMP::flipped_faces(mesh, border, uv, std::back_inserter(flipped));
  if(!flipped.empty()) {
    return "OK with " + std::to_string(flipped.size()) + " flipped triangles";
  }
  const int wound = wound_vertices(mesh, border, uv);
  return wound == 0
             ? ""
             : "OK with triangles that wind around " + std::to_string(wound) + " vertices more than once";
}

template <class Parameterizer>
void flatten(Mesh& mesh, const Halfedge border, Parameterizer parameterizer, Run& run)
{
  const UV_map uv = mesh.add_property_map<Vertex, Point_2>("v:sweep_uv", untouched).first;
  try {
    CGAL::Real_timer timer;
    timer.start();
    const SMP::Error_code code = SMP::parameterize(mesh, parameterizer, border, uv);
    run.seconds = timer.time();
    run.code = code;
    run.message = parameterizer.report().message;
    run.fault = fault_of_map(mesh, border, uv, code);
    if(run.fault.empty() && error_code(parameterizer.report().diagnosis) != code) {
      run.fault = "the report has another error code";
    } else if(run.fault.empty() && run.message.empty() != (code == SMP::OK)) {
      run.fault = code == SMP::OK ? "OK with a message of an error" : "an error without a message";
    }
    run.injective = run.is_valid() && SMP::is_injective(mesh, border, uv);
  } catch(const std::exception& error) {
    run.fault = std::string("an exception: ") + error.what();
  }
  Mesh::Property_map<Vertex, Point_2> map = uv;
  mesh.remove_property_map(map);
}

void flatten(Mesh& mesh, const Halfedge border, const std::string& method, Run& run)
{
  SMP::ABF_plus_plus_options direct;
  direct.allow_holes = run.allow_holes;
  if(method == "direct") {
    flatten(mesh, border, SMP::ABF_plus_plus_parameterizer_3<Mesh>(direct), run);
    return;
  }
  typedef SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh> Parameterizer;
  SMP::Hierarchical_options options;
  options.allow_holes = run.allow_holes;
  flatten(mesh, border, Parameterizer(options, Parameterizer::Coarse_parameterizer(direct)), run);
}

Halfedge longest(const Mesh& mesh, const std::vector<Halfedge>& borders)
{
  Halfedge result = borders.front();
  double length = 0;
  for(const Halfedge h : borders) {
    const double l = CGAL::to_double(PMP::face_border_length(h, mesh));
    if(l > length) {
      result = h;
      length = l;
    }
  }
  return result;
}

} // namespace

void flatten_file(const std::string& file, const std::string& method, const int first_run)
{
  Mesh mesh;
  if(!read_surface(file, mesh)) {
    std::cout << '\n' << unreadable_tag << " no surface in it that CGAL reads" << std::endl;
    return;
  }
  const std::vector<Component> components = find_components(mesh);
  long closed = 0;
  int number = 0;
  for(std::size_t i = 0; i < components.size(); ++i) {
    closed += components[i].borders.empty();
    Run run;
    run.component = static_cast<int>(i);
    run.triangles = components[i].triangles;
    run.borders = static_cast<int>(components[i].borders.size());
    for(const bool allow_holes : {false, true}) {
      if(run.borders > int(allow_holes) && number++ >= first_run) {
        run.allow_holes = allow_holes;
        tell_begin(std::cout, run);
        flatten(mesh, longest(mesh, components[i].borders), method, run);
        tell_end(std::cout, run);
      }
    }
  }
  std::cout << '\n' << closed_tag << ' ' << closed << std::endl;
}

} // namespace sweep
