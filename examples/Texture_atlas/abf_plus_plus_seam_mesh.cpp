// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/seam_selection.h>

#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using Mesh = TA::Cut_mesh<Surface>;

int main(int argc, char* argv[])
{
  Surface surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/egg.off", surface)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }

  const auto seams = surface.add_property_map<Surface::Edge_index, bool>("e:seam", false).first;
  const char* file_name = argc > 2 ? argv[2] : "data/egg.selection.txt";
  if(const auto report = TA::read_seam_selection(file_name, surface, seams); !report) {
    std::cerr << report.message << "\n";
    return 1;
  }
  if(const auto check = TA::is_disk_cut(surface, seams); !check) {
    std::cerr << check.message << "\n";
    return 1;
  }

  // Along its seam the closed surface is cut open.
  auto opened = TA::make_seam_mesh(surface, seams);
  if(!opened) {
    std::cerr << opened.message << "\n";
    return 1;
  }
  Mesh& mesh = opened.mesh;
  const auto border = TA::border_halfedge(mesh);

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
