// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_BLOCK_PRECONDITIONER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_BLOCK_PRECONDITIONER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/symmetric_system.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The inverse of a symmetric matrix of 2x2 blocks without what couples its even unknowns to its odd ones. Of the matrix
// of Eq. 16 these are the multipliers of planarity and those of reconstruction: two weakly coupled Laplacians. Each of
// the two has a quarter of the entries of the whole, and can be factored while the other one is, if there can be two
// solvers; else one solver gets both as one matrix.
template <typename System>
class Block_preconditioner
{
  static constexpr int number_of_systems = Owns_factorization<typename System::Traits>::value ? 2 : 1;

public:
  explicit Block_preconditioner(const typename System::Traits& traits)
  {
    for(int k = 0; k < number_of_systems; ++k)
      m_systems.emplace_back(traits);
  }

  // Factors both diagonal blocks. Returns `false` if that fails.
  bool set_matrix(const Block_matrix<2>& matrix)
  {
    std::array<bool, number_of_systems> done;
    parallel_for(number_of_systems, [&](int k) {
      const int last = number_of_systems == 1 ? 2 : k + 1;
      done[k] = m_systems[k].set_matrix(Diagonal_parts<2>{matrix, k, last});
    });
    return done.front() && done.back();
  }

  bool solve(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    const Eigen::Index n = residual.size() / number_of_systems;
    Eigen::VectorXd sorted(residual.size());
    sorted << every_other(residual, 0), every_other(residual, 1);
    std::array<bool, number_of_systems> done;
    parallel_for(number_of_systems, [&](int k) {
      Eigen::VectorXd solution;
      done[k] = m_systems[k].solve(sorted.segment(k * n, n), solution);
      if(done[k])
        sorted.segment(k * n, n) = solution;
    });
    correction.resize(residual.size());
    every_other(correction, 0) = sorted.head(residual.size() / 2);
    every_other(correction, 1) = sorted.tail(residual.size() / 2);
    return done.front() && done.back();
  }

  // Factorizations of the last matrix that single precision was not enough for
  int repeated_in_double() const
  {
    return static_cast<int>(std::count_if(m_systems.begin(), m_systems.end(), [](const System& system) {
      return system.is_repeated_in_double();
    }));
  }

  // The solver of one of the blocks, whose pattern is that of the one-rings of the interior vertices
  const typename System::Traits& scalar_solver() const { return m_systems.front().traits(); }

private:
  template <typename Vector>
  static auto every_other(Vector& vector, int first)
  {
    return vector(Eigen::seqN(first, vector.size() / 2, 2));
  }

  std::vector<System> m_systems;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_BLOCK_PRECONDITIONER_H
