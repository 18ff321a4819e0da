// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// Twists the surface about the z-axis.
Point_3 twisted(const Point_3& p, double angle)
{
  const double a = angle * p.z();
  return Point_3(p.x() * std::cos(a) - p.y() * std::sin(a), p.x() * std::sin(a) + p.y() * std::cos(a), p.z());
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  const Mesh original = mesh;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto border = PMP::longest_border(mesh).first;

  SMP::ABF_plus_plus_options options;
  options.warm_start = true; // each frame starts from the angles of the frame before
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  int first_steps = 0, other_steps = 0;
  for(int frame = 0; frame < 50; ++frame) {
    for(Mesh::Vertex_index v : mesh.vertices())
      mesh.point(v) = twisted(original.point(v), 0.01 * frame);
    if(SMP::parameterize(mesh, parameterizer, border, uv) != SMP::OK) {
      std::cerr << "frame " << frame << ": " << parameterizer.report().message << "\n";
      return 1;
    }
    (frame == 0 ? first_steps : other_steps) += parameterizer.report().iterations;
  }
  std::cout << first_steps << " steps for the first frame, " << other_steps / 49.
            << " for each of the others\n";
}
