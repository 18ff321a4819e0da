// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHOSEN_SOLVER_H
#define FLATTEN_MESH_CHOSEN_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <memory>
#include <string>

namespace flatten_mesh {

// Traits of one of several solvers, which is known only at run time: the parameterizers are compiled once for all of
// them.
struct Chosen_solver
{
  using Source = CGAL::Surface_mesh_parameterization::internal::ABF::Solver_source;

  std::shared_ptr<const Source> source;
};

// Where the parameterizers get their solvers from
inline std::shared_ptr<const Chosen_solver::Source> solver_source(const Chosen_solver& solver)
{
  return solver.source;
}

// The solver that `--solver` names
Chosen_solver choose_solver(const std::string& name);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHOSEN_SOLVER_H
