// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From target angles to planar angles: each stage alone, on handmade charts.

#include <boost/test/unit_test.hpp>

#include "hard_charts.h"
#include "small_matrices.h"
#include "test_charts.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_nodes.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/newton_equation.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <limits>
#include <utility>

// Its factors precondition in double precision too.
namespace test_angles {
struct Double_solver : CGAL::SuperLU_solver_traits<>
{};
} // namespace test_angles

BOOST_AUTO_TEST_SUITE(test_angles)

using small_matrices::small;

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::ABF_plus_plus_options Options;
typedef CGAL::SuperLU_solver_traits<> Solver;
typedef Eigen::MatrixXd Matrix;
typedef Eigen::VectorXd Vector;

namespace {

Vector as_vector(const std::vector<double>& values)
{
  return Eigen::Map<const Vector>(values.data(), values.size());
}

Vector random_vector(Eigen::Index n, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Vector v(n);
  for(double& x : v)
    x = uniform(random);
  return v;
}

// The Jacobian of planarity and reconstruction (J_2 of Eq. 11), dense.
Matrix constraint_jacobian(const Chart& chart, const std::vector<double>& alpha)
{
  Matrix jacobian = Matrix::Zero(2 * chart.number_of_nodes(), alpha.size());
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int i = chart.node_of_corner(c); i >= 0) {
      const int next = abf::next_corner(c), previous = abf::previous_corner(c);
      jacobian(2 * i, c) += chart.nodes[i].has_planarity;
      jacobian(2 * i + 1, next) += chart.nodes[i].has_reconstruction / std::tan(alpha[next]);
      jacobian(2 * i + 1, previous) -= chart.nodes[i].has_reconstruction / std::tan(alpha[previous]);
    }
  for(const abf::Loop_crossing& crossing : chart.crossings) {
    jacobian(2 * chart.node_of_loop(crossing.loop) + 1, crossing.out) += 1 / std::tan(alpha[crossing.out]);
    jacobian(2 * chart.node_of_loop(crossing.loop) + 1, crossing.in) -= 1 / std::tan(alpha[crossing.in]);
  }
  return jacobian;
}

// J of Eq. 11: the triangles' constraints above the others.
Matrix full_jacobian(const Chart& chart, const std::vector<double>& alpha)
{
  const int n_f = chart.number_of_triangles();
  Matrix jacobian = Matrix::Zero(n_f + 2 * chart.number_of_nodes(), alpha.size());
  for(int c = 0; c < chart.number_of_corners(); ++c)
    jacobian(c / 3, c) = 1;
  jacobian.bottomRows(2 * chart.number_of_nodes()) = constraint_jacobian(chart, alpha);
  return jacobian;
}

// Two interior vertices with added equations, two with one equation each, and two border vertices with an angle alone
Chart bump_with_other_nodes()
{
  Chart chart = bump(5, 7);
  chart.nodes[0].angle_sum += chart.nodes[1].angle_sum;
  std::replace(chart.node.begin(), chart.node.end(), 1, 0);
  chart.nodes[1] = {3, true, false}; // where a border vertex is now
  chart.nodes[4].has_reconstruction = false;
  chart.nodes[5].has_planarity = false;
  chart.node[chart.edge_source(chart.borders[0][3])] = 1;
  chart.node[chart.edge_source(chart.borders[0][8])] = chart.number_of_nodes();
  chart.nodes.push_back({2.5, true, false});
  return chart;
}

// A chart whose border is one seam: each edge is glued to the one half a border further, which makes a closed surface
// with a handle for every four edges.
Chart bump_with_handles(int n)
{
  Chart chart = bump(n, 7);
  const std::vector<int>& border = chart.borders.front();
  chart.seam.assign(chart.vertex.size(), -1);
  for(std::size_t i = 0; i < border.size(); ++i)
    chart.seam[border[i]] = border[(i + border.size() / 2) % border.size()];
  chart.equal_seams = true;
  abf::find_nodes(chart);
  return chart;
}

// A torus: each side of a square is glued to the one across.
Chart torus_of_bump(int n)
{
  Chart chart = bump(n, 7);
  const std::vector<int>& border = chart.borders.front();
  const int side = static_cast<int>(border.size()) / 4;
  int corner = 0; // the rank of a corner of the square: a border vertex whose edges have different directions
  const auto direction = [&](int i) {
    const int c = border[i % (4 * side)];
    const auto d = projected(chart)[chart.edge_target(c)] - projected(chart)[chart.edge_source(c)];
    return std::abs(d.x()) > std::abs(d.y());
  };
  while(direction(corner) == direction(corner + 4 * side - 1))
    ++corner;
  chart.seam.assign(chart.vertex.size(), -1);
  for(int i = 0; i < side; ++i)
    for(int first : {0, 1}) {
      const int a = border[(corner + first * side + i) % (4 * side)],
                b = border[(corner + (first + 3) * side - 1 - i) % (4 * side)];
      chart.seam[a] = b;
      chart.seam[b] = a;
    }
  chart.equal_seams = true;
  abf::find_nodes(chart);
  return chart;
}

// Multipliers, which are 0 where there is no equation
Vector random_multipliers(const Chart& chart, unsigned int seed)
{
  Vector multipliers = random_vector(2 * chart.number_of_nodes(), seed);
  for(int i = 0; i < chart.number_of_nodes(); ++i) {
    multipliers[2 * i] *= chart.nodes[i].has_planarity;
    multipliers[2 * i + 1] *= chart.nodes[i].has_reconstruction;
  }
  return multipliers;
}

abf::Angle_solution solve(const Chart& chart, const Options& options, std::vector<double>& alpha)
{
  const std::vector<double> beta = abf::target_angles(chart);
  abf::Angle_solution solution =
      abf::solve_angles(chart, beta, options, Solver(), abf::starting_angles(beta));
  BOOST_REQUIRE(solution.is_solved);
  alpha = solution.alpha;
  return solution;
}

} // namespace

BOOST_AUTO_TEST_SUITE(targets)

BOOST_AUTO_TEST_CASE(sum_to_two_pi_inside_and_are_the_surface_angles_at_the_border)
{
  const Chart chart = bump(10, 5, 2);
  const std::vector<double> beta = abf::target_angles(chart);
  std::vector<double> sum(chart.points.size(), 0);
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    sum[chart.vertex[c]] += beta[c];
    if(chart.interior[chart.vertex[c]] < 0)
      BOOST_TEST(beta[c] == abf::surface_angle(chart, c));
  }
  for(int v = 0; v < chart.number_of_vertices(); ++v)
    if(chart.interior[v] >= 0)
      BOOST_TEST(sum[v] == 2 * CGAL_PI, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(are_positive_on_degenerate_triangles)
{
  Chart chart = flat_grid(6, 5);
  chart.points[8] = chart.points[9];
  chart.points[24] = CGAL::midpoint(chart.points[17], chart.points[31]);
  const std::vector<double> beta = abf::target_angles(chart);
  const std::vector<double> alpha = abf::starting_angles(beta);
  for(std::size_t c = 0; c < beta.size(); ++c) {
    BOOST_TEST(beta[c] >= abf::least_target_angle);
    BOOST_TEST(alpha[c] > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(energy)

BOOST_AUTO_TEST_CASE(without_barrier_is_that_of_the_paper)
{
  const abf::Angle_energy paper{0};
  for(double alpha : {0.01, 0.5, 1., 3.})
    for(double beta : {0.02, 0.7, 2.})
      BOOST_TEST(paper.value(alpha, beta) == (alpha - beta) * (alpha - beta) / (beta * beta),
                 boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(derivatives_match_finite_differences)
{
  for(double barrier : {0., 0.1, 10.})
    for(double alpha : {0.05, 0.5, 1., 3.})
      for(double beta : {0.02, 0.7, 2.}) {
        const abf::Angle_energy e{barrier};
        const double h = 1e-5 * alpha;
        BOOST_TEST(e.first_derivative(alpha, beta) ==
                       (e.value(alpha + h, beta) - e.value(alpha - h, beta)) / (2 * h),
                   boost::test_tools::tolerance(1e-6));
        BOOST_TEST(e.second_derivative(alpha, beta) ==
                       (e.first_derivative(alpha + h, beta) - e.first_derivative(alpha - h, beta)) / (2 * h),
                   boost::test_tools::tolerance(1e-6));
      }
}

BOOST_AUTO_TEST_CASE(barrier_is_least_at_the_target_and_infinite_at_zero)
{
  const abf::Angle_energy e{0.1};
  BOOST_TEST(e.value(0.7, 0.7) == 0);
  BOOST_TEST(e.first_derivative(0.7, 0.7) == 0);
  BOOST_TEST(e.value(1e-300, 0.7) > 1 + 0.1 * 600);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(constraints)

BOOST_AUTO_TEST_CASE(vanish_on_planar_triangulations)
{
  const Chart chart = flat_grid(12, 2);
  const auto residual = abf::constraint_residuals(chart, planar_angles(chart, projected(chart)));
  BOOST_TEST(residual.cwiseAbs().maxCoeff() < 1e-13);
}

BOOST_AUTO_TEST_CASE(are_those_of_the_paper)
{
  const Chart chart = bump(6, 2);
  const std::vector<double> alpha = random_angles(chart.vertex.size(), 3);
  const auto residual = abf::constraint_residuals(chart, alpha);
  for(int i = 0; i < chart.number_of_interior_vertices; ++i) {
    double sum = 0, next = 1, previous = 1;
    for(int c = 0; c < chart.number_of_corners(); ++c)
      if(chart.interior[chart.vertex[c]] == i) {
        sum += alpha[c];
        next *= std::sin(alpha[abf::next_corner(c)]);
        previous *= std::sin(alpha[abf::previous_corner(c)]);
      }
    BOOST_TEST(residual[2 * i] == sum - 2 * CGAL_PI, boost::test_tools::tolerance(1e-10)); // Eq. 3
    BOOST_TEST(residual[2 * i + 1] == std::log(next / previous),
               boost::test_tools::tolerance(1e-10)); // Eq. 4
  }
}

void check_derivatives(const Chart& chart)
{
  const std::vector<double> alpha = random_angles(chart.vertex.size(), 4);
  const Matrix jacobian = constraint_jacobian(chart, alpha);
  const Vector multipliers = random_multipliers(chart, 5);
  const double h = 1e-5;
  for(std::size_t c = 0; c < alpha.size(); ++c) {
    auto less = alpha, more = alpha;
    less[c] -= h;
    more[c] += h;
    const Vector difference =
        (abf::constraint_residuals(chart, more) - abf::constraint_residuals(chart, less)) / (2 * h);
    BOOST_TEST((difference - jacobian.col(c)).cwiseAbs().maxCoeff() < 1e-7);

    // The second derivative is diagonal.
    const Vector change = (constraint_jacobian(chart, more) - constraint_jacobian(chart, less)).transpose() *
                          multipliers / (2 * h);
    Vector expected = Vector::Zero(alpha.size());
    expected[c] = abf::constraint_curvature(chart, multipliers, static_cast<int>(c), 1 / std::tan(alpha[c]));
    BOOST_TEST((change - expected).cwiseAbs().maxCoeff() < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(derivatives_match_finite_differences)
{
  check_derivatives(bump(4, 2));
}

BOOST_AUTO_TEST_CASE(derivatives_of_any_nodes_match_finite_differences)
{
  check_derivatives(bump_with_other_nodes());
  const Chart torus = torus_of_bump(4);
  BOOST_TEST(torus.number_of_loops == 2);
  check_derivatives(torus);
  const Chart handles = bump_with_handles(4);
  BOOST_TEST(handles.number_of_loops == 8);
  check_derivatives(handles);
  // Each equation of each node there or not
  std::mt19937 random(11);
  for(int i = 0; i < 5; ++i) {
    Chart chart = bump(4, 2);
    for(abf::Constraint_node& node : chart.nodes) {
      node.has_planarity = random() % 2;
      node.has_reconstruction = random() % 2;
    }
    check_derivatives(chart);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(reduced_hessian)

// The P of Eq. 17
Eigen::Matrix3d inverse_on_plane(const Eigen::Vector3d& energy, const Eigen::Vector3d& hessian)
{
  const Eigen::Matrix<double, 3, 2> basis = small_matrices::eigen(abf::basis_of_sum_preserving_steps());
  return basis * small_matrices::eigen(abf::reduced_hessian_inverse(small(energy), small(hessian))) *
         basis.transpose();
}

BOOST_AUTO_TEST_CASE(invert_the_hessian_on_steps_that_keep_the_sum)
{
  const Eigen::Vector3d energy(3, 5, 7), hessian(2, 9, 4);
  const Eigen::Matrix3d p = inverse_on_plane(energy, hessian);
  Eigen::Matrix4d kkt = Eigen::Matrix4d::Zero();
  kkt.topLeftCorner<3, 3>() = hessian.asDiagonal();
  kkt.topRightCorner<3, 1>().setOnes();
  kkt.bottomLeftCorner<1, 3>().setOnes();
  BOOST_TEST((p - kkt.inverse().topLeftCorner<3, 3>()).cwiseAbs().maxCoeff() < 1e-15);
}

BOOST_AUTO_TEST_CASE(lift_an_indefinite_hessian)
{
  const Eigen::Vector3d energy(3, 5, 7);
  const Eigen::Matrix3d least = inverse_on_plane(energy, energy) / abf::least_relative_curvature;
  for(const Eigen::Vector3d& hessian : {Eigen::Vector3d(-2, 9, 4), Eigen::Vector3d(-2, -9, -4),
                                        Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1e9, -1e9, 1)}) {
    const Eigen::Matrix3d p = inverse_on_plane(energy, hessian);
    BOOST_TEST((p * Eigen::Vector3d::Ones()).norm() < 1e-12);
    const Eigen::Vector3d lower = p.selfadjointView<Eigen::Lower>().eigenvalues();
    const Eigen::Vector3d gap = Eigen::Matrix3d(least - p).selfadjointView<Eigen::Lower>().eigenvalues();
    BOOST_TEST(lower.minCoeff() > -1e-12);
    BOOST_TEST(gap.minCoeff() > -1e-12);
  }
}

BOOST_AUTO_TEST_CASE(assemble_the_matrix_of_equation_16)
{
  const Chart chart = bump(5, 7);
  const int n_f = chart.number_of_triangles(), n = 2 * chart.number_of_interior_vertices;
  const std::vector<double> beta = abf::target_angles(chart);
  const std::vector<double> alpha = random_angles(beta.size(), 8);
  const Vector multipliers = random_vector(n, 9);
  abf::Newton_system system(chart, beta, abf::Angle_energy{0}, false, Solver());
  system.assemble(alpha, multipliers, abf::constraint_residuals(chart, alpha));

  // Eqs. 6, 11 and 12, with weights 1 / beta^2.
  const Matrix inverse_lambda = (as_vector(beta).array().square() / 2).matrix().asDiagonal();
  const Matrix j = full_jacobian(chart, alpha);
  const Matrix all = j * inverse_lambda * j.transpose();
  const Matrix lambda_star = all.topLeftCorner(n_f, n_f), j_star = all.bottomLeftCorner(n, n_f),
               j_star_star = all.bottomRightCorner(n, n);
  const Matrix equation_16 = j_star * lambda_star.inverse() * j_star.transpose() - j_star_star;
  BOOST_TEST((Matrix(abf::eigen_matrix<double>(system.matrix())) + equation_16).cwiseAbs().maxCoeff() <
             1e-12 * equation_16.cwiseAbs().maxCoeff());
}

// So `int` can count up to the size limit.
BOOST_AUTO_TEST_CASE(have_at_most_14_numbers_for_each_triangle)
{
  static_assert(14ll * abf::largest_number_of_triangles <= (std::numeric_limits<int>::max)());
  static_assert(14ll * (abf::largest_number_of_triangles + 1ll) > (std::numeric_limits<int>::max)());
  double most = 0;
  for(const Chart& chart : {bump(2, 1), bump(60, 1), pyramid(3, 1), pyramid(500, 1), annulus(20)}) {
    const std::vector<double> beta = abf::target_angles(chart);
    abf::Newton_system system(chart, beta, abf::Angle_energy{0}, false, Solver());
    const double entries = 4. * static_cast<double>(system.matrix().row.size());
    BOOST_TEST(entries <= 14. * chart.number_of_triangles());
    most = (std::max)(most, entries / chart.number_of_triangles());
  }
  BOOST_TEST(most > 13); // so no larger limit is possible
}

void check_step_against_dense_kkt(const Chart& chart, double barrier, bool curvature,
                                  const std::vector<double>& alpha, const Vector& multipliers)
{
  const int n_f = chart.number_of_triangles();
  const int n_alpha = chart.number_of_corners();
  const std::vector<double> beta = abf::target_angles(chart);
  const abf::Angle_energy energy{barrier};
  const Vector residual = abf::constraint_residuals(chart, alpha);
  abf::Newton_system system(chart, beta, energy, curvature, Solver());
  abf::Newton_step step;
  BOOST_REQUIRE(system.compute(alpha, multipliers, residual, step));

  // Eq. 6, all of it.
  const Matrix j = full_jacobian(chart, alpha);
  Matrix kkt = Matrix::Zero(n_alpha + j.rows(), n_alpha + j.rows());
  Vector rhs = Vector::Zero(kkt.rows());
  for(int c = 0; c < n_alpha; ++c) {
    kkt(c, c) = energy.second_derivative(alpha[c], beta[c]);
    if(curvature)
      kkt(c, c) += abf::constraint_curvature(chart, multipliers, c, 1 / std::tan(alpha[c]));
    rhs[c] = -energy.first_derivative(alpha[c], beta[c]);
  }
  kkt.topRightCorner(n_alpha, j.rows()) = j.transpose();
  kkt.bottomLeftCorner(j.rows(), n_alpha) = j;
  for(Eigen::Index row = 0; row < j.rows(); ++row)
    if(j.row(row).isZero(0)) // a missing constraint: its multiplier stays 0
      kkt(n_alpha + row, n_alpha + row) = 1;
  rhs.head(n_alpha) -= j.bottomRows(multipliers.size()).transpose() * multipliers;
  rhs.tail(residual.size()) = -residual;
  const Vector solution = kkt.partialPivLu().solve(rhs);

  const double scale = solution.cwiseAbs().maxCoeff();
  BOOST_TEST((as_vector(step.angles) - solution.head(n_alpha)).cwiseAbs().maxCoeff() < 1e-10 * scale);
  BOOST_TEST((step.multipliers - solution.tail(residual.size())).cwiseAbs().maxCoeff() < 1e-10 * scale);
  for(int t = 0; t < n_f; ++t)
    BOOST_TEST(std::abs(step.angles[3 * t] + step.angles[3 * t + 1] + step.angles[3 * t + 2]) <
               1e-13 * scale);
}

BOOST_AUTO_TEST_CASE(give_the_step_of_equation_6)
{
  const Chart chart = bump(5, 7);
  const std::vector<double> alpha = abf::starting_angles(abf::target_angles(chart));
  const Vector multipliers = 0.01 * random_vector(2 * chart.number_of_interior_vertices, 9);
  for(double barrier : {0., 0.1})
    for(bool curvature : {false, true})
      check_step_against_dense_kkt(chart, barrier, curvature, alpha, multipliers);
}

BOOST_AUTO_TEST_CASE(are_as_exact_as_asked_for)
{
  const Chart chart = bump(12, 7);
  const std::vector<double> beta = abf::target_angles(chart), alpha = abf::starting_angles(beta);
  const Vector residual = abf::constraint_residuals(chart, alpha), zero = 0 * residual;
  const abf::Angle_energy energy{0.1};
  abf::Newton_system direct(chart, beta, energy, true, Solver()),
      iterative(chart, beta, energy, true, Solver(), true);
  abf::Newton_step exact, step;
  BOOST_REQUIRE(direct.compute(alpha, zero, residual, exact));
  BOOST_TEST(direct.equation().factorizations() == 1);
  BOOST_TEST(direct.equation().steps() == 0);
  const auto matrix = abf::eigen_matrix<double>(direct.matrix());
  int last_steps = 0;
  for(double accuracy : {1e-1, 1e-3, 1e-10}) {
    BOOST_REQUIRE(iterative.compute(alpha, zero, residual, step, {accuracy}));
    const Vector error = step.multipliers - exact.multipliers;
    const double energy_norm = std::sqrt(error.dot(matrix * error)),
                 whole = std::sqrt(exact.multipliers.dot(matrix * exact.multipliers));
    BOOST_TEST(energy_norm < 2 * accuracy * whole);
    BOOST_TEST(iterative.equation().steps() > last_steps);
    BOOST_TEST(iterative.equation().factorizations() == (last_steps == 0 ? 2 : 0));
    last_steps = iterative.equation().steps();
  }
}

BOOST_AUTO_TEST_CASE(are_the_same_where_memory_is_saved)
{
  const Chart chart = bump(12, 7);
  const std::vector<double> beta = abf::target_angles(chart);
  const Vector multipliers = 0.1 * random_vector(2 * chart.number_of_nodes(), 3);
  for(bool iteratively : {false, true}) {
    abf::Newton_step steps[2];
    for(int saves_memory : {0, 1}) {
      abf::Newton_system system(chart, beta, abf::Angle_energy{0.1}, true, Solver(), iteratively,
                                saves_memory);
      BOOST_REQUIRE(system.compute(beta, multipliers, abf::constraint_residuals(chart, beta),
                                   steps[saves_memory], {1e-2}));
    }
    BOOST_TEST(steps[0].angles == steps[1].angles);
    BOOST_TEST(steps[0].multipliers == steps[1].multipliers);
    BOOST_TEST(steps[0].predicted_decrease == steps[1].predicted_decrease);
  }
}

BOOST_AUTO_TEST_CASE(give_the_step_of_equation_6_for_any_nodes)
{
  for(const Chart& chart : {bump_with_other_nodes(), torus_of_bump(5), bump_with_handles(4)}) {
    const std::vector<double> alpha = abf::starting_angles(abf::target_angles(chart));
    const Vector multipliers = 0.01 * random_multipliers(chart, 9);
    for(bool curvature : {false, true})
      check_step_against_dense_kkt(chart, 0.1, curvature, alpha, multipliers);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(conjugate_gradients)

// A matrix with the pattern of a chain. `entry(i, j)` is one of its blocks.
template <int BlockSize, typename Entry>
abf::Block_matrix<BlockSize> chain_of_blocks(int n, Entry entry)
{
  abf::Block_matrix<BlockSize> matrix;
  for(int j = 0; j < n; ++j) {
    for(int i = (std::max)(0, j - 1); i <= (std::min)(n - 1, j + 1); ++i) {
      matrix.row.push_back(i);
      matrix.block.push_back(entry(i, j));
    }
    matrix.begin.push_back(static_cast<int>(matrix.row.size()));
  }
  return matrix;
}

abf::Block_matrix<2> chain(int n, double diagonal, double coupling)
{
  return chain_of_blocks<2>(n, [&](int i, int j) {
    return abf::Matrix_2{{i == j ? diagonal : -1, coupling, coupling, i == j ? diagonal + 1 : -1}};
  });
}

template <int BlockSize>
Vector product(const abf::Block_matrix<BlockSize>& matrix, const Vector& x)
{
  return abf::eigen_matrix<double>(matrix) * x;
}

BOOST_AUTO_TEST_CASE(blocks_are_multiplied_and_taken_apart)
{
  const auto blocks = chain_of_blocks<2>(50, [](int i, int j) {
    return abf::Matrix_2{{1. + i + j, 1. * (j - i), 1. * (i - j), 2. * i * j}};
  });
  const Matrix whole = abf::eigen_matrix<double>(blocks);
  BOOST_TEST(whole.isApprox(whole.transpose()));
  const Vector x = random_vector(100, 12);
  Vector y;
  blocks.multiply(x, y);
  BOOST_TEST((y - whole * x).cwiseAbs().maxCoeff() < 1e-10);

  const Matrix first = abf::eigen_matrix<double>(abf::Diagonal_part<2>{blocks, 0}),
               second = abf::eigen_matrix<float>(abf::Diagonal_part<2>{blocks, 1}).cast<double>();
  for(int i = 0; i < 50; ++i)
    for(int j = 0; j < 50; ++j) {
      BOOST_TEST(whole(2 * i, 2 * j) == first(i, j));
      BOOST_TEST(whole(2 * i + 1, 2 * j + 1) == second(i, j));
    }
}

BOOST_AUTO_TEST_CASE(preconditioner_inverts_both_diagonal_blocks)
{
  abf::Newton_preconditioner preconditioner(Double_solver(), 0, chain(40, 1, 0));
  BOOST_REQUIRE(preconditioner.set_global_matrix(chain(40, 2.5, 0.3)));
  const Vector b = random_vector(80, 4);
  Vector x;
  BOOST_REQUIRE(preconditioner.solve(b, x));
  BOOST_TEST((product(chain(40, 2.5, 0), x) - b).cwiseAbs().maxCoeff() < 1e-12);
}

// Flat, but for two neighbours here and there, at different heights
Chart chart_with_spikes(int n, double height)
{
  return patch(n, n, [=](int i, int j) {
    const double part = j % 10 == 5 ? (i % 10 == 4) + 0.8 * (i % 10 == 5) : 0;
    return Point_3(i, j, height * part);
  });
}

std::vector<char> strongly_coupled_blocks(const abf::Block_matrix<2>& matrix)
{
  std::vector<double> coupling;
  std::vector<char> is_in;
  abf::find_strongly_coupled_blocks(matrix, coupling, is_in);
  return is_in;
}

struct First_equation
{
  std::vector<double> beta;
  abf::Newton_system system;
  Vector right_hand_side;

  explicit First_equation(const Chart& chart)
      : beta(abf::target_angles(chart)), system(chart, beta, abf::Angle_energy{0.1}, true, Solver())
  {
    const abf::Constraint_vector zero = abf::Constraint_vector::Zero(2 * chart.number_of_nodes());
    right_hand_side = system.assemble(beta, zero, abf::constraint_residuals(chart, beta));
  }
};

BOOST_AUTO_TEST_CASE(solves_near_strongly_coupled_blocks)
{
  const First_equation first(chart_with_spikes(40, 10));
  const abf::Block_matrix<2>& matrix = first.system.matrix();
  const std::vector<char> is_near = strongly_coupled_blocks(matrix);
  BOOST_TEST(std::count(is_near.begin(), is_near.end(), true) > 0);
  BOOST_TEST(4 * std::count(is_near.begin(), is_near.end(), true) <= matrix.columns_of_blocks());

  abf::Newton_preconditioner scalar(Solver(), 0, matrix);
  BOOST_REQUIRE(scalar.set_global_matrix(matrix));
  Vector x;
  const abf::Iterative_accuracy accuracy{1e-8};
  const int without =
      abf::conjugate_gradients(matrix, first.right_hand_side, scalar, accuracy, 1000, x).steps;

  Vector results[2];
  for(int threads : {1, 2})
    abf::with_threads(threads, [&] {
      abf::Newton_equation equation(Solver(), true);
      BOOST_REQUIRE(equation.solve(matrix, first.right_hand_side, accuracy, results[threads - 1]));
      BOOST_TEST(equation.factorizations() == 3);
      BOOST_TEST(2 * equation.steps() < without);
    });
  BOOST_TEST(results[0] == results[1]);

  abf::Newton_equation whole(Solver(), false);
  BOOST_REQUIRE(whole.solve(matrix, first.right_hand_side, accuracy, x));
  const Vector error = results[0] - x;
  BOOST_TEST(error.dot(product(matrix, error)) < 1e-14 * x.dot(product(matrix, x)));
}

BOOST_AUTO_TEST_CASE(nothing_is_strongly_coupled_on_a_smooth_chart)
{
  const First_equation first(bump(40, 7));
  const std::vector<char> is_near = strongly_coupled_blocks(first.system.matrix());
  BOOST_TEST(std::count(is_near.begin(), is_near.end(), true) == 0);
  abf::Newton_equation equation(Solver(), true);
  Vector x;
  BOOST_REQUIRE(equation.solve(first.system.matrix(), first.right_hand_side, {1e-2}, x));
  BOOST_TEST(equation.factorizations() == 2);
}

// Only the strongest are solved as a whole where all are too many.
BOOST_AUTO_TEST_CASE(at_most_a_quarter_is_strongly_coupled)
{
  auto matrix = chain(400, 2.5, 0);
  for(int j = 0; j < 400; ++j)
    for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e)
      if(matrix.row[e] == j)
        matrix.block[e](0, 1) = matrix.block[e](1, 0) = 10 + (j >= 200 && j < 250);
  const std::vector<char> is_near = strongly_coupled_blocks(matrix);
  BOOST_TEST(std::count(is_near.begin(), is_near.end(), true) <= 100);
}

// A Laplacian of a chain, plus a multiple of the identity
abf::Block_matrix<1> laplacian(int n, double identity)
{
  return chain_of_blocks<1>(n, [&](int i, int j) {
    const int neighbours = i == 0 || i == n - 1 ? 1 : 2;
    return abf::Block_matrix<1>::Block{{i == j ? neighbours + identity : -1.}};
  });
}

double relative_residual(const abf::Block_matrix<1>& matrix, const Vector& x, const Vector& b)
{
  return (product(matrix, x) - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

#ifdef CGAL_SUPERLU_HAS_SINGLE_PRECISION
BOOST_AUTO_TEST_CASE(single_precision_serves_to_precondition)
{
  const Vector b = random_vector(300, 5);
  Vector x;
  const auto system = abf::Linear_solvers(Solver())->low_precision();
  const auto regular = laplacian(300, 0.1);
  for(double scale : {1., 1e-60}) {
    BOOST_REQUIRE(system->set_matrix(regular));
    BOOST_REQUIRE(system->solve(scale * b, x));
    BOOST_TEST(!system->is_repeated());
    BOOST_TEST(relative_residual(regular, x, scale * b) < 1e-4);
    BOOST_TEST(relative_residual(regular, x, scale * b) > 1e-12);
  }
  const auto singular_as_float = laplacian(300, 1e-9);
  BOOST_REQUIRE(system->set_matrix(singular_as_float));
  BOOST_REQUIRE(system->solve(b, x));
  BOOST_TEST(system->is_repeated());
  BOOST_TEST(relative_residual(singular_as_float, x, b) < 1e-6);
}

BOOST_AUTO_TEST_CASE(report_what_single_precision_is_not_enough_for)
{
  const auto regular = laplacian(300, 0.1), singular_as_float = laplacian(300, 1e-9);
  const auto both = chain_of_blocks<2>(300, [&, entry = 0](int, int) mutable {
    const abf::Matrix_2 block = {{regular.block[entry][0], 0, 0, singular_as_float.block[entry][0]}};
    ++entry;
    return block;
  });
  abf::Newton_equation equation(Solver(), true);
  equation.analyze_pattern(both);
  Vector x;
  BOOST_REQUIRE(equation.solve(both, random_vector(600, 5), {1e-6}, x));
  BOOST_TEST(equation.factorizations() == 2);
  BOOST_TEST(equation.repeated_factorizations() == 1);
  BOOST_REQUIRE(equation.solve(both, random_vector(600, 6), {1e-6}, x));
  BOOST_TEST(equation.repeated_factorizations() == 0);
}

BOOST_AUTO_TEST_CASE(single_precision_is_refined_or_given_up)
{
  const auto solver = abf::Linear_solvers(Solver())->low_precision();
  const abf::Two_vectors b = {random_vector(300, 5), random_vector(300, 6)};
  for(double identity : {0.1, 1e-9}) {
    const auto matrix = laplacian(300, identity);
    abf::Two_vectors x;
    BOOST_REQUIRE(abf::solve_definite(matrix, *solver, b, x));
    BOOST_TEST(solver->is_repeated() == (identity != 0.1));
    for(int k : {0, 1})
      BOOST_TEST(relative_residual(matrix, x[k], b[k]) < (identity == 0.1 ? 1e-14 : 1e-6));
  }
  abf::Two_vectors x;
  auto zero = laplacian(300, 1);
  std::fill(zero.block.begin(), zero.block.end(), abf::Block_matrix<1>::Block::zero());
  BOOST_TEST(!abf::solve_definite(zero, *solver, b, x));
}
#endif

BOOST_AUTO_TEST_CASE(solve_definite_systems_and_refuse_others)
{
  abf::Newton_preconditioner preconditioner(Double_solver(), 0, chain(40, 2.5, 0));
  BOOST_REQUIRE(preconditioner.set_global_matrix(chain(40, 2.5, 0)));
  const Vector b = random_vector(80, 4);
  Vector x;
  const auto definite = chain(40, 2.5, 0.1), indefinite = chain(40, 2.5, 3);
  abf::Iterative_accuracy accuracy{1e-12};
  const auto solve = [&](const abf::Block_matrix<2>& matrix, const Vector& right_hand_side, int max_steps) {
    return abf::conjugate_gradients(matrix, right_hand_side, preconditioner, accuracy, max_steps, x);
  };
  typedef abf::Iterative_solution Solution;
  const Solution solution = solve(definite, b, 80);
  BOOST_TEST(solution.status == Solution::SOLVED);
  BOOST_TEST(solution.steps > 3);
  BOOST_TEST((product(definite, x) - b).cwiseAbs().maxCoeff() < 1e-10);
  BOOST_TEST(solve(definite, b, 3).status == Solution::NOT_SOLVED);
  accuracy = {0.9, 1e-12};
  BOOST_TEST(solve(definite, b, 80).steps > 3);
  BOOST_TEST((product(definite, x) - b).cwiseAbs().maxCoeff() < 2e-12);
  BOOST_TEST(solve(definite, b, 3).status == Solution::SOLVED); // as a whole it is
  accuracy = {1e-12};
  BOOST_TEST(solve(indefinite, b, 1000).status == Solution::NOT_SOLVED);
  BOOST_TEST(solve(definite, 0 * b, 3).steps == 0);
  BOOST_TEST(x.isZero());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(assembly)

BOOST_AUTO_TEST_CASE(adds_up_local_matrices)
{
  const Chart chart = bump(4, 11);
  const int n = chart.number_of_interior_vertices;
  abf::Triangle_assembly<2> assembly(chart.vertex, chart.interior, n);
  for(unsigned seed : {3, 4}) { // nothing of the first remains
    std::vector<Eigen::Matrix<double, 6, 6>> local(chart.number_of_triangles());
    Matrix dense = Matrix::Zero(2 * n, 2 * n);
    for(int t = 0; t < chart.number_of_triangles(); ++t) {
      local[t] = Eigen::Map<const Eigen::Matrix<double, 6, 6>>(random_vector(36, seed + 10 * t).data());
      for(int a = 0; a < 3; ++a)
        for(int b = 0; b < 3; ++b) {
          const int i = chart.interior[chart.vertex[3 * t + a]], j = chart.interior[chart.vertex[3 * t + b]];
          if(i >= 0 && j >= 0)
            dense.block<2, 2>(2 * i, 2 * j) += local[t].block<2, 2>(2 * a, 2 * b);
        }
    }
    assembly.assemble([&](int c) -> abf::Triangle_assembly<2>::Local_columns {
      return small<6, 2>(local[c / 3].middleCols<2>(2 * (c % 3)));
    });
    const auto matrix = abf::eigen_matrix<double>(assembly.matrix());
    BOOST_TEST((Matrix(matrix) - dense).cwiseAbs().maxCoeff() < 1e-14);
    BOOST_TEST(matrix.isCompressed());
  }
}

// The entries of a long column are found by bisection.
BOOST_AUTO_TEST_CASE(adds_up_at_hubs)
{
  const int n = 100000;
  std::vector<Point_3> points{Point_3(0, 0, 1)};
  Triangles triangles;
  for(int ring : {1, 2})
    for(int i = 0; i < n; ++i)
      points.emplace_back(ring * std::cos(2 * CGAL_PI * i / n), ring * std::sin(2 * CGAL_PI * i / n), 0);
  for(int i = 0; i < n; ++i) {
    const int a = 1 + i, b = 1 + (i + 1) % n;
    triangles.push_back({0, a, b});
    triangles.push_back({a, n + a, n + b});
    triangles.push_back({a, n + b, b});
  }
  const Chart chart = make_chart(points, triangles);
  BOOST_REQUIRE(chart.number_of_interior_vertices == n + 1);
  abf::Triangle_assembly<2> assembly(chart.vertex, chart.node, chart.number_of_nodes());
  assembly.assemble([](int) -> abf::Triangle_assembly<2>::Local_columns {
    return small<6, 2>(Eigen::Matrix<double, 6, 2>::Ones());
  });
  BOOST_TEST(assembly.diagonal_block(0)(0, 0) == n);
  BOOST_TEST(assembly.matrix().begin[1] == n + 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(angle_solver)

BOOST_AUTO_TEST_CASE(keeps_the_angles_of_a_planar_chart)
{
  const Chart chart = flat_grid(10, 12);
  std::vector<double> alpha;
  const abf::Angle_solution solution = solve(chart, Options(), alpha);
  BOOST_TEST(solution.converged);
  BOOST_TEST(solution.iterations == 1);
  const std::vector<double> expected = planar_angles(chart, projected(chart));
  BOOST_TEST((as_vector(alpha) - as_vector(expected)).cwiseAbs().maxCoeff() < 1e-12);
}

// At a minimum the gradient is a combination of the constraints' gradients.
double distance_from_stationarity(const Chart& chart, double barrier, const std::vector<double>& alpha)
{
  const std::vector<double> beta = abf::target_angles(chart);
  const abf::Angle_energy energy{barrier};
  Vector gradient(alpha.size());
  for(std::size_t c = 0; c < alpha.size(); ++c)
    gradient[c] = energy.first_derivative(alpha[c], beta[c]);
  const Matrix j_transposed = full_jacobian(chart, alpha).transpose();
  const Vector multipliers =
      (j_transposed.transpose() * j_transposed).partialPivLu().solve(j_transposed.transpose() * gradient);
  return (gradient - j_transposed * multipliers).norm() / gradient.norm();
}

BOOST_AUTO_TEST_CASE(finds_a_constrained_minimum)
{
  const Chart chart = bump(9, 13, 1);
  for(double barrier : {0., 0.1}) {
    Options options;
    options.barrier = barrier;
    options.energy_tolerance = 1e-16;
    std::vector<double> newton, sequential;
    const abf::Angle_solution solution = solve(chart, options, newton);
    BOOST_TEST(solution.converged);
    BOOST_TEST(solution.constraint_residual <= options.tolerance);
    BOOST_TEST(distance_from_stationarity(chart, barrier, newton) < 1e-6);
    BOOST_TEST(solution.iterations == static_cast<int>(solution.steps.size()));

    options.step = Options::SEQUENTIAL_LINEARLY_CONSTRAINED;
    BOOST_TEST(solve(chart, options, sequential).converged);
    BOOST_TEST((as_vector(newton) - as_vector(sequential)).cwiseAbs().maxCoeff() < 1e-6);
  }
}

std::vector<double> angle_sums(const Chart& chart, const std::vector<double>& alpha)
{
  std::vector<double> sums(chart.nodes.size(), 0);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int i = chart.node_of_corner(c); i >= 0)
      sums[i] += alpha[c];
  return sums;
}

void check_angle_sums(const Chart& chart, const std::vector<double>& alpha, double tolerance)
{
  const std::vector<double> sums = angle_sums(chart, alpha);
  for(int i = 0; i < chart.number_of_nodes(); ++i)
    if(chart.nodes[i].has_planarity)
      BOOST_TEST(std::abs(sums[i] - chart.nodes[i].angle_sum) <= tolerance);
}

// The angles at the border are prescribed, except for one, which follows from the others.
BOOST_AUTO_TEST_CASE(makes_a_rectangle_of_prescribed_border_angles)
{
  const int n = 10;
  Chart chart = bump(n, 3, 0.3);
  for(int v = 1; v < chart.number_of_vertices(); ++v)
    if(chart.interior[v] < 0) {
      const bool is_corner = v == n || v == n * (n + 1) || v == n * (n + 2);
      chart.node[v] = chart.number_of_nodes();
      chart.nodes.push_back({is_corner ? CGAL_PI / 2 : CGAL_PI, true, false});
    }
  for(auto linear_solver : {Options::ITERATIVE, Options::DIRECT}) {
    Options options;
    options.linear_solver = linear_solver;
    std::vector<double> alpha;
    BOOST_TEST(solve(chart, options, alpha).converged);
    check_angle_sums(chart, alpha, options.tolerance);
    double free_corner = 0;
    for(int c = 0; c < chart.number_of_corners(); ++c)
      free_corner += chart.vertex[c] == 0 ? alpha[c] : 0;
    BOOST_TEST(std::abs(free_corner - CGAL_PI / 2) <= 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(binds_several_vertices_to_one_node)
{
  Chart bound = bump(8, 5, 1);
  const Chart free = bound;
  for(int v = 0; v < bound.number_of_vertices(); ++v) // two nodes that are left, and one without equations
    if(bound.node[v] >= 2)
      bound.node[v] %= 2;
  bound.nodes.resize(3);
  for(int i : {0, 1})
    bound.nodes[i].angle_sum = 2 * CGAL_PI * std::count(bound.node.begin(), bound.node.end(), i);
  bound.nodes[2] = {0, false, false};
  std::vector<double> alpha, free_alpha;
  const abf::Angle_solution solution = solve(bound, Options(), alpha);
  BOOST_TEST(solution.converged);
  check_angle_sums(bound, alpha, Options().tolerance);
  BOOST_TEST(solution.constraint_residual <= Options().tolerance);
  BOOST_TEST(solve(free, Options(), free_alpha).converged);
  BOOST_TEST((as_vector(alpha) - as_vector(free_alpha)).cwiseAbs().maxCoeff() > 1e-3);
}

BOOST_AUTO_TEST_CASE(converges_quadratically)
{
  std::vector<double> alpha;
  Options options;
  options.energy_tolerance = 1e-16;
  const abf::Angle_solution solution = solve(bump(20, 14, 1), options, alpha);
  BOOST_REQUIRE(solution.converged);
  const auto& last = solution.steps.back();
  const auto& before = solution.steps[solution.steps.size() - 2];
  BOOST_TEST(last.predicted_decrease < 1e-2 * before.predicted_decrease);
  BOOST_TEST(solution.iterations < 10);
}

BOOST_AUTO_TEST_CASE(stays_inside_the_open_interval)
{
  BOOST_TEST(abf::longest_step({1, 0.5}, {-0.5, -0.2}, 1) == 1);
  BOOST_TEST(abf::longest_step({1, 0.5}, {-3, -0.2}, 1) == 0.3, boost::test_tools::tolerance(1e-15));
}

// Steps that each leave the same part of the way to the solution
BOOST_AUTO_TEST_CASE(lengthens_steps_that_converge_linearly)
{
  const std::vector<double> beta(30, 0.5);
  const auto second_length = [&](double rest, double first_length, double residual) {
    abf::Step_lengths lengths;
    abf::Newton_step step;
    step.angles.assign(beta.size(), 1e-3);
    BOOST_TEST(lengths.next(beta, step, residual) == 1);
    lengths.remember(step, first_length);
    step.angles.assign(beta.size(), rest * 1e-3);
    return lengths.next(beta, step, residual);
  };
  for(double rest : {0.4, 0.5, 0.8})
    BOOST_TEST(second_length(rest, 1, 1e-3) == 1 / (1 - rest), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(second_length(0.1, 1, 1e-3) == 1); // converges fast
  BOOST_TEST(second_length(-0.5, 1, 1e-3) == 1);
  BOOST_TEST(second_length(0.5, 0.7, 1e-3) == 1); // the last one was cut short,
  BOOST_TEST(second_length(0.5, 1.5, 1e-3) == 1); // or lengthened
  BOOST_TEST(second_length(0.5, 1, 0.1) == 1);
  BOOST_TEST(abf::longest_step({1, 0.5}, {-0.3, -0.2}, 1.5) == 1.5);
  BOOST_TEST(abf::longest_step({1, 0.5}, {-0.7, -0.2}, 1.5) == 0.9 / 0.7,
             boost::test_tools::tolerance(1e-15));
}

// So rough that the Hessians of some triangles stay lifted
BOOST_AUTO_TEST_CASE(lengthened_steps_end_at_a_minimum)
{
  std::mt19937 random(1);
  const Chart chart = noisy_terrain(12, 6, random);
  std::vector<double> alpha;
  Options options;
  options.energy_tolerance = 1e-16;
  const abf::Angle_solution solution = solve(chart, options, alpha);
  BOOST_TEST(solution.converged);
  BOOST_TEST(std::any_of(solution.steps.begin(), solution.steps.end(),
                         [](const SMP::ABF_plus_plus_step& step) { return step.step_length > 1; }));
  BOOST_TEST(distance_from_stationarity(chart, options.barrier, alpha) < 1e-6);
}

BOOST_AUTO_TEST_CASE(steps_are_reported)
{
  struct Counter : SMP::Flattening_visitor
  {
    int calls = 0;
    bool step(const SMP::ABF_plus_plus_step& step) override { return step.iteration == ++calls; }
  } counter;
  Options options;
  options.visitor = &counter;
  std::vector<double> alpha;
  BOOST_TEST(solve(bump(6, 1), options, alpha).iterations == counter.calls);
  BOOST_TEST(counter.calls > 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
