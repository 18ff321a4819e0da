// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#define BOOST_TEST_MODULE SuperLU_solver_traits
#include <boost/test/unit_test.hpp>

// Names of SuperLU are free for others, before its header is included...
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
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#include <sys/resource.h>
#define TEST_MEMORY_LIMIT
#endif

#define TEXT_2(x) #x
#define TEXT(x) TEXT_2(x)

typedef CGAL::SuperLU_solver_traits<> Solver;
typedef Solver::Matrix Matrix;
typedef Solver::Vector Vector;
typedef Eigen::SparseMatrix<double> Columns;

static_assert(std::is_copy_constructible<Solver>::value && std::is_copy_assignable<Solver>::value,
              "copyable");
static_assert(std::is_nothrow_move_constructible<Solver>::value, "movable");

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

Vector random_vector(int n, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(-1, 1);
  Vector b(n);
  for(int i = 0; i < n; ++i)
    b.set(i, value(random));
  return b;
}

void check_solution(const Columns& a, const Vector& b, const Vector& x, double tolerance = 1e-10)
{
  Eigen::SparseLU<Columns> reference(a);
  BOOST_REQUIRE(reference.info() == Eigen::Success);
  const Eigen::VectorXd y = reference.solve(b.eigen_object());
  BOOST_REQUIRE_EQUAL(x.size(), y.size());
  BOOST_CHECK_LE((x - y).norm(), tolerance * y.norm());
}

void check_solver(const Columns& a, std::mt19937& random, bool symmetric, double tolerance = 1e-10)
{
  Solver solver;
  double d = 0;
  const int n = static_cast<int>(a.cols());
  const Vector b = random_vector(n, random);
  Vector x(1);
  BOOST_REQUIRE(solver.linear_solver(Matrix(a), b, x, d));
  BOOST_CHECK_EQUAL(d, 1);
  BOOST_CHECK_EQUAL(solver.symmetric(), symmetric);
  BOOST_CHECK_GE(solver.factor_nonzeros(), static_cast<std::size_t>(n));
  check_solution(a, b, x, tolerance);
}

void check_refused(const Columns& a)
{
  Solver solver;
  double d;
  Vector x(a.rows()), b(a.rows());
  b.setOnes();
  BOOST_CHECK(!solver.factor(Matrix(a), d));
  BOOST_CHECK(!solver.is_factored());
  BOOST_CHECK(!solver.linear_solver(b, x));
  // it is still usable
  const Columns good = grid_laplacian(5, 4, 1);
  Vector ones(good.rows());
  ones.setOnes();
  BOOST_CHECK(solver.linear_solver(Matrix(good), ones, x, d));
  check_solution(good, ones, x);
}

BOOST_AUTO_TEST_CASE(definite)
{
  std::mt19937 random(1);
  for(int size : {1, 2, 3, 7, 20, 61})
    check_solver(grid_laplacian(size, size + 1, 0.01), random, true);
  for(int n : {1, 2, 5, 30, 200, 700}) {
    for(int k = 0; k < 5; ++k) {
      const Columns a = random_definite(n, random);
      check_solver(a, random, true);
      check_solver(-a, random, true);
    }
  }
}

BOOST_AUTO_TEST_CASE(degenerate_patterns)
{
  std::mt19937 random(2);
  Columns diagonal(1000, 1000);
  diagonal.setIdentity();
  check_solver(diagonal, random, true);
  check_solver(grid_laplacian(1, 100000, 0.1), random, true); // a long chain
  Columns chain = grid_laplacian(1, 100000, 0.1);
  chain.coeffRef(5, 6) = -2;
  check_solver(chain, random, false);
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
  check_solver(arrow, random, true);
  check_solver(Columns(Eigen::MatrixXd(random_definite(60, random)).sparseView()), random, true);
}

BOOST_AUTO_TEST_CASE(badly_scaled)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> exponent(-40, 40);
  for(int k = 0; k < 10; ++k) {
    const int n = 300;
    const Columns a = random_definite(n, random);
    const Columns u = random_matrix(n, 3, random, 3);
    Eigen::VectorXd s(n), t(n);
    for(int i = 0; i < n; ++i) {
      s[i] = std::ldexp(1., exponent(random));
      t[i] = std::ldexp(1., exponent(random));
    }
    // a solution of the scaled system is one of the original system
    for(bool symmetric : {true, false}) {
      const Columns original = symmetric ? a : u;
      const Columns scaled = s.asDiagonal() * original * (symmetric ? s : t).asDiagonal();
      const Vector b = random_vector(n, random);
      Vector scaled_b(b), x(n);
      scaled_b.array() *= s.array();
      Solver solver;
      double d;
      BOOST_REQUIRE(solver.linear_solver(Matrix(scaled), scaled_b, x, d));
      BOOST_CHECK_EQUAL(solver.symmetric(), symmetric);
      x.array() *= (symmetric ? s : t).array();
      // equilibration does not find the original scales, and other pivots lose up to 2e-10 here
      check_solution(original, b, x, symmetric ? 1e-10 : 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(general)
{
  std::mt19937 random(4);
  for(int n : {2, 3, 10, 50, 300}) {
    for(int k = 0; k < 5; ++k) {
      check_solver(random_matrix(n, 4, random, 3), random, false, 1e-9);
      // a permuted matrix has hardly any entry on the diagonal, and needs a matching
      Columns a = random_matrix(n, 2, random, 3);
      Eigen::PermutationMatrix<Eigen::Dynamic> shuffle(n);
      shuffle.setIdentity();
      std::shuffle(shuffle.indices().data(), shuffle.indices().data() + n, random);
      check_solver(Columns(shuffle * a), random, false, 1e-8);
    }
  }
}

BOOST_AUTO_TEST_CASE(indefinite)
{
  std::mt19937 random(5);
  // the diagonal and the 2x2 minors do not tell that these are indefinite
  Columns laplacian = grid_laplacian(20, 20, -0.9);
  check_solver(laplacian, random, false, 1e-9);
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
  check_solver(saddle, random, false);
}

BOOST_AUTO_TEST_CASE(one_triangle)
{
  std::mt19937 random(6);
  const Columns a = random_definite(50, random);
  Matrix half(50, 50, true);
  for(int j = 0; j < 50; ++j) {
    for(Columns::InnerIterator it(a, j); it; ++it)
      half.set_coef(it.row(), it.col(), it.value(), true);
  }
  const Vector b = random_vector(50, random);
  Vector x(50);
  double d;
  Solver solver;
  BOOST_REQUIRE(solver.linear_solver(half, b, x, d));
  BOOST_CHECK(solver.symmetric());
  check_solution(a, b, x);

  // a triangular matrix is not mistaken for one, and stays as it is
  Columns lower = a.triangularView<Eigen::Lower>();
  const Matrix triangular(lower);
  BOOST_REQUIRE(solver.linear_solver(triangular, b, x, d));
  BOOST_CHECK_EQUAL(triangular.eigen_object().nonZeros(), lower.nonZeros());
  check_solution(lower, b, x, 1e-8);
}

BOOST_AUTO_TEST_CASE(reuse)
{
  std::mt19937 random(7);
  Solver solver;
  double d;
  for(int round = 0; round < 3; ++round) {
    for(bool symmetric : {true, false}) {
      Columns a = symmetric ? random_definite(100, random) : random_matrix(120, 4, random, 3);
      for(int k = 0; k < 4; ++k) {
        const Vector b = random_vector(static_cast<int>(a.cols()), random);
        Vector x(1);
        {
          const std::unique_ptr<Matrix> matrix(new Matrix(a)); // destroyed after the factorization
          BOOST_REQUIRE(solver.factor(*matrix, d));
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

BOOST_AUTO_TEST_CASE(several_right_sides)
{
  std::mt19937 random(8);
  for(bool symmetric : {true, false}) {
    const Columns a = symmetric ? random_definite(80, random) : random_matrix(80, 4, random, 3);
    Solver solver;
    double d;
    BOOST_REQUIRE(solver.factor(Matrix(a), d));
    Eigen::MatrixXd b = Eigen::MatrixXd::Random(80, 37), x;
    BOOST_REQUIRE(solver.linear_solver(b, x));
    BOOST_CHECK_LE((a * x - b).norm(), 1e-10 * b.norm());
  }
}

BOOST_AUTO_TEST_CASE(copies)
{
  std::mt19937 random(9);
  const Columns a = random_definite(50, random), other = random_matrix(60, 3, random, 3);
  const Vector b = random_vector(50, random), c = random_vector(60, random);
  Vector x(50), y(60);
  double d;
  Solver first;
  BOOST_REQUIRE(first.factor(Matrix(a), d));
  Solver second(first);
  BOOST_REQUIRE(second.factor(Matrix(other), d));
  BOOST_REQUIRE(first.linear_solver(b, x));
  check_solution(a, b, x);
  BOOST_REQUIRE(second.linear_solver(c, y));
  check_solution(other, c, y);
  Solver third(std::move(first));
  BOOST_REQUIRE(third.linear_solver(b, x));
  check_solution(a, b, x);
  second = third;
  third.clear();
  BOOST_REQUIRE(second.linear_solver(b, x));
  check_solution(a, b, x);
}

BOOST_AUTO_TEST_CASE(bad_matrices)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Solver solver;
  double d;
  Vector x(3), b(3);
  b.setOnes();
  BOOST_CHECK(!solver.linear_solver(b, x)); // nothing was factored
  BOOST_CHECK(!solver.factor(Matrix(Columns(0, 0)), d));
  BOOST_CHECK(!solver.factor(Matrix(Columns(3, 4)), d));
  BOOST_CHECK(!solver.factor(Matrix(Columns(4, 3)), d));
  check_refused(Columns(5, 5)); // no entries at all

  for(double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for(int i : {0, 7}) {
      Columns a = grid_laplacian(5, 5, 1);
      a.coeffRef(i, 7) = value;
      check_refused(a);
    }
  }

  Columns empty_column = grid_laplacian(6, 6, 1); // singular by pattern
  empty_column.prune([](int, int j, double) { return j != 11; });
  check_refused(empty_column);
  check_refused(Columns(empty_column.transpose()));
  Columns zero_column = grid_laplacian(6, 6, 1); // singular by value
  for(int i = 0; i < 36; ++i) {
    if(zero_column.coeff(i, 11) != 0)
      zero_column.coeffRef(i, 11) = 0;
  }
  check_refused(zero_column);

  std::vector<Eigen::Triplet<double>> entries; // three columns in two rows
  for(int j = 0; j < 30; ++j)
    entries.emplace_back(j < 3 ? j % 2 : j, j, 1);
  entries.emplace_back(0, 1, 1);
  Columns deficient(30, 30);
  deficient.setFromTriplets(entries.begin(), entries.end());
  check_refused(deficient);
}

// The Laplacian without boundary conditions: singular, but for rounding errors
BOOST_AUTO_TEST_CASE(numerically_singular)
{
  for(int width : {2, 3, 5, 10, 30, 100, 300}) {
    Columns a = grid_laplacian(width, width, 0);
    const Eigen::VectorXd sums = a * Eigen::VectorXd::Ones(a.cols());
    for(int i = 0; i < a.cols(); ++i)
      a.coeffRef(i, i) -= sums[i];
    check_refused(a);
  }
  Eigen::MatrixXd rank_one = Eigen::VectorXd::LinSpaced(6, 1, 2) * Eigen::RowVectorXd::LinSpaced(6, 3, 1);
  check_refused(Columns(rank_one.sparseView()));
}

BOOST_AUTO_TEST_CASE(bad_right_sides)
{
  const Columns a = grid_laplacian(4, 4, 1);
  Solver solver;
  double d;
  BOOST_REQUIRE(solver.factor(Matrix(a), d));
  Vector x(16), b(16), shorter(15), longer(17), none(0);
  b.setOnes();
  BOOST_CHECK(!solver.linear_solver(shorter, x));
  BOOST_CHECK(!solver.linear_solver(longer, x));
  BOOST_CHECK(!solver.linear_solver(none, x));
  Vector bad(b);
  bad[3] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK(!solver.linear_solver(bad, x));
  BOOST_CHECK(solver.linear_solver(b, x));
  check_solution(a, b, x);
  BOOST_CHECK(solver.linear_solver(b, b)); // in place
  BOOST_CHECK_EQUAL((x - b).norm(), 0);
}

BOOST_AUTO_TEST_CASE(extreme_values)
{
  std::mt19937 random(10);
  for(double factor : {1e-290, 1e290}) {
    check_solver(factor * grid_laplacian(10, 10, 1), random, true);
    Columns a = factor * random_matrix(50, 3, random, 3);
    check_solver(a, random, false);
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
        const Vector b = random_vector(static_cast<int>(a.cols()), random);
        Vector x(1);
        double d;
        Solver solver;
        if(solver.linear_solver(Matrix(a), b, x, d) && (a * x - b).norm() < 1e-9 * b.norm())
          ++good[k];
      }
    });
  }
  for(std::thread& thread : threads)
    thread.join();
  BOOST_CHECK_EQUAL(good[0], 10);
  BOOST_CHECK_EQUAL(good[1], 10);
}

#ifdef TEST_MEMORY_LIMIT
BOOST_AUTO_TEST_CASE(too_little_memory)
{
  std::mt19937 random(11);
  const Columns a = grid_laplacian(300, 300, 0.1);
  const Matrix matrix(a);
  Solver solver;
  double d;
  rlimit old_limit;
  BOOST_REQUIRE_EQUAL(getrlimit(RLIMIT_AS, &old_limit), 0);
  rlimit tight = old_limit;
  tight.rlim_cur = 1; // mappings there are stay, no more are made
  BOOST_REQUIRE_EQUAL(setrlimit(RLIMIT_AS, &tight), 0);
  const bool result = solver.factor(matrix, d);
  BOOST_REQUIRE_EQUAL(setrlimit(RLIMIT_AS, &old_limit), 0);
  BOOST_CHECK(!result);

  const Vector b = random_vector(static_cast<int>(a.cols()), random);
  Vector x(1);
  BOOST_REQUIRE(solver.linear_solver(matrix, b, x, d));
  check_solution(a, b, x);
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
BOOST_AUTO_TEST_CASE(normal_equation)
{
  std::mt19937 random(12);
  for(int n : {1, 4, 30, 100}) {
    const int rows = n + n / 2;
    const Columns square = random_matrix(n, 3, random, 3);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows, n);
    dense.topRows(n) = Eigen::MatrixXd(square);
    dense.bottomRows(rows - n) = Eigen::MatrixXd(square).topRows(rows - n).rowwise().reverse();
    const Columns a = dense.sparseView();
    const Vector b = random_vector(rows, random);
    const Eigen::VectorXd expected = dense.colPivHouseholderQr().solve(b.eigen_object());

    Solver solver;
    Vector x(1);
    BOOST_REQUIRE(solver.normal_equation_solver(Matrix(a), b, x));
    BOOST_CHECK(solver.symmetric());
    BOOST_CHECK_LE((x - expected).norm(), 1e-10 * expected.norm());
    BOOST_REQUIRE(solver.normal_equation_solver(b, x)); // once more, A being gone
    BOOST_CHECK_LE((x - expected).norm(), 1e-10 * expected.norm());
    BOOST_CHECK(!solver.normal_equation_solver(random_vector(rows + 1, random), x));
  }
}

BOOST_AUTO_TEST_CASE(bad_normal_equations)
{
  Solver solver;
  Vector x(3), b(3);
  b.setOnes();
  BOOST_CHECK(!solver.normal_equation_solver(b, x)); // nothing was factored
  BOOST_CHECK(!solver.normal_equation_factor(Matrix(Columns(0, 0))));
  BOOST_CHECK(!solver.normal_equation_factor(Matrix(Columns(3, 4)))); // dependent columns
  Columns a = grid_laplacian(2, 2, 1);
  a.coeffRef(1, 1) = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK(!solver.normal_equation_factor(Matrix(a)));
  a.coeffRef(1, 1) = 1e200; // its square is infinite
  BOOST_CHECK(!solver.normal_equation_factor(Matrix(a)));
  double d;
  BOOST_CHECK(solver.factor(Matrix(grid_laplacian(2, 2, 1)), d));
  BOOST_CHECK(!solver.normal_equation_solver(Vector(4), x)); // another kind of factorization
}
