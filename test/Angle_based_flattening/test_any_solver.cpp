// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// ABF++ with other solvers: those of Eigen, CHOLMOD, and archetypes of CGAL's concepts, which have only what the
// concepts require.

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#ifdef ABF_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_any_solver)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_2 Vector_2;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef SMP::ABF_plus_plus_options Options;
typedef Eigen::SparseMatrix<double> Columns;

namespace {

double angle(const Vector_2& a, const Vector_2& b)
{
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a * b);
}

// The planar angles at all corners, recomputed from the coordinates.
template <typename SolverTraits>
std::vector<double> planar_angles(Surface_mesh& mesh, const Options& options,
                                  const SolverTraits& traits = SolverTraits())
{
  SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, SolverTraits> parameterizer(options, traits);
  const auto uv = mesh.add_property_map<Surface_mesh::Vertex_index, Point_2>("v:uv").first;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, PMP::longest_border(mesh).first, uv) == SMP::OK);
  BOOST_TEST(parameterizer.report().converged);

  std::vector<double> angles;
  for(Surface_mesh::Halfedge_index h : halfedges(mesh))
    if(!is_border(h, mesh)) {
      const Point_2 p = uv[target(h, mesh)];
      angles.push_back(angle(uv[target(next(h, mesh), mesh)] - p, uv[source(h, mesh)] - p));
    }
  return angles;
}

double relative_difference(const std::vector<double>& angles, const std::vector<double>& reference)
{
  BOOST_REQUIRE(angles.size() == reference.size());
  double largest = 0;
  for(std::size_t c = 0; c < angles.size(); ++c)
    largest = (std::max)(largest, std::abs(angles[c] / reference[c] - 1));
  return largest;
}

// Each layout has a linear system of its own.
template <typename SolverTraits>
void check_same_angles(Surface_mesh mesh, const SolverTraits& traits = SolverTraits())
{
  for(Options::Layout_type layout : {Options::EXACT_LAYOUT, Options::LEAST_SQUARES_LAYOUT}) {
    Options options;
    options.layout = layout;
    options.holes = Options::SOLVE;
    options.tolerance = 1e-8;
    options.energy_tolerance = 1e-6;
    const double difference = relative_difference(
        planar_angles(mesh, options, traits), planar_angles<CGAL::SuperLU_solver_traits<>>(mesh, options));
    BOOST_TEST(difference < 1e-8);
    BOOST_TEST_MESSAGE("largest relative difference of an angle: " << difference);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(simplicial_LDLT)
{
  check_same_angles<CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Columns>>>(
      test_meshes::bump<Surface_mesh>(16));
}

// Copies of these traits share their factors, but each matrix has a solver of its own.
BOOST_AUTO_TEST_CASE(simplicial_LDLT_with_a_hole)
{
  Surface_mesh mesh = test_meshes::bump<Surface_mesh>(16);
  const auto is_inside = [&](Surface_mesh::Face_index f) {
    for(Surface_mesh::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh))
      if(mesh.is_border(v))
        return false;
    return true;
  };
  const auto faces = mesh.faces();
  CGAL::Euler::remove_face(halfedge(*std::find_if(faces.begin(), faces.end(), is_inside), mesh), mesh);
  check_same_angles<CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Columns>>>(mesh);
}

BOOST_AUTO_TEST_CASE(sparse_LU)
{
  check_same_angles<CGAL::Eigen_solver_traits<Eigen::SparseLU<Columns>>>(test_meshes::bump<Surface_mesh>(16));
}

#ifdef ABF_WITH_CHOLMOD
BOOST_AUTO_TEST_CASE(cholmod)
{
  check_same_angles<CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Columns>>>(
      test_meshes::bump<Surface_mesh>(16));
}
#endif

// The accuracy of an iterative method is a setting of the user's traits object.
BOOST_AUTO_TEST_CASE(conjugate_gradient)
{
  CGAL::Eigen_solver_traits<Eigen::ConjugateGradient<Columns>> traits;
  traits.solver().setTolerance(1e-13);
  traits.solver().setMaxIterations(10000);
  check_same_angles(test_meshes::bump<Surface_mesh>(16), traits);
}

// CGAL specializes these traits without `factor()`. They start from a vector of ones.
BOOST_AUTO_TEST_CASE(bi_cg_stab)
{
  CGAL::Eigen_solver_traits<Eigen::BiCGSTAB<Columns>> traits;
  static_assert(!SMP::internal::ABF::Has_factor<decltype(traits)>::value, "solves in one call");
  traits.solver().setTolerance(1e-13);
  traits.solver().setMaxIterations(10000);
  check_same_angles(test_meshes::bump<Surface_mesh>(16), traits);
}

namespace {

// Archetype of `SparseLinearAlgebraTraits_d::Vector`. No archetype can be assigned, or has a default constructor
// unless the concepts of all versions of CGAL require it. The number type is not `double`.
class Archetype_vector
{
public:
  typedef long double NT;

  Archetype_vector(int rows) : m_values(rows) {}
  Archetype_vector(const Archetype_vector&) = default;
  Archetype_vector& operator=(const Archetype_vector&) = delete;

  int dimension() const { return static_cast<int>(m_values.size()); }
  NT operator[](int row) const { return m_values.at(row); }
  NT& operator[](int row) { return m_values.at(row); }

private:
  std::vector<NT> m_values;
};

// Archetype of `SparseLinearAlgebraTraits_d::Matrix`, which need not even be copyable.
class Archetype_matrix
{
public:
  typedef long double NT;

  Archetype_matrix(int dimension) : Archetype_matrix(dimension, dimension) {}
  Archetype_matrix(int rows, int columns) : m_rows(rows), m_columns(columns) {}
  Archetype_matrix(const Archetype_matrix&) = delete;
  Archetype_matrix& operator=(const Archetype_matrix&) = delete;

  int row_dimension() const { return m_rows; }
  int column_dimension() const { return m_columns; }

  NT get_coef(int row, int column) const
  {
    const auto entry = m_entries.find(place(row, column));
    return entry == m_entries.end() ? 0 : entry->second;
  }

  void add_coef(int row, int column, NT value) { m_entries[place(row, column)] += value; }

  void set_coef(int row, int column, NT value, bool new_coef = false)
  {
    BOOST_TEST_REQUIRE(!(new_coef && m_entries.count(place(row, column)) > 0));
    m_entries[place(row, column)] = value;
  }

private:
  typedef std::pair<int, int> Place;

  Place place(int row, int column) const
  {
    BOOST_TEST_REQUIRE((row >= 0 && row < m_rows && column >= 0 && column < m_columns));
    return {row, column};
  }

  int m_rows, m_columns;
  std::map<Place, NT> m_entries;
};

// Gauss elimination in a dense matrix.
class Elimination
{
public:
  typedef long double NT;

  explicit Elimination(const Archetype_matrix& A) : m_n(A.row_dimension()), m_entries(m_n * m_n)
  {
    for(std::size_t i = 0; i < m_n; ++i)
      for(std::size_t j = 0; j < m_n; ++j)
        entry(i, j) = A.get_coef(static_cast<int>(i), static_cast<int>(j));
    for(std::size_t k = 0; k < m_n; ++k)
      for(std::size_t i = k + 1; i < m_n; ++i)
        if(entry(i, k) != 0) {
          entry(i, k) /= entry(k, k);
          for(std::size_t j = k + 1; j < m_n; ++j)
            entry(i, j) -= entry(i, k) * entry(k, j);
        }
  }

  // The solution is `X / D`.
  void solve(const Archetype_vector& B, Archetype_vector& X, NT D) const
  {
    const int n = static_cast<int>(m_n);
    BOOST_TEST_REQUIRE((B.dimension() == n && X.dimension() == n));
    for(int i = 0; i < n; ++i) {
      X[i] = D * B[i];
      for(int j = 0; j < i; ++j)
        X[i] -= entry(i, j) * X[j];
    }
    for(int i = n - 1; i >= 0; --i) {
      for(int j = i + 1; j < n; ++j)
        X[i] -= entry(i, j) * X[j];
      X[i] /= entry(i, i);
    }
  }

private:
  NT& entry(std::size_t i, std::size_t j) { return m_entries[i * m_n + j]; }
  NT entry(std::size_t i, std::size_t j) const { return m_entries[i * m_n + j]; }

  std::size_t m_n;
  std::vector<NT> m_entries;
};

struct Calls
{
  int one_call_solves = 0, factorizations = 0, solves = 0;
};

// Archetype of `SparseLinearAlgebraTraits_d`. Parameterizers take their traits by value, hence the copy constructor.
// The test also sets the denominator, and counts the calls of an object and its copies. These are not part of the
// concept.
class Archetype_traits
{
public:
  typedef Archetype_matrix Matrix;
  typedef Archetype_vector Vector;
  typedef long double NT;

  Archetype_traits() = default;
  Archetype_traits(const Archetype_traits&) = default;
  Archetype_traits& operator=(const Archetype_traits&) = delete;
  Archetype_traits(NT denominator, Calls& calls) : m_denominator(denominator), m_calls(&calls) {}

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    ++m_calls->one_call_solves;
    D = m_denominator;
    Elimination(A).solve(B, X, D);
    return true;
  }

protected:
  NT m_denominator = 1;
  Calls* m_calls = nullptr;
};

// Archetype of `SparseLinearAlgebraWithFactorTraits_d`. It refers to the caller's matrix until the last solution, as
// `Eigen_solver_traits` does.
class Archetype_factor_traits : public Archetype_traits
{
public:
  using Archetype_traits::Archetype_traits;
  using Archetype_traits::linear_solver;

  bool factor(const Matrix& A, NT& D)
  {
    ++m_calls->factorizations;
    m_matrix = &A;
    D = m_denominator;
    return true;
  }

  bool linear_solver(const Vector& B, Vector& X)
  {
    ++m_calls->solves;
    Elimination(*m_matrix).solve(B, X, m_denominator);
    return true;
  }

  bool linear_solver(const Matrix&, Vector&) { return false; }

private:
  const Matrix* m_matrix = nullptr;
};

template <typename SolverTraits>
Calls check_archetype(int denominator)
{
  Calls calls;
  check_same_angles(test_meshes::bump<Surface_mesh>(6), SolverTraits(denominator, calls));
  return calls;
}

} // namespace

BOOST_AUTO_TEST_CASE(archetype)
{
  static_assert(!SMP::internal::ABF::Has_factor<Archetype_traits>::value, "solves in one call");
  BOOST_TEST(check_archetype<Archetype_traits>(1).one_call_solves > 0);
}

// One factorization is enough for the right-hand sides of a layout: the exact one has two, and the least squares one
// is solved again for a correction.
BOOST_AUTO_TEST_CASE(archetype_with_factor)
{
  static_assert(SMP::internal::ABF::Has_factor<Archetype_factor_traits>::value, "factors");
  const Calls calls = check_archetype<Archetype_factor_traits>(1);
  BOOST_TEST(calls.one_call_solves == 0);
  BOOST_TEST(calls.factorizations > 0);
  BOOST_TEST(calls.solves >= calls.factorizations + 2);

  // Without `factor()`, each system is solved separately, and none is a preconditioner.
  const Calls one_by_one = check_archetype<Archetype_traits>(1);
  BOOST_TEST(one_by_one.factorizations == 0);
  BOOST_TEST(one_by_one.one_call_solves < calls.solves);
}

// The solution is `X / D`.
BOOST_AUTO_TEST_CASE(denominators)
{
  for(int denominator : {3, -4}) {
    BOOST_TEST(check_archetype<Archetype_traits>(denominator).one_call_solves > 0);
    BOOST_TEST(check_archetype<Archetype_factor_traits>(denominator).solves > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
