// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Matrices of a few numbers for single triangles and vertices, which compile faster than Eigen's.
// `block_matrix.h`, `triangle_assembly.h` and the matrix splits of `reduced_hessian.h` compute with them.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_SMALL_MATRIX_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_SMALL_MATRIX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A matrix of a few numbers, by columns: the blocks and local systems of Newton's method. Expression templates for each
// of their sums and products would take longer to compile than all the rest of the direct method.
template <int Rows, int Columns>
struct Small_matrix
{
  double entry[Rows * Columns];

  static Small_matrix zero() { return Small_matrix{}; }

  double& operator()(int i, int j) { return entry[Rows * j + i]; }
  double operator()(int i, int j) const { return entry[Rows * j + i]; }
  double& operator[](int i) { return entry[i]; }
  double operator[](int i) const { return entry[i]; }

  Small_matrix& operator+=(const Small_matrix& other)
  {
    for(int k = 0; k < Rows * Columns; ++k)
      entry[k] += other.entry[k];
    return *this;
  }

  Small_matrix& operator-=(const Small_matrix& other)
  {
    for(int k = 0; k < Rows * Columns; ++k)
      entry[k] -= other.entry[k];
    return *this;
  }

  Small_matrix& operator*=(double factor)
  {
    for(double& e : entry)
      e *= factor;
    return *this;
  }
};

typedef Small_matrix<2, 2> Matrix_2;
typedef Small_matrix<2, 1> Vector_2;
typedef Small_matrix<3, 1> Vector_3;

template <int Rows, int Columns>
Small_matrix<Rows, Columns> operator+(Small_matrix<Rows, Columns> a, const Small_matrix<Rows, Columns>& b)
{
  return a += b;
}

template <int Rows, int Columns>
Small_matrix<Rows, Columns> operator-(Small_matrix<Rows, Columns> a, const Small_matrix<Rows, Columns>& b)
{
  return a -= b;
}

template <int Rows, int Columns>
Small_matrix<Rows, Columns> operator*(double factor, Small_matrix<Rows, Columns> a)
{
  return a *= factor;
}

template <int Rows, int Inner, int Columns>
Small_matrix<Rows, Columns> operator*(const Small_matrix<Rows, Inner>& a,
                                      const Small_matrix<Inner, Columns>& b)
{
  Small_matrix<Rows, Columns> product;
  for(int j = 0; j < Columns; ++j)
    for(int i = 0; i < Rows; ++i) {
      double sum = a(i, 0) * b(0, j);
      for(int k = 1; k < Inner; ++k)
        sum += a(i, k) * b(k, j);
      product(i, j) = sum;
    }
  return product;
}

template <int Rows, int Columns>
Small_matrix<Columns, Rows> transposed(const Small_matrix<Rows, Columns>& a)
{
  Small_matrix<Columns, Rows> result;
  for(int j = 0; j < Columns; ++j)
    for(int i = 0; i < Rows; ++i)
      result(j, i) = a(i, j);
  return result;
}

// The rows from `first` on
template <int Number, int Rows, int Columns>
Small_matrix<Number, Columns> rows_of(const Small_matrix<Rows, Columns>& a, int first)
{
  Small_matrix<Number, Columns> result;
  for(int j = 0; j < Columns; ++j)
    for(int i = 0; i < Number; ++i)
      result(i, j) = a(first + i, j);
  return result;
}

// The unknowns of block number `i` of a vector
inline Vector_2 block_of(const Eigen::VectorXd& x, int i)
{
  return {{x[2 * i], x[2 * i + 1]}};
}

// Eigen frees the memory of a vector before it allocates other memory: if that fails, the vector refers to memory that
// is not its own.
inline void set_size(Eigen::VectorXd& x, Eigen::Index n)
{
  if(x.size() != n)
    x = Eigen::VectorXd(n);
}

inline void add_to_block(const Vector_2& block, int i, Eigen::VectorXd& x)
{
  x[2 * i] += block[0];
  x[2 * i + 1] += block[1];
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_SMALL_MATRIX_H
