// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the vertices of Eq. 16 where planarity and reconstruction are strongly coupled: slivers and steep cones, with
// their neighbours. `near_preconditioner.h` solves the whole matrix near these.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_COUPLED_BLOCKS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_COUPLED_BLOCKS_H

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

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_COUPLED_BLOCKS_H
