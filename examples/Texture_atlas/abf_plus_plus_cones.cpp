// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>

#include <cmath>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
namespace TA = CGAL::Texture_atlas;

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
  TA::Cone_options options;
  options.angle_multiple = CGAL_PI / 2;
  const auto result = TA::flatten_with_cones(mesh, 8, seams, uv, options);
  if(!result) {
    std::cerr << result.message << "\n";
    return 1;
  }

  std::cout << result.cones.cones.size() << " cones: ";
  for(const auto& [vertex, angle] : result.cones.cones)
    std::cout << std::lround(angle * 180 / CGAL_PI) << " ";
  std::cout << "degrees\n"
            << result.map.triangles << " triangles, " << result.map.iterations
            << " steps, lengths equal up to " << result.map.largest_seam_jump << "\n";

  return TA::IO::write_OBJ("abf_plus_plus_cones.obj", mesh, uv) ? 0 : 1;
}
