// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The arrays of SuperLU's factors, which one factorization after the other can fill, and substitution with the lower
// factor alone. `SuperLU_factors.h` passes the arrays to SuperLU.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ARRAYS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ARRAYS_H

#include <CGAL/Solver_interface/internal/Spare_objects.h>
#include <CGAL/Solver_interface/internal/SuperLU_headers.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// An array from SuperLU's allocator, because SuperLU may replace it by a larger one
template <class T>
class SuperLU_array
{
public:
  SuperLU_array() = default;
  SuperLU_array(const SuperLU_array&) = delete;
  SuperLU_array& operator=(const SuperLU_array&) = delete;
  ~SuperLU_array() { release(); }

  // Makes room for `size` entries; the old ones are lost.
  void reserve(std::size_t size)
  {
    if(size <= m_size)
      return;
    release();
    m_data = static_cast<T*>(superlu::superlu_malloc(size * sizeof(T)));
    if(m_data == nullptr)
      throw std::bad_alloc();
    m_size = size;
  }

  // Takes what SuperLU has put into the place of this array.
  void set(T* data, std::size_t size)
  {
    m_data = data;
    m_size = size;
  }

  T* data() const { return m_data; }
  std::size_t size() const { return m_size; }

private:
  void release()
  {
    if(m_data != nullptr)
      superlu::superlu_free(m_data);
    set(nullptr, 0);
  }

  T* m_data = nullptr;
  std::size_t m_size = 0;
};

// Consecutive columns of L with the same pattern: a dense trapezoid, with the entries of U on its diagonal, and those
// of the unit triangle of L below it.
template <class FT>
struct Supernode
{
  int first, columns, rows;
  const int* below; // the numbers of the rows below the triangle
  const FT* values;

  const FT* column(int j) const { return values + std::ptrdiff_t(j) * rows; }
};

// The lower factor. If the matrix is symmetric and the pivots are on the diagonal, it is enough to solve: with the
// pivots as D, the matrix is L D L'.
template <class FT>
struct SuperLU_lower_arrays
{
  SuperLU_array<int> supernode_of_column, first_column, row_begin, value_begin, row;
  SuperLU_array<FT> value;
  std::vector<int> row_permutation;

  void reserve(std::size_t columns, std::size_t rows, std::size_t values)
  {
    for(SuperLU_array<int>* array : {&supernode_of_column, &first_column, &row_begin, &value_begin})
      array->reserve(columns + 1);
    row.reserve(rows);
    value.reserve(values);
  }

  superlu::SCformat pass(superlu::GlobalLU_t& growing) const
  {
    growing.nzlmax = static_cast<int>(row.size());
    growing.nzlumax = static_cast<int>(value.size());
    return {0,
            0,
            value.data(),
            value_begin.data(),
            row.data(),
            row_begin.data(),
            supernode_of_column.data(),
            first_column.data()};
  }

  // Takes them back, or takes others that SuperLU has put into their place.
  void take(const superlu::GlobalLU_t& growing, std::size_t columns)
  {
    if(growing.xsup == nullptr)
      return;
    supernode_of_column.set(growing.supno, columns + 1);
    first_column.set(growing.xsup, columns + 1);
    row_begin.set(growing.xlsub, columns + 1);
    value_begin.set(growing.xlusup, columns + 1);
    row.set(growing.lsub, growing.nzlmax);
    value.set(static_cast<FT*>(growing.lusup), growing.nzlumax);
  }

  int number_of_supernodes(int size) const { return supernode_of_column.data()[size - 1] + 1; }

  Supernode<FT> supernode(int s) const
  {
    const int first = first_column.data()[s], columns = first_column.data()[s + 1] - first;
    const int begin = row_begin.data()[first], end = row_begin.data()[first + 1];
    return {first, columns, end - begin, row.data() + begin + columns,
            value.data() + value_begin.data()[first]};
  }

  // The entry of U on the diagonal of a column
  FT pivot(int column) const
  {
    const int first = first_column.data()[supernode_of_column.data()[column]];
    return value.data()[value_begin.data()[column] + (column - first)];
  }

  // Replaces `x` by the solution with L D L', in the order of the pivots. There must be memory for as many numbers in
  // `rows`. Most supernodes are too small for calls of the BLAS.
  void solve(int size, FT* x, FT* rows) const
  {
    const int number = number_of_supernodes(size);
    for(int s = 0; s < number; ++s)
      forward(supernode(s), x, rows);
    for(int s = number - 1; s >= 0; --s)
      divide_and_go_backward(supernode(s), x, rows);
  }

private:
  static void forward(const Supernode<FT>& node, FT* x, FT* sums)
  {
    FT* top = x + node.first;
    if(std::all_of(top, top + node.columns,
                   [](FT value) { return value == 0; })) // as most are of a unit vector
      return;
    const int below = node.rows - node.columns;
    std::fill(sums, sums + below, FT(0));
    for(int j = 0; j < node.columns; ++j) {
      const FT* column = node.column(j);
      const FT value = top[j];
      for(int i = j + 1; i < node.columns; ++i)
        top[i] -= column[i] * value;
      for(int i = 0; i < below; ++i)
        sums[i] += column[node.columns + i] * value;
    }
    for(int i = 0; i < below; ++i)
      x[node.below[i]] -= sums[i];
  }

  static void divide_and_go_backward(const Supernode<FT>& node, FT* x, FT* values)
  {
    for(int j = 0; j < node.columns; ++j)
      values[j] = x[node.first + j] / node.column(j)[j];
    for(int i = node.columns; i < node.rows; ++i)
      values[i] = x[node.below[i - node.columns]];
    for(int j = node.columns - 1; j >= 0; --j) {
      typedef Eigen::Map<const Eigen::Matrix<FT, Eigen::Dynamic, 1>> Column;
      const int below = node.rows - j - 1;
      values[j] -= Column(node.column(j) + j + 1, below).dot(Column(values + j + 1, below));
    }
    std::copy(values, values + node.columns, x + node.first);
  }
};

// The upper factor, and what else only a factorization needs
template <class FT>
struct SuperLU_upper_arrays
{
  SuperLU_array<int> begin, row;
  SuperLU_array<FT> value;
  std::vector<int> column_begin, column_end, tree;

  void reserve(std::size_t columns, std::size_t values)
  {
    begin.reserve(columns + 1);
    row.reserve(values);
    value.reserve(values);
  }

  superlu::NCformat pass(superlu::GlobalLU_t& growing) const
  {
    growing.nzumax = static_cast<int>((std::min)(row.size(), value.size()));
    return {0, value.data(), row.data(), begin.data()};
  }

  void take(const superlu::GlobalLU_t& growing, std::size_t columns)
  {
    if(growing.xsup == nullptr)
      return;
    begin.set(growing.xusub, columns + 1);
    row.set(growing.usub, growing.nzumax);
    value.set(static_cast<FT*>(growing.ucol), growing.nzumax);
  }
};

// What factorizations have left for later ones, and vectors for solutions
template <class FT>
struct SuperLU_spare_memory
{
  Spare_objects<SuperLU_lower_arrays<FT>> lower;
  Spare_objects<SuperLU_upper_arrays<FT>> upper;
  Spare_objects<std::vector<FT>> vectors;
};

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ARRAYS_H
