// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/split_overlaps.h>

#include <boost/property_map/function_property_map.hpp>

#include <iostream>
#include <iterator>
#include <vector>

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

  const auto uv = surface.add_property_map<Halfedge, Kernel::Point_2>("h:uv", {0, 0}).first;
  auto opened = TA::make_seam_mesh(surface, seams);
  if(!opened) {
    std::cerr << opened.message << "\n";
    return 1;
  }
  Mesh& mesh = opened.mesh;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, TA::border_halfedge(mesh), uv) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }
  std::vector<Surface::Face_index> overlapping;
  TA::overlapping_faces(mesh, uv, std::back_inserter(overlapping));
  std::cout << overlapping.size() << " of " << surface.number_of_faces() << " faces overlap others\n";

  // The seam mesh knows at which halfedge the coordinates of each corner are.
  const auto corner_uv = boost::make_function_property_map<Halfedge>(
      [&](Halfedge h) { return uv[target(Mesh::halfedge_descriptor(h), mesh)]; });
  const auto piece = surface.add_property_map<Surface::Face_index, int>("f:piece").first;
  const auto split = TA::split_overlaps(surface, corner_uv, seams, piece);
  if(!split) {
    std::cerr << split.message << "\n";
    return 1;
  }
  std::cout << split.number_of_pieces << " pieces without overlap, borders " << 100 * split.extra_seam
            << " % longer\n";

  return TA::IO::write_OBJ("abf_plus_plus_split_overlaps.obj", surface, corner_uv,
                           CGAL::parameters::face_patch_map(piece))
             ? 0
             : 1;
}
