// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Functions that take the solver as a named parameter, with one of Eigen's

#include "checks.h"
#include "public_headers.h" // all but that of SuperLU's traits: CMakeLists.txt writes it

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/SparseCholesky>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace SMP = CGAL::Surface_mesh_parameterization;

void without_superlu::make_atlases()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1);
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto np = CGAL::parameters::sparse_linear_solver(
      CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>());

  const auto selected = SMP::select_seams(mesh, seams, SMP::Seam_options(), np);
  expect(bool(selected), "select_seams", selected.message);
  const auto cones = SMP::select_cones(mesh, 8, SMP::Cone_options(), np);
  expect(bool(cones), "select_cones", cones.message);
  const auto flattened = SMP::flatten_with_cones(mesh, 8, seams, uv, SMP::Cone_options(), np);
  expect(bool(flattened), "flatten_with_cones", flattened.message);
  const auto atlas = SMP::make_atlas(mesh, uv, SMP::Atlas_options(), np);
  expect(bool(atlas), "make_atlas", atlas.message);
}
