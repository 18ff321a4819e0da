// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/subdivision_method_3.h>

#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "Cannot read the mesh, or it has no border.\n";
    return 1;
  }
  // Each step makes four triangles of one.
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2));

  const Mesh::Halfedge_index border = PMP::longest_border(mesh).first;
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  const SMP::Error_code code = SMP::parameterize(mesh, parameterizer, border, uv);
  const SMP::Hierarchical_report& report = parameterizer.report();
  if(code != SMP::OK) {
    std::cerr << report.message << "\n";
    return 1;
  }
  std::cout << report.triangles << " triangles, " << report.coarse_triangles << " after " << report.levels
            << " levels of collapses\n"
            << report.flipped_triangles << " flipped, smallest angle " << report.smallest_angle << "\n"
            << "seconds: coarsen " << report.seconds.coarsen << ", solve " << report.seconds.coarse_chart
            << ", refine " << report.seconds.refine << ", in all " << report.seconds.total() << "\n";

  std::ofstream out("hierarchical_abf_plus_plus.off");
  SMP::IO::output_uvmap_to_off(mesh, border, uv, out);
}
