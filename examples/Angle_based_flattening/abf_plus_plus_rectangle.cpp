// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <array>
#include <cmath>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// Four vertices of a border, a quarter of its length apart
std::array<Vertex, 4> quarter_points(const Mesh& mesh, const Halfedge border)
{
  std::array<Vertex, 4> corners;
  const double quarter = PMP::face_border_length(border, mesh) / 4;
  double length = 0;
  std::size_t number = 0;
  for(const Halfedge h : mesh.halfedges_around_face(border)) {
    if(number < 4 && length >= quarter * static_cast<double>(number)) {
      corners[number++] = mesh.source(h);
    }
    length += PMP::edge_length(h, mesh);
  }
  return corners;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/mask.off", mesh)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  const Halfedge border = PMP::longest_border(mesh).first;
  const std::array<Vertex, 4> corners = quarter_points(mesh, border);

  // Right angles at the corners, and straight sides between them.
  const auto rectangle = SMP::rectangle_angles(mesh, corners);
  if(!rectangle) {
    std::cerr << rectangle.message << "\n";
    return 1;
  }

  // A triangle with two edges on a straight side would be flat.
  SMP::split_flat_chords(mesh, border, rectangle.angles);

  SMP::ABF_plus_plus_options options;
  options.holes = SMP::Flattening_options::SOLVE;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  parameterizer.set_angle_sums(rectangle.angles);
  const auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  SMP::parameterize(mesh, parameterizer, border, uv);
  const SMP::ABF_plus_plus_report& report = parameterizer.report();
  if(!report) {
    std::cerr << report.message << "\n";
    return 1;
  }
  const double width = std::sqrt(CGAL::squared_distance(uv[corners[0]], uv[corners[1]])),
               height = std::sqrt(CGAL::squared_distance(uv[corners[1]], uv[corners[2]]));
  std::cout << "sides of " << width << " and " << height << ", "
            << (report.side_deviation < 1e-12 ? "straight" : "bent") << "\n"
            << report.prescribed_angles << " angles prescribed, " << report.iterations << " steps\n";
  return 0;
}
