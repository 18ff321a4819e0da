// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_LINEAR_SYSTEM_H
#define SOLVERS_LINEAR_SYSTEM_H

#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <fstream>
#include <ios>
#include <stdexcept>
#include <string>

namespace solvers {

// A square matrix that stores both triangles, and a right-hand side, in the types that CGAL's solvers take.
// As it goes from process to process in a file, it is stored as it is in memory.
struct Linear_system
{
  typedef Eigen::SparseMatrix<double> Columns;

  CGAL::Eigen_sparse_matrix<double> matrix{0, 0};
  CGAL::Eigen_vector<double> right_side{0};

  Columns& columns() { return matrix.eigen_object(); }
  const Columns& columns() const { return matrix.eigen_object(); }
  int order() const { return static_cast<int>(columns().rows()); }
  std::size_t nonzeros() const { return static_cast<std::size_t>(columns().nonZeros()); }
};

// Changes the values of the matrix, by scaling some of its rows and the columns alike: it stays definite.
inline void change_values(Linear_system& system)
{
  const auto scale = [](const Eigen::Index i) { return 1 + static_cast<double>(i % 5) / 8; };
  for(int j = 0; j < system.order(); ++j) {
    for(Linear_system::Columns::InnerIterator it(system.columns(), j); it; ++it) {
      it.valueRef() *= scale(it.row()) * scale(j);
    }
  }
}

// |A x - b| / |b|
inline double relative_residual(const Linear_system& system, const CGAL::Eigen_vector<double>& x)
{
  const Eigen::VectorXd& b = system.right_side.eigen_object();
  return (system.columns() * x.eigen_object() - b).norm() / b.norm();
}

namespace internal {

template <class Number>
void write_array(std::ostream& stream, const Number* data, const std::size_t size)
{
  stream.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size * sizeof(Number)));
}

template <class Number>
void read_array(std::istream& stream, Number* data, const std::size_t size)
{
  stream.read(reinterpret_cast<char*>(data), static_cast<std::streamsize>(size * sizeof(Number)));
}

} // namespace internal

inline void write_system(const Linear_system& system, const std::string& name)
{
  std::ofstream file(name, std::ios::binary);
  const Linear_system::Columns& columns = system.columns();
  const int sizes[] = {system.order(), static_cast<int>(system.nonzeros())};
  internal::write_array(file, sizes, 2);
  internal::write_array(file, columns.outerIndexPtr(), sizes[0] + std::size_t(1));
  internal::write_array(file, columns.innerIndexPtr(), sizes[1]);
  internal::write_array(file, columns.valuePtr(), sizes[1]);
  internal::write_array(file, system.right_side.eigen_object().data(), sizes[0]);
  if(!file.flush()) {
    throw std::runtime_error("cannot write '" + name + "'");
  }
}

inline Linear_system read_system(const std::string& name)
{
  Linear_system system;
  std::ifstream file(name, std::ios::binary);
  int sizes[] = {0, 0};
  internal::read_array(file, sizes, 2);
  Linear_system::Columns& columns = system.columns();
  columns.resize(sizes[0], sizes[0]);
  columns.resizeNonZeros(sizes[1]);
  system.right_side.eigen_object().resize(sizes[0]);
  internal::read_array(file, columns.outerIndexPtr(), sizes[0] + std::size_t(1));
  internal::read_array(file, columns.innerIndexPtr(), sizes[1]);
  internal::read_array(file, columns.valuePtr(), sizes[1]);
  internal::read_array(file, system.right_side.eigen_object().data(), sizes[0]);
  if(!file) {
    throw std::runtime_error("cannot read a linear system from '" + name + "'");
  }
  return system;
}

} // namespace solvers

#endif // SOLVERS_LINEAR_SYSTEM_H
