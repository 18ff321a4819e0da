// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <algorithm>
#include <iostream>
#include <optional>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_2 = Kernel::Point_2;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/mask.off", mesh)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  const auto border = PMP::longest_border(mesh).first;
  const auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  const auto pins = mesh.add_property_map<Vertex, std::optional<Point_2>>("v:pin").first;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  parameterizer.set_pins(pins);

  // Two pins choose the scale, the direction and the place of the map. The third one bends it.
  const auto is_left_of = [&](Vertex v, Vertex w) { return mesh.point(v).x() < mesh.point(w).x(); };
  const auto is_below = [&](Vertex v, Vertex w) { return mesh.point(v).y() < mesh.point(w).y(); };
  const auto [left, right] = std::minmax_element(mesh.vertices_begin(), mesh.vertices_end(), is_left_of);
  const Vertex top = *std::max_element(mesh.vertices_begin(), mesh.vertices_end(), is_below);
  pins[*left] = Point_2(0, 0.5);
  pins[*right] = Point_2(1, 0.5);
  for(const bool is_bent : {false, true}) {
    if(is_bent)
      pins[top] = uv[top] + Kernel::Vector_2(0, 0.1);
    SMP::parameterize(mesh, parameterizer, border, uv);
    const SMP::ABF_plus_plus_report& report = parameterizer.report();
    if(!report) {
      std::cerr << report.message << "\n";
      return 1;
    }
    std::cout << report.pins << " pins, missed by " << report.largest_pin_distance << ": angles change by "
              << (report.mean_pin_angle_change < 1e-12 ? 0 : report.mean_pin_angle_change) << "\n";
  }
}
