// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/split_overlaps.h>

#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Surface::Halfedge_index;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using Mesh = TA::Cut_mesh<Surface>;

int main(int argc, char* argv[])
{
  Surface surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", surface)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }
  const auto seams = surface.add_property_map<Surface::Edge_index, bool>("e:seam", false).first;
  TA::Seam_options seam_options;
  seam_options.stretch_bound = 1.05;
  const auto cut = TA::select_seams(surface, seams, seam_options);
  if(!cut) {
    std::cerr << cut.message << "\n";
    return 1;
  }
  const auto uv_of_seam_mesh = surface.add_property_map<Halfedge, Kernel::Point_2>("h:uv", {0, 0}).first;
  auto opened = TA::make_seam_mesh(surface, seams);
  if(!opened) {
    std::cerr << opened.message << "\n";
    return 1;
  }
  Mesh& mesh = opened.mesh;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, TA::border_halfedge(mesh), uv_of_seam_mesh) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }

  // Each corner of a face has coordinates of its own, at the halfedge that leads to it.
  const auto uv = surface.add_property_map<Halfedge, Kernel::Point_2>("h:corner_uv", {0, 0}).first;
  for(auto f : faces(surface))
    for(auto h : halfedges_around_face(halfedge(f, surface), surface))
      uv[h] = uv_of_seam_mesh[target(Mesh::halfedge_descriptor(h), mesh)];

  const auto chart = surface.add_property_map<Surface::Face_index, int>("f:chart").first;
  const auto split = TA::split_overlaps(surface, uv, seams, chart);
  if(!split) {
    std::cerr << split.message << "\n";
    return 1;
  }
  TA::Packing_options packing_options;
  packing_options.resolution = 2048;
  packing_options.gutter = 4;
  const auto packing = TA::pack_charts(surface, chart, uv, packing_options);
  if(!packing) {
    std::cerr << packing.message << "\n";
    return 1;
  }
  std::cout << packing.number_of_charts << " charts cover " << 100 * packing.covered_share
            << " % of the texture, " << packing.texels_per_length << " texels for a length of 1\n";

  return TA::IO::write_OBJ("abf_plus_plus_pack_charts.obj", surface, uv) ? 0 : 1;
}
