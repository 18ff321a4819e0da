// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All pairs of triangles that overlap in the plane, by exact predicates. `overlapping_faces.h` reports them to the
// user, `separate_overlaps.h` cuts until there are none, and `minimum_cut.h` makes sheets of them.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_TRIANGLE_PAIRS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_TRIANGLE_PAIRS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

typedef std::pair<int, int> Triangle_pair;

// The pairs of triangles that have more in common in the plane than on the surface: more than a common vertex or edge.
// Triangles without area and those with points that are not finite are left out.
template <typename Point>
class Overlapping_triangles
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel::Triangle_2 Triangle_2;
  typedef CGAL::Box_intersection_d::Box_with_info_d<double, 2, int> Box;

public:
  // `vertex` and `opposite` are those of a chart.
  Overlapping_triangles(const std::vector<int>& vertex, const std::vector<int>& opposite,
                        const std::vector<Point>& uv)
      : m_opposite(opposite), m_uv(uv)
  {
    for(int t = 0; t < static_cast<int>(vertex.size()) / 3; ++t) {
      m_triangles.push_back({vertex[3 * t], vertex[3 * t + 1], vertex[3 * t + 2]});
      const auto& [p, q, r] = m_triangles.back();
      if(!is_finite_point(uv[p]) || !is_finite_point(uv[q]) || !is_finite_point(uv[r]) ||
         CGAL::collinear(uv[p], uv[q], uv[r]))
        continue;
      if(turn(p, q, r) == CGAL::RIGHT_TURN)
        std::swap(m_triangles.back()[1], m_triangles.back()[2]);
      m_boxes.emplace_back(uv[p].bbox() + uv[q].bbox() + uv[r].bbox(), t);
    }
  }

  // Calls `visit(s, t)` for each pair, once, in no particular order.
  template <typename Visit>
  void visit_pairs(const Visit& visit)
  {
    CGAL::box_self_intersection_d(m_boxes.begin(), m_boxes.end(), [&](const Box& a, const Box& b) {
      if(overlap(a.info(), b.info()))
        visit(a.info(), b.info());
    });
  }

  bool overlap(int s, int t) const
  {
    std::array<int, 3> common;
    int count = 0;
    for(int v : m_triangles[s])
      if(has_vertex(t, v))
        common[count++] = v;
    if(count == 0)
      return CGAL::do_intersect(triangle(s), triangle(t));
    if(count == 1)
      return has_ray_in_sector(common[0], s, t) || has_ray_in_sector(common[0], t, s);
    return count == 3 || !are_neighbours(s, t) ||
           turn(common[0], common[1], third_vertex(s, common)) ==
               turn(common[0], common[1], third_vertex(t, common));
  }

private:
  bool has_vertex(int t, int v) const
  {
    return m_triangles[t][0] == v || m_triangles[t][1] == v || m_triangles[t][2] == v;
  }

  Triangle_2 triangle(int t) const
  {
    return Triangle_2(m_uv[m_triangles[t][0]], m_uv[m_triangles[t][1]], m_uv[m_triangles[t][2]]);
  }

  CGAL::Orientation turn(int u, int v, int w) const { return CGAL::orientation(m_uv[u], m_uv[v], m_uv[w]); }

  bool are_neighbours(int s, int t) const
  {
    return std::any_of(m_opposite.begin() + 3 * s, m_opposite.begin() + 3 * s + 3,
                       [t](int c) { return c >= 0 && c / 3 == t; });
  }

  int third_vertex(int t, const std::array<int, 3>& common) const
  {
    const auto is_third = [&](int v) { return v != common[0] && v != common[1]; };
    return *std::find_if(m_triangles[t].begin(), m_triangles[t].end(), is_third);
  }

  // The edges of `s` at its vertex `v`, or one of them, begin in the sector of `t`.
  bool has_ray_in_sector(int v, int s, int t) const
  {
    std::array<int, 3> sector = m_triangles[t];
    std::rotate(sector.begin(), std::find(sector.begin(), sector.end(), v), sector.end());
    return std::any_of(m_triangles[s].begin(), m_triangles[s].end(), [&](int w) {
      return w != v && turn(v, sector[1], w) != CGAL::RIGHT_TURN && turn(v, w, sector[2]) != CGAL::RIGHT_TURN;
    });
  }

  const std::vector<int>& m_opposite;
  const std::vector<Point>& m_uv;
  std::vector<std::array<int, 3>> m_triangles; // their vertices, counterclockwise in the plane
  std::vector<Box> m_boxes;
};

// All pairs, sorted, or some of them if they are more than `limit`
template <typename Point>
std::vector<Triangle_pair> overlapping_pairs(const std::vector<int>& vertex, const std::vector<int>& opposite,
                                             const std::vector<Point>& uv, std::size_t limit)
{
  std::vector<Triangle_pair> pairs;
  Overlapping_triangles<Point>(vertex, opposite, uv).visit_pairs([&](int s, int t) {
    if(pairs.size() < limit)
      pairs.push_back(std::minmax(s, t));
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_TRIANGLE_PAIRS_H
