// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Is_seam_edge = Surface::Property_map<Surface::Edge_index, bool>;
using Is_seam_vertex = Surface::Property_map<Surface::Vertex_index, bool>;
using Mesh = CGAL::Seam_mesh<Surface, Is_seam_edge, Is_seam_vertex>;
using Halfedge = boost::graph_traits<Mesh>::halfedge_descriptor;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Surface surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/egg.off", surface)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }

  // Along its seam the closed surface is cut open.
  const Is_seam_edge is_seam_edge =
      surface.add_property_map<Surface::Edge_index, bool>("e:seam", false).first;
  const Is_seam_vertex is_seam_vertex =
      surface.add_property_map<Surface::Vertex_index, bool>("v:seam", false).first;
  Mesh mesh(surface, is_seam_edge, is_seam_vertex);
  const Surface::Halfedge_index seam = mesh.add_seams(argc > 2 ? argv[2] : "data/egg.selection.txt");
  if(seam == Surface::null_halfedge()) {
    std::cerr << "Cannot read the seam.\n";
    return 1;
  }
  const Halfedge border = opposite(Halfedge(seam), mesh);

  // A vertex on the seam has a place in the plane on each side: coordinates belong to halfedges.
  const auto uv = surface.add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, border, uv) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }
  std::cout << parameterizer.report().triangles << " triangles, " << parameterizer.report().iterations
            << " steps\n";

  std::ofstream out("abf_plus_plus_seam_mesh.off");
  SMP::IO::output_uvmap_to_off(mesh, border, uv, out);
}
