// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Memory that is taken once, and memory that is refused. The program's own `malloc()` counts, and fails when told to.

#include <boost/test/unit_test.hpp>

#include "test_charts.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/objectives.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/injective_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/tutte_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

namespace {

constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
std::atomic<std::size_t> least_size{none}; // of an allocation that counts
std::atomic<long> counted_allocations{0};
std::atomic<long> failing_allocation{0};

// Counts an allocation, and returns whether it is to fail.
bool is_to_fail(std::size_t size)
{
  return size >= least_size && ++counted_allocations == failing_allocation;
}

} // namespace

extern "C" {
void* __libc_malloc(std::size_t) noexcept;
void* __libc_calloc(std::size_t, std::size_t) noexcept;
void* __libc_realloc(void*, std::size_t) noexcept;

void* malloc(std::size_t size) noexcept
{
  return is_to_fail(size) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size) noexcept
{
  return is_to_fail(number * size) ? nullptr : __libc_calloc(number, size);
}

void* realloc(void* old, std::size_t size) noexcept
{
  return is_to_fail(size) ? nullptr : __libc_realloc(old, size);
}
}

BOOST_AUTO_TEST_SUITE(test_memory)

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace abf = SMP::internal::ABF;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef SMP::ABF_plus_plus_options Options;

// Counts allocations of at least `size` bytes while it lives.
class Allocation_count
{
public:
  explicit Allocation_count(std::size_t size)
  {
    counted_allocations = 0;
    least_size = size;
  }

  ~Allocation_count() { least_size = none; }

  long get() const { return counted_allocations; }
};

// Lets one of the allocations of at least `size` bytes fail while it lives: the first one has number 1.
class Allocation_failure
{
public:
  Allocation_failure(std::size_t size, long number) : m_count(size) { failing_allocation = number; }
  ~Allocation_failure() { failing_allocation = 0; }

  bool has_happened() const { return m_count.get() >= failing_allocation; }

private:
  Allocation_count m_count;
};

// Counts allocations between Newton steps.
struct Step_counter : SMP::Flattening_visitor
{
  bool step(const SMP::ABF_plus_plus_step& step) override
  {
    if(step.iteration > 2)
      counts.push_back(counted_allocations - last);
    last_factorizations = step.factorizations;
    last = counted_allocations;
    return true;
  }

  std::vector<long> counts;
  int last_factorizations = 0;
  long last = 0;
};

struct Run
{
  explicit Run(int n)
      : mesh(test_meshes::bump<Mesh>(n)), bhd(CGAL::Polygon_mesh_processing::longest_border(mesh).first),
        uv(mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first),
        done(mesh.add_property_map<Mesh::Vertex_index, bool>("v:done", false).first)
  {}

  template <typename Parameterizer>
  void operator()(Parameterizer& parameterizer)
  {
    BOOST_TEST_REQUIRE(parameterizer.parameterize(mesh, bhd, uv, get(boost::vertex_index, mesh), done) ==
                       SMP::OK);
  }

  Mesh mesh;
  Mesh::Halfedge_index bhd;
  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv;
  Mesh::Property_map<Mesh::Vertex_index, bool> done;
};

// An array with a number for every tenth vertex counts.
std::size_t bytes_of_an_array(const Mesh& mesh)
{
  return mesh.number_of_vertices() * sizeof(double) / 10;
}

Eigen::SparseMatrix<float> grid_laplacian(int width)
{
  std::vector<Eigen::Triplet<float>> entries;
  for(int i = 0; i < width * width; ++i) {
    entries.emplace_back(i, i, 4.1f);
    for(int j : {i + 1, i + width})
      if(j < width * width && (j != i + 1 || j % width != 0)) {
        entries.emplace_back(i, j, -1.f);
        entries.emplace_back(j, i, -1.f);
      }
  }
  Eigen::SparseMatrix<float> a(width * width, width * width);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

typedef CGAL::SuperLU_solver_traits<float> Solver;

// The solution for the vector of ones; empty if the matrix cannot be factored
Eigen::VectorXf solution(Solver& solver, const Solver::Matrix& matrix)
{
  float d;
  if(!solver.factor(matrix, d))
    return Eigen::VectorXf();
  Solver::Vector b(matrix.row_dimension()), x(matrix.row_dimension());
  b.eigen_object().setOnes();
  BOOST_TEST_REQUIRE(solver.linear_solver(b, x));
  return x.eigen_object();
}

} // namespace

// The second one has another array of angles than the first one. (There are no slivers here.)
BOOST_AUTO_TEST_CASE(newton_steps_after_two_allocate_no_array)
{
  Run run(40);
  Options options;
  options.threads = 1;
  Step_counter visitor;
  options.visitor = &visitor;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  const Allocation_count count(bytes_of_an_array(run.mesh));
  run(parameterizer);
  BOOST_TEST(count.get() > 20); // it does count
  BOOST_TEST_REQUIRE(visitor.counts.size() >= 1);
  for(long count_of_step : visitor.counts)
    BOOST_TEST(count_of_step == 0);
  BOOST_TEST(visitor.last_factorizations == 0);
}

BOOST_AUTO_TEST_CASE(a_second_call_allocates_less)
{
  Run run(40);
  Options options;
  options.threads = 1;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  long counts[2];
  for(long& allocations : counts) {
    const Allocation_count count(bytes_of_an_array(run.mesh));
    run(parameterizer);
    allocations = count.get();
  }
  BOOST_TEST(counts[1] < counts[0]);
}

// Newton's method on the whole chart, where only SuperLU allocates, and the checks before it; and sweeps over single
// vertices
BOOST_AUTO_TEST_CASE(steps_and_sweeps_of_injective_maps_allocate_no_array)
{
  const double area_weight = 0.5, clearance = 0.1;
  abf::Chart chart = test_charts::flat_grid(60, 1);
  const std::size_t array = chart.points.size() * sizeof(double) / 10;
  const abf::Linear_solvers solvers = CGAL::SuperLU_solver_traits<>();
  std::vector<abf::Planar_point> uv = abf::Tutte_map(chart).run(solvers).value();
  const abf::Area_objective objective(chart, area_weight);
  const int steps = 4;
  const auto allocations = [&](const auto& run) {
    const Allocation_count count(array);
    for(int i = 0; i < steps; ++i)
      run();
    return count.get();
  };
  abf::Injective_descent<abf::Area_objective> descent(chart, objective, clearance, solvers);
  const auto step = [&] { BOOST_TEST_REQUIRE(descent.run(uv, {0, 1})); };
  allocations(step);
  const long of_steps = allocations(step);
  BOOST_TEST(descent.steps() == 2 * steps);

  abf::Definite_hessian hessian(chart);
  hessian.couple({});
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    hessian.of_triangle(t).hessian.setIdentity();
  hessian.sum_up();
  const std::unique_ptr<abf::Linear_solver> solver = solvers->low_precision();
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(hessian.matrix().size());
  Eigen::VectorXd x;
  const auto factor = [&] {
    BOOST_TEST_REQUIRE(solver->set_matrix(hessian.matrix()));
    BOOST_TEST_REQUIRE(solver->solve(b, x)); // the first solution allocates what further ones use
  };
  allocations(factor);
  BOOST_TEST(of_steps == allocations(factor));

  const abf::Coarsening coarsening(chart);
  abf::Border_keeper border(clearance);
  abf::Relaxation<abf::Border_keeper> relaxation(coarsening, uv, border);
  const auto sweep = [&] { relaxation.sweep(abf::Area_star(area_weight)); };
  allocations(sweep);
  BOOST_TEST(allocations(sweep) == 0);
  BOOST_TEST(relaxation.moves() > 0);
}

// Nor do the rounds in which seams become shorter. Arrays double when they become too small: that is seldom.
BOOST_AUTO_TEST_CASE(seams_to_further_terminals_allocate_no_array)
{
  Mesh mesh = test_meshes::bump<Mesh>(40);
  const auto allocations = [&](int terminals) {
    auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    TA::Seam_options options;
    options.maximum_number_of_terminals = terminals;
    options.stretch_bound = 1.0001;
    const Allocation_count count(bytes_of_an_array(mesh));
    const auto report = TA::select_seams(mesh, seams, options);
    const long number = count.get();
    BOOST_TEST(report.number_of_terminals == std::size_t(terminals));
    mesh.remove_property_map(seams);
    return number;
  };
  const int few = 4, many = 32;
  const long of_few = allocations(few);
  BOOST_TEST(of_few > 20);
  BOOST_TEST(allocations(many) - of_few < many - few);
}

// Everything before SuperLU itself is called, which ends the program if memory runs out.
BOOST_AUTO_TEST_CASE(refused_memory_is_an_error)
{
  constexpr int arrays = 7; // of the checks, of what SuperLU gets, and the memory that is tried
  const Solver::Matrix matrix(grid_laplacian(40));
  Solver solver;
  BOOST_TEST_REQUIRE(solver.analyze_pattern(matrix));
  const Eigen::VectorXf expected = solution(solver, matrix);
  const std::size_t array = matrix.row_dimension() * sizeof(float);
  for(long number = 1; number <= arrays; ++number) {
    float d;
    bool done, has_failed;
    {
      const Allocation_failure failure(array, number);
      done = solver.factor(matrix, d);
      has_failed = failure.has_happened();
    }
    BOOST_TEST_REQUIRE(has_failed);
    BOOST_TEST(!done);
    BOOST_TEST(!solver.is_factored());
    BOOST_TEST(solver.lacks_memory());
    BOOST_TEST((solution(solver, matrix) == expected));
  }
}

BOOST_AUTO_TEST_SUITE_END()
