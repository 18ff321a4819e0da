// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The analysis of a pattern before SuperLU is called. SuperLU must never enlarge an array, because it writes beyond
// the end of some that it enlarges.

#include <boost/test/unit_test.hpp>

#include "random_charts.h"
#include "test_data.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Solver_interface/internal/SuperLU_factors.h>

#include <Eigen/SparseCore>

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_SuperLU_analysis)

namespace {

typedef Eigen::SparseMatrix<double> Columns;
typedef Eigen::Triplet<double> Triplet;
typedef CGAL::internal::SuperLU_analysis Analysis;

std::shared_ptr<const Analysis> analyze(const Columns& a, bool symmetric, int relax)
{
  return std::make_shared<Analysis>(a, symmetric, relax, CGAL::internal::superlu::sp_ienv(3));
}

CGAL::SuperLU_options with_panels(int width)
{
  CGAL::SuperLU_options options;
  options.panel_width = width;
  return options;
}

// Definite, with -1 where an edge is
Columns with_edges(int n, std::vector<Triplet> edges)
{
  for(int i = 0; i < n; ++i)
    edges.emplace_back(i, i, 1.);
  Columns a(n, n);
  a.setFromTriplets(edges.begin(), edges.end(), [](double, double last) { return last; });
  for(int i = 0; i < n; ++i)
    a.coeffRef(i, i) = static_cast<double>(a.col(i).nonZeros());
  return a;
}

// The edges of a chart between vertices whose number is not negative
Columns laplacian(const test_charts::Chart& chart, const std::vector<int>& number, int n)
{
  std::vector<Triplet> edges;
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    const int i = number[chart.edge_source(c)], j = number[chart.edge_target(c)];
    if(i >= 0 && j >= 0) {
      edges.emplace_back(i, j, -1.);
      edges.emplace_back(j, i, -1.);
    }
  }
  return with_edges(n, edges);
}

// What SuperLU has stored of L, counted in its result: entries, and subscripts of rows
struct Use
{
  std::size_t entries = 0, subscripts = 0;

  template <class FT>
  explicit Use(const CGAL::internal::SuperLU_factors<FT>& factors)
  {
    for(int s = 0; s < factors.lower().number_of_supernodes(); ++s) {
      const std::size_t columns = factors.lower().supernode(s).columns,
                        rows = factors.lower().supernode(s).rows;
      entries += columns * rows;
      subscripts += rows;
    }
  }
};

// The sizes that are predicted are upper bounds of what SuperLU uses, and are not enlarged on the way.
template <class FT>
void check_that_nothing_grows(const Columns& a, int relax, int panel)
{
  BOOST_TEST_INFO_SCOPE("relax " << relax << ", panel " << panel << ", " << a.rows() << " rows");
  const auto analysis = analyze(a, true, relax);
  CGAL::internal::SuperLU_factors<FT> factors(analysis);
  BOOST_REQUIRE(factors.factor(a.cast<FT>(), with_panels(panel)));
  BOOST_TEST(factors.expansions() == 0);
  BOOST_TEST(factors.nonzeros() <= 2 * analysis->factor_size());
  const Use use(factors);
  BOOST_TEST(use.entries <= analysis->factor_size());
  BOOST_TEST(use.subscripts <= analysis->subscripts());
}

// The edges of the polygons in a file
Columns laplacian(const std::string& file)
{
  std::vector<test_charts::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  const std::string extension = std::filesystem::path(file).extension().string();
  const bool done = extension == ".off"   ? CGAL::IO::read_OFF(file, points, polygons)
                    : extension == ".ply" ? CGAL::IO::read_PLY(file, points, polygons)
                                          : false;
  if(!done || points.empty())
    return Columns();
  std::vector<Triplet> edges;
  for(const auto& polygon : polygons)
    for(std::size_t k = 0; k < polygon.size(); ++k) {
      const int i = static_cast<int>(polygon[k]), j = static_cast<int>(polygon[(k + 1) % polygon.size()]);
      if(i != j) {
        edges.emplace_back(i, j, -1.);
        edges.emplace_back(j, i, -1.);
      }
    }
  return with_edges(static_cast<int>(points.size()), edges);
}

// A graph of random edges, most of which join vertices that are near each other in a grid of one to three dimensions. A
// few vertices have many edges.
Columns random_graph(int n, int dimension, std::mt19937& random)
{
  const int side = (std::max)(2, static_cast<int>(std::pow(n, 1. / dimension)));
  std::vector<Triplet> edges;
  const auto join = [&](int i, int j) {
    if(j >= 0 && j < n && i != j)
      edges.insert(edges.end(), {Triplet(i, j, -1.), Triplet(j, i, -1.)});
  };
  for(int i = 0; i < n; ++i) {
    for(int k = 0, step = 1; k < dimension; ++k, step *= side)
      if(random() % 8 > 0)
        join(i, i + step);
    if(random() % 16 == 0)
      join(i, static_cast<int>(random() % n));
  }
  for(int hub = static_cast<int>(random() % 3); hub > 0; --hub)
    for(int k = 0, i = static_cast<int>(random() % n); k < n / 4; ++k)
      join(i, static_cast<int>(random() % n));
  return with_edges(n, edges);
}

// All meshes of a folder that are not too large. The number of them is returned.
int check_meshes(const test_data::Folder& folder)
{
  const std::size_t largest = std::getenv("ABF_TEST_QUICK") ? 20000 : 100000;
  int meshes = 0;
  for(const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if(!entry.is_regular_file() || entry.file_size() > 50 * largest)
      continue;
    const std::string file = entry.path().string();
    const Columns a = laplacian(file);
    if(a.rows() == 0)
      continue;
    BOOST_TEST_INFO_SCOPE(file);
    ++meshes;
    for(int relax : {1, 6, 10, 20})
      check_that_nothing_grows<float>(a, relax, 1 + (meshes + relax) % 20);
  }
  return meshes;
}

} // namespace

// Whatever BLAS is linked: only OpenBLAS has these functions. The headers do not look for them by name.
BOOST_AUTO_TEST_CASE(one_thread_of_OpenBLAS)
{
  const auto threads = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
  const auto set_threads = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  BOOST_TEST((CGAL::internal::openblas_get_num_threads == threads));
  if(threads == nullptr)
    return;
  const int before = threads();
  set_threads(2);
  const int several = threads();
  {
    const CGAL::internal::SuperLU_one_blas_thread one;
    BOOST_TEST(threads() == 1);
    {
      const CGAL::internal::SuperLU_one_blas_thread another;
      BOOST_TEST(threads() == 1);
    }
    BOOST_TEST(threads() == 1);
  }
  BOOST_TEST(threads() == several);
  set_threads(before);
}

// The interior vertices and all vertices of random charts, as in the two kinds of systems
BOOST_AUTO_TEST_CASE(random_charts)
{
  std::mt19937 random(1);
  for(int i = 0; i < 1000; ++i) {
    const test_charts::Chart chart = test_charts::random_chart(20 + 10 * (i % 100), random);
    const int relax = 1 + i % 20, panel = 1 + i / 20 % 20;
    if(const int n = chart.number_of_interior_vertices)
      check_that_nothing_grows<float>(laplacian(chart, chart.interior, n), relax, panel);
    std::vector<int> all(chart.number_of_vertices());
    std::iota(all.begin(), all.end(), 0);
    check_that_nothing_grows<double>(laplacian(chart, all, static_cast<int>(all.size())), relax, panel);
  }
}

// Patterns that no chart has
BOOST_AUTO_TEST_CASE(random_graphs)
{
  std::mt19937 random(2);
  for(int i = 0; i < 600; ++i) {
    const Columns a =
        random_graph(2 + static_cast<int>(random() % (i % 20 == 0 ? 3000 : 200)), 1 + i % 3, random);
    check_that_nothing_grows<float>(a, 1 + i % 20, 1 + i / 20 % 20);
  }
}

BOOST_AUTO_TEST_CASE(meshes_of_examples)
{
  BOOST_TEST(check_meshes(test_data::examples) >= 2);
}

// The bound is tight: chains, stars and grids need exactly the predicted size.
BOOST_AUTO_TEST_CASE(room_is_what_is_needed)
{
  for(int n : {5, 50, 500}) {
    std::vector<Triplet> chain, star;
    for(int i = 1; i < n; ++i) {
      chain.insert(chain.end(), {Triplet(i, i - 1, -1.), Triplet(i - 1, i, -1.)});
      star.insert(star.end(), {Triplet(i, 0, -1.), Triplet(0, i, -1.)});
    }
    for(const Columns& a : {with_edges(n, chain), with_edges(n, star)})
      for(int relax : {1, 3, 10}) {
        const auto analysis = analyze(a, true, relax);
        CGAL::internal::SuperLU_factors<double> factors(analysis);
        BOOST_REQUIRE(factors.factor(a, with_panels(1)));
        BOOST_TEST(Use(factors).entries == analysis->factor_size());
      }
  }
}

// If pivots are not on the diagonal, arrays may exceed the predicted size and be enlarged. This is harmless.
BOOST_AUTO_TEST_CASE(arrays_that_grow)
{
  std::mt19937 random(3);
  int grown = 0;
  for(int i = 0; i < 300; ++i) {
    const test_charts::Chart chart = test_charts::random_chart(50 + i, random);
    std::vector<int> all(chart.number_of_vertices());
    std::iota(all.begin(), all.end(), 0);
    Columns a = laplacian(chart, all, static_cast<int>(all.size()));
    for(int j = 0; j < a.cols(); ++j)
      a.coeffRef(j, j) = random() % 2 == 0 ? 0. : random() % 3 - 1.;
    CGAL::internal::SuperLU_factors<double> factors(analyze(a, true, 1 + i % 20));
    if(factors.factor(a, with_panels(1 + i / 20)))
      grown += factors.expansions() > 0;
  }
  BOOST_TEST(grown > 0);
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

BOOST_AUTO_TEST_CASE(nothing_grows)
{
  BOOST_TEST(check_meshes(test_data::CGAL_meshes) >= 20);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(of_reference_disks, *test_data::needs(test_data::reference_disks))

BOOST_AUTO_TEST_CASE(nothing_grows)
{
  BOOST_TEST(check_meshes(test_data::reference_disks) >= 2);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
