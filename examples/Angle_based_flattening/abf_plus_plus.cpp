// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>

#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  const auto report = SMP::flatten_surface(mesh, uv);
  if(!report) {
    std::cerr << report.message << "\n";
    return 1;
  }
  std::cout << report.triangles << " triangles, " << report.iterations << " steps\n";

  std::ofstream out("abf_plus_plus.off");
  SMP::IO::output_uvmap_to_off(mesh, PMP::longest_border(mesh).first, uv, out);
}
