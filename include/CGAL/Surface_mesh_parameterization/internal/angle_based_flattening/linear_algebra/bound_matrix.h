// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Replaces the unknowns of the vertices of holes in Eq. 16 by four for each hole, because a hole has only four
// equations. `newton_system.h` binds the matrix of a chart with holes with it, and expands the solution.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BOUND_MATRIX_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BOUND_MATRIX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Binds the pairs of unknowns of the last blocks of a matrix S, those of the vertices of holes, to four numbers a, b,
// c, d for each hole:
//   lambda_plan(v) = a - c Im q(v) + d Re q(v)
//   lambda_len(v)  = b + c Re q(v) + d Im q(v)
// where the complex number q(v) is the vertex's position. The matrix Z from the bound unknowns to all has a block of
// its own for each free block of S, then one (a, b) for each hole, then one (c, d) for each. Computes Z' S Z, and
// products with Z and Z'.
class Bound_matrix
{
  typedef Block_matrix<2>::Block Block;

public:
  // `hole` is the hole of each block of `matrix` behind the free ones. The pattern of the matrix stays the same.
  Bound_matrix(std::vector<int> hole, int number_of_holes, const Block_matrix<2>& matrix)
      : m_free(matrix.columns_of_blocks() - static_cast<int>(hole.size())), m_holes(number_of_holes),
        m_hole(std::move(hole)), m_translation(m_hole.size(), Block::zero())
  {
    find_pattern(matrix);
  }

  // Sets the position of the vertex of bound block number `i`.
  void set_position(int i, const std::complex<double>& q)
  {
    m_translation[i] = {{-q.imag(), q.real(), q.real(), q.imag()}};
  }

  // Sets `all` to Z x.
  void expand(const Eigen::VectorXd& x, Eigen::VectorXd& all) const
  {
    all.resize(2 * (m_free + number_of_bound_blocks()));
    std::copy_n(x.data(), 2 * m_free, all.data());
    for(int i = 0; i < number_of_bound_blocks(); ++i) {
      const Vector_2 own = block_of(x, rotation(i)) + m_translation[i] * block_of(x, translation(i));
      std::copy_n(own.entry, 2, &all[2 * (m_free + i)]);
    }
  }

  // Sets `sums` to Z' x.
  void bind(const Eigen::VectorXd& x, Eigen::VectorXd& sums) const
  {
    sums = Eigen::VectorXd::Zero(2 * (m_free + 2 * m_holes));
    std::copy_n(x.data(), 2 * m_free, sums.data());
    for(int i = 0; i < number_of_bound_blocks(); ++i) {
      const Vector_2 own = block_of(x, m_free + i);
      add_to_block(own, rotation(i), sums);
      add_to_block(m_translation[i] * own, translation(i), sums); // which is symmetric
    }
  }

  // Sets the matrix to Z' S Z.
  void bind(const Block_matrix<2>& s)
  {
    m_matrix.block.resize(m_matrix.row.size());
    parallel_for_blocks(m_free, [&](int first, int last) {
      for(int j = first; j < last; ++j) {
        const auto begin = s.block.begin() + s.begin[j], bound = s.block.begin() + first_bound_entry(s, j);
        const auto out = std::copy(begin, bound, m_matrix.block.begin() + m_matrix.begin[j]);
        std::fill(out, m_matrix.block.begin() + m_matrix.begin[j + 1], Block::zero());
      }
    });
    std::fill(m_matrix.block.begin() + m_matrix.begin[m_free], m_matrix.block.end(), Block::zero());
    for(int j = 0; j < number_of_bound_blocks(); ++j)
      for(int e = s.begin[m_free + j]; e < s.begin[m_free + j + 1]; ++e) {
        if(s.row[e] < m_free)
          add_coupling(s.row[e], j, s.block[e]);
        else
          add_bound(s.row[e] - m_free, j, s.block[e]);
      }
  }

  const Block_matrix<2>& matrix() const { return m_matrix; }

private:
  int number_of_bound_blocks() const { return static_cast<int>(m_hole.size()); }
  int rotation(int i) const { return m_free + m_hole[i]; }
  int translation(int i) const { return m_free + m_holes + m_hole[i]; }

  int first_bound_entry(const Block_matrix<2>& s, int j) const
  {
    int e = s.begin[j + 1];
    while(e > s.begin[j] && s.row[e - 1] >= m_free)
      --e;
    return e;
  }

  Block& entry(int row, int column)
  {
    const auto begin = m_matrix.row.begin();
    const auto place =
        std::lower_bound(begin + m_matrix.begin[column], begin + m_matrix.begin[column + 1], row);
    return m_matrix.block[place - begin];
  }

  // Adds what a block of S in a free row and the column of bound block `j` makes, on both sides of the diagonal.
  void add_coupling(int row, int j, const Block& block)
  {
    const Block moved = block * m_translation[j];
    entry(row, rotation(j)) += block;
    entry(rotation(j), row) += transposed(block);
    entry(row, translation(j)) += moved;
    entry(translation(j), row) += transposed(moved);
  }

  void add_bound(int i, int j, const Block& block)
  {
    entry(rotation(i), rotation(j)) += block;
    entry(rotation(i), translation(j)) += block * m_translation[j];
    entry(translation(i), rotation(j)) += m_translation[i] * block;
    entry(translation(i), translation(j)) += m_translation[i] * block * m_translation[j];
  }

  void find_pattern(const Block_matrix<2>& s)
  {
    std::vector<std::vector<int>> hole_rows(m_holes); // free ones, and rotations of holes
    for(int j = 0; j < number_of_bound_blocks(); ++j) {
      std::vector<int>& rows = hole_rows[m_hole[j]];
      rows.push_back(rotation(j));
      for(int e = s.begin[m_free + j]; e < s.begin[m_free + j + 1]; ++e)
        rows.push_back(s.row[e] < m_free ? s.row[e] : rotation(s.row[e] - m_free));
    }
    std::vector<int> rows;
    for(int j = 0; j < m_free; ++j) {
      rows.assign(s.row.begin() + s.begin[j], s.row.begin() + s.begin[j + 1]);
      for(int& row : rows)
        row = row < m_free ? row : rotation(row - m_free);
      append_column(rows);
    }
    for(int pass = 0; pass < 2; ++pass)
      for(const std::vector<int>& of_hole : hole_rows)
        append_column(rows = of_hole);
  }

  // Appends a column of the pattern: with the row of a hole's rotation also that of its translation.
  void append_column(std::vector<int>& rows)
  {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    const std::size_t with_rotations = rows.size();
    for(std::size_t i = 0; i < with_rotations; ++i)
      if(rows[i] >= m_free)
        rows.push_back(rows[i] + m_holes);
    m_matrix.row.insert(m_matrix.row.end(), rows.begin(), rows.end());
    m_matrix.begin.push_back(static_cast<int>(m_matrix.row.size()));
  }

  int m_free, m_holes;
  std::vector<int> m_hole;          // of each bound block
  std::vector<Block> m_translation; // of each bound block: from (c, d) to its unknowns
  Block_matrix<2> m_matrix;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BOUND_MATRIX_H
