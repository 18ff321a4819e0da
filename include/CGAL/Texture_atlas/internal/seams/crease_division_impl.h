// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The body of `divide_at_creases()`: finds the patches between creases, and joins those that unfold side by side in the
// plane, as the faces of a cube to a cross. `crease_division.h` includes it, or the source file of the compiled
// library.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/patch_layouts.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/crease_division.h>
#include <CGAL/Texture_atlas/internal/seams/crease_patches.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Joins patches along chains of edges that are equal in both layouts, the longest chains first, as long as the union
// does not overlap itself and is compact.
class Patch_merger
{
  typedef Corner_table::Point_2 Point_2;
  typedef std::vector<Point_2> Polygon;

public:
  Patch_merger(const Chart& surface, Crease_patches patches)
      : m_surface(surface), m_patches(std::move(patches.patches)), m_patch(std::move(patches.patch)),
        m_layout(std::move(patches.layout)), m_hull(m_patches.size())
  {
    for(std::size_t i = 0; i < m_patches.size(); ++i) {
      m_total_area += m_patches[i].area;
      if(m_patches[i].joins)
        m_hull[i] = hull(corners(m_patches[i].triangles));
    }
  }

  // Returns whether the edge that each corner faces lies between parts.
  std::vector<char> run()
  {
    std::vector<char> is_seam(m_surface.vertex.size(), false);
    for(int c = 0; c < m_surface.number_of_corners(); ++c)
      is_seam[c] = is_between(c);
    std::vector<Chain> chains = find_chains(), waiting;
    for(bool is_changed = true; is_changed; chains.swap(waiting)) {
      waiting.clear();
      for(Chain& chain : chains)
        if(!merge(chain))
          waiting.push_back(std::move(chain));
      is_changed = waiting.size() < chains.size();
    }
    for(std::size_t c = 0; c < is_seam.size(); ++c)
      is_seam[c] = is_seam[c] && !fits_together(static_cast<int>(c));
    return is_seam;
  }

private:
  static constexpr double least_share_of_hull = 0.6;
  static constexpr double least_chain = 0.5;      // of the square root of the smaller area
  static constexpr double longest_diameter = 1.2; // of the square root of the whole area, unless
  static constexpr double roundest_union = 0.29;  // the area is at least so many squares of the diameter
  static constexpr double largest_overlap = 2e-3; // of the smaller area

  // Edges between two patches that hang together
  struct Chain
  {
    std::vector<int> corners; // that face the edges, from one of the patches
    double length = 0;
  };

  bool is_between(int c) const
  {
    return m_surface.opposite[c] >= 0 && m_patch[c / 3] != m_patch[m_surface.opposite[c] / 3];
  }

  // The longest ones first
  std::vector<Chain> find_chains() const
  {
    std::vector<int> edges; // a corner of each, in the patch with the lower number
    for(int c = 0; c < m_surface.number_of_corners(); ++c)
      if(is_between(c) && m_patch[c / 3] < m_patch[m_surface.opposite[c] / 3])
        edges.push_back(c);
    std::vector<std::vector<int>> edges_at(m_surface.points.size());
    for(std::size_t i = 0; i < edges.size(); ++i)
      for(int v : {m_surface.edge_source(edges[i]), m_surface.edge_target(edges[i])})
        edges_at[v].push_back(static_cast<int>(i));
    Disjoint_sets sets(edges.size());
    for(const std::vector<int>& at : edges_at)
      if(at.size() == 2) // two patches meet here, and no third one
        sets.union_set(at[0], at[1]);
    std::vector<int> number(edges.size(), -1);
    std::vector<Chain> chains;
    for(std::size_t i = 0; i < edges.size(); ++i) {
      int& chain = number[sets.find_set(i)];
      if(chain < 0) {
        chain = static_cast<int>(chains.size());
        chains.emplace_back();
      }
      chains[chain].corners.push_back(edges[i]);
      chains[chain].length += edge_length(m_surface, edges[i]);
    }
    std::stable_sort(chains.begin(), chains.end(),
                     [](const Chain& c, const Chain& d) { return c.length > d.length; });
    return chains;
  }

  // Returns whether the patches on both sides of a chain are joined now.
  bool merge(const Chain& chain)
  {
    int moving = m_patch[chain.corners.front() / 3],
        resting = m_patch[m_surface.opposite[chain.corners.front()] / 3];
    if(moving == resting || !m_patches[moving].joins || !m_patches[resting].joins)
      return false;
    if(m_patches[moving].triangles.size() > m_patches[resting].triangles.size())
      std::swap(moving, resting);
    if(chain.length < least_chain * std::sqrt((std::min)(m_patches[moving].area, m_patches[resting].area)))
      return false;
    std::vector<Point_2> from, to;
    for(int c : chain.corners) {
      const int d = m_surface.opposite[c], mine = m_patch[c / 3] == moving ? c : d, other = mine == c ? d : c;
      from.insert(from.end(), {m_layout[next_corner(mine)], m_layout[previous_corner(mine)]});
      to.insert(to.end(), {m_layout[previous_corner(other)], m_layout[next_corner(other)]});
    }
    const Planar_motion motion(from, to);
    for(std::size_t i = 0; i < from.size(); ++i)
      if(!are_near(motion(from[i]), to[i], chain.length))
        return false;
    Polygon points = m_hull[resting];
    for(const Point_2& p : m_hull[moving])
      points.push_back(motion(p));
    const Polygon joint_hull = hull(points);
    if(!is_compact(moving, resting, joint_hull) || overlap(moving, resting, motion))
      return false;
    join(moving, resting, motion);
    m_hull[resting] = joint_hull;
    return true;
  }

  static bool are_near(const Point_2& p, const Point_2& q, double length)
  {
    return CGAL::squared_distance(p, q) <= layout_tolerance * layout_tolerance * length * length;
  }

  void join(int moving, int resting, const Planar_motion& motion)
  {
    for(int t : m_patches[moving].triangles) {
      m_patch[t] = resting;
      m_patches[resting].triangles.push_back(t);
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        m_layout[c] = motion(m_layout[c]);
    }
    m_patches[resting].area += m_patches[moving].area;
    m_patches[moving] = Crease_patch();
  }

  Polygon corners(const std::vector<int>& triangles) const
  {
    Polygon points;
    for(int t : triangles)
      points.insert(points.end(), m_layout.begin() + 3 * t, m_layout.begin() + 3 * t + 3);
    return points;
  }

  static Polygon hull(const Polygon& points)
  {
    Polygon result;
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(result));
    return result;
  }

  double share_of_hull(double area, const Polygon& hull) const
  {
    return area / CGAL::polygon_area_2(hull.begin(), hull.end(), Corner_table::Kernel());
  }

  // A union that is long, or leaves much of its hull empty, would be hard to pack.
  bool is_compact(int moving, int resting, const Polygon& joint_hull) const
  {
    const double a = m_patches[moving].area, b = m_patches[resting].area;
    double square = 0; // of the diameter
    for(const Point_2& p : joint_hull)
      for(const Point_2& q : joint_hull)
        square = (std::max)(square, CGAL::squared_distance(p, q));
    if(square > longest_diameter * longest_diameter * m_total_area && a + b < roundest_union * square)
      return false;
    return share_of_hull(a + b, joint_hull) >=
           (std::min)(
               {least_share_of_hull, share_of_hull(a, m_hull[moving]), share_of_hull(b, m_hull[resting])});
  }

  bool overlap(int moving, int resting, const Planar_motion& motion) const
  {
    CGAL::Bbox_2 box;
    for(const Point_2& p : m_hull[moving])
      box += motion(p).bbox();
    const double area = (std::min)(m_patches[moving].area, m_patches[resting].area),
                 size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    Covered_cells cells(box, (std::max)(std::sqrt(area) / 64, size / 512));
    for(int t : m_patches[resting].triangles)
      cells.cover({m_layout[3 * t], m_layout[3 * t + 1], m_layout[3 * t + 2]}, 1);
    for(int t : m_patches[moving].triangles)
      cells.cover({motion(m_layout[3 * t]), motion(m_layout[3 * t + 1]), motion(m_layout[3 * t + 2])}, 2);
    return cells.common_area(1 | 2) > largest_overlap * area;
  }

  // Whether both sides of an edge are one line in the layout of a part
  bool fits_together(int c) const
  {
    const int d = m_surface.opposite[c];
    if(is_between(c))
      return false;
    const double length = std::sqrt(m_patches[m_patch[c / 3]].area);
    return are_near(m_layout[next_corner(c)], m_layout[previous_corner(d)], length) &&
           are_near(m_layout[previous_corner(c)], m_layout[next_corner(d)], length);
  }

  const Chart& m_surface;
  std::vector<Crease_patch> m_patches;
  std::vector<int> m_patch; // of each triangle
  std::vector<Point_2> m_layout;
  std::vector<Polygon> m_hull; // of each patch that joins others
  double m_total_area = 0;
};

// The sum of what the angles lack or exceed 2 pi at vertices within patches
inline double curvature_within(const std::vector<int>& patch, const Chart& surface)
{
  std::vector<double> missing(surface.points.size(), 2 * pi);
  std::vector<char> is_within(surface.points.size(), true);
  for(int c = 0; c < surface.number_of_corners(); ++c) {
    missing[surface.vertex[c]] -= surface_angle(surface, c);
    if(!is_within_patch(surface, patch, c))
      is_within[surface.edge_source(c)] = is_within[surface.edge_target(c)] = false;
  }
  double result = 0;
  for(std::size_t v = 0; v < missing.size(); ++v)
    result += is_within[v] ? std::abs(missing[v]) : 0;
  return result;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Crease_division divide_at_creases(const Chart& surface,
                                                                     const std::vector<double>& cost,
                                                                     double angle)
{
  Crease_patches patches = Crease_patch_finder(surface, cost, angle).run();
  Crease_division result;
  result.number_of_patches = static_cast<std::size_t>(
      std::count_if(patches.patches.begin(), patches.patches.end(),
                    [](const Crease_patch& patch) { return !patch.triangles.empty(); }));
  for(const Crease_patch& patch : patches.patches) {
    result.area += patch.area;
    result.flat_area +=
        result.number_of_patches > 1 && patch.is_flat && patch.triangles.size() > 1 ? patch.area : 0;
  }
  result.curvature = curvature_within(patches.patch, surface);
  result.is_seam = Patch_merger(surface, std::move(patches)).run();
  return result;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_IMPL_H
