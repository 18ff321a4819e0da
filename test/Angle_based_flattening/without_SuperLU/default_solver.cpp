// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile without SuperLU: the default solver is asked for, by a parameterizer or by a function.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

#ifdef DEFAULT_SOLVER_OF_PARAMETERIZER
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>

CGAL::Surface_mesh_parameterization::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
#else
#include <CGAL/Texture_atlas/select_seams.h>

void seams(const Mesh& mesh, Mesh::Property_map<Mesh::Edge_index, bool> seams)
{
  CGAL::Texture_atlas::select_seams(mesh, seams);
}
#endif
