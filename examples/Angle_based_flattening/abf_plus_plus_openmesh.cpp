// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <iostream>

struct Traits : OpenMesh::DefaultTraitsDouble
{
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::TexCoord2D);
  FaceAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel; // of the points that CGAL sees
namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[])
{
  Mesh mesh; // OpenMesh's own reader knows no comments in files
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/dinosaur.off", mesh) || CGAL::is_closed(mesh)) {
    std::cerr << "Cannot read the mesh, or it has no border.\n";
    return 1;
  }
  const Mesh::HalfedgeHandle border = PMP::longest_border(mesh).first;

  const auto uv = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
  if(SMP::parameterize(mesh, parameterizer, border, uv) != SMP::OK) {
    std::cerr << parameterizer.report().message << "\n";
    return 1;
  }
  std::cout << parameterizer.report().triangles << " triangles, " << parameterizer.report().iterations
            << " steps\n";

  for(const Mesh::VertexHandle v : mesh.vertices()) {
    mesh.set_texcoord2D(v, Mesh::TexCoord2D(get(uv, v).x(), get(uv, v).y()));
  }
  OpenMesh::IO::write_mesh(mesh, "abf_plus_plus_openmesh.obj", OpenMesh::IO::Options::VertexTexCoord);
}
