// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEAR_PRECONDITIONER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEAR_PRECONDITIONER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_preconditioner.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/mixed_precision.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Some blocks of unknowns, and what belongs to them in a matrix or a vector
class Part_of_blocks
{
public:
  Part_of_blocks() = default;

  explicit Part_of_blocks(const std::vector<char>& is_in) : m_rank(is_in.size(), -1)
  {
    for(std::size_t j = 0; j < is_in.size(); ++j)
      if(is_in[j]) {
        m_rank[j] = static_cast<int>(m_blocks.size());
        m_blocks.push_back(static_cast<int>(j));
      }
  }

  // A matrix whose pattern is known, but not its blocks
  Block_matrix<2> pattern_of(const Block_matrix<2>& matrix) const
  {
    Block_matrix<2> part;
    for(int j : m_blocks) {
      for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e)
        if(const int i = m_rank[matrix.row[e]]; i >= 0)
          part.row.push_back(i);
      part.begin.push_back(static_cast<int>(part.row.size()));
    }
    return part;
  }

  Block_matrix<2> of(const Block_matrix<2>& matrix) const
  {
    Block_matrix<2> part = pattern_of(matrix);
    part.block.reserve(part.row.size());
    for(int j : m_blocks)
      for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e)
        if(m_rank[matrix.row[e]] >= 0)
          part.block.push_back(matrix.block[e]);
    return part;
  }

  Eigen::VectorXd of(const Eigen::VectorXd& x) const
  {
    Eigen::VectorXd part(2 * m_blocks.size());
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      part.segment<2>(2 * i) = x.segment<2>(2 * m_blocks[i]);
    return part;
  }

  void add(const Eigen::VectorXd& part, Eigen::VectorXd& x) const
  {
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      x.segment<2>(2 * m_blocks[i]) += part.segment<2>(2 * i);
  }

  // Subtracts from `x` the columns of the part times `part`.
  void subtract_columns(const Block_matrix<2>& matrix, const Eigen::VectorXd& part, Eigen::VectorXd& x) const
  {
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      for(int e = matrix.begin[m_blocks[i]]; e < matrix.begin[m_blocks[i] + 1]; ++e)
        x.segment<2>(2 * matrix.row[e]) -= matrix.block[e] * part.segment<2>(2 * i);
  }

  // Subtracts from `part` the rows of the part times `x`. They are the columns, for the matrix is symmetric.
  void subtract_rows(const Block_matrix<2>& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& part) const
  {
    for(std::size_t i = 0; i < m_blocks.size(); ++i)
      for(int e = matrix.begin[m_blocks[i]]; e < matrix.begin[m_blocks[i] + 1]; ++e)
        part.segment<2>(2 * i) -= matrix.block[e].transpose() * x.segment<2>(2 * matrix.row[e]);
  }

private:
  std::vector<int> m_blocks; // ascending
  std::vector<int> m_rank;   // of each block of the whole: that in `m_blocks`, or -1
};

// Preconditions the matrix Z' S Z of `Bound_matrix`. Its two scalar matrices, without translations and with each hole as
// one node, are good far from the holes. They know nothing of the translations, which couple both multipliers around
// a hole. So near the holes the whole matrix is solved as well, before and after (symmetric multiplicative Schwarz).
class Near_preconditioner
{
  static constexpr int rings = 2; // one takes up to twice as many steps, three or four take longer to factor

public:
  // `global` preconditions the part without translations.
  Near_preconditioner(const Linear_solvers& solvers, Block_preconditioner& global, int holes,
                      const Block_matrix<2>& pattern)
      : m_global(global), m_system(solvers, solvers->low_precision())
  {
    std::vector<char> is_global(pattern.columns_of_blocks(), true);
    std::fill(is_global.end() - holes, is_global.end(), false);
    m_global_part = Part_of_blocks(is_global);
    m_near_part = Part_of_blocks(blocks_near_holes(pattern, 2 * holes));
    m_global.analyze_pattern(m_global_part.pattern_of(pattern));
  }

  // Factors the two scalar matrices.
  bool set_global_matrix(const Block_matrix<2>& matrix)
  {
    return m_global.set_matrix(m_global_part.of(matrix));
  }

  // Factors the part near the holes. The matrix is referred to by `solve()`.
  bool set_near_matrix(const Block_matrix<2>& matrix)
  {
    m_matrix = &matrix;
    return m_system.set_matrix(m_near_part.of(matrix));
  }

  bool solve(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    Eigen::VectorXd near, far, rest = residual;
    if(!m_system.solve(m_near_part.of(residual), near))
      return false;
    m_near_part.subtract_columns(*m_matrix, near, rest);
    if(!m_global.solve(m_global_part.of(rest), far))
      return false;
    correction = Eigen::VectorXd::Zero(residual.size());
    m_near_part.add(near, correction);
    m_global_part.add(far, correction);

    rest = m_near_part.of(residual);
    m_near_part.subtract_rows(*m_matrix, correction, rest);
    if(!m_system.solve(rest, near))
      return false;
    m_near_part.add(near, correction);
    return true;
  }

  // Whether low precision was not enough for the part near the holes
  bool is_repeated() const { return m_system.is_repeated(); }

private:
  static std::vector<char> blocks_near_holes(const Block_matrix<2>& pattern, int blocks_of_holes)
  {
    const int n = pattern.columns_of_blocks();
    std::vector<char> is_near(n, false);
    std::vector<int> front, next;
    for(int j = n - blocks_of_holes; j < n; ++j) {
      is_near[j] = true;
      front.push_back(j);
    }
    for(int ring = 0; ring < rings; ++ring, front.swap(next), next.clear())
      for(int j : front)
        for(int e = pattern.begin[j]; e < pattern.begin[j + 1]; ++e)
          if(const int i = pattern.row[e]; !is_near[i]) {
            is_near[i] = true;
            next.push_back(i);
          }
    return is_near;
  }

  Block_preconditioner& m_global;
  Preconditioning_system m_system;
  Part_of_blocks m_global_part, m_near_part;
  const Block_matrix<2>* m_matrix = nullptr;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEAR_PRECONDITIONER_H
