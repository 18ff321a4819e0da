// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Ordering, elimination tree and memory of a factorization, from the pattern alone, once for all matrices of that
// pattern. `SuperLU_factors.h` calls it in place of SuperLU's own analysis, which can write out of bounds and end the
// program.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ANALYSIS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ANALYSIS_H

#include <CGAL/Solver_interface/internal/SuperLU_elimination_tree.h>
#include <CGAL/Solver_interface/internal/SuperLU_matrix.h>

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

// What the pattern of a matrix alone determines: an ordering of the columns, its elimination tree, and the memory
// that SuperLU needs for the factors. It is not computed by SuperLU, because SuperLU does not postorder in its
// symmetric mode, ends the program if memory runs out, and finds out the size of the factors only while it computes
// them.
//
// In symmetric mode the elimination tree is that of A + A', and the sizes hold if all the pivots are on the diagonal.
// Otherwise it is that of A'A, and the sizes are upper bounds.
//
// SuperLU makes one dense block, a relaxed supernode, of a maximal subtree of at most `relax` columns. It does not
// check whether such a block fills its array of subscripts, and the next column then writes beyond the end (SuperLU
// 5.3, `dsnode_dfs` and `dcolumn_dfs`). So these subtrees are ordered before all other columns. Their subscripts
// depend on the pattern only, not on the pivots, so enough memory is reserved for them. SuperLU checks the other
// columns one by one, and enlarges the array in time if the pivots differ from the prediction.
class SuperLU_analysis
{
public:
  // `relax` and `max_supernode` are the parameters with which SuperLU will form supernodes.
  SuperLU_analysis(const SuperLU_pattern& a, bool symmetric, int relax, int max_supernode)
      : m_symmetric(symmetric), m_n(a.size), m_relax(relax), m_outer(a.outer, a.outer + m_n + 1),
        m_inner(a.inner, a.inner + a.nonzeros())
  {
    order(a);
    std::vector<int> row_begin, row_neighbor;
    if(!symmetric)
      build_row_graph(a, row_begin, row_neighbor);
    const SuperLU_column_graph graph = {symmetric ? m_outer.data() : row_begin.data(),
                                        symmetric ? m_inner.data() : row_neighbor.data()};
    const SuperLU_elimination_tree tree(graph, m_permutation);
    put_relaxed_subtrees_first(tree, max_supernode);
  }

  bool is_symmetric() const { return m_symmetric; }
  int size() const { return m_n; }
  int relax() const { return m_relax; }

  // `permutation()[i]` is the position of column i of A.
  const std::vector<int>& permutation() const { return m_permutation; }

  // The parent of every column at its position; `size()` stands for the parent of a root.
  const std::vector<int>& elimination_tree() const { return m_parent; }

  // The number of entries in the supernodes of L (which include the blocks of U on the diagonal). Outside of these
  // blocks, U has at most one entry for each of these.
  std::size_t factor_size() const { return m_factor_size; }

  // The largest number of row subscripts that SuperLU stores at any time
  std::size_t subscripts() const { return m_subscripts; }

  // The number of subscripts of the relaxed supernodes, which come first
  std::size_t relaxed_subscripts() const { return m_relaxed_subscripts; }

  bool has_pattern_of(const SuperLU_pattern& a) const
  {
    return a.size == m_n && a.nonzeros() == m_inner.size() &&
           std::equal(m_outer.begin(), m_outer.end(), a.outer) &&
           std::equal(m_inner.begin(), m_inner.end(), a.inner);
  }

private:
  void order(const SuperLU_pattern& a)
  {
    // Eigen's ordering needs a matrix and copies its values, so the values have the smallest type
    const std::vector<char> values(a.nonzeros(), 0);
    const Eigen::Map<const Eigen::SparseMatrix<char>> columns(m_n, m_n, static_cast<int>(a.nonzeros()),
                                                              a.outer, a.inner, values.data());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> column_at;
    m_permutation.resize(m_n);
    if(m_symmetric) {
      Eigen::AMDOrdering<int>()(columns.selfadjointView<Eigen::Lower>(), column_at);
      for(int k = 0; k < m_n; ++k)
        m_permutation[column_at.indices()[k]] = k;
    } else {
      Eigen::COLAMDOrdering<int>()(columns, column_at);
      for(int i = 0; i < m_n; ++i)
        m_permutation[i] = column_at.indices()[i];
    }
  }

  // The columns with an entry in a common row are a clique in A'A. A star from the first of them to the others has
  // the same factor, because eliminating the first one completes the clique.
  void build_row_graph(const SuperLU_pattern& a, std::vector<int>& begin, std::vector<int>& neighbor) const
  {
    std::vector<int> first(m_n, -1);
    a.for_each_entry([&](int row, int column) {
      if(first[row] < 0 || m_permutation[column] < m_permutation[first[row]])
        first[row] = column;
    });

    begin.assign(m_n + 1, 0);
    a.for_each_entry([&](int row, int column) {
      if(column != first[row]) {
        ++begin[column + 1];
        ++begin[first[row] + 1];
      }
    });
    for(int i = 0; i < m_n; ++i)
      begin[i + 1] += begin[i];

    neighbor.resize(begin[m_n]);
    std::vector<int> end(begin.begin(), begin.end() - 1);
    a.for_each_entry([&](int row, int column) {
      if(column != first[row]) {
        neighbor[end[column]++] = first[row];
        neighbor[end[first[row]]++] = column;
      }
    });
  }

  void put_relaxed_subtrees_first(const SuperLU_elimination_tree& tree, int max_supernode)
  {
    std::vector<int> in_order, others;
    in_order.reserve(m_n);
    m_factor_size = m_subscripts = 0;
    for(int j = 0; j < m_n; ++j) {
      if(tree.subtree_size(j) > 1) {
        others.push_back(j);
        continue;
      }
      int root = j; // of the relaxed subtree that begins with the leaf `j`
      while(tree.parent(root) < m_n && tree.subtree_size(tree.parent(root)) <= m_relax)
        root = tree.parent(root);
      const int width = root - j + 1;
      const std::size_t height = width - 1 + tree.column_count(root);
      m_factor_size += width * height;
      m_subscripts += width == 1 ? height : 2 * height; // SuperLU keeps a copy to find later fill-in
      for(int i = j; i <= root; ++i)
        in_order.push_back(i);
      j = root;
    }
    m_relaxed_subscripts = m_subscripts;
    count_other_supernodes(tree, others, max_supernode);
    in_order.insert(in_order.end(), others.begin(), others.end());
    renumber(tree, in_order);
  }

  // Columns with nested patterns make a supernode. While a supernode grows, SuperLU keeps the subscripts of all its
  // columns. Once the next supernode has begun, it keeps those of the first and the last column.
  void count_other_supernodes(const SuperLU_elimination_tree& tree, const std::vector<int>& columns,
                              int max_supernode)
  {
    std::size_t held = m_subscripts, between = 0, height = 0;
    int width = 0;
    for(std::size_t i = 0; i < columns.size(); ++i) {
      const int j = columns[i], count = tree.column_count(j);
      const bool extends = i > 0 && width < max_supernode && tree.parent(columns[i - 1]) == j &&
                           count == tree.column_count(columns[i - 1]) - 1;
      held += count;
      m_subscripts = (std::max)(m_subscripts, held);
      if(extends) {
        if(++width > 2)
          between += tree.column_count(columns[i - 1]);
      } else {
        held -= between;
        between = 0;
        width = 1;
        height = count;
      }
      m_factor_size += height;
    }
  }

  void renumber(const SuperLU_elimination_tree& tree, const std::vector<int>& in_order)
  {
    std::vector<int> position(m_n + 1, m_n);
    for(int k = 0; k < m_n; ++k)
      position[in_order[k]] = k;
    m_parent.resize(m_n);
    for(int k = 0; k < m_n; ++k)
      m_parent[k] = position[tree.parent(in_order[k])];
    for(int& p : m_permutation)
      p = position[p];
  }

  bool m_symmetric;
  int m_n, m_relax;
  std::vector<int> m_outer, m_inner; // the pattern
  std::vector<int> m_permutation, m_parent;
  std::size_t m_factor_size, m_subscripts, m_relaxed_subscripts;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ANALYSIS_H
