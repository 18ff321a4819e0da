// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <boost/property_map/function_property_map.hpp>

#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Surface::Property_map<Surface::Halfedge_index, Kernel::Point_2>;
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
  TA::Seam_options options;
  options.stretch_bound = 1.1;
  const auto report = TA::select_seams(surface, seams, options);
  if(!report) {
    std::cerr << report.message << "\n";
    return 1;
  }
  std::cout << report.number_of_terminals << " terminals, seams of length " << report.relative_seam_length
            << ", predicted stretch " << report.predicted_stretch << "\n";

  // A vertex on a seam has a place in the plane on each side: coordinates belong to halfedges.
  const UV_map uv = surface.add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv", {0, 0}).first;
  auto opened = TA::make_seam_mesh(surface, seams);
  if(!opened) {
    std::cerr << opened.message << "\n";
    return 1;
  }
  Mesh& mesh = opened.mesh;
  for(const auto& disk : TA::is_disk_cut(surface, seams).parts) {
    const auto border = TA::border_halfedge(mesh, disk.face);
    SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
    if(SMP::parameterize(mesh, parameterizer, border, uv) != SMP::OK) {
      std::cerr << parameterizer.report().message << "\n";
      return 1;
    }
    const auto measures = SMP::measure_flattening(mesh, border, uv);
    std::cout << parameterizer.report().triangles << " triangles, stretch " << measures.l2_stretch << ", "
              << measures.flipped_triangles << " flipped\n";
  }

  // The seam mesh knows at which halfedge the coordinates of each corner are.
  const auto corner_uv = boost::make_function_property_map<Surface::Halfedge_index>(
      [&](Surface::Halfedge_index h) { return uv[target(Mesh::halfedge_descriptor(h), mesh)]; });
  return TA::IO::write_OBJ("abf_plus_plus_closed_surface.obj", surface, corner_uv) ? 0 : 1;
}
