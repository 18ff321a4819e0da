// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ANALYSIS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ANALYSIS_H

#include <CGAL/Solver_interface/internal/SuperLU_input.h>

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace internal {

// What the pattern of a matrix alone determines: an ordering of the columns that is a postorder of its
// elimination tree, that tree, and the size of the factors. It is computed here and not by
// SuperLU because SuperLU does not postorder in its symmetric mode, ends the
// program where memory lacks, and only finds out the size of the factors while it computes them.
//
// In symmetric mode the elimination tree is that of A + A', and the sizes hold if all the pivots are on the diagonal.
// Otherwise it is that of A'A, and the sizes are upper bounds.
class SuperLU_analysis
{
public:
  // `relax` and `max_supernode` are the parameters with which SuperLU will form supernodes.
  SuperLU_analysis(const SuperLU_pattern& a, bool symmetric, int relax, int max_supernode)
      : m_symmetric(symmetric), m_n(a.size), m_outer(a.outer, a.outer + m_n + 1),
        m_inner(a.inner, a.inner + a.nonzeros())
  {
    order(a);
    Graph graph = {m_outer.data(), m_inner.data(), {}, {}};
    if(!symmetric)
      build_row_graph(a, graph);
    compute_elimination_tree(graph);
    compute_subtree_sizes();
    postorder();
    compute_column_counts(graph);
    estimate_factor_size(relax, max_supernode);
    m_size_of_subtree = std::vector<int>();
    m_count = std::vector<int>();
  }

  bool is_symmetric() const { return m_symmetric; }
  int size() const { return m_n; }

  // `permutation()[i]` is the position of column i of A.
  const std::vector<int>& permutation() const { return m_permutation; }

  // The parent of every column at its position; `size()` stands for the parent of a root.
  const std::vector<int>& elimination_tree() const { return m_parent; }

  // The number of entries in the supernodes of L (which include the blocks of U on the diagonal)
  std::size_t factor_size() const { return m_factor_size; }

  // The row subscripts that SuperLU keeps: of each dense block those of its first column, and a copy of them
  std::size_t subscripts() const { return m_subscripts; }

  bool has_pattern_of(const SuperLU_pattern& a) const
  {
    return a.size == m_n && a.nonzeros() == m_inner.size() &&
           std::equal(m_outer.begin(), m_outer.end(), a.outer) &&
           std::equal(m_inner.begin(), m_inner.end(), a.inner);
  }

private:
  // Adjacency lists of a symmetric graph on the columns, either somebody else's or its own
  struct Graph
  {
    const int* begin;
    const int* neighbor;
    std::vector<int> own_begin, own_neighbor;
  };

  void order(const SuperLU_pattern& a)
  {
    // Eigen orders matrices, and copies their values in between: they are as small as possible
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

  // The columns that meet in a row are a clique in A'A. A star from the first of them to the others has the same
  // factor, as eliminating the first one completes the clique.
  void build_row_graph(const SuperLU_pattern& a, Graph& graph) const
  {
    std::vector<int> first(m_n, -1);
    for_each_entry(a, [&](int row, int column) {
      if(first[row] < 0 || m_permutation[column] < m_permutation[first[row]])
        first[row] = column;
    });

    graph.own_begin.assign(m_n + 1, 0);
    for_each_entry(a, [&](int row, int column) {
      if(column != first[row]) {
        ++graph.own_begin[column + 1];
        ++graph.own_begin[first[row] + 1];
      }
    });
    for(int i = 0; i < m_n; ++i)
      graph.own_begin[i + 1] += graph.own_begin[i];

    graph.own_neighbor.resize(graph.own_begin[m_n]);
    std::vector<int> end(graph.own_begin.begin(), graph.own_begin.end() - 1);
    for_each_entry(a, [&](int row, int column) {
      if(column != first[row]) {
        graph.own_neighbor[end[column]++] = first[row];
        graph.own_neighbor[end[first[row]]++] = column;
      }
    });
    graph.begin = graph.own_begin.data();
    graph.neighbor = graph.own_neighbor.data();
  }

  template <class Function>
  static void for_each_entry(const SuperLU_pattern& a, const Function& function)
  {
    for(int column = 0; column < a.size; ++column) {
      for(int k = a.outer[column]; k < a.outer[column + 1]; ++k)
        function(a.inner[k], column);
    }
  }

  std::vector<int> inverse_permutation() const
  {
    std::vector<int> inverse(m_n);
    for(int i = 0; i < m_n; ++i)
      inverse[m_permutation[i]] = i;
    return inverse;
  }

  // Liu's algorithm with compressed paths
  void compute_elimination_tree(const Graph& graph)
  {
    const std::vector<int> column_at = inverse_permutation();
    std::vector<int> ancestor(m_n, m_n);
    m_parent.assign(m_n, m_n);
    for(int j = 0; j < m_n; ++j) {
      const int column = column_at[j];
      for(int k = graph.begin[column]; k < graph.begin[column + 1]; ++k) {
        int i = m_permutation[graph.neighbor[k]];
        while(i < j) {
          const int next = ancestor[i];
          ancestor[i] = j;
          if(next == m_n)
            m_parent[i] = j;
          i = next;
        }
      }
    }
  }

  void compute_subtree_sizes()
  {
    m_size_of_subtree.assign(m_n, 1);
    for(int j = 0; j < m_n; ++j) {
      if(m_parent[j] < m_n)
        m_size_of_subtree[m_parent[j]] += m_size_of_subtree[j];
    }
  }

  // A subtree gets consecutive numbers, its root the last one. The numbers are dealt out from the last one
  // downward, parents before children; so the child that preceded its parent
  // still does, and both can be in one supernode.
  void postorder()
  {
    std::vector<int> post(m_n), last(m_n + 1);
    last[m_n] = m_n - 1;
    for(int j = m_n - 1; j >= 0; --j) {
      post[j] = last[m_parent[j]];
      last[m_parent[j]] -= m_size_of_subtree[j];
      last[j] = post[j] - 1;
    }

    std::vector<int> parent(m_n), size(m_n);
    for(int j = 0; j < m_n; ++j) {
      parent[post[j]] = m_parent[j] == m_n ? m_n : post[m_parent[j]];
      size[post[j]] = m_size_of_subtree[j];
    }
    m_parent.swap(parent);
    m_size_of_subtree.swap(size);
    for(int& position : m_permutation)
      position = post[position];
  }

  // The number of entries of every column of L, by the skeleton algorithm of Gilbert, Ng and Peyton: a row of L
  // is a subtree of the elimination tree, and it suffices to know its leaves and where their paths meet.
  void compute_column_counts(const Graph& graph)
  {
    const std::vector<int> column_at = inverse_permutation();
    std::vector<int> largest_first(m_n, -1), previous_leaf(m_n, -1), ancestor(m_n);
    std::iota(ancestor.begin(), ancestor.end(), 0);
    m_count.assign(m_n, 0);
    for(int j = 0; j < m_n; ++j) {
      const int first_descendant = j - m_size_of_subtree[j] + 1;
      if(first_descendant == j)
        ++m_count[j];
      if(m_parent[j] < m_n)
        --m_count[m_parent[j]];
      const int column = column_at[j];
      for(int k = graph.begin[column]; k < graph.begin[column + 1]; ++k) {
        const int i = m_permutation[graph.neighbor[k]];
        if(i <= j || first_descendant <= largest_first[i])
          continue; // not a leaf of the subtree of row i
        largest_first[i] = first_descendant;
        ++m_count[j];
        if(previous_leaf[i] >= 0)
          --m_count[root_of(previous_leaf[i], ancestor)];
        previous_leaf[i] = j;
      }
      if(m_parent[j] < m_n)
        ancestor[j] = m_parent[j];
    }
    for(int j = 0; j < m_n; ++j) {
      if(m_parent[j] < m_n)
        m_count[m_parent[j]] += m_count[j];
    }
  }

  static int root_of(int i, std::vector<int>& ancestor)
  {
    int root = i;
    while(ancestor[root] != root)
      root = ancestor[root];
    while(ancestor[i] != root && i != root) {
      const int next = ancestor[i];
      ancestor[i] = root;
      i = next;
    }
    return root;
  }

  // SuperLU makes one dense block of a maximal subtree of at most `relax` columns, and further up
  // of columns with nested patterns.
  void estimate_factor_size(int relax, int max_supernode)
  {
    m_factor_size = 0;
    m_subscripts = 0;
    std::size_t width = 0, height = 0;
    for(int j = 0; j < m_n; ++j) {
      if(m_size_of_subtree[j] == 1) {
        int last = j;
        while(m_parent[last] < m_n && m_size_of_subtree[m_parent[last]] <= relax)
          last = m_parent[last];
        width = last - j + 1;
        height = width + m_count[last] - 1;
        m_factor_size += width * height;
        m_subscripts += 2 * height;
        j = last;
      } else {
        const bool extends = m_parent[j - 1] == j && m_count[j] == m_count[j - 1] - 1 &&
                             width < static_cast<std::size_t>(max_supernode);
        width = extends ? width + 1 : 1;
        if(!extends) {
          height = m_count[j];
          m_subscripts += 2 * height;
        }
        m_factor_size += height;
      }
    }
  }

  bool m_symmetric;
  int m_n;
  std::vector<int> m_outer, m_inner; // the pattern
  std::vector<int> m_permutation, m_parent;
  std::vector<int> m_size_of_subtree, m_count; // while it is computed
  std::size_t m_factor_size, m_subscripts;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ANALYSIS_H
