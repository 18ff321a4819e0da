// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Parameterizers with solvers of Eigen's and CHOLMOD's, where SuperLU can neither be included nor be linked with

#include "checks.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#ifdef ABF_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include "../test_meshes.h"

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef Eigen::SparseMatrix<double> Columns;

namespace {

template <typename Parameterizer>
void check(const char* name)
{
  Mesh mesh = test_meshes::bump<Mesh>(16);
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto report = SMP::flatten_surface(mesh, uv, Parameterizer());
  without_superlu::expect(bool(report), name, report.message);
}

template <typename Solver>
void check_solver(const char* name)
{
  check<SMP::ABF_plus_plus_parameterizer_3<Mesh, CGAL::Eigen_solver_traits<Solver>>>(name);
}

} // namespace

void without_superlu::flatten_charts()
{
  typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Columns>> Simplicial;
  typedef SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh, Simplicial> Coarse;
  typedef SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh> Conformal;
  check_solver<Eigen::SimplicialLDLT<Columns>>("ABF++ with SimplicialLDLT");
  check_solver<Eigen::SparseLU<Columns>>("ABF++ with SparseLU");
#ifdef ABF_WITH_CHOLMOD
  check_solver<Eigen::CholmodSupernodalLLT<Columns>>("ABF++ with CholmodSupernodalLLT");
#endif
  check<SMP::Hierarchical_parameterizer_3<Mesh, Coarse>>("hierarchical ABF++");
  check<SMP::Hierarchical_parameterizer_3<Mesh, Conformal, Simplicial>>("hierarchical LSCM");
}
