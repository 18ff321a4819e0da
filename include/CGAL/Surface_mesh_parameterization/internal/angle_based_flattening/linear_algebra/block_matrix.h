// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Matrices of a few numbers for single triangles and vertices, which compile faster than Eigen's, and symmetric sparse
// matrices of such blocks, with their form for Eigen's solvers. A block has all unknowns of one vertex. Newton's method
// for angles has blocks of two multipliers (Eq. 16). Layouts and Tutte's map take blocks, too.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BLOCK_MATRIX_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BLOCK_MATRIX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

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

// A symmetric sparse matrix of small blocks, stored as a whole. One subscript serves for a block.
template <int BlockSize>
struct Block_matrix
{
  typedef Small_matrix<BlockSize, BlockSize> Block;

  std::vector<int> begin = {0}; // of each column of blocks: its first entry; and the end of the last column
  std::vector<int> row;         // of each entry, ascending in a column
  std::vector<Block> block;     // of each entry

  int columns_of_blocks() const { return static_cast<int>(begin.size()) - 1; }
  int size() const { return BlockSize * columns_of_blocks(); }

  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& product) const
  {
    product.resize(x.size());
    parallel_for_blocks(columns_of_blocks(), [&](int first, int last) {
      for(int j = first; j < last; ++j) {
        Block sum = Block::zero(); // of products that do not wait for one another
        for(int e = begin[j]; e < begin[j + 1]; ++e)
          for(int k = 0; k < BlockSize * BlockSize; ++k)
            sum[k] += x[BlockSize * row[e] + k % BlockSize] * block[e][k];
        for(int k = 0; k < BlockSize; ++k) {
          double& entry = product[BlockSize * j + k] = sum(0, k);
          for(int i = 1; i < BlockSize; ++i)
            entry += sum(i, k);
        }
      }
    });
  }
};

template <int BlockSize>
void take_diagonal(const Block_matrix<BlockSize>& matrix, Eigen::VectorXd& diagonal)
{
  diagonal = Eigen::VectorXd::Zero(matrix.size());
  for(int j = 0; j < matrix.columns_of_blocks(); ++j)
    for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e)
      if(matrix.row[e] == j)
        for(int k = 0; k < BlockSize; ++k)
          diagonal[BlockSize * j + k] = matrix.block[e](k, k);
}

// A matrix of the unknowns number `index` of all blocks, without what couples them to the others
template <int BlockSize>
struct Diagonal_part
{
  const Block_matrix<BlockSize>& matrix;
  int index;
};

// Sets `matrix` to one with an entry for each block, which `value_of_entry` gives.
template <typename NT, int BlockSize, typename Value>
void set_scalar_matrix(const Block_matrix<BlockSize>& blocks, const Value& value_of_entry,
                       Eigen::SparseMatrix<NT>& matrix)
{
  const int n = blocks.columns_of_blocks();
  matrix.resize(n, n);
  matrix.resizeNonZeros(blocks.begin[n]);
  std::copy(blocks.begin.begin(), blocks.begin.end(), matrix.outerIndexPtr());
  std::copy(blocks.row.begin(), blocks.row.end(), matrix.innerIndexPtr());
  for(int j = 0; j < n; ++j)
    for(int e = blocks.begin[j]; e < blocks.begin[j + 1]; ++e)
      matrix.valuePtr()[e] = static_cast<NT>(value_of_entry(e, j));
}

template <typename NT, int BlockSize>
void set_eigen_matrix(const Diagonal_part<BlockSize>& part, Eigen::SparseMatrix<NT>& matrix)
{
  set_scalar_matrix(
      part.matrix, [&](int e, int) { return part.matrix.block[e](part.index, part.index); }, matrix);
}

// Sets `matrix` to a definite one of the same pattern: what can be analyzed before there are values
template <typename NT, int BlockSize>
void set_pattern_of_blocks(const Block_matrix<BlockSize>& blocks, Eigen::SparseMatrix<NT>& matrix)
{
  set_scalar_matrix(
      blocks, [&](int e, int j) { return blocks.row[e] == j; }, matrix);
}

// Sets `matrix` to one that is there already.
template <typename NT>
void set_eigen_matrix(const Eigen::SparseMatrix<NT>& source, Eigen::SparseMatrix<NT>& matrix)
{
  matrix = source;
}

// Sets `matrix` to the whole of it.
template <typename NT, int BlockSize>
void set_eigen_matrix(const Block_matrix<BlockSize>& blocks, Eigen::SparseMatrix<NT>& matrix)
{
  matrix.resize(blocks.size(), blocks.size());
  matrix.resizeNonZeros(blocks.block.size() * BlockSize * BlockSize);
  int* inner = matrix.innerIndexPtr();
  NT* value = matrix.valuePtr();
  for(int column = 0; column < blocks.size(); ++column) {
    const int j = column / BlockSize;
    for(int e = blocks.begin[j]; e < blocks.begin[j + 1]; ++e)
      for(int i = 0; i < BlockSize; ++i) {
        *inner++ = BlockSize * blocks.row[e] + i;
        *value++ = static_cast<NT>(blocks.block[e](i, column % BlockSize));
      }
    matrix.outerIndexPtr()[column + 1] = static_cast<int>(inner - matrix.innerIndexPtr());
  }
}

template <typename NT, typename Source>
Eigen::SparseMatrix<NT> eigen_matrix(const Source& source)
{
  Eigen::SparseMatrix<NT> matrix;
  set_eigen_matrix(source, matrix);
  return matrix;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BLOCK_MATRIX_H
