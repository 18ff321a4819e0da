// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "components.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <iterator>
#include <string>
#include <vector>

namespace sweep {

namespace PMP = CGAL::Polygon_mesh_processing;

bool read_surface(const std::string& file, Mesh& mesh)
{
  if(!PMP::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() == 0) {
    return false;
  }
  if(!CGAL::is_triangle_mesh(mesh)) {
    PMP::triangulate_faces(mesh);
  }
  return true;
}

std::vector<Component> find_components(Mesh& mesh)
{
  const auto ids = mesh.add_property_map<Mesh::Face_index, Mesh::size_type>("f:component").first;
  std::vector<Component> components(PMP::connected_components(mesh, ids));
  for(const Mesh::Face_index f : mesh.faces()) {
    ++components[ids[f]].triangles;
  }
  std::vector<Mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  for(const Mesh::Halfedge_index h : borders) {
    components[ids[mesh.face(mesh.opposite(h))]].borders.push_back(h);
  }
  return components;
}

} // namespace sweep
