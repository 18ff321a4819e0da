// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

// Other code may use names of SuperLU before its header is included...
#define ABORT a_macro_of_the_user
#define COL 17
namespace used_before {
enum Names
{
  EMPTY = 7,
  TRUE,
  FALSE,
  NO,
  YES,
  ROW,
  TRANS,
  FACT,
  SOLVE,
  COLAMD,
  NATURAL
};
}

#include <CGAL/SuperLU_solver_traits.h>

#include <Eigen/QR>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#include <sys/resource.h>
#define TEST_MEMORY_LIMIT
#endif

#define TEXT_2(x) #x
#define TEXT(x) TEXT_2(x)

// ...and after it.
enum User_enumerators
{
  EMPTY = 3,
  TRUE,
  FALSE,
  NO,
  YES,
  ROW,
  TRANS,
  FACT,
  SOLVE,
  NO_MARKER
};
struct SuperMatrix
{
  int int_t;
};

BOOST_AUTO_TEST_SUITE(test_SuperLU_solver_traits)

template <class FT>
using Solver = CGAL::SuperLU_solver_traits<FT>;
template <class FT>
using Vector = typename Solver<FT>::Vector;
typedef Eigen::SparseMatrix<double> Columns;
typedef std::tuple<double, float> Number_types;

static_assert(std::is_same<Solver<double>, CGAL::SuperLU_solver_traits<>>::value, "the default");
static_assert(std::is_base_of<CGAL::Eigen_sparse_matrix<float>, Solver<float>::Matrix>::value &&
                  std::is_same<Solver<float>::Vector, CGAL::Eigen_vector<float>>::value,
              "types of CGAL");
static_assert(std::is_copy_constructible<Solver<float>>::value &&
                  std::is_copy_assignable<Solver<float>>::value,
              "copyable");
static_assert(std::is_nothrow_move_constructible<Solver<float>>::value, "movable");

Columns grid_laplacian(int width, int height, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(int y = 0; y < height; ++y) {
    for(int x = 0; x < width; ++x) {
      const int i = y * width + x;
      entries.emplace_back(i, i, 4 + shift);
      if(x + 1 < width) {
        entries.emplace_back(i, i + 1, -1);
        entries.emplace_back(i + 1, i, -1);
      }
      if(y + 1 < height) {
        entries.emplace_back(i, i + width, -1);
        entries.emplace_back(i + width, i, -1);
      }
    }
  }
  Columns a(width * height, width * height);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

Columns random_matrix(int n, int entries_per_column, std::mt19937& random, double diagonal)
{
  std::uniform_real_distribution<double> value(-1, 1);
  std::uniform_int_distribution<int> index(0, n - 1);
  std::vector<Eigen::Triplet<double>> entries;
  for(int j = 0; j < n; ++j) {
    entries.emplace_back(j, j, diagonal + 0.1 * value(random));
    for(int k = 0; k < entries_per_column; ++k)
      entries.emplace_back(index(random), j, value(random));
  }
  Columns a(n, n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

Columns random_definite(int n, std::mt19937& random)
{
  const Columns a = random_matrix(n, 3, random, 2);
  Columns identity(n, n);
  identity.setIdentity();
  return Columns(Columns(a.transpose()) * a) + identity;
}

// The matrix with its entries rounded to the number type
template <class FT = double>
typename Solver<FT>::Matrix rounded(const Columns& a)
{
  return typename Solver<FT>::Matrix(Eigen::SparseMatrix<FT>(a.cast<FT>()));
}

template <class FT = double>
Vector<FT> random_vector(int n, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(-1, 1);
  Vector<FT> b(n);
  for(int i = 0; i < n; ++i)
    b.set(i, static_cast<FT>(value(random)));
  return b;
}

void check_solution(const Columns& a, const Vector<double>& b, const Vector<double>& x,
                    double tolerance = 1e-10)
{
  Eigen::SparseLU<Columns> reference(a);
  BOOST_REQUIRE(reference.info() == Eigen::Success);
  const Eigen::VectorXd y = reference.solve(b.eigen_object());
  BOOST_REQUIRE_EQUAL(x.size(), y.size());
  BOOST_CHECK_LE((x - y).norm(), tolerance * y.norm());
}

// The condition number may cost all digits of a float, so this checks the backward error: a few units of the
// precision, times the ratio of the tolerance for `double` to its default.
void check_solution(const Columns& a, const Vector<float>& b, const Vector<float>& x,
                    double tolerance = 1e-10)
{
  const Columns single = a.cast<float>().cast<double>();
  const Eigen::VectorXd right_side = b.eigen_object().cast<double>(),
                        solution = x.eigen_object().cast<double>();
  BOOST_REQUIRE_EQUAL(solution.size(), a.cols());
  const Eigen::VectorXd row_sums = single.cwiseAbs() * Eigen::VectorXd::Ones(a.cols());
  const double scale = row_sums.maxCoeff() * solution.lpNorm<Eigen::Infinity>();
  BOOST_CHECK_LE((single * solution - right_side).lpNorm<Eigen::Infinity>(),
                 1e-6 * (tolerance / 1e-10) * scale);
}

template <class FT>
void check_solver(const Columns& a, std::mt19937& random, bool symmetric, double tolerance = 1e-10)
{
  Solver<FT> solver;
  FT d = 0;
  const int n = static_cast<int>(a.cols());
  const Vector<FT> b = random_vector<FT>(n, random);
  Vector<FT> x(1);
  BOOST_REQUIRE(solver.linear_solver(rounded<FT>(a), b, x, d));
  BOOST_CHECK_EQUAL(d, 1);
  BOOST_CHECK_EQUAL(solver.symmetric(), symmetric);
  BOOST_CHECK_GE(solver.factor_nonzeros(), static_cast<std::size_t>(n));
  check_solution(a, b, x, tolerance);
}

template <class FT>
void check_refused(const Columns& a)
{
  Solver<FT> solver;
  FT d;
  Vector<FT> x(a.rows()), b(a.rows());
  b.setOnes();
  BOOST_CHECK(!solver.factor(rounded<FT>(a), d));
  BOOST_CHECK(!solver.is_factored());
  BOOST_CHECK(!solver.linear_solver(b, x));
  // it is still usable
  const Columns good = grid_laplacian(5, 4, 1);
  Vector<FT> ones(good.rows());
  ones.setOnes();
  BOOST_CHECK(solver.linear_solver(rounded<FT>(good), ones, x, d));
  check_solution(good, ones, x);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(definite, FT, Number_types)
{
  std::mt19937 random(1);
  for(int size : {1, 2, 3, 7, 20, 61})
    check_solver<FT>(grid_laplacian(size, size + 1, 0.01), random, true);
  for(int n : {1, 2, 5, 30, 200, 700}) {
    for(int k = 0; k < 5; ++k) {
      const Columns a = random_definite(n, random);
      check_solver<FT>(a, random, true);
      check_solver<FT>(-a, random, true);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(degenerate_patterns, FT, Number_types)
{
  std::mt19937 random(2);
  Columns diagonal(1000, 1000);
  diagonal.setIdentity();
  check_solver<FT>(diagonal, random, true);
  check_solver<FT>(grid_laplacian(1, 100000, 0.1), random, true); // a long chain
  Columns chain = grid_laplacian(1, 100000, 0.1);
  chain.coeffRef(5, 6) = -2;
  check_solver<FT>(chain, random, false);
  std::vector<Eigen::Triplet<double>> entries; // an arrow
  const int n = 500;
  for(int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, n);
    if(i > 0) {
      entries.emplace_back(0, i, 1);
      entries.emplace_back(i, 0, 1);
    }
  }
  Columns arrow(n, n);
  arrow.setFromTriplets(entries.begin(), entries.end());
  // the last pivot is the remainder after 499 subtractions
  check_solver<FT>(arrow, random, true, std::is_same<FT, double>::value ? 1e-10 : 1e-9);
  check_solver<FT>(Columns(Eigen::MatrixXd(random_definite(60, random)).sparseView()), random, true);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(badly_scaled, FT, Number_types)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> exponent(-40, 40);
  for(int k = 0; k < 10; ++k) {
    const int n = 300;
    const Columns a = random_definite(n, random);
    const Columns u = random_matrix(n, 3, random, 3);
    Eigen::VectorXi e(n), f(n);
    for(int i = 0; i < n; ++i) {
      e[i] = exponent(random);
      f[i] = exponent(random);
    }
    // a solution of the scaled system is one of the original system
    for(bool symmetric : {true, false}) {
      // a float lacks the digits for the scales that equilibration leaves
      const int divisor = symmetric || std::is_same<FT, double>::value ? 1 : 4;
      Eigen::VectorXd s(n), t(n);
      for(int i = 0; i < n; ++i) {
        s[i] = std::ldexp(1., e[i] / divisor);
        t[i] = std::ldexp(1., f[i] / divisor);
      }
      const Columns original = symmetric ? a : u;
      const Columns scaled = s.asDiagonal() * original * (symmetric ? s : t).asDiagonal();
      const Vector<FT> b = random_vector<FT>(n, random);
      Vector<FT> scaled_b(b), x(n);
      scaled_b.array() *= s.array().cast<FT>();
      Solver<FT> solver;
      FT d;
      BOOST_REQUIRE(solver.linear_solver(rounded<FT>(scaled), scaled_b, x, d));
      BOOST_CHECK_EQUAL(solver.symmetric(), symmetric);
      x.array() *= (symmetric ? s : t).array().cast<FT>();
      // equilibration does not restore the original scales, and other pivots lose up to 2e-10 here
      check_solution(original, b, x, symmetric ? 1e-10 : 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(general, FT, Number_types)
{
  std::mt19937 random(4);
  for(int n : {2, 3, 10, 50, 300}) {
    for(int k = 0; k < 5; ++k) {
      check_solver<FT>(random_matrix(n, 4, random, 3), random, false, 1e-9);
      // a permuted matrix has hardly any entry on the diagonal, and needs a matching
      Columns a = random_matrix(n, 2, random, 3);
      Eigen::PermutationMatrix<Eigen::Dynamic> shuffle(n);
      shuffle.setIdentity();
      std::shuffle(shuffle.indices().data(), shuffle.indices().data() + n, random);
      check_solver<FT>(Columns(shuffle * a), random, false, 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(indefinite, FT, Number_types)
{
  std::mt19937 random(5);
  // the diagonal and the 2x2 minors do not tell that these are indefinite
  Columns laplacian = grid_laplacian(20, 20, -0.9);
  check_solver<FT>(laplacian, random, false, 1e-9);
  // a saddle point, with zeros on the diagonal
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < 40; ++i) {
    entries.emplace_back(i, i, 2);
    if(i < 20) {
      entries.emplace_back(40 + i, i, 1 + i);
      entries.emplace_back(i, 40 + i, 1 + i);
    }
  }
  Columns saddle(60, 60);
  saddle.setFromTriplets(entries.begin(), entries.end());
  check_solver<FT>(saddle, random, false);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(one_triangle, FT, Number_types)
{
  std::mt19937 random(6);
  const Columns a = random_definite(50, random);
  typename Solver<FT>::Matrix half(50, 50, true);
  for(int j = 0; j < 50; ++j) {
    for(Columns::InnerIterator it(a, j); it; ++it)
      half.set_coef(it.row(), it.col(), static_cast<FT>(it.value()), true);
  }
  const Vector<FT> b = random_vector<FT>(50, random);
  Vector<FT> x(50);
  FT d;
  Solver<FT> solver;
  BOOST_REQUIRE(solver.linear_solver(half, b, x, d));
  BOOST_CHECK(solver.symmetric());
  check_solution(a, b, x);

  // a triangular matrix is not mistaken for a symmetric one, and is not changed
  Columns lower = a.triangularView<Eigen::Lower>();
  const typename Solver<FT>::Matrix triangular = rounded<FT>(lower);
  BOOST_REQUIRE(solver.linear_solver(triangular, b, x, d));
  BOOST_CHECK_EQUAL(triangular.eigen_object().nonZeros(), lower.nonZeros());
  check_solution(lower, b, x, 1e-8);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(reuse, FT, Number_types)
{
  std::mt19937 random(7);
  Solver<FT> solver;
  FT d;
  for(int round = 0; round < 3; ++round) {
    for(bool symmetric : {true, false}) {
      Columns a = symmetric ? random_definite(100, random) : random_matrix(120, 4, random, 3);
      for(int k = 0; k < 4; ++k) {
        const Vector<FT> b = random_vector<FT>(static_cast<int>(a.cols()), random);
        Vector<FT> x(1);
        {
          const auto matrix = rounded<FT>(a); // destroyed after the factorization
          BOOST_REQUIRE(solver.factor(matrix, d));
        }
        BOOST_CHECK_EQUAL(solver.symmetric(), symmetric);
        BOOST_CHECK_EQUAL(solver.ordering_reused(), k > 0);
        BOOST_REQUIRE(solver.linear_solver(b, x));
        check_solution(a, b, x);
        for(int j = 0; j < a.cols(); ++j)
          a.coeffRef(j, j) *= 1.5;
      }
    }
  }
  solver.clear();
  BOOST_CHECK(!solver.is_factored());
  BOOST_CHECK_EQUAL(solver.factor_nonzeros(), 0u);
}

// The pattern is enough to compute the ordering, for the object and for its copies.
BOOST_AUTO_TEST_CASE_TEMPLATE(pattern_analyzed_beforehand, FT, Number_types)
{
  std::mt19937 random(8);
  for(bool symmetric : {true, false}) {
    const Columns a = symmetric ? random_definite(100, random) : random_matrix(120, 4, random, 3);
    Solver<FT> solver;
    FT d;
    BOOST_REQUIRE(solver.analyze_pattern(rounded<FT>(a)));
    BOOST_CHECK(!solver.is_factored());
    Solver<FT> copy = solver;
    for(Solver<FT>* each : {&solver, &copy}) {
      const Vector<FT> b = random_vector<FT>(static_cast<int>(a.cols()), random);
      Vector<FT> x(1);
      BOOST_REQUIRE(each->factor(rounded<FT>(2 * a), d));
      BOOST_CHECK(each->ordering_reused());
      BOOST_CHECK_EQUAL(each->symmetric(), symmetric);
      BOOST_REQUIRE(each->linear_solver(b, x));
      check_solution(2 * a, b, x);
    }
    BOOST_CHECK(copy.analyze_pattern(rounded<FT>(grid_laplacian(3, 3, 1))));
    BOOST_CHECK(copy.is_factored()); // as before
    BOOST_CHECK(!solver.analyze_pattern(rounded<FT>(Columns(3, 4))));
    BOOST_CHECK(solver.is_factored());
  }
}

// A preconditioner must be definite. Nothing else is required.
BOOST_AUTO_TEST_CASE_TEMPLATE(only_pivots_checked, FT, Number_types)
{
  std::mt19937 random(9);
  CGAL::SuperLU_options options;
  options.check = CGAL::SuperLU_options::PIVOTS;
  Solver<FT> solver(options);
  FT d;
  for(int size : {1, 2, 7, 30}) {
    const Columns a = grid_laplacian(size, size + 1, 0.5);
    for(double sign : {1., -1.}) {
      const Vector<FT> b = random_vector<FT>(static_cast<int>(a.cols()), random);
      Vector<FT> x(1);
      BOOST_REQUIRE(solver.linear_solver(rounded<FT>(sign * a), b, x, d));
      BOOST_CHECK(solver.symmetric());
      check_solution(sign * a, b, x);
    }
  }

  Columns indefinite = grid_laplacian(6, 5, 0.5);
  indefinite.coeffRef(7, 7) = 0.3;
  const FT least = 16 * std::numeric_limits<FT>::epsilon();
  for(const Columns& a : {indefinite, random_matrix(40, 3, random, 3)}) {
    BOOST_CHECK(Solver<FT>().factor(rounded<FT>(a), d));
    BOOST_CHECK(!solver.factor(rounded<FT>(a), d));
    BOOST_CHECK(!solver.is_factored());
  }
  for(FT pivot : {FT(0), -least, least / 2, std::numeric_limits<FT>::quiet_NaN()}) {
    Columns a(3, 3);
    a.setIdentity();
    a.coeffRef(0, 1) = a.coeffRef(1, 0) = 1;
    a.coeffRef(0, 0) = 1 + double(pivot);
    a.makeCompressed();
    BOOST_CHECK(!solver.factor(rounded<FT>(a), d));
  }
}

// More than SuperLU's counters and arrays allow
BOOST_AUTO_TEST_CASE_TEMPLATE(widths, FT, Number_types)
{
  std::mt19937 random(10);
  for(bool symmetric : {true, false}) {
    const Columns a = symmetric ? grid_laplacian(40, 40, 0.1) : random_matrix(300, 3, random, 3);
    const Vector<FT> b = random_vector<FT>(static_cast<int>(a.cols()), random);
    for(int width : {-5, 1, 2, 19, 20, 21, 1000000})
      for(int relax : {-5, 1, 2, 19, 20, 21, 1000000}) {
        CGAL::SuperLU_options options;
        options.panel_width = width;
        options.relax = relax;
        Solver<FT> solver(options);
        FT d;
        Vector<FT> x(1);
        BOOST_REQUIRE(solver.linear_solver(rounded<FT>(a), b, x, d));
        check_solution(a, b, x);
        BOOST_CHECK_EQUAL(solver.options().relax, relax);
      }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(several_right_sides, FT, Number_types)
{
  std::mt19937 random(8);
  for(bool symmetric : {true, false}) {
    const Columns a = symmetric ? random_definite(80, random) : random_matrix(80, 4, random, 3);
    Solver<FT> solver;
    FT d;
    BOOST_REQUIRE(solver.factor(rounded<FT>(a), d));
    typename Solver<FT>::Dense_matrix b = Solver<FT>::Dense_matrix::Random(80, 37), x;
    BOOST_REQUIRE(solver.linear_solver(b, x));
    BOOST_REQUIRE_EQUAL(x.cols(), b.cols());
    for(int k = 0; k < 37; ++k) {
      Vector<FT> right_side(80), solution(80);
      right_side.eigen_object() = b.col(k);
      solution.eigen_object() = x.col(k);
      check_solution(a, right_side, solution);
    }
  }
}

namespace {

// Solves 2 x = 4 with a matrix that has dimensions of the given types.
template <class... Integers>
double solution_with_dimensions(Integers... dimensions)
{
  Solver<double>::Matrix a(dimensions...);
  a.set_coef(0, 0, 2, true);
  Vector<double> b(1), x(1);
  b[0] = 4;
  double d = 0;
  return Solver<double>().linear_solver(a, b, x, d) ? x[0] / d : 0;
}

} // namespace

BOOST_AUTO_TEST_CASE(dimensions_of_any_integer_type)
{
  BOOST_TEST(solution_with_dimensions(1) == 2);
  BOOST_TEST(solution_with_dimensions(1u) == 2);
  BOOST_TEST(solution_with_dimensions(1l) == 2);
  BOOST_TEST(solution_with_dimensions(std::size_t(1)) == 2);
  BOOST_TEST(solution_with_dimensions(1u, true) == 2);
  BOOST_TEST(solution_with_dimensions(1, 1u) == 2);
  BOOST_TEST(solution_with_dimensions(std::size_t(1), 1, true) == 2);
}

BOOST_AUTO_TEST_CASE(copies)
{
  std::mt19937 random(9);
  const Columns a = random_definite(50, random), other = random_matrix(60, 3, random, 3);
  const Vector<double> b = random_vector(50, random), c = random_vector(60, random);
  Vector<double> x(50), y(60);
  double d;
  Solver<double> first;
  BOOST_REQUIRE(first.factor(rounded(a), d));
  Solver<double> second(first);
  BOOST_REQUIRE(second.factor(rounded(other), d));
  BOOST_REQUIRE(first.linear_solver(b, x));
  check_solution(a, b, x);
  BOOST_REQUIRE(second.linear_solver(c, y));
  check_solution(other, c, y);
  Solver<double> third(std::move(first));
  BOOST_REQUIRE(third.linear_solver(b, x));
  check_solution(a, b, x);
  second = third;
  third.clear();
  BOOST_REQUIRE(second.linear_solver(b, x));
  check_solution(a, b, x);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bad_matrices, FT, Number_types)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Solver<FT> solver;
  FT d;
  Vector<FT> x(3), b(3);
  b.setOnes();
  BOOST_CHECK(!solver.linear_solver(b, x)); // nothing was factored
  BOOST_CHECK(!solver.factor(rounded<FT>(Columns(0, 0)), d));
  BOOST_CHECK(!solver.factor(rounded<FT>(Columns(3, 4)), d));
  BOOST_CHECK(!solver.factor(rounded<FT>(Columns(4, 3)), d));
  check_refused<FT>(Columns(5, 5)); // no entries at all

  for(double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for(int i : {0, 7}) {
      Columns a = grid_laplacian(5, 5, 1);
      a.coeffRef(i, 7) = value;
      check_refused<FT>(a);
    }
  }

  Columns empty_column = grid_laplacian(6, 6, 1); // singular by pattern
  empty_column.prune([](int, int j, double) { return j != 11; });
  check_refused<FT>(empty_column);
  check_refused<FT>(Columns(empty_column.transpose()));
  Columns zero_column = grid_laplacian(6, 6, 1); // singular by value
  for(int i = 0; i < 36; ++i) {
    if(zero_column.coeff(i, 11) != 0)
      zero_column.coeffRef(i, 11) = 0;
  }
  check_refused<FT>(zero_column);

  std::vector<Eigen::Triplet<double>> entries; // three columns in two rows
  for(int j = 0; j < 30; ++j)
    entries.emplace_back(j < 3 ? j % 2 : j, j, 1);
  entries.emplace_back(0, 1, 1);
  Columns deficient(30, 30);
  deficient.setFromTriplets(entries.begin(), entries.end());
  check_refused<FT>(deficient);
}

// The Laplacian without boundary conditions: singular up to rounding errors
BOOST_AUTO_TEST_CASE_TEMPLATE(numerically_singular, FT, Number_types)
{
  for(int width : {2, 3, 5, 10, 30, 100, 300}) {
    Columns a = grid_laplacian(width, width, 0);
    const Eigen::VectorXd sums = a * Eigen::VectorXd::Ones(a.cols());
    for(int i = 0; i < a.cols(); ++i)
      a.coeffRef(i, i) -= sums[i];
    check_refused<FT>(a);
  }
  Eigen::MatrixXd rank_one = Eigen::VectorXd::LinSpaced(6, 1, 2) * Eigen::RowVectorXd::LinSpaced(6, 3, 1);
  check_refused<FT>(Columns(rank_one.sparseView()));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bad_right_sides, FT, Number_types)
{
  const Columns a = grid_laplacian(4, 4, 1);
  Solver<FT> solver;
  FT d;
  BOOST_REQUIRE(solver.factor(rounded<FT>(a), d));
  Vector<FT> x(16), b(16), shorter(15), longer(17), none(0);
  b.setOnes();
  BOOST_CHECK(!solver.linear_solver(shorter, x));
  BOOST_CHECK(!solver.linear_solver(longer, x));
  BOOST_CHECK(!solver.linear_solver(none, x));
  Vector<FT> bad(b);
  bad[3] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK(!solver.linear_solver(bad, x));
  BOOST_CHECK(solver.linear_solver(b, x));
  check_solution(a, b, x);
  BOOST_CHECK(solver.linear_solver(b, b)); // in place
  BOOST_CHECK_EQUAL((x - b).norm(), 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(extreme_values, FT, Number_types)
{
  std::mt19937 random(10);
  const double exponent = std::is_same<FT, double>::value ? 290 : 35;
  for(double factor : {std::pow(10., -exponent), std::pow(10., exponent)}) {
    check_solver<FT>(factor * grid_laplacian(10, 10, 1), random, true);
    Columns a = factor * random_matrix(50, 3, random, 3);
    check_solver<FT>(a, random, false);
  }
}

BOOST_AUTO_TEST_CASE(two_threads)
{
  std::vector<int> good(2, 0);
  std::vector<std::thread> threads;
  for(int k = 0; k < 2; ++k) {
    threads.emplace_back([k, &good]() {
      std::mt19937 random(k);
      for(int round = 0; round < 10; ++round) {
        const Columns a = round % 2 ? grid_laplacian(40 + k, 40, 0.1) : random_matrix(200 + k, 4, random, 3);
        const Vector<double> b = random_vector(static_cast<int>(a.cols()), random);
        Vector<double> x(1);
        double d;
        Solver<double> solver;
        if(solver.linear_solver(rounded(a), b, x, d) && (a * x - b).norm() < 1e-9 * b.norm())
          ++good[k];
      }
    });
  }
  for(std::thread& thread : threads)
    thread.join();
  BOOST_CHECK_EQUAL(good[0], 10);
  BOOST_CHECK_EQUAL(good[1], 10);
}

BOOST_AUTO_TEST_CASE(float_agrees_with_double)
{
  std::mt19937 random(13);
  const Columns a = grid_laplacian(60, 60, 0);
  const Vector<float> b = random_vector<float>(3600, random);
  Vector<float> x(1);
  Vector<double> exact_b(3600), y(1);
  exact_b.eigen_object() = b.cast<double>();
  Solver<float> single;
  Solver<double> exact;
  float f;
  double d;
  BOOST_REQUIRE(single.linear_solver(rounded<float>(a), b, x, f));
  BOOST_REQUIRE(exact.linear_solver(rounded(a), exact_b, y, d));
  BOOST_CHECK(single.symmetric());
  BOOST_CHECK_EQUAL(single.factor_nonzeros(), exact.factor_nonzeros());
  const double difference = (x.cast<double>() - y).norm() / y.norm();
  BOOST_CHECK_LE(difference, 1e-4);
  BOOST_CHECK_GT(difference, 0);
}

// Entries that are infinite as floats, lose digits, or vanish
BOOST_AUTO_TEST_CASE(out_of_range_of_float)
{
  std::mt19937 random(14);
  const Columns good = grid_laplacian(6, 6, 1);
  for(double factor : {1e39, 1e300, 1e-40, 1e-42, 1e-60})
    check_refused<float>(factor * good);
  for(int i : {20, 21}) {
    Columns huge = good;
    huge.coeffRef(i, 21) = 1e39;
    check_refused<float>(huge);
  }
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(36);
  scale[21] = 1e-41;
  check_refused<float>(scale.asDiagonal() * good);
  check_refused<float>(good * scale.asDiagonal());
  scale[21] = 1e-21;
  check_refused<float>(scale.asDiagonal() * good * scale.asDiagonal());

  Columns tiny = good; // an entry that vanishes among others of normal size is a rounding error
  tiny.coeffRef(3, 30) = tiny.coeffRef(30, 3) = 1e-60;
  check_solver<float>(tiny, random, true);
  // the norm and the right-hand side of the trial are infinite, which scaling repairs
  check_solver<float>(6e37 * grid_laplacian(6, 6, 1), random, false);
}

// Laplacians that are definite by a weight at one vertex, which is smaller than the rounding errors of floats
BOOST_AUTO_TEST_CASE(singular_as_float)
{
  for(int width : {3, 10, 30, 100, 200}) {
    Columns a = grid_laplacian(width, width, 0);
    const Eigen::VectorXd sums = a * Eigen::VectorXd::Ones(a.cols());
    for(int i = 0; i < a.cols(); ++i)
      a.coeffRef(i, i) -= sums[i];
    a.coeffRef(0, 0) += 1e-7;
    check_refused<float>(a);
    check_refused<float>(Eigen::VectorXd::LinSpaced(a.rows(), 1, 2).asDiagonal() * a);
    Solver<double> solver;
    double d;
    BOOST_CHECK(solver.factor(rounded(a), d));
    BOOST_CHECK(solver.symmetric());

    a.coeffRef(0, 0) += 2; // regular also as floats, though pivots are small
    std::mt19937 random(width);
    check_solver<float>(a, random, true);
  }
}

#ifdef TEST_MEMORY_LIMIT
BOOST_AUTO_TEST_CASE(too_little_memory)
{
  std::mt19937 random(11);
  const Columns a = grid_laplacian(300, 300, 0.1);
  const Solver<double>::Matrix matrix(a);
  Solver<double> solver;
  double d;
  rlimit old_limit;
  BOOST_REQUIRE_EQUAL(getrlimit(RLIMIT_AS, &old_limit), 0);
  rlimit tight = old_limit;
  tight.rlim_cur = 1; // existing mappings stay, but no new ones are possible
  BOOST_REQUIRE_EQUAL(setrlimit(RLIMIT_AS, &tight), 0);
  const bool result = solver.factor(matrix, d);
  BOOST_REQUIRE_EQUAL(setrlimit(RLIMIT_AS, &old_limit), 0);
  BOOST_CHECK(!result);
  BOOST_CHECK(solver.lacks_memory());

  const Vector<double> b = random_vector(static_cast<int>(a.cols()), random);
  Vector<double> x(1);
  BOOST_REQUIRE(solver.linear_solver(matrix, b, x, d));
  BOOST_CHECK(!solver.lacks_memory());
  BOOST_CHECK(!solver.factor(Solver<double>::Matrix(Columns(3, 3)), d)); // singular
  BOOST_CHECK(!solver.lacks_memory());
  check_solution(a, b, x);
}

// Two simultaneous factorizations do not get the same memory.
BOOST_AUTO_TEST_CASE(memory_is_promised_once)
{
  typedef CGAL::internal::SuperLU_memory Memory;
  rlimit old_limit;
  BOOST_REQUIRE_EQUAL(getrlimit(RLIMIT_AS, &old_limit), 0);
  rlimit limit = old_limit;
  limit.rlim_cur = rlim_t(8) << 30;
  BOOST_REQUIRE_EQUAL(setrlimit(RLIMIT_AS, &limit), 0);
  const auto is_there = [](double bytes) {
    try {
      const Memory memory(bytes);
      return true;
    } catch(const std::bad_alloc&) {
      return false;
    }
  };
  const bool first = is_there(4.5e9);
  bool second;
  {
    const Memory memory(first ? 4.5e9 : 0);
    second = is_there(4.5e9);
  }
  const bool after = is_there(4.5e9);
  BOOST_REQUIRE_EQUAL(setrlimit(RLIMIT_AS, &old_limit), 0);
  BOOST_CHECK(first);
  BOOST_CHECK(!second);
  BOOST_CHECK(after);
  BOOST_CHECK(!is_there(1e300));
}
#endif

BOOST_AUTO_TEST_CASE(names_of_the_user)
{
  BOOST_CHECK_EQUAL(std::string(TEXT(ABORT)), "a_macro_of_the_user");
  BOOST_CHECK_EQUAL(COL, 17);
  BOOST_CHECK_EQUAL(EMPTY + TRUE, 7);
  BOOST_CHECK_EQUAL(used_before::EMPTY + used_before::TRUE, 15);
  const int NOTRANS = 1, BOTH = 2;
  BOOST_CHECK_EQUAL(ROW + NO + NOTRANS + BOTH + SuperMatrix().int_t, 17);
}

// The normal equation finds the least squares solution, as Eigen's QR decomposition does.
BOOST_AUTO_TEST_CASE_TEMPLATE(normal_equation, FT, Number_types)
{
  std::mt19937 random(12);
  for(int n : {1, 4, 30, 100}) {
    const int rows = n + n / 2;
    const Columns square = random_matrix(n, 3, random, 3);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows, n);
    dense.topRows(n) = Eigen::MatrixXd(square);
    dense.bottomRows(rows - n) = Eigen::MatrixXd(square).topRows(rows - n).rowwise().reverse();
    dense = dense.cast<FT>().eval().template cast<double>().eval();
    const Columns a = dense.sparseView();
    const Vector<FT> b = random_vector<FT>(rows, random);
    const Eigen::VectorXd expected =
        dense.colPivHouseholderQr().solve(b.eigen_object().template cast<double>());
    const double tolerance = std::is_same<FT, double>::value ? 1e-10 : 1e-4;

    Solver<FT> solver;
    Vector<FT> x(1);
    BOOST_REQUIRE(solver.normal_equation_solver(rounded<FT>(a), b, x));
    BOOST_CHECK(solver.symmetric());
    BOOST_CHECK_LE((x.template cast<double>() - expected).norm(), tolerance * expected.norm());
    BOOST_REQUIRE(solver.normal_equation_solver(b, x)); // again, after A was destroyed
    BOOST_CHECK_LE((x.template cast<double>() - expected).norm(), tolerance * expected.norm());
    BOOST_CHECK(!solver.normal_equation_solver(random_vector<FT>(rows + 1, random), x));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bad_normal_equations, FT, Number_types)
{
  Solver<FT> solver;
  Vector<FT> x(3), b(3);
  b.setOnes();
  BOOST_CHECK(!solver.normal_equation_solver(b, x)); // nothing was factored
  BOOST_CHECK(!solver.normal_equation_factor(rounded<FT>(Columns(0, 0))));
  BOOST_CHECK(!solver.normal_equation_factor(rounded<FT>(Columns(3, 4)))); // dependent columns
  Columns a = grid_laplacian(2, 2, 1);
  a.coeffRef(1, 1) = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK(!solver.normal_equation_factor(rounded<FT>(a)));
  a.coeffRef(1, 1) =
      10 * std::sqrt(static_cast<double>((std::numeric_limits<FT>::max)())); // its square is infinite
  BOOST_CHECK(!solver.normal_equation_factor(rounded<FT>(a)));
  FT d;
  BOOST_CHECK(solver.factor(rounded<FT>(grid_laplacian(2, 2, 1)), d));
  BOOST_CHECK(!solver.normal_equation_solver(Vector<FT>(4), x)); // another kind of factorization
}

BOOST_AUTO_TEST_SUITE_END()
