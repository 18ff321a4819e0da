// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Raises the middle of a square by CGAL's deformation, which solves its linear systems with SuperLU.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <CGAL/boost/graph/generators.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Deformation = CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, CGAL::SRE_ARAP,
                                                   CGAL::Default, CGAL::SuperLU_solver_traits<>>;

int main()
{
  Mesh mesh;
  CGAL::make_grid(
      8, 8, mesh, [](std::size_t i, std::size_t j) { return Kernel::Point_3(i, j, 0); }, true);
  Deformation deformation(mesh);
  deformation.insert_roi_vertices(vertices(mesh).begin(), vertices(mesh).end());
  const Mesh::Vertex_index middle(40);
  deformation.insert_control_vertex(middle);
  for(const Mesh::Vertex_index v : vertices(mesh))
    if(mesh.is_border(v))
      deformation.insert_control_vertex(v);
  deformation.set_target_position(middle, Kernel::Point_3(4, 4, 2));
  if(!deformation.preprocess())
    return 1;
  deformation.deform();
  const double z = mesh.point(Mesh::Vertex_index(41)).z();
  return mesh.point(middle).z() == 2 && z > 0.5 && z < 2 ? 0 : 1;
}
