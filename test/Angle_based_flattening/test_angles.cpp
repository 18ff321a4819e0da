// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The step of Newton's method against that of the paper's Eq. 6, and the angles that it ends at, on handmade charts.

#include <boost/test/unit_test.hpp>

#include "hard_charts.h"
#include "test_charts.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_nodes.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/newton_equation.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <iterator>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_angles)

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

BOOST_AUTO_TEST_SUITE(newton_steps)

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

template <int BlockSize>
Vector product(const abf::Block_matrix<BlockSize>& matrix, const Vector& x)
{
  return abf::eigen_matrix<double>(matrix) * x;
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

#ifdef CGAL_SUPERLU_HAS_SINGLE_PRECISION
#endif

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(assembly)

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
    abf::Triangle_assembly<2>::Local_columns ones;
    std::fill(std::begin(ones.entry), std::end(ones.entry), 1.);
    return ones;
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
