// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/Chosen_solver.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/SuperLU_solver_traits.h>

#include <Eigen/SparseCholesky>

#ifdef ABF_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace flatten_mesh {

Chosen_solver choose_solver(const std::string& name)
{
  using Matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
  namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
  if(name == "eigen") {
    return {ABF::solver_source(CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Matrix>>())};
  }
#ifdef ABF_WITH_CHOLMOD
  if(name == "cholmod") {
    return {ABF::solver_source(CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Matrix>>())};
  }
#endif
  return {ABF::solver_source(CGAL::SuperLU_solver_traits<>())};
}

} // namespace flatten_mesh
