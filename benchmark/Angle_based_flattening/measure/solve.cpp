// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "linear_solvers.h" // first: it includes <Eigen/SuperLUSupport>
#include "subcommands.h"

#include <algorithm>
#include <stdexcept>

namespace ABF_benchmark {

namespace {

constexpr double largest_residual = 1e-8; // a solution that is further off does not count

template <class Function>
double seconds_of_step(const std::string& name, const Function& step)
{
  bool succeeded = false;
  const double seconds = seconds_of([&] { succeeded = step(); });
  if(!succeeded)
    throw std::runtime_error(name + " failed");
  return seconds;
}

// Returns the seconds; the residual becomes the largest one so far.
template <class Engine>
double solve_once(Engine& engine, const Linear_system& system, double& residual)
{
  Solution x;
  const double seconds = seconds_of_step("solve", [&] { return engine.solve(system.right_side, x); });
  residual = (std::max)(residual, relative_residual(system, x));
  if(!(residual <= largest_residual))
    throw std::runtime_error("residual " + std::to_string(residual));
  return seconds;
}

// In seconds: order, factor, solve, and again and again_solve of a second factorization if that was measured. Nonzeros are
// those of the factors, bytes the largest use of memory beyond the matrix.
template <class Engine>
void run_solver(Linear_system& system, Measurement& m)
{
  double residual = 0;
  const Gauge gauge;
  Engine engine;
  const double order = seconds_of_step("order", [&] { return engine.order(system); });
  const double factor = seconds_of_step("factor", [&] { return engine.factor(system); });
  m.add("solve", solve_once(engine, system, residual));
  m.add("bytes", gauge.bytes());
  m.add("nonzeros", engine.nonzeros());
  if(Engine::factors_again) {
    change_values(system);
    m.add("again", seconds_of_step("second factor", [&] { return engine.factor(system); }));
    m.add("ordering_reused", engine.ordering_reused());
    m.add("again_solve", solve_once(engine, system, residual));
  }
  const double order_within_factor = engine.seconds_of_order(system);
  m.add("order", order + order_within_factor);
  m.add("factor", factor - order_within_factor);
  m.add("residual", residual);
}

// The mesh is out of memory when this returns.
Linear_system make_system(const std::string& file, const std::string& matrix, Measurement& m)
{
  Mesh mesh;
  read_mesh(file, mesh);
  Linear_system full = first_newton_system(read_chart(mesh));
  m.add("triangles", mesh.number_of_faces());
  return matrix == "block" ? planarity_block(full) : full;
}

} // namespace

void solve(const std::string& solver, const std::string& file, const std::string& matrix, Measurement& m)
{
  if(matrix != "full" && matrix != "block")
    throw std::runtime_error("the matrix is full or block");
  Linear_system system = make_system(file, matrix, m);
  m.add("unknowns", system.order());
  if(solver == "superlu")
    run_solver<CGAL_superlu>(system, m);
  else if(solver == "eigen-superlu")
    run_solver<Eigen_superlu>(system, m);
  else if(solver == "eigen-ldlt")
    run_solver<Eigen_ldlt>(system, m);
#ifdef ABF_WITH_CHOLMOD
  else if(solver == "cholmod")
    run_solver<Cholmod_supernodal>(system, m);
#endif
  else
    throw std::runtime_error("there is no solver '" + solver + "'");
}

} // namespace ABF_benchmark
