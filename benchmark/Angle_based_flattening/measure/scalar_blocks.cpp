// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// SuperLU beside Eigen's Cholesky factorization, both in single precision, on what preconditions Eq. 16: its two scalar
// blocks. Both solvers run in turn in one process, so that their ratio does not depend on what else the machine does.

#include "read_mesh.h"
#include "subcommands.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace ABF_benchmark {

namespace {

typedef Eigen::SparseMatrix<float> Columns;

// Two matrices of one pattern, and right-hand sides
struct Scalar_blocks
{
  std::array<CGAL::Eigen_sparse_matrix<float>, 2> matrix = {CGAL::Eigen_sparse_matrix<float>(1),
                                                            CGAL::Eigen_sparse_matrix<float>(1)};
  std::vector<CGAL::Eigen_vector<float>> right_sides;
};

// Those of the first Newton step. The right-hand sides are random, as residuals of conjugate gradients look.
Scalar_blocks first_scalar_blocks(const abf::Chart& chart)
{
  const std::vector<double> beta = abf::target_angles(chart), alpha = abf::starting_angles(beta);
  const abf::Constraint_vector residuals = abf::constraint_residuals(chart, alpha);
  const CGAL::Surface_mesh_parameterization::ABF_plus_plus_options options;
  abf::Newton_system newton(chart, beta, abf::Angle_energy{options.barrier}, true,
                            CGAL::SuperLU_solver_traits<>());
  newton.assemble(alpha, abf::Constraint_vector::Zero(residuals.size()), residuals);
  Scalar_blocks blocks;
  for(int k = 0; k < 2; ++k)
    abf::set_eigen_matrix(abf::Diagonal_part<2>{newton.matrix(), k}, blocks.matrix[k].eigen_object());
  const int number = 8, n = static_cast<int>(blocks.matrix[0].row_dimension());
  for(int i = 0; i < number; ++i) {
    blocks.right_sides.emplace_back(n);
    blocks.right_sides.back().eigen_object().setRandom();
  }
  return blocks;
}

// The counterpart of lower precision of the default solver, as the direct method uses it: copies know the order.
class Two_of_SuperLU
{
  typedef CGAL::Low_precision_solver_traits<CGAL::SuperLU_solver_traits<>> Counterpart;
  typedef Counterpart::type Solver;

public:
  static constexpr double orders_of_a_run = 1; // for both blocks and the layout

  bool order(const Scalar_blocks& blocks)
  {
    if(!m_solvers[0].analyze_pattern(blocks.matrix[0]))
      return false;
    m_solvers[1] = m_solvers[0];
    return true;
  }

  bool factor(const Scalar_blocks& blocks, int k)
  {
    float denominator = 1;
    return m_solvers[k].factor(blocks.matrix[k], denominator);
  }

  bool solve(int k, const CGAL::Eigen_vector<float>& b, CGAL::Eigen_vector<float>& x)
  {
    return m_solvers[k].linear_solver(b, x);
  }

private:
  std::array<Solver, 2> m_solvers = {Counterpart::create({}), Counterpart::create({})};
};

// Eigen's solvers cannot be copied, and so each of them orders.
class Two_of_Eigen
{
  typedef Eigen::SimplicialLLT<Columns, Eigen::Lower, Eigen::AMDOrdering<int>> Solver;

public:
  static constexpr double orders_of_a_run = 1.5;

  bool order(const Scalar_blocks& blocks)
  {
    for(int k = 0; k < 2; ++k)
      m_solvers[k].analyzePattern(blocks.matrix[k].eigen_object());
    return true;
  }

  bool factor(const Scalar_blocks& blocks, int k)
  {
    m_solvers[k].factorize(blocks.matrix[k].eigen_object());
    return m_solvers[k].info() == Eigen::Success;
  }

  bool solve(int k, const CGAL::Eigen_vector<float>& b, CGAL::Eigen_vector<float>& x)
  {
    x.eigen_object() = m_solvers[k].solve(b.eigen_object());
    return m_solvers[k].info() == Eigen::Success;
  }

private:
  std::array<Solver, 2> m_solvers;
};

double processor_seconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The least times of all rounds, for both blocks, and the largest relative residual
struct Times
{
  double order = (std::numeric_limits<double>::infinity)(), factor = order;
  double again = order; // another factorization, whose memory is there already
  double solve = order, residual = 0;
};

template <class Function>
void measure_least(double& least, const Function& function)
{
  const double start = processor_seconds();
  const bool succeeded = function();
  least = (std::min)(least, processor_seconds() - start);
  if(!succeeded)
    throw std::runtime_error("a solver failed");
}

double relative_residual(const Columns& a, const Eigen::VectorXf& b, const Eigen::VectorXf& x)
{
  const Eigen::VectorXd right_side = b.cast<double>();
  return (a.cast<double>() * x.cast<double>() - right_side).norm() / right_side.norm();
}

template <class Solvers>
void run_round(const Scalar_blocks& blocks, Times& times)
{
  Solvers solvers;
  measure_least(times.order, [&] { return solvers.order(blocks); });
  for(double* least : {&times.factor, &times.again})
    measure_least(*least, [&] { return solvers.factor(blocks, 0) && solvers.factor(blocks, 1); });
  std::vector<std::array<CGAL::Eigen_vector<float>, 2>> solutions(blocks.right_sides.size());
  double all = (std::numeric_limits<double>::infinity)();
  measure_least(all, [&] {
    bool done = true;
    for(std::size_t i = 0; i < solutions.size(); ++i)
      for(int k = 0; k < 2; ++k)
        done = solvers.solve(k, blocks.right_sides[i], solutions[i][k]) && done;
    return done;
  });
  times.solve = (std::min)(times.solve, all / static_cast<double>(solutions.size()));
  for(int k = 0; k < 2; ++k)
    times.residual = (std::max)(times.residual, relative_residual(blocks.matrix[k].eigen_object(),
                                                                  blocks.right_sides[0], solutions[0][k]));
}

// What a run of the direct method takes of them: orders, three factorizations (both blocks and the layout), and as many
// solutions with both blocks as conjugate gradients take on an ordinary chart
double of_a_run(const Times& times, double orders)
{
  constexpr int steps = 30;
  return orders * times.order + times.factor + 0.5 * times.again + steps * times.solve;
}

void add(const Times& times, double run, const std::string& name, Measurement& m)
{
  m.add(name + " order", times.order);
  m.add(name + " factor", times.factor);
  m.add(name + " again", times.again);
  m.add(name + " solve", times.solve);
  m.add(name + " run", run);
  m.add(name + " residual", times.residual);
}

} // namespace

void scalar_blocks(const std::string& file, int repeat, Measurement& m)
{
  Mesh mesh;
  read_mesh(file, mesh);
  m.add("triangles", mesh.number_of_faces());
  const Scalar_blocks blocks = first_scalar_blocks(read_chart(mesh));
  mesh.clear();
  m.add("unknowns", blocks.matrix[0].row_dimension());
  Times of_superlu, of_eigen;
  for(int round = 0; round < repeat; ++round) {
    run_round<Two_of_SuperLU>(blocks, of_superlu);
    run_round<Two_of_Eigen>(blocks, of_eigen);
  }
  add(of_superlu, of_a_run(of_superlu, Two_of_SuperLU::orders_of_a_run), "superlu", m);
  add(of_eigen, of_a_run(of_eigen, Two_of_Eigen::orders_of_a_run), "eigen", m);
}

} // namespace ABF_benchmark
