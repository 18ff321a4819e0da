// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/property_map/property_map.hpp>

#include <fstream>
#include <iostream>
#include <unordered_map>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Halfedge = boost::graph_traits<Mesh>::halfedge_descriptor;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "Cannot read the mesh, or it has no border.\n";
    return 1;
  }
  const Halfedge border = PMP::longest_border(mesh).first;

  // A polyhedron has no place for further properties: the coordinates are kept beside it.
  std::unordered_map<Vertex, Kernel::Point_2> coordinates;
  const boost::associative_property_map<std::unordered_map<Vertex, Kernel::Point_2>> uv(coordinates);

  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, border, uv) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }
  std::cout << "coordinates of " << coordinates.size() << " vertices, smallest angle "
            << parameterizer.report().smallest_angle << "\n";

  std::ofstream out("abf_plus_plus_polyhedron.off");
  SMP::IO::output_uvmap_to_off(mesh, border, uv, out);
}
