// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The barrier of Smith and Schaefer (2015), which repels parts of the border that come near one another through the
// outside. `injective_descent.h` adds it to the energy of the whole map. It shapes the map; the exact tests of
// `planar_border.h` keep the border simple.
//
// `Border_keeper` is the border policy of `Relaxation` and `Refinement` for injective maps: it adds the barrier to the
// energy of one vertex, and refuses moves and insertions that make the border touch itself. `Local_border` would let
// the border overlap itself.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_BARRIER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_BARRIER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/planar_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The function (range / distance - 1)^2 with derivatives, which is zero from the range on
struct Barrier_function
{
  double value, first_derivative, second_derivative;

  Barrier_function(double range, double distance)
  {
    const double ratio = range / distance, excess = (std::max)(ratio - 1, 0.);
    value = excess * excess;
    first_derivative = -2 * excess * ratio / distance;
    second_derivative = excess > 0 ? 2 * ratio * (3 * ratio - 2) / (distance * distance) : 0;
  }
};

// A border vertex, a border edge without this vertex, and the distance below which they repel each other
struct Border_pair
{
  int vertex, edge;
  double range;
};

// The shortest segment from a vertex to an edge
struct Border_gap
{
  double distance;
  Planar_point direction; // from the edge to the vertex, of unit length
  double parameter;       // of the end on the edge, 0 at its source

  Border_gap(const Planar_point& p, const Planar_point& a, const Planar_point& b)
  {
    const Planar_point ab = b - a;
    const double square = ab.squaredNorm();
    parameter = square > 0 ? (std::min)((std::max)((p - a).dot(ab) / square, 0.), 1.) : 0;
    const Planar_point difference = p - (a + parameter * ab);
    distance = difference.norm();
    direction = distance > 0 ? Planar_point(difference / distance) : Planar_point(Planar_point::Zero());
  }
};

// The barrier of a pair times `weight`, by the positions of the vertex and of both ends of the edge
inline Triangle_derivatives barrier_derivatives(const Border_pair& pair, const Border_gap& gap, double weight)
{
  const Barrier_function barrier(pair.range, gap.distance);
  Triangle_derivatives result;
  result.value = weight * barrier.value;
  result.gradient << gap.direction, (gap.parameter - 1) * gap.direction, -gap.parameter * gap.direction;
  result.hessian = weight * barrier.second_derivative * result.gradient * result.gradient.transpose();
  result.gradient *= weight * barrier.first_derivative;
  return result;
}

// Whether the direction leads from a border vertex to the outside. The interior is on the left of `previous`, `vertex`,
// `next`.
inline bool leads_outside(const Planar_point& direction, const Planar_point& previous,
                          const Planar_point& vertex, const Planar_point& next)
{
  const Planar_point to_next = next - vertex, to_previous = previous - vertex;
  const bool left_of_next = cross(to_next, direction) > 0;
  const bool right_of_previous = cross(direction, to_previous) > 0;
  return cross(to_next, to_previous) > 0 ? !(left_of_next && right_of_previous)
                                         : !(left_of_next || right_of_previous);
}

// The pairs of one border vertex and edges nearby. Where edges are short, they may come nearer to one another.
inline void add_pairs_of_vertex(const Planar_border& border, int i, double clearance,
                                std::vector<Border_pair>& pairs)
{
  const double range = clearance * border.local_length(i);
  const Planar_point p = border.point(i);
  border.for_each_edge_at(Planar_box(p, p).widened(range), [&](int e) {
    if(e != i && border.next(e) != i)
      pairs.push_back({i, e, (std::min)(range, clearance * border.taken_length(e))});
  });
}

// The gap of a pair if it is shorter than its range and leads through the outside: inside, triangles keep parts apart.
// `at(i)` is the position of border vertex i.
template <typename Positions, typename Visitor>
void visit_gap(const Planar_border& border, const Border_pair& pair, const Positions& at,
               const Visitor& visit)
{
  const int i = pair.vertex;
  const Border_gap gap(at(i), at(pair.edge), at(border.next(pair.edge)));
  if(gap.distance < pair.range &&
     leads_outside(-gap.direction, at(border.previous(i)), at(i), at(border.next(i))))
    visit(gap);
}

// The barrier around one border vertex as a function of its position: other vertices and edges repel it and its two
// edges.
class Vertex_barrier
{
public:
  // Ignores parts of the border that are farther away than `reach`.
  void gather(const Planar_border& border, int i, double clearance, double reach)
  {
    m_border = &border;
    m_vertex = i;
    m_pairs.clear();
    const int next = border.next(i), previous = border.previous(i);
    const Planar_box box =
        Planar_box(border.point(previous), border.point(next)) + Planar_box(border.point(i), border.point(i));
    const double range = clearance * border.local_length(i);
    const double next_length = border.taken_length(i), previous_length = border.taken_length(previous);
    border.for_each_edge_at(box.widened(reach), [&](int e) {
      if(e != i && e != previous)
        m_pairs.push_back({i, e, (std::min)(range, clearance * border.taken_length(e))});
      const double local = clearance * border.local_length(e);
      if(e != i && e != next)
        m_pairs.push_back({e, i, (std::min)(local, clearance * next_length)});
      if(e != i && e != previous)
        m_pairs.push_back({e, previous, (std::min)(local, clearance * previous_length)});
    });
  }

  bool empty() const { return m_pairs.empty(); }

  // Adds the barrier, times `weight`, to an energy.
  void add(const Planar_point& x, double weight, Energy_derivatives<2>& energy) const
  {
    const auto at = [&](int i) { return i == m_vertex ? x : m_border->point(i); };
    for(const Border_pair& pair : m_pairs)
      visit_gap(*m_border, pair, at, [&](const Border_gap& gap) {
        const Barrier_function barrier(pair.range, gap.distance);
        energy.value += weight * barrier.value;
        const double share = pair.vertex == m_vertex ? 1
                             : pair.edge == m_vertex ? gap.parameter - 1
                                                     : -gap.parameter;
        const Planar_point direction = share * gap.direction;
        energy.gradient += weight * barrier.first_derivative * direction;
        energy.hessian += weight * barrier.second_derivative * direction * direction.transpose();
      });
  }

private:
  const Planar_border* m_border = nullptr;
  int m_vertex = -1;
  std::vector<Border_pair> m_pairs;
};

// How near parts of a border are to one another
struct Border_contact
{
  double share = 0; // of the length of the border that is nearer to another part than the clearance
  double least_clearance =
      (std::numeric_limits<double>::infinity)(); // in local lengths; only below 1 is looked at
};

inline Border_contact measure_contact(const Planar_border& border, double clearance)
{
  Border_contact result;
  std::vector<char> is_near(border.size(), false);
  std::vector<Border_pair> pairs;
  const auto at = [&](int i) { return border.point(i); };
  for(int i = 0; i < border.size(); ++i) {
    pairs.clear();
    add_pairs_of_vertex(border, i, 1, pairs);
    for(const Border_pair& pair : pairs)
      visit_gap(border, pair, at, [&](const Border_gap& gap) {
        const double relative = gap.distance / pair.range;
        result.least_clearance = (std::min)(result.least_clearance, relative);
        if(relative < clearance)
          is_near[pair.edge] = is_near[i] = is_near[border.previous(i)] = true;
      });
  }
  double length = 0, length_of_contact = 0;
  for(int i = 0; i < border.size(); ++i) {
    length += border.edge_length(i);
    length_of_contact += is_near[i] ? border.edge_length(i) : 0;
  }
  result.share = length > 0 ? length_of_contact / length : 0;
  return result;
}

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

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_BARRIER_H
