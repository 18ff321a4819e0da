// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiles where SuperLU cannot be included: parameterizers, seams, cones and atlases with a solver of Eigen's.

#include "public_headers.h" // all but that of SuperLU's traits: CMakeLists.txt writes it

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>

#include <Eigen/SparseCholesky>

#ifdef CGAL_SUPERLU_ENABLED
#error "This is about programs without SuperLU."
#endif

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> Simplicial;
typedef SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh, Simplicial> Coarse;
typedef SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh> Conformal;

void flatten(Mesh& mesh, Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv)
{
  SMP::flatten_surface(mesh, uv, SMP::ABF_plus_plus_parameterizer_3<Mesh, Simplicial>());
  SMP::flatten_surface(mesh, uv, SMP::Hierarchical_parameterizer_3<Mesh, Coarse>());
  SMP::flatten_surface(mesh, uv, SMP::Hierarchical_parameterizer_3<Mesh, Conformal, Simplicial>());
}

void make_atlas(Mesh& mesh, Mesh::Property_map<Mesh::Edge_index, bool> seams,
                Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv)
{
  const auto np = CGAL::parameters::sparse_linear_solver(Simplicial());
  TA::select_seams(mesh, seams, TA::Seam_options(), np);
  TA::flatten_with_cones(mesh, 8, seams, uv, TA::Cone_options(), np);
  TA::make_atlas(mesh, uv, TA::Atlas_options(), np);
  TA::Soup_atlas atlas;
  TA::make_atlas(TA::Surface_soup(), atlas, TA::Soup_options(), np);
}
