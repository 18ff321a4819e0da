// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The elimination tree of a symmetric graph (Liu) and the column counts of its factor (Gilbert, Ng and Peyton), without
// factoring. `SuperLU_analysis.h` postorders columns and sizes the factors with it.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ELIMINATION_TREE_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ELIMINATION_TREE_H

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace internal {

// A graph on the columns of a matrix: the neighbors of column i are `neighbor[begin[i]]`, ...,
// `neighbor[begin[i + 1] - 1]`, in any order, possibly including i itself. The graph is symmetric.
struct SuperLU_column_graph
{
  const int* begin;
  const int* neighbor;
};

// The elimination tree of a symmetric graph. Nodes are positions in the order of elimination.
class SuperLU_elimination_tree
{
public:
  // `position[i]` is the position of column i. It is changed to a postorder of the tree, which has the same factor:
  // the nodes of a subtree get consecutive numbers, with the root last, and children still precede their parents.
  SuperLU_elimination_tree(const SuperLU_column_graph& graph, std::vector<int>& position)
      : m_n(static_cast<int>(position.size())), m_graph(graph)
  {
    compute_parents(position);
    compute_subtree_sizes();
    postorder(position);
    compute_column_counts(position);
  }

  // The parent of node j; `size()` if j is a root.
  int parent(int j) const { return m_parent[j]; }

  // The number of nodes in the subtree of node j: these are consecutive, and j is the last one
  int subtree_size(int j) const { return m_size_of_subtree[j]; }

  // The number of entries of column j of the factor, including the diagonal
  int column_count(int j) const { return m_count[j]; }

private:
  static std::vector<int> inverse(const std::vector<int>& position)
  {
    std::vector<int> column_at(position.size());
    for(std::size_t i = 0; i < position.size(); ++i)
      column_at[position[i]] = static_cast<int>(i);
    return column_at;
  }

  // Liu's algorithm with path compression
  void compute_parents(const std::vector<int>& position)
  {
    const std::vector<int> column_at = inverse(position);
    std::vector<int> ancestor(m_n, m_n);
    m_parent.assign(m_n, m_n);
    for(int j = 0; j < m_n; ++j) {
      const int column = column_at[j];
      for(int k = m_graph.begin[column]; k < m_graph.begin[column + 1]; ++k) {
        int i = position[m_graph.neighbor[k]];
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
    for(int j = 0; j < m_n; ++j)
      if(m_parent[j] < m_n)
        m_size_of_subtree[m_parent[j]] += m_size_of_subtree[j];
  }

  // Numbers are assigned in descending order, parents before children.
  void postorder(std::vector<int>& position)
  {
    std::vector<int> post(m_n + 1), last(m_n + 1), parent(m_n), size(m_n);
    post[m_n] = m_n;
    last[m_n] = m_n - 1;
    for(int j = m_n - 1; j >= 0; --j) {
      int& last_of_parent = last[m_parent[j]];
      post[j] = last_of_parent;
      last[j] = last_of_parent - 1;
      last_of_parent -= m_size_of_subtree[j];
      parent[post[j]] = post[m_parent[j]];
      size[post[j]] = m_size_of_subtree[j];
    }
    m_parent.swap(parent);
    m_size_of_subtree.swap(size);
    for(int& p : position)
      p = post[p];
  }

  // By the skeleton algorithm of Gilbert, Ng and Peyton: the pattern of a row of the factor is a subtree of the
  // elimination tree, and is determined by its leaves and the nodes where their paths meet.
  void compute_column_counts(const std::vector<int>& position)
  {
    const std::vector<int> column_at = inverse(position);
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
      for(int k = m_graph.begin[column]; k < m_graph.begin[column + 1]; ++k) {
        const int i = position[m_graph.neighbor[k]];
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
    for(int j = 0; j < m_n; ++j)
      if(m_parent[j] < m_n)
        m_count[m_parent[j]] += m_count[j];
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

  int m_n;
  SuperLU_column_graph m_graph;
  std::vector<int> m_parent, m_size_of_subtree, m_count;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_ELIMINATION_TREE_H
