// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SUPERNODAL_FACTORS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SUPERNODAL_FACTORS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Solver_interface/internal/Supernodal_solution.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The factors L D L' of a symmetric matrix by supernodes: fewer subscripts, and faster to solve with than the columns from
// which they are made.
class Supernodal_factors
{
public:
  // `lower` is what L has below its diagonal, with ascending rows; `pivots` is D.
  Supernodal_factors(const Eigen::SparseMatrix<float>& lower, const Eigen::VectorXf& pivots)
  {
    find_supernodes(lower);
    m_below.reserve(m_row_begin.back());
    m_values.reserve(m_value_begin.back());
    for(int s = 0; s < number_of_supernodes(); ++s)
      copy_supernode(lower, pivots, m_first[s], m_first[s + 1]);
  }

  int size() const { return m_first.back(); }
  int number_of_supernodes() const { return static_cast<int>(m_first.size()) - 1; }

  CGAL::internal::Supernode<float> supernode(int s) const
  {
    const int columns = m_first[s + 1] - m_first[s];
    const int below = static_cast<int>(m_row_begin[s + 1] - m_row_begin[s]);
    return {m_first[s], columns, columns + below, m_below.data() + m_row_begin[s],
            m_values.data() + m_value_begin[s]};
  }

private:
  static constexpr int max_columns = 32; // half of a triangle's entries are not used

  static std::size_t count(const Eigen::SparseMatrix<float>& lower, int column)
  {
    return lower.outerIndexPtr()[column + 1] - lower.outerIndexPtr()[column];
  }

  // Of a factor, the next column has all rows of this one but its first if it is that row, and as many as are left.
  static bool continues(const Eigen::SparseMatrix<float>& lower, int column)
  {
    return column + 1 < lower.cols() && count(lower, column) == count(lower, column + 1) + 1 &&
           lower.innerIndexPtr()[lower.outerIndexPtr()[column]] == column + 1;
  }

  void find_supernodes(const Eigen::SparseMatrix<float>& lower)
  {
    const int n = static_cast<int>(lower.cols());
    m_first = {0};
    m_row_begin = m_value_begin = {0};
    for(int j = 0; j < n; ++j) {
      const int columns = j + 1 - m_first.back();
      if(continues(lower, j) && columns < max_columns)
        continue;
      m_row_begin.push_back(m_row_begin.back() + count(lower, j));
      m_value_begin.push_back(m_value_begin.back() + columns * (columns + count(lower, j)));
      m_first.push_back(j + 1);
    }
  }

  void copy_supernode(const Eigen::SparseMatrix<float>& lower, const Eigen::VectorXf& pivots, int first,
                      int end)
  {
    const int* rows = lower.innerIndexPtr() + lower.outerIndexPtr()[end - 1];
    m_below.insert(m_below.end(), rows, rows + count(lower, end - 1));
    for(int j = first; j < end; ++j) {
      m_values.insert(m_values.end(), j - first, 0.f);
      m_values.push_back(pivots[j]);
      const float* values = lower.valuePtr() + lower.outerIndexPtr()[j];
      m_values.insert(m_values.end(), values, values + count(lower, j));
    }
  }

  std::vector<int> m_first; // column of each supernode, and the end
  std::vector<std::size_t> m_row_begin, m_value_begin;
  std::vector<int> m_below;
  std::vector<float> m_values;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SUPERNODAL_FACTORS_H
