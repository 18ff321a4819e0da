// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Gradient and Hessian of a sum of energies of three vertices each, assembled by blocks for Newton's method on
// positions. `injective_descent.h` sums triangles and border pairs in it, each without its negative eigenvalues: the
// sum is semidefinite.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_DEFINITE_HESSIAN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_DEFINITE_HESSIAN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/small_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Of an energy by the positions of three vertices
struct Triangle_derivatives
{
  Eigen::Matrix<double, 6, 1> gradient;
  Eigen::Matrix<double, 6, 6> hessian; // without negative eigenvalues
};

// The gradient and the projected Hessian of a sum of energies of three vertices each, by the positions of all vertices.
// The three need not be a triangle: parts of the border that repel each other are coupled too.
class Definite_hessian
{
  typedef Block_matrix<2>::Block Block;

  struct Entry
  {
    int row;
    Block block;
  };

public:
  explicit Definite_hessian(const Chart& chart)
      : m_columns(chart.points.size()), m_gradient(Eigen::VectorXd::Zero(2 * chart.points.size()))
  {}

  void add(const int* vertices, const Triangle_derivatives& derivatives)
  {
    for(int k = 0; k < 3; ++k) {
      const auto& [gradient, hessian] = derivatives;
      add_to_block({{gradient[2 * k], gradient[2 * k + 1]}}, vertices[k], m_gradient);
      for(int l = 0; l < 3; ++l)
        add(m_columns[vertices[k]], vertices[l],
            {{hessian(2 * l, 2 * k), hessian(2 * l + 1, 2 * k), hessian(2 * l, 2 * k + 1),
              hessian(2 * l + 1, 2 * k + 1)}});
    }
  }

  const Eigen::VectorXd& gradient() const { return m_gradient; }

  Block_matrix<2> matrix() const
  {
    Block_matrix<2> result;
    std::vector<Entry> column;
    for(std::size_t v = 0; v < m_columns.size(); ++v) {
      column = m_columns[v];
      std::sort(column.begin(), column.end(), [](const Entry& e, const Entry& f) { return e.row < f.row; });
      for(const Entry& entry : column) {
        result.row.push_back(entry.row);
        result.block.push_back(entry.block);
      }
      result.begin.push_back(static_cast<int>(result.row.size()));
    }
    return result;
  }

private:
  static void add(std::vector<Entry>& column, int row, const Block& block)
  {
    for(Entry& entry : column)
      if(entry.row == row) {
        entry.block += block;
        return;
      }
    column.push_back({row, block});
  }

  std::vector<std::vector<Entry>> m_columns;
  Eigen::VectorXd m_gradient;
};

// Adds a fraction of the diagonal to a matrix.
inline Block_matrix<2> damped(Block_matrix<2> matrix, double fraction)
{
  for(int v = 0; v < matrix.columns_of_blocks(); ++v)
    for(int e = matrix.begin[v]; e < matrix.begin[v + 1]; ++e)
      if(matrix.row[e] == v) {
        Block_matrix<2>::Block& block = matrix.block[e];
        const double damping = fraction * (block(0, 0) + block(1, 1));
        block(0, 0) += damping;
        block(1, 1) += damping;
      }
  return matrix;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_DEFINITE_HESSIAN_H
