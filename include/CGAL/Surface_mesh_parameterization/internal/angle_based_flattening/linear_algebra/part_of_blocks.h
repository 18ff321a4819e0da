// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Chooses blocks of Eq. 16, those of vertices where planarity and reconstruction are strongly coupled, and restricts
// matrices and vectors to them. `newton_preconditioner.h` solves the whole matrix there: near slivers, steep cones and
// holes.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_PART_OF_BLOCKS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_PART_OF_BLOCKS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Adds the neighbours of some blocks, and theirs, so many times.
inline void add_rings(const Block_matrix<2>& pattern, int rings, std::vector<char>& is_in)
{
  std::vector<int> front, next;
  for(std::size_t j = 0; j < is_in.size(); ++j)
    if(is_in[j])
      front.push_back(static_cast<int>(j));
  for(int ring = 0; ring < rings; ++ring, front.swap(next), next.clear())
    for(int j : front)
      for(int e = pattern.begin[j]; e < pattern.begin[j + 1]; ++e)
        if(const int i = pattern.row[e]; !is_in[i]) {
          is_in[i] = true;
          next.push_back(i);
        }
}

// How strongly a block's two unknowns are coupled to those of the other kind, compared with its diagonal
inline double relative_coupling(const Block_matrix<2>& matrix, int j)
{
  Block_matrix<2>::Block diagonal = {{1, 0, 0, 1}};
  double first = 0, second = 0;
  for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e) {
    const Block_matrix<2>::Block& block = matrix.block[e];
    first += std::abs(block(0, 1));
    second += std::abs(block(1, 0));
    if(matrix.row[e] == j)
      diagonal = block;
  }
  return (std::max)(first, second) / std::sqrt(diagonal(0, 0) * diagonal(1, 1));
}

// The blocks with strong couplings, and their neighbours; if these are too many, only the blocks with the strongest
// couplings. The memory of `coupling` is used.
inline void find_strongly_coupled_blocks(const Block_matrix<2>& matrix, std::vector<double>& coupling,
                                         std::vector<char>& is_in)
{
  constexpr double strong = 1;       // at 0.7 or 2 it takes longer, on charts with slivers and steep noise
  constexpr double largest_part = 4; // the factors of more than a quarter cost as much as those of all
  const int n = matrix.columns_of_blocks();
  coupling.resize(n);
  parallel_for_blocks(n, [&](int first, int last) {
    for(int j = first; j < last; ++j)
      coupling[j] = relative_coupling(matrix, j);
  });
  is_in.resize(n);
  for(double bound = strong;; bound *= 1.25) {
    std::transform(coupling.begin(), coupling.end(), is_in.begin(), [&](double c) { return c > bound; });
    add_rings(matrix, 1, is_in);
    if(largest_part * std::count(is_in.begin(), is_in.end(), true) <= n)
      return;
  }
}

// Some blocks of unknowns, and what belongs to them in a matrix or a vector
class Part_of_blocks
{
public:
  void set(const std::vector<char>& is_in)
  {
    m_blocks.clear();
    m_rank.assign(is_in.size(), -1);
    for(std::size_t j = 0; j < is_in.size(); ++j)
      if(is_in[j]) {
        m_rank[j] = static_cast<int>(m_blocks.size());
        m_blocks.push_back(static_cast<int>(j));
      }
  }

  std::size_t size() const { return m_blocks.size(); }

  // Sets `part` to what belongs to these blocks; of the matrix only the pattern
  void take_pattern(const Block_matrix<2>& matrix, Block_matrix<2>& part) const
  {
    part.begin.assign(1, 0);
    part.row.clear();
    for(int j : m_blocks) {
      for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e)
        if(const int i = m_rank[matrix.row[e]]; i >= 0)
          part.row.push_back(i);
      part.begin.push_back(static_cast<int>(part.row.size()));
    }
  }

  void take(const Block_matrix<2>& matrix, Block_matrix<2>& part) const
  {
    take_pattern(matrix, part);
    part.block.clear();
    part.block.reserve(part.row.size());
    for(int j : m_blocks)
      for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e)
        if(m_rank[matrix.row[e]] >= 0)
          part.block.push_back(matrix.block[e]);
  }

  void take(const Eigen::VectorXd& x, Eigen::VectorXd& part) const
  {
    set_size(part, 2 * static_cast<Eigen::Index>(m_blocks.size()));
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      std::copy_n(&x[2 * m_blocks[i]], 2, &part[2 * i]);
  }

  void add(const Eigen::VectorXd& part, Eigen::VectorXd& x) const
  {
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      add_to_block(block_of(part, static_cast<int>(i)), m_blocks[i], x);
  }

  // Subtracts from `x` the columns of the part times `part`.
  void subtract_columns(const Block_matrix<2>& matrix, const Eigen::VectorXd& part, Eigen::VectorXd& x) const
  {
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      for(int e = matrix.begin[m_blocks[i]]; e < matrix.begin[m_blocks[i] + 1]; ++e)
        subtract(matrix.block[e] * block_of(part, static_cast<int>(i)), &x[2 * matrix.row[e]]);
  }

  // Subtracts from `part` the rows of the part times `x`. They are the columns, for the matrix is symmetric.
  void subtract_rows(const Block_matrix<2>& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& part) const
  {
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      for(int e = matrix.begin[m_blocks[i]]; e < matrix.begin[m_blocks[i] + 1]; ++e)
        subtract(transposed(matrix.block[e]) * block_of(x, matrix.row[e]), &part[2 * i]);
  }

private:
  static void subtract(const Vector_2& block, double* from)
  {
    from[0] -= block[0];
    from[1] -= block[1];
  }

  std::vector<int> m_blocks; // ascending
  std::vector<int> m_rank;   // of each block of the whole: that in `m_blocks`, or -1
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_PART_OF_BLOCKS_H
