// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

// What a map is worth, whatever made it.
template <typename VertexUVMap>
void certify(const std::string& name, const Mesh& mesh, const VertexUVMap& uv)
{
  if(SMP::is_injective(mesh, uv)) {
    std::cout << name << ": injective\n";
    return;
  }
  std::vector<Mesh::Face_index> flipped;
  SMP::flipped_faces(mesh, uv, std::back_inserter(flipped));
  std::vector<std::pair<Mesh::Halfedge_index, Mesh::Halfedge_index>> crossing;
  SMP::crossing_border_edges(mesh, uv, std::back_inserter(crossing));
  std::cout << name << ": " << flipped.size() << " flipped faces, " << crossing.size()
            << " pairs of border edges that cross\n";
  if(!flipped.empty()) {
    std::cout << "  flipped, for example: " << flipped.front() << "\n";
  }
  if(!crossing.empty()) {
    std::cout << "  crossing, for example: " << mesh.edge(crossing.front().first) << " and "
              << mesh.edge(crossing.front().second) << "\n";
  }
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "Cannot read the mesh, or it has no border.\n";
    return 1;
  }
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;

  // This parameterizer says OK whether or not its map is injective.
  if(SMP::parameterize(mesh, SMP::LSCM_parameterizer_3<Mesh>(), PMP::longest_border(mesh).first, uv) !=
     SMP::OK) {
    std::cerr << "Cannot flatten the mesh.\n";
    return 1;
  }
  certify("least squares conformal map", mesh, uv);

  for(const Mesh::Vertex_index v : mesh.vertices()) {
    uv[v] = Kernel::Point_2(mesh.point(v).x(), mesh.point(v).y());
  }
  certify("view from above", mesh, uv);
}
