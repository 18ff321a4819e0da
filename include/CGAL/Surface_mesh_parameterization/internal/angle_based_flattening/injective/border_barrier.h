// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The barrier of Smith and Schaefer (2015), which repels parts of the border that come near one another through the
// outside. `injective_descent.h` adds it to the energy of the whole map, `border_keeper.h` to that of one vertex. It
// shapes the map; the exact tests of `planar_border.h` keep the border simple.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_BARRIER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_BARRIER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/box_tree.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/planar_border.h>

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

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BORDER_BARRIER_H
