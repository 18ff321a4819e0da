// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What users of the installed package do first, each in a few lines and with the number that they look at.

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/fit_rectangle.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Vertex = Mesh::Vertex_index;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Point_2>;
using Vertex_uv_map = Mesh::Property_map<Vertex, Point_2>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;

// A wavy sheet of 2 x n x n triangles, and a sphere
template <class Surface = Mesh>
Surface sheet(int n = 12, double height = 1)
{
  Surface mesh;
  const auto point = [&](std::size_t i, std::size_t j) {
    return Point_3(double(i), double(j), height * std::sin(0.4 * double(i)) * std::sin(0.5 * double(j)));
  };
  CGAL::make_grid(n, n, mesh, point, true);
  return mesh;
}

Mesh sphere()
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  return mesh;
}

Vertex_uv_map add_uv(Mesh& mesh)
{
  return mesh.add_property_map<Vertex, Point_2>("v:uv", Point_2(0, 0)).first;
}

UV_map add_corner_uv(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", Point_2(0, 0)).first;
}

bool swaps_the_parameterizer()
{
  Mesh mesh = sheet();
  const auto uv = add_uv(mesh);
  const auto border = PMP::longest_border(mesh).first;
  return SMP::parameterize(mesh, SMP::LSCM_parameterizer_3<Mesh>(), border, uv) == SMP::OK &&
         SMP::parameterize(mesh, SMP::ABF_plus_plus_parameterizer_3<Mesh>(), border, uv) == SMP::OK;
}

bool flattens_a_polyhedron()
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  auto mesh = sheet<Polyhedron>();
  std::map<Polyhedron::Vertex_handle, Point_2> uv;
  return bool(SMP::flatten_surface(mesh, boost::make_assoc_property_map(uv))) &&
         uv.size() == mesh.size_of_vertices();
}

bool flattens_a_seam_mesh()
{
  Mesh mesh = sphere();
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  if(!TA::select_seams(mesh, seams))
    return false;
  auto opened = TA::make_seam_mesh(mesh, seams);
  return opened && SMP::flatten_surface(opened.mesh, add_corner_uv(mesh));
}

bool writes_an_atlas()
{
  Mesh mesh = sphere(), read;
  const UV_map uv = add_corner_uv(mesh);
  if(!TA::make_atlas(mesh, uv) || !TA::IO::write_OBJ("tasks.obj", mesh, uv))
    return false;
  return TA::IO::read_OBJ("tasks.obj", read, add_corner_uv(read)) && read.number_of_faces() == 20;
}

bool makes_a_rectangle()
{
  Mesh mesh = sheet();
  const auto uv = add_uv(mesh);
  const auto border = PMP::longest_border(mesh).first;
  const auto rectangle = SMP::rectangle_angles(mesh, border, 2);
  SMP::split_flat_chords(mesh, border, rectangle.angles);
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  parameterizer.set_angle_sums(rectangle.angles);
  if(!rectangle || SMP::parameterize(mesh, parameterizer, border, uv) != SMP::OK)
    return false;
  if(!SMP::fit_rectangle(mesh, uv, rectangle.corners, 2))
    return false;
  const auto far_corner = uv[rectangle.corners[2]]; // the first corner is at the origin
  return std::abs(far_corner.x() / far_corner.y() - 2) < 1e-12;
}

bool morphs()
{
  Mesh mesh = sheet();
  const auto uv = add_uv(mesh);
  SMP::ABF_plus_plus_options options;
  options.warm_start = true;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  for(const double height : {0.9, 1., 1.1}) {
    const Mesh shape = sheet(12, height);
    for(const Vertex v : mesh.vertices())
      mesh.point(v) = shape.point(v);
    if(!SMP::flatten_surface(mesh, uv, parameterizer))
      return false;
  }
  return SMP::is_injective(mesh, uv);
}

bool flattens_coarse_charts_by_LSCM()
{
  Mesh mesh = sheet(40);
  using Coarse = SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh>;
  const auto report =
      SMP::flatten_surface(mesh, add_uv(mesh), SMP::Hierarchical_parameterizer_3<Mesh, Coarse>());
  return report && report.start == SMP::Hierarchical_report::COARSE_PARAMETERIZER;
}

bool takes_another_solver()
{
  using Solver = CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>;
  Mesh mesh = sheet(), closed = sphere();
  return SMP::flatten_surface(mesh, add_uv(mesh), SMP::ABF_plus_plus_parameterizer_3<Mesh, Solver>()) &&
         TA::make_atlas(closed, add_corner_uv(closed), CGAL::parameters::sparse_linear_solver(Solver()));
}

bool measures_another_map()
{
  Mesh mesh = sheet();
  const auto uv = add_uv(mesh);
  SMP::ARAP_parameterizer_3<Mesh> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, PMP::longest_border(mesh).first, uv) != SMP::OK)
    return false;
  const auto measures = SMP::measure_flattening(mesh, uv);
  return measures && measures.l2_stretch < 1.1 && SMP::is_injective(mesh, uv);
}

bool packs_two_meshes_into_one_square()
{
  std::vector<Mesh> meshes = {sheet(), sphere()};
  std::vector<UV_map> uv = {add_corner_uv(meshes[0]), add_corner_uv(meshes[1])};
  if(!TA::make_atlas(meshes[0], uv[0]) || !TA::make_atlas(meshes[1], uv[1]))
    return false;
  TA::Atlas_options options;
  options.given_charts = TA::Atlas_options::KEEP;
  const auto report = TA::make_common_atlas(meshes, uv, options);
  return report && report.charts.front().mesh == 0 && report.charts.back().mesh == 1;
}

bool takes_points_and_importance()
{
  Mesh mesh = sheet();
  const auto points = mesh.add_property_map<Vertex, Point_3>("v:other", Point_3(0, 0, 0)).first;
  for(const Vertex v : mesh.vertices())
    points[v] = Point_3(2 * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  const auto importance = mesh.add_property_map<Mesh::Face_index, double>("f:importance", 1.).first;
  importance[Mesh::Face_index(0)] = 10;
  return bool(SMP::flatten_surface(
      mesh, add_uv(mesh), CGAL::parameters::face_importance_map(importance).vertex_point_map(points)));
}

struct Impatient : SMP::Flattening_visitor
{
  bool step(const SMP::ABF_plus_plus_step&) override { return false; }
};

bool cancels()
{
  Mesh mesh = sheet();
  Impatient visitor;
  return SMP::flatten_surface(mesh, add_uv(mesh), CGAL::parameters::visitor(std::ref(visitor))).status ==
         SMP::Diagnosis::CANCELLED;
}

bool names_what_is_wrong()
{
  Mesh mesh = sheet(), closed = sphere();
  mesh.point(Vertex(7)) = Point_3(0, 0, std::numeric_limits<double>::quiet_NaN());
  const auto report = SMP::flatten_surface(mesh, add_uv(mesh));
  const auto atlas = TA::make_atlas(mesh, add_corner_uv(mesh));
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  SMP::parameterize(closed, parameterizer, Mesh::null_halfedge(), add_uv(closed));
  return report.status == SMP::Diagnosis::NON_FINITE_POINT &&
         report.offending_vertices.front() == Vertex(7) && report.message.find("vertex 7 (0, 0, nan)") == 0 &&
         atlas.skipped_elements[0].vertices.front() == Vertex(7) &&
         parameterizer.report().status == SMP::Diagnosis::NO_BORDER;
}

int main()
{
  const std::pair<const char*, bool (*)()> tasks[] = {
      {"swaps the parameterizer", swaps_the_parameterizer},
      {"flattens a polyhedron", flattens_a_polyhedron},
      {"flattens a seam mesh", flattens_a_seam_mesh},
      {"writes an atlas", writes_an_atlas},
      {"makes a rectangle", makes_a_rectangle},
      {"morphs", morphs},
      {"flattens coarse charts by LSCM", flattens_coarse_charts_by_LSCM},
      {"takes another solver", takes_another_solver},
      {"measures another map", measures_another_map},
      {"packs two meshes into one square", packs_two_meshes_into_one_square},
      {"takes points and importance", takes_points_and_importance},
      {"cancels", cancels},
      {"names what is wrong", names_what_is_wrong}};
  int failures = 0;
  for(const auto& [name, task] : tasks)
    if(!task()) {
      std::cerr << name << ": failed\n";
      ++failures;
    }
  return failures;
}
