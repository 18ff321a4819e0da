// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums up a sparse matrix from a small one for each triangle. The pattern is found once, and the order does not depend
// on threads. `newton_system.h` assembles Eq. 16 with it, and both layouts their systems (Eqs. 19 to 21 in least
// squares).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_TRIANGLE_ASSEMBLY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_TRIANGLE_ASSEMBLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A block of unknowns that a triangle has besides those of its vertices
struct Extra_unknown
{
  int triangle, unknown;
};

// A symmetric sparse matrix that is the sum of a small matrix for each triangle, as a finite element stiffness matrix
// is. A vertex has `BlockSize` unknowns or none; several vertices may have the same ones. The pattern is found once.
// Each column is summed up by itself, in the order of the triangles.
template <int BlockSize>
class Triangle_assembly
{
public:
  typedef Small_matrix<3 * BlockSize, BlockSize> Local_columns;

  // `vertex` is the vertex of each corner; `unknown` of each vertex the number of its block of unknowns, less than `n`,
  // or -1. Both are referred to later. The pattern has room for `extra` unknowns, which are sorted by triangles.
  Triangle_assembly(const std::vector<int>& vertex, const std::vector<int>& unknown, int n,
                    std::vector<Extra_unknown> extra = {})
      : m_vertex(vertex), m_unknown(unknown), m_extra(std::move(extra))
  {
    find_corners(n);
    find_pattern(n);
  }

  // Sets the matrix to the sum of those of all triangles. `columns(c)` returns the columns that belong to corner `c` of
  // its triangle's matrix; it is called once for each corner, by one thread for all corners at a vertex, ascending.
  template <typename Columns>
  void assemble(const Columns& columns)
  {
    m_matrix.block.resize(m_matrix.row.size());
    parallel_for_blocks(m_matrix.columns_of_blocks(), [&](int first, int last) {
      for(int j = first; j < last; ++j) {
        std::fill(m_matrix.block.begin() + m_matrix.begin[j], m_matrix.block.begin() + m_matrix.begin[j + 1],
                  Block_matrix<BlockSize>::Block::zero());
        for(const int c : corners(j))
          add(j, c, columns(c));
      }
    });
  }

  const Block_matrix<BlockSize>& matrix() const { return m_matrix; }

  typename Block_matrix<BlockSize>::Block& block(int row, int column)
  {
    return m_matrix.block[entry(row, column)];
  }

  typename Block_matrix<BlockSize>::Block& diagonal_block(int j) { return block(j, j); }

private:
  // The corners at vertices with block `j`, ascending
  boost::iterator_range<const int*> corners(int j) const
  {
    return {m_corner.data() + m_first[j], m_corner.data() + m_first[j + 1]};
  }

  int unknown(int corner) const { return m_unknown[m_vertex[corner]]; }

  void add(int column, int corner, const Local_columns& local)
  {
    for(int a = 0; a < 3; ++a)
      if(const int row = unknown(corner / 3 * 3 + a); row >= 0) {
        m_matrix.block[entry(row, column)] += rows_of<BlockSize>(local, BlockSize * a);
      }
  }

  // The number of an entry in the matrix. Rings are small, but for a few.
  int entry(int row, int column) const
  {
    const int begin = m_matrix.begin[column], end = m_matrix.begin[column + 1];
    if(end - begin > 32)
      return static_cast<int>(
          std::lower_bound(m_matrix.row.begin() + begin, m_matrix.row.begin() + end, row) -
          m_matrix.row.begin());
    int e = begin;
    while(m_matrix.row[e] != row)
      ++e;
    return e;
  }

  void find_corners(int n)
  {
    const int corners = static_cast<int>(m_vertex.size());
    m_first.assign(n + 1, 0);
    for(int c = 0; c < corners; ++c)
      if(const int j = unknown(c); j >= 0)
        ++m_first[j + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_corner.resize(m_first.back());
    std::vector<int> end(m_first.begin(), m_first.end() - 1);
    for(int c = 0; c < corners; ++c)
      if(const int j = unknown(c); j >= 0)
        m_corner[end[j]++] = c;
  }

  void find_pattern(int n)
  {
    std::vector<int>& begin = m_matrix.begin;
    begin.assign(n + 1, 0);
    std::vector<std::vector<int>> rows(n / block_size + 1); // of each block of columns
    parallel_for_blocks(n, [&](int first, int last) {
      std::vector<int>& row = rows[first / block_size];
      for(int j = first; j < last; ++j) {
        const std::ptrdiff_t size = row.size();
        add_ring(j, row);
        begin[j + 1] = static_cast<int>(row.size() - size);
      }
    });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    m_matrix.row.resize(begin.back());
    parallel_for_blocks(n, [&](int first, int) {
      const std::vector<int>& row = rows[first / block_size];
      std::copy(row.begin(), row.end(), m_matrix.row.begin() + begin[first]);
    });
  }

  // Appends the rows of a column, ascending; the one on the diagonal also without a corner.
  void add_ring(int column, std::vector<int>& rows) const
  {
    const std::ptrdiff_t size = rows.size();
    rows.push_back(column);
    for(const int corner : corners(column))
      add_triangle(corner / 3, corner, rows);
    if(corners(column).empty())
      for(const Extra_unknown& extra : m_extra)
        if(extra.unknown == column)
          add_triangle(extra.triangle, -1, rows);
    std::sort(rows.begin() + size, rows.end());
    rows.erase(std::unique(rows.begin() + size, rows.end()), rows.end());
  }

  // Appends the rows of a triangle but that of corner `column`.
  void add_triangle(int t, int column, std::vector<int>& rows) const
  {
    for(int c = 3 * t; c < 3 * t + 3; ++c)
      if(c != column && unknown(c) >= 0)
        rows.push_back(unknown(c));
    if(m_extra.empty())
      return;
    const auto first =
        std::lower_bound(m_extra.begin(), m_extra.end(), t,
                         [](const Extra_unknown& extra, int triangle) { return extra.triangle < triangle; });
    for(auto extra = first; extra != m_extra.end() && extra->triangle == t; ++extra)
      rows.push_back(extra->unknown);
  }

  const std::vector<int>& m_vertex;
  const std::vector<int>& m_unknown;
  std::vector<Extra_unknown> m_extra;
  std::vector<int> m_first, m_corner; // the corners at each vertex
  Block_matrix<BlockSize> m_matrix;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_TRIANGLE_ASSEMBLY_H
