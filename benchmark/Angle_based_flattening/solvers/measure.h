// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_MEASURE_H
#define SOLVERS_MEASURE_H

#include "engines.h"

#include "Linear_system.h"

#include "../common/Measurement.h"
#include "../common/Peak_memory.h"
#include "../common/format.h"

#include <algorithm>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace solvers {

using namespace benchmarks;

constexpr double largest_residual = 1e-8; // a solution that is further off does not count

namespace internal {

struct Solver_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

template <class Function>
double seconds_of_step(const std::string& name, const Function& step)
{
  bool succeeded = false;
  const double seconds = seconds_of([&] { succeeded = step(); });
  if(!succeeded) {
    throw Solver_error(name + " failed");
  }
  return seconds;
}

// Returns the seconds; the residual becomes the largest one so far.
template <class Engine>
double measure_solve(Engine& engine, const Linear_system& system, Measurement& m)
{
  CGAL_vector x;
  const double seconds = seconds_of_step("solve", [&] { return engine.solve(system.right_side, x); });
  const double residual = relative_residual(system, x);
  if(!(residual <= largest_residual)) {
    throw Solver_error("residual " + format_number("%.1e", residual));
  }
  m.numbers["residual"] = (std::max)(m.numbers["residual"], residual);
  return seconds;
}

// In seconds: order, factor, solve, and again and again_solve of a second factorization if that was measured. Nonzeros are
// those of the factors, bytes the largest use of memory beyond the matrix.
template <class Engine>
Measurement measure_engine(Linear_system& system)
{
  Measurement m;
  std::map<std::string, double>& numbers = m.numbers;
  const Peak_memory memory;
  Engine engine;
  numbers["order"] = seconds_of_step("order", [&] { return engine.order(system); });
  numbers["factor"] = seconds_of_step("factor", [&] { return engine.factor(system); });
  numbers["solve"] = measure_solve(engine, system, m);
  numbers["bytes"] = memory.bytes();
  numbers["nonzeros"] = engine.nonzeros();

  if(Engine::factors_again) {
    change_values(system);
    numbers["again"] = seconds_of_step("second factor", [&] { return engine.factor(system); });
    numbers["ordering_reused"] = engine.ordering_reused();
    numbers["again_solve"] = measure_solve(engine, system, m);
  }
  const double order = engine.seconds_of_order(system);
  numbers["order"] += order;
  numbers["factor"] -= order;
  return m;
}

} // namespace internal

// A solver as the table and the command line know it.
struct Solver
{
  const char* name;
  const char* title;
  Measurement (*measure)(Linear_system&);
};

// Names that the ratios of the report need
constexpr const char* cgal_superlu = "superlu";
constexpr const char* eigen_superlu = "eigen-superlu";
constexpr const char* cholmod = "cholmod";

inline const std::vector<Solver>& all_solvers()
{
  static const std::vector<Solver> solvers = {
      {cgal_superlu, "SuperLU, `CGAL::SuperLU_solver_traits`", internal::measure_engine<CGAL_superlu>},
      {eigen_superlu, "SuperLU, `Eigen::SuperLU`", internal::measure_engine<Eigen_superlu>},
      {"eigen-ldlt", "`Eigen::SimplicialLDLT`", internal::measure_engine<Eigen_ldlt>},
#ifdef ABF_WITH_CHOLMOD
      {cholmod, "CHOLMOD, `Eigen::CholmodSupernodalLLT`", internal::measure_engine<Cholmod_supernodal>},
#endif
  };
  return solvers;
}

// Runs the solver of that name on the linear system in a file.
inline Measurement measure(const std::string& name, const std::string& file)
{
  for(const Solver& solver : all_solvers()) {
    if(name == solver.name) {
      Linear_system system = read_system(file);
      try {
        return solver.measure(system);
      } catch(const internal::Solver_error& error) {
        return failed_measurement(error.what());
      } catch(const std::bad_alloc&) {
        return failed_measurement("out of memory");
      }
    }
  }
  throw std::runtime_error("unknown solver '" + name + "'");
}

} // namespace solvers

#endif // SOLVERS_MEASURE_H
