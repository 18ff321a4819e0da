// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The given solver solves all systems, with the settings of the given object.

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Solver_traits_factory.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_solver_traits_factory)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef SMP::Hierarchical_coarse_mesh Surface_mesh; // so that one parameterizer is compiled for both levels
typedef CGAL::Simple_cartesian<double>::Point_2 Point_2;
typedef SMP::ABF_plus_plus_options Options;
typedef Eigen::SparseMatrix<double> Columns;

namespace {

struct Factorization
{
  bool is_double;
  Eigen::Index size;
  CGAL::SuperLU_options options;
  const void* solver;
};

struct Log
{
  std::mutex mutex;
  std::vector<Factorization> factorizations;
  bool refuses = false; // every matrix

  std::size_t count(bool is_double) const
  {
    return std::count_if(factorizations.begin(), factorizations.end(),
                         [&](const Factorization& f) { return f.is_double == is_double; });
  }
};

// The default solver, which logs what it factors.
template <class FT>
class Logging_solver : public CGAL::SuperLU_solver_traits<FT>
{
  typedef CGAL::SuperLU_solver_traits<FT> Base;

public:
  using typename Base::Matrix;
  using Base::linear_solver;

  Logging_solver(const CGAL::SuperLU_options& options, Log& log) : Base(options), m_log(&log) {}

  bool factor(const Matrix& A, FT& D)
  {
    const std::lock_guard<std::mutex> lock(m_log->mutex);
    m_log->factorizations.push_back(
        {std::is_same<FT, double>::value, A.eigen_object().rows(), this->options(), this});
    return !m_log->refuses && Base::factor(A, D);
  }

  Log& log() const { return *m_log; }

private:
  Log* m_log;
};

CGAL::SuperLU_options unusual_options()
{
  CGAL::SuperLU_options options;
  options.relax = 7;
  options.panel_width = 3;
  return options;
}

// Copies own their factors: each factorization is a new object. Nothing else is known about it.
class Own_solver
{
public:
  typedef double NT;
  typedef CGAL::Eigen_sparse_matrix<double> Matrix;
  typedef CGAL::Eigen_vector<double> Vector;

  explicit Own_solver(Log& log) : m_log(&log) {}

  bool factor(const Matrix& A, NT& D)
  {
    {
      const std::lock_guard<std::mutex> lock(m_log->mutex);
      m_log->factorizations.push_back({true, A.eigen_object().rows(), {}, this});
    }
    D = 1;
    m_ldlt = std::make_shared<Eigen::SimplicialLDLT<Columns>>(A.eigen_object());
    return m_ldlt->info() == Eigen::Success;
  }

  bool linear_solver(const Vector& B, Vector& X)
  {
    X.eigen_object() = m_ldlt->solve(B.eigen_object());
    return m_ldlt->info() == Eigen::Success;
  }

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    return factor(A, D) && linear_solver(B, X);
  }

private:
  std::shared_ptr<Eigen::SimplicialLDLT<Columns>> m_ldlt;
  Log* m_log;
};

} // namespace

BOOST_AUTO_TEST_SUITE_END()

template <>
struct CGAL::Low_precision_solver_traits<test_solver_traits_factory::Logging_solver<double>>
{
  typedef test_solver_traits_factory::Logging_solver<float> type;
  static type create(const test_solver_traits_factory::Logging_solver<double>& traits)
  {
    return type(traits.options(), traits.log());
  }
};

BOOST_AUTO_TEST_SUITE(test_solver_traits_factory)

namespace {

// Runs a parameterizer on a bump, and returns its report, as far as linear systems go: what must have been factored.
template <typename Parameterizer>
auto report_of(Parameterizer parameterizer, int n)
{
  auto mesh = test_meshes::bump<Surface_mesh>(n);
  const auto uv = mesh.add_property_map<Surface_mesh::Vertex_index, Point_2>("v:uv").first;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, PMP::longest_border(mesh).first, uv) == SMP::OK);
  return parameterizer.report();
}

std::size_t factorizations(const SMP::ABF_plus_plus_report& report)
{
  std::size_t sum = 1 + report.layout_repeated;
  for(const SMP::ABF_plus_plus_step& step : report.steps)
    sum += step.factorizations + step.repeated_factorizations;
  return sum;
}

void check_that_options_are_seen(const Log& log)
{
  for(const Factorization& f : log.factorizations)
    BOOST_TEST((f.options.relax == 7 && f.options.panel_width == 3));
}

} // namespace

// Each factorization of a run is made by the traits given, or their counterpart, with the options of the caller's
// object.
BOOST_AUTO_TEST_CASE(all_factorizations_are_made_by_the_traits_given)
{
  typedef Logging_solver<double> Solver;
  for(int n : {2, 10, 150})
    for(Options::Linear_solver solver : {Options::ITERATIVE, Options::DIRECT})
      for(Options::Layout_type layout : {Options::EXACT_LAYOUT, Options::LEAST_SQUARES_LAYOUT}) {
        Log log;
        Options options;
        options.linear_solver = solver;
        options.layout = layout;
        const auto report = report_of(
            SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Solver>(options, Solver(unusual_options(), log)),
            n);
        BOOST_TEST(log.factorizations.size() == factorizations(report));
        check_that_options_are_seen(log);
        const std::size_t whole = solver == Options::DIRECT ? report.steps.size() : 0;
        BOOST_TEST(log.count(true) == whole + (layout == Options::LEAST_SQUARES_LAYOUT));
        if(solver == Options::ITERATIVE) { // two solvers, for two matrices of the same size
          BOOST_REQUIRE(log.factorizations.size() >= 2);
          const Factorization &first = log.factorizations[0], &second = log.factorizations[1];
          BOOST_TEST((first.size == (n - 1) * (n - 1) && second.size == first.size));
          BOOST_TEST(first.solver != second.solver);
        }
      }
}

BOOST_AUTO_TEST_CASE(coarse_charts_and_polishing_are_solved_by_the_traits_given)
{
  typedef Logging_solver<double> Solver;
  typedef SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Solver> Coarse;
  Log log, polishing_log;
  SMP::Hierarchical_options options;
  const Coarse coarse(Options(), Solver(unusual_options(), log));
  SMP::Hierarchical_parameterizer_3<Surface_mesh, Coarse> plain(options, coarse);
  report_of(plain, 40);
  const std::size_t of_coarse_chart = log.factorizations.size();
  BOOST_TEST(of_coarse_chart == factorizations(plain.coarse_parameterizer().report()));

  options.polish = true;
  log.factorizations.clear();
  BOOST_TEST(
      report_of(SMP::Hierarchical_parameterizer_3<Surface_mesh, Coarse>(options, coarse), 40).polished);
  BOOST_TEST(log.factorizations.size() >= of_coarse_chart + 3);
  check_that_options_are_seen(log);

  log.factorizations.clear();
  const SMP::Hierarchical_parameterizer_3<Surface_mesh, Coarse> with_two(
      options, coarse, Solver(unusual_options(), polishing_log));
  BOOST_TEST(report_of(with_two, 40).polished);
  BOOST_TEST(log.factorizations.size() == of_coarse_chart);
  BOOST_TEST(polishing_log.factorizations.size() >= 3);
}

BOOST_AUTO_TEST_CASE(solver_of_ones_own_factors_two_matrices_at_once)
{
  Log log;
  const auto report =
      report_of(SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Own_solver>(Options(), Own_solver(log)), 16);
  BOOST_TEST(log.factorizations.size() == factorizations(report));
  BOOST_REQUIRE(log.factorizations.size() >= 3);
  BOOST_TEST(log.factorizations[0].solver != log.factorizations[1].solver);
  for(const Factorization& f : log.factorizations)
    BOOST_TEST(f.size == 15 * 15);
  typedef Logging_solver<double> Solver;
  const auto expected = report_of(
      SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Solver>(Options(), Solver(unusual_options(), log)),
      16);
  BOOST_TEST(report.energy == expected.energy, boost::test_tools::tolerance(1e-6));
}

// No other solver replaces one that refuses.
BOOST_AUTO_TEST_CASE(nothing_replaces_the_traits_given)
{
  typedef Logging_solver<double> Solver;
  typedef SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Solver> Direct;
  Log log;
  log.refuses = true;
  auto mesh = test_meshes::bump<Surface_mesh>(8);
  const auto uv = mesh.add_property_map<Surface_mesh::Vertex_index, Point_2>("v:uv").first;
  for(Options::Linear_solver solver : {Options::ITERATIVE, Options::DIRECT}) {
    Options options;
    options.linear_solver = solver;
    Direct parameterizer(options, Solver(unusual_options(), log));
    BOOST_TEST(SMP::parameterize(mesh, parameterizer, PMP::longest_border(mesh).first, uv) ==
               SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
  }
  SMP::Hierarchical_options options;
  options.polish = true;
  const Direct coarse(Options(), Solver(unusual_options(), log));
  const auto report = report_of(SMP::Hierarchical_parameterizer_3<Surface_mesh, Direct>(options, coarse), 16);
  BOOST_TEST(report.start == SMP::Hierarchical_report::PROGRESSIVE_EMBEDDING);
  BOOST_TEST(!report.polished);
}

BOOST_AUTO_TEST_SUITE_END()
