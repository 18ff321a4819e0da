// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The surface data of all stars of a level, kept in one place for several sweeps of relaxation (Section 5.2) over that
// level. `refine.h` and `flatten_injectively.h` call `relax_level()`, so that several sweeps gather these data once.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_KEPT_RINGS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_KEPT_RINGS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation_stars.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What the stars of the interior vertices of a level need of the surface, side by side in memory, for several sweeps
// over the level. Single precision is enough for the weights of an energy, and takes half of the memory.
class Kept_rings
{
public:
  // A triangle (v, p, q) of a `MIPS_star`; q is the p of the triangle before it.
  struct Triangle
  {
    int p;
    float dot_v, dot_p, dot_q;
  };

  struct Ring
  {
    const Triangle *first = nullptr, *last = nullptr;

    const Triangle* begin() const { return first; }
    const Triangle* end() const { return last; }
  };

  Kept_rings(const Edge_collapses& mesh, const std::vector<int>& vertices)
      : m_blocks(vertices.size() / block_size + 1), m_rings(mesh.chart().points.size())
  {
    parallel_for_blocks(static_cast<int>(vertices.size()), [&](int begin, int end) {
      std::vector<Triangle>& block = m_blocks[begin / block_size];
      block.reserve(7 * block_size); // a ring has about six
      std::vector<std::size_t> first;
      for(int i = begin; i < end; ++i) {
        first.push_back(block.size());
        if(mesh.chart().interior[vertices[i]] >= 0)
          append(mesh, vertices[i], block);
      }
      first.push_back(block.size());
      for(int i = begin; i < end; ++i)
        m_rings[vertices[i]] = {block.data() + first[i - begin], block.data() + first[i - begin + 1]};
    });
  }

  // That of a vertex at the border is empty.
  const Ring& ring(int v) const { return m_rings[v]; }

private:
  static void append(const Edge_collapses& mesh, int v, std::vector<Triangle>& block)
  {
    Surface_edges e(mesh.chart(), v);
    for_each_ring_triangle(mesh, v, [&](int c, int p, int q) {
      e.turn(p, q);
      const double weight = mesh.chart().weight_of_triangle(c / 3);
      block.push_back({p, static_cast<float>(weight * e.dot_v()), static_cast<float>(weight * e.dot_p()),
                       static_cast<float>(weight * e.dot_q())});
    });
  }

  std::vector<std::vector<Triangle>> m_blocks;
  std::vector<Ring> m_rings; // of each vertex of the chart
};

// A star whose ring was kept
struct Kept_MIPS_star : MIPS_star
{
  const Kept_rings& rings;

  explicit Kept_MIPS_star(const Kept_rings& of_all) : rings(of_all) {}

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    const Kept_rings::Ring& ring = rings.ring(v);
    if(ring.first == ring.last)
      return MIPS_star::gather(mesh, uv, v);
    triangles.clear();
    begin_ring(v, false);
    int q = ring.last[-1].p;
    for(const Kept_rings::Triangle& t : ring) {
      take_ring_edge(uv, t.p, q);
      triangles.push_back({uv[t.p], uv[q], t.dot_v, t.dot_p, t.dot_q});
      q = t.p;
    }
  }
};

// Sweeps over what is left of a chart, as similar to the surface as possible
template <typename Relaxation>
void relax_level(const Coarsening& coarsening, Relaxation& relaxation, int sweeps)
{
  if(sweeps == 1)
    return relaxation.sweep(MIPS_star());
  if(sweeps == 0)
    return;
  const Kept_rings rings(coarsening.mesh(), coarsening.alive());
  for(int i = 0; i < sweeps; ++i)
    relaxation.sweep(Kept_MIPS_star(rings));
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_KEPT_RINGS_H
