// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_REFINE_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_REFINE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/insert_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/relax_vertex.h>

#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Puts back the vertices that collapses removed, level by level, and relaxes what is there (Section 5.2).
class Refinement
{
public:
  Refinement(Coarsening& coarsening, std::vector<Planar_point>& uv, Hierarchical_report& report)
      : m_coarsening(coarsening), m_uv(uv), m_report(report)
  {}

  // Undoes all levels, with `sweeps` of relaxation on each. Returns `false` if a vertex has no place in its star.
  bool run(int sweeps)
  {
    relax(sweeps);
    while(m_coarsening.number_of_levels() > 0) {
      if(!insert(m_coarsening.undo_level()))
        return false;
      relax(sweeps);
    }
    return true;
  }

private:
  bool insert(const std::vector<Edge_collapses::Record>& records)
  {
    for(Edge_collapses::Record record : records) {
      const int v = m_coarsening.mesh().removed_vertex(record);
      m_star.gather(m_coarsening.mesh(), m_uv, v);
      const Insertion insertion = insert_vertex(m_star, m_uv[v]);
      if(insertion == NOT_INSERTED)
        return false;
      m_report.kernel_insertions += insertion == INSERTED_IN_KERNEL;
    }
    return true;
  }

  void relax(int sweeps)
  {
    for(int i = 0; i < sweeps; ++i)
      for(int v : m_coarsening.alive()) {
        m_star.gather(m_coarsening.mesh(), m_uv, v);
        if(relax_vertex(m_star, m_uv[v]))
          ++m_report.moves;
        else
          ++m_report.rejected_moves;
      }
  }

  Coarsening& m_coarsening;
  std::vector<Planar_point>& m_uv;
  Hierarchical_report& m_report;
  Planar_star m_star;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_REFINE_H
