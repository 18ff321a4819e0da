// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Parameterizers and atlases with solvers of Eigen's and CHOLMOD's, where SuperLU can neither be included nor be linked
// with

#include "public_headers.h" // all but that of SuperLU's traits: CMakeLists.txt writes it

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/SparseCholesky>
#ifdef ABF_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include "../test_meshes.h"

#include <iostream>
#include <string>

#ifdef CGAL_SUPERLU_ENABLED
#error "This is about programs without SuperLU."
#endif

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef Eigen::SparseMatrix<double> Columns;
typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Columns>> Simplicial;

namespace {

int faults = 0;

template <typename Report>
void expect_success(const Report& report, const std::string& what)
{
  std::cout << what << ": " << (report ? "done" : report.message) << "\n";
  faults += !report;
}

template <typename Parameterizer>
void flatten(const char* name)
{
  Mesh mesh = test_meshes::bump<Mesh>(16);
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  expect_success(SMP::flatten_surface(mesh, uv, Parameterizer()), name);
}

void make_atlas()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto np = CGAL::parameters::sparse_linear_solver(Simplicial());
  expect_success(SMP::select_seams(mesh, seams, SMP::Seam_options(), np), "select_seams");
  expect_success(SMP::flatten_with_cones(mesh, 8, seams, uv, SMP::Cone_options(), np), "flatten_with_cones");
  expect_success(SMP::make_atlas(mesh, uv, SMP::Atlas_options(), np), "make_atlas");
}

} // namespace

int main()
{
  typedef SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh, Simplicial> Coarse;
  typedef SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh> Conformal;
  flatten<SMP::ABF_plus_plus_parameterizer_3<Mesh, Simplicial>>("ABF++ with SimplicialLDLT");
#ifdef ABF_WITH_CHOLMOD
  flatten<SMP::ABF_plus_plus_parameterizer_3<
      Mesh, CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Columns>>>>(
      "ABF++ with CholmodSupernodalLLT");
#endif
  flatten<SMP::Hierarchical_parameterizer_3<Mesh, Coarse>>("hierarchical ABF++");
  flatten<SMP::Hierarchical_parameterizer_3<Mesh, Conformal, Simplicial>>("hierarchical LSCM");
  make_atlas();
  return faults;
}
