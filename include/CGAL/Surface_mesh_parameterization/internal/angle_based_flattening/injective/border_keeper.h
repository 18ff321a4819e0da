// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The border policy of `Relaxation` and `Refinement` for injective maps: a move or insertion that makes the border
// touch itself is refused. `flatten_injectively.h` uses it in place of `Local_border`, which lets the border overlap
// itself.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_KEEPER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_KEEPER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/planar_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation_stars.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A star whose vertex is repelled by other parts of the border
template <typename Star>
struct Repelled_star
{
  static constexpr double over_relaxation = 1; // the barrier is steep

  const Star& star;
  const Vertex_barrier& barrier;

  struct Energy : Star::Energy
  {
    Energy(const Repelled_star& repelled, const Planar_point& x, bool with_derivatives)
        : Star::Energy(repelled.star, x, with_derivatives)
    {
      repelled.barrier.add(x, repelled.star.barrier_weight(), *this);
    }
  };
};

// Keeps the border of a map simple while its vertices are inserted and moved.
class Border_keeper
{
public:
  explicit Border_keeper(double clearance) : m_clearance(clearance) {}

  int rejections() const { return m_rejections; }
  Border_contact contact() const { return measure_contact(m_border, m_clearance); }

  // Takes the current border vertices, and all positions.
  void take(const Coarsening& coarsening, const std::vector<Planar_point>& uv)
  {
    m_border.set(coarsening.borders(), uv);
  }

  bool touches_at(int v) const { return m_border.touches_at(m_border.number(v)); }

  bool has_moved(int v, const Planar_point&, const Planar_point& now) { return try_to_move(v, now); }

  // Relaxes a vertex, on the border with a barrier around it. Returns `false` if it does not move.
  template <typename Star>
  bool relax(const Star& star, int v, Planar_point& position)
  {
    if(!star.on_border)
      return relax_vertex_repeatedly(star, position, [](const Planar_point&) { return true; }) < 1;
    const int i = m_border.number(v);
    m_barrier.gather(m_border, i, m_clearance, m_clearance * m_border.local_length(i));
    const auto accept = [&](const Planar_point& x) { return try_to_move(v, x); };
    if(m_barrier.empty())
      return relax_vertex_repeatedly(star, position, accept) < 1;
    return relax_vertex_repeatedly(Repelled_star<Star>{star, m_barrier}, position, accept) < 1;
  }

private:
  // Moves a vertex on the border to `x` if its edges touch nothing there. Returns whether it did.
  bool try_to_move(int v, const Planar_point& x)
  {
    const int i = m_border.number(v);
    const Planar_point before = m_border.point(i);
    m_border.move(i, x);
    if(!m_border.touches_at(i))
      return true;
    m_border.move(i, before);
    ++m_rejections;
    return false;
  }

  double m_clearance;
  Planar_border m_border;
  Vertex_barrier m_barrier;
  int m_rejections = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_KEEPER_H
