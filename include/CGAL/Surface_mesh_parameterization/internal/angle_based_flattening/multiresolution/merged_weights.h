// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The importance of faces on a coarse chart: each triangle has the mean of what was merged into its vertices.
// `coarse_to_fine.h` and `flatten_injectively.h` apply it, so that the coarse map already favours what the user
// marked.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_MERGED_WEIGHTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_MERGED_WEIGHTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The weights of triangles after collapses. Each vertex owns a third of the area of each triangle around it, and brings
// that along where it is merged into another. The weight of a coarse triangle is the mean of what its vertices own
// then.
class Merged_weights
{
public:
  // `chart` is the one before all collapses.
  explicit Merged_weights(const Chart& chart)
  {
    if(chart.weight.empty())
      return;
    m_owned.resize(chart.points.size());
    for(int c = 0; c < chart.number_of_corners(); ++c) {
      // Degenerate triangles count a little, so that there is something to take the mean of.
      const double area = surface_area(chart, c / 3) + 1e-30;
      m_owned[chart.vertex[c]] += {area, area * chart.weight[c / 3]};
    }
  }

  // Sets the weights of a coarse chart, which is what is left.
  void apply(const Coarsening& coarsening, Coarse_chart& coarse) const
  {
    if(m_owned.empty())
      return;
    const std::vector<Owned> owned = coarsening.merged(m_owned);
    Chart& chart = coarse.chart;
    chart.weight.assign(chart.number_of_triangles(), 0.);
    for(int c = 0; c < chart.number_of_corners(); ++c)
      chart.weight[c / 3] += owned[coarse.vertices[chart.vertex[c]]].mean() / 3;
  }

private:
  struct Owned
  {
    double area = 0, weighted_area = 0;

    Owned& operator+=(const Owned& other)
    {
      area += other.area;
      weighted_area += other.weighted_area;
      return *this;
    }

    double mean() const { return weighted_area / area; }
  };

  std::vector<Owned> m_owned; // by each vertex; empty if there are no weights
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_MERGED_WEIGHTS_H
