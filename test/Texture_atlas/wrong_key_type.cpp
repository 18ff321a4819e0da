// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates of vertices where an atlas needs those of corners: the compiler says so, in one sentence.

#include <CGAL/Texture_atlas/make_atlas.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

void make_atlas_of_vertices(const Mesh& mesh, Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv)
{
  CGAL::Texture_atlas::make_atlas(mesh, uv);
}
