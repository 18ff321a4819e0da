// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "linear_solvers.h" // first: it includes <Eigen/SuperLUSupport>
#include "read_mesh.h"
#include "subcommands.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>

#include <CGAL/version.h>

#include <dlfcn.h>
#include <slu_util.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace ABF_benchmark {

namespace {

constexpr double largest_residual = 1e-8; // a solution with a larger one is a failure

// The linear system of the first Newton step: Eq. 16 at the angles where the solver starts.
Linear_system first_newton_system(const abf::Chart& chart)
{
  const std::vector<double> beta = abf::target_angles(chart);
  const std::vector<double> alpha = abf::starting_angles(beta);
  const abf::Constraint_vector residuals = abf::constraint_residuals(chart, alpha);
  const abf::Constraint_vector no_multipliers = abf::Constraint_vector::Zero(residuals.size());

  const CGAL::Surface_mesh_parameterization::ABF_plus_plus_options options;
  abf::Newton_system newton(chart, beta, abf::Angle_energy{options.barrier}, true,
                            CGAL::Eigen_solver_traits<>());
  Linear_system system;
  system.right_side.eigen_object() = newton.assemble(alpha, no_multipliers, residuals);
  system.columns() = abf::eigen_matrix<double>(newton.matrix());
  return system;
}

// The block of the planarity multipliers, which have even indices
Linear_system planarity_block(const Linear_system& full)
{
  const int n = full.order() / 2;
  Linear_system::Columns even(n, 2 * n);
  even.reserve(Eigen::VectorXi::Ones(2 * n));
  for(int i = 0; i < n; ++i)
    even.insert(i, 2 * i) = 1;
  Linear_system block;
  block.columns() = even * full.columns() * even.transpose();
  block.right_side.eigen_object() = even * full.right_side.eigen_object();
  return block;
}

// Changes the values of the matrix by scaling some rows and the same columns, so it stays definite.
void change_values(Linear_system& system)
{
  const Eigen::VectorXd scale = Eigen::VectorXd::NullaryExpr(
      system.order(), [](const Eigen::Index i) { return 1 + static_cast<double>(i % 5) / 8; });
  system.columns() = scale.asDiagonal() * system.columns() * scale.asDiagonal();
}

// |A x - b| / |b|
double relative_residual(const Linear_system& system, const Solution& x)
{
  const Eigen::VectorXd& b = system.right_side.eigen_object();
  return (system.columns() * x.eigen_object() - b).norm() / b.norm();
}

template <class Function>
double seconds_of_step(const std::string& name, const Function& step)
{
  bool succeeded = false;
  const double seconds = seconds_of([&] { succeeded = step(); });
  if(!succeeded)
    throw std::runtime_error(name + " failed");
  return seconds;
}

// Returns the seconds, and updates the largest residual so far.
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

// The seconds of order, factor and solve, and those of a second factorization (again, again_solve) if it was
// measured. The nonzeros of the factors, and the peak memory beyond that of the matrix.
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

// The mesh is freed before this returns.
Linear_system make_system(const std::string& file, const std::string& matrix, Measurement& m)
{
  Mesh mesh;
  read_mesh(file, mesh);
  Linear_system full = first_newton_system(read_chart(mesh));
  m.add("triangles", mesh.number_of_faces());
  return matrix == "block" ? planarity_block(full) : full;
}

std::string version(const int major, const int minor, const int patch)
{
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
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

void describe_software(Measurement& m)
{
#ifdef __clang__
  m.add("compiler", "Clang " __clang_version__);
#else
  m.add("compiler", "GCC " __VERSION__);
#endif
  m.add("CGAL", CGAL_VERSION_STR);
  m.add("SuperLU", version(SUPERLU_MAJOR_VERSION, SUPERLU_MINOR_VERSION, SUPERLU_PATCH_VERSION));
  m.add("Eigen", version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
#ifdef ABF_WITH_CHOLMOD
  m.add("CHOLMOD", version(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION));
#endif
  // Only OpenBLAS reports its version.
  const auto get_config = reinterpret_cast<const char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_config"));
  m.add("BLAS", get_config != nullptr ? get_config() : "a BLAS that is not OpenBLAS");
}

} // namespace ABF_benchmark
