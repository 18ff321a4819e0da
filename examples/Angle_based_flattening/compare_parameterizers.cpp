// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/number_utils.h>

#include <iomanip>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// Every parameterizer goes here: they differ in their type only.
template <typename Parameterizer>
void compare(const char* name, const Parameterizer& parameterizer, Mesh& mesh)
{
  const Mesh::Halfedge_index border = PMP::longest_border(mesh).first;
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  std::cout << std::setw(6) << name;
  if(SMP::parameterize(mesh, parameterizer, border, uv) == SMP::OK) {
    const auto measures = SMP::measure_flattening(mesh, border, uv);
    const double degrees = 180. / CGAL_PI;
    std::cout << std::fixed << std::setprecision(2) << std::setw(8) << measures.mean_angle_change * degrees
              << std::setw(11) << measures.mean_corner_angle_change * degrees << std::setprecision(3)
              << std::setw(17) << measures.mean_quasi_conformal_ratio << std::setw(9)
              << measures.flipped_triangles << "\n";
  } else {
    std::cout << " failed\n";
  }
  mesh.remove_property_map(uv);
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "Cannot read the mesh, or it has no border.\n";
    return 1;
  }
  std::cout << "       change of angles, degrees  quasi-conformal  flipped\n"
            << "          area  per corner            ratio\n";
  compare("LSCM", SMP::LSCM_parameterizer_3<Mesh>(), mesh);
  compare("ARAP", SMP::ARAP_parameterizer_3<Mesh>(), mesh);
  compare("ABF++", SMP::ABF_plus_plus_parameterizer_3<Mesh>(), mesh);
  compare("HABF++", SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>(), mesh);
}
