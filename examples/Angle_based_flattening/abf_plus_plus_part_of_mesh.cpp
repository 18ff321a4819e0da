// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/selection.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Part = CGAL::Face_filtered_graph<Surface>;
using Halfedge = boost::graph_traits<Part>::halfedge_descriptor;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Surface surface;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/egg.off", surface)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }

  // The part is a disk of ten rings of faces around the first face. The surface itself stays whole.
  std::vector<Surface::Face_index> faces{*surface.faces().begin()};
  auto selected = surface.add_property_map<Surface::Face_index, bool>("f:selected", false).first;
  selected[faces.front()] = true;
  CGAL::expand_face_selection(std::vector<Surface::Face_index>(faces), surface, 10, selected,
                              std::back_inserter(faces));
  Part part(surface, faces);
  if(CGAL::is_closed(part)) {
    std::cerr << "The part is the whole of a closed surface.\n";
    return 1;
  }
  const Halfedge border = PMP::longest_border(part).first;

  // The coordinates belong to the vertices of the surface; those elsewhere keep what they have.
  const auto uv = surface.add_property_map<Surface::Vertex_index, Kernel::Point_2>("v:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Part> parameterizer;
  if(SMP::parameterize(part, parameterizer, border, uv) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }
  std::cout << parameterizer.report().triangles << " of " << surface.number_of_faces()
            << " triangles, smallest angle " << parameterizer.report().smallest_angle << "\n";

  std::ofstream out("abf_plus_plus_part_of_mesh.off");
  SMP::IO::output_uvmap_to_off(part, border, uv, out);
}
