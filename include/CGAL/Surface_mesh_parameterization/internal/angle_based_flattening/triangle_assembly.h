// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_TRIANGLE_ASSEMBLY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_TRIANGLE_ASSEMBLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/parallel.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// A symmetric sparse matrix that is the sum of a small matrix for each triangle, as a finite element stiffness
// matrix is. A vertex has `BlockSize` unknowns or none. The pattern, that of the one-rings, is found once.
template <int BlockSize>
class Triangle_assembly
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Eigen::Matrix<double, 3 * BlockSize, 3 * BlockSize> Local_matrix;

  // `vertex` is the vertex of each corner; `unknown` of each vertex its rank among the `n` that have unknowns, or
  // -1.
  Triangle_assembly(const std::vector<int>& vertex, const std::vector<int>& unknown, int n)
      : m_unknown(vertex.size()), m_slots(vertex.size() / 3)
  {
    for(std::size_t c = 0; c < vertex.size(); ++c)
      m_unknown[c] = unknown[vertex[c]];

    std::vector<int> first(n + 1, 0);
    for_each_pair([&](int, int, int column) { ++first[column + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> rows(first.back()), end(first.begin(), first.end() - 1);
    for_each_pair([&](int, int row, int column) { rows[end[column]++] = row; });
    remove_duplicates(first, end, rows);
    build_pattern(first, end, rows);
    find_slots(first, end, rows);
  }

  void set_zero() { m_matrix.coeffs().setZero(); }

  // Adds the matrix of triangle `t`, without the rows and columns of vertices that have no unknowns.
  void add(std::size_t t, const Local_matrix& local)
  {
    double* values = m_matrix.valuePtr();
    for(int b = 0; b < 3; ++b) {
      const int column = m_unknown[3 * t + b];
      if(column < 0)
        continue;
      const int column_length = (column_start(column + 1) - column_start(column)) / BlockSize;
      for(int a = 0; a < 3; ++a) {
        if(m_unknown[3 * t + a] < 0)
          continue;
        double* block = values + m_slots[t][3 * b + a];
        for(int j = 0; j < BlockSize; ++j)
          for(int i = 0; i < BlockSize; ++i)
            block[j * column_length + i] += local(BlockSize * a + i, BlockSize * b + j);
      }
    }
  }

  const Matrix& matrix() const { return m_matrix; }

private:
  int column_start(int vertex) const { return m_matrix.outerIndexPtr()[BlockSize * vertex]; }

  // Calls `visit` with a number for a pair of corners of triangle `t`, and their unknowns.
  template <typename Visitor>
  void for_each_pair(int t, const Visitor& visit) const
  {
    for(int b = 0; b < 3; ++b)
      for(int a = 0; a < 3; ++a)
        if(m_unknown[3 * t + a] >= 0 && m_unknown[3 * t + b] >= 0)
          visit(3 * b + a, m_unknown[3 * t + a], m_unknown[3 * t + b]);
  }

  template <typename Visitor>
  void for_each_pair(const Visitor& visit) const
  {
    for(int t = 0; t < static_cast<int>(m_slots.size()); ++t)
      for_each_pair(t, visit);
  }

  // Column j has the rows [first[j], end[j]).
  static void remove_duplicates(const std::vector<int>& first, std::vector<int>& end, std::vector<int>& rows)
  {
    parallel_for_blocks(static_cast<int>(end.size()), [&](int begin_column, int end_column) {
      for(int j = begin_column; j < end_column; ++j) {
        const auto begin = rows.begin() + first[j];
        std::sort(begin, rows.begin() + end[j]);
        end[j] = static_cast<int>(std::unique(begin, rows.begin() + end[j]) - rows.begin());
      }
    });
  }

  void build_pattern(const std::vector<int>& first, const std::vector<int>& end, const std::vector<int>& rows)
  {
    const int n = static_cast<int>(end.size());
    m_matrix.resize(BlockSize * n, BlockSize * n);
    int* outer = m_matrix.outerIndexPtr();
    for(int j = 0; j < n; ++j)
      for(int k = 0; k < BlockSize; ++k)
        outer[BlockSize * j + k + 1] = outer[BlockSize * j + k] + BlockSize * (end[j] - first[j]);
    m_matrix.resizeNonZeros(outer[BlockSize * n]);
    parallel_for_blocks(n, [&](int begin_column, int end_column) {
      int* inner = m_matrix.innerIndexPtr() + column_start(begin_column);
      for(int j = begin_column; j < end_column; ++j)
        for(int k = 0; k < BlockSize; ++k)
          for(int r = first[j]; r < end[j]; ++r)
            for(int i = 0; i < BlockSize; ++i)
              *inner++ = BlockSize * rows[r] + i;
    });
    set_zero();
  }

  void find_slots(const std::vector<int>& first, const std::vector<int>& end, const std::vector<int>& rows)
  {
    parallel_for_blocks(static_cast<int>(m_slots.size()), [&](int begin_triangle, int end_triangle) {
      for(int t = begin_triangle; t < end_triangle; ++t)
        for_each_pair(t, [&](int pair, int row, int column) {
          const auto begin = rows.begin() + first[column];
          const auto rank = std::lower_bound(begin, rows.begin() + end[column], row) - begin;
          m_slots[t][pair] = column_start(column) + BlockSize * static_cast<int>(rank);
        });
    });
  }

  std::vector<int> m_unknown;              // of each corner
  std::vector<std::array<int, 9>> m_slots; // of each triangle: where the block of a pair of corners starts
  Matrix m_matrix;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_TRIANGLE_ASSEMBLY_H
