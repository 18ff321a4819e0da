// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHOSEN_SOLVER_H
#define FLATTEN_MESH_CHOSEN_SOLVER_H

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <Eigen/SparseCholesky>

#ifdef ABF_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <memory>
#include <string>

namespace flatten_mesh {

// Traits of the solver that `--solver` names: the parameterizers are compiled once for all of them.
struct Chosen_solver
{
  using Source = CGAL::Surface_mesh_parameterization::internal::ABF::Solver_source;

  explicit Chosen_solver(const std::string& name)
  {
    namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
    using Matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
    if(name == "eigen") {
      source = ABF::solver_source(CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Matrix>>());
#ifdef ABF_WITH_CHOLMOD
    } else if(name == "cholmod") {
      source = ABF::solver_source(CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Matrix>>());
#endif
    } else {
      source = ABF::solver_source(CGAL::SuperLU_solver_traits<>());
    }
  }

  std::shared_ptr<const Source> source;
};

// Where the parameterizers get their solvers from
inline std::shared_ptr<const Chosen_solver::Source> solver_source(const Chosen_solver& solver)
{
  return solver.source;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHOSEN_SOLVER_H
