// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/flatten_with_cones.h>

#include <cmath>
#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
namespace SMP = CGAL::Surface_mesh_parameterization;

// Each corner of a face has its own texture coordinates. They are numbered like the halfedges.
void write_obj(std::ostream& out, const Mesh& mesh, const UV_map& uv)
{
  out.precision(17);
  for(auto v : mesh.vertices())
    out << "v " << mesh.point(v) << "\n";
  for(auto h : mesh.halfedges())
    out << "vt " << uv[h] << "\n";
  for(auto f : mesh.faces()) {
    out << "f";
    for(auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      out << " " << mesh.target(h).idx() + 1 << "/" << h.idx() + 1;
    out << "\n";
  }
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/egg.off", mesh)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }

  // All angles around cones are right angles or multiples of them.
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", {0, 0}).first;
  const auto result =
      SMP::flatten_with_cones(mesh, 8, seams, uv, CGAL::parameters::angle_quantum(CGAL_PI / 2));
  if(result.diagnosis != SMP::Cone_flattening_defect::NOTHING_WRONG) {
    std::cerr << result.message << "\n";
    return 1;
  }

  std::cout << result.cones.cones.size() << " cones: ";
  for(const auto& [vertex, angle] : result.cones.cones)
    std::cout << std::lround(angle * 180 / CGAL_PI) << " ";
  std::cout << "degrees\n"
            << result.map.triangles << " triangles, " << result.map.iterations
            << " steps, lengths equal up to " << result.map.largest_seam_jump << "\n";

  std::ofstream out("abf_plus_plus_cones.obj");
  write_obj(out, mesh, uv);
}
