// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/number_utils.h>

#include <iomanip>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// Prints how much the angles change, and whether the map is injective.
bool flatten(const char* name, const SMP::Flattening_options::Holes holes, Mesh& mesh)
{
  SMP::ABF_plus_plus_options options;
  options.holes = holes;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto report = SMP::flatten_surface(mesh, uv, options);
  if(!report) {
    std::cerr << report.message << "\n";
    return false;
  }
  const auto measures = SMP::measure_flattening(mesh, PMP::longest_border(mesh).first, uv);
  const double degrees = 180. / CGAL_PI;
  std::cout << name << std::fixed << std::setprecision(2) << std::setw(8)
            << measures.mean_angle_change * degrees << std::setw(11)
            << measures.mean_corner_angle_change * degrees << std::setprecision(6) << std::setw(14)
            << measures.angular_distortion << (report.border_is_simple ? "  injective\n" : "  overlaps\n");
  return true;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/mask.off", mesh)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  std::cout << "       change of angles, degrees      energy\n"
            << "          area  per corner\n";
  // The equations of the holes are solved with those of the interior vertices.
  const bool solved = flatten("solved", SMP::Flattening_options::SOLVE, mesh);
  // Soft triangles cover the holes during the flattening.
  const bool filled = flatten("filled", SMP::Flattening_options::FILL, mesh);
  return solved && filled ? 0 : 1;
}
