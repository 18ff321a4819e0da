// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/shell.off", mesh)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }

  // The violation of the constraints goes down to the tolerance, in the end quadratically.
  SMP::ABF_plus_plus_options options;
  options.tolerance = 1e-10;
  options.on_step = [&options](const SMP::ABF_plus_plus_step& step) {
    std::cout << "step " << step.iteration << ": energy " << step.energy << ", violation "
              << step.constraint_residual << (step.constraint_residual < options.tolerance ? ", done" : "")
              << std::endl;
  };

  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  if(SMP::parameterize(mesh, parameterizer, PMP::longest_border(mesh).first, uv) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }
  std::cout << "angles took " << parameterizer.report().seconds.angles << " s, the layout "
            << parameterizer.report().seconds.layout << " s\n";
}
