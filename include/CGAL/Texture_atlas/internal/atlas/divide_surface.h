// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Divides a surface into regions around triangles that are far apart, for surfaces that no single disk flattens well.
// Called by `divided_part_atlas.h`, which makes the atlas of each region.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDE_SURFACE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDE_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Texture_atlas/internal/overlaps/minimum_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/centroid.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Divides a connected surface that cannot be flattened well into regions that can: some triangles, far apart, are
// seeds, and a region contains the triangles that are nearest to its seed. Distances run from triangle to triangle.
// Edges that must not become seams do not separate regions.
class Surface_division
{
public:
  // `cost` is that of the edge that each corner faces.
  Surface_division(const Chart& surface, const std::vector<double>& cost) : m_surface(surface), m_cost(cost)
  {
    for(int t = 0; t < surface.number_of_triangles(); ++t)
      m_center.push_back(CGAL::centroid(point(3 * t), point(3 * t + 1), point(3 * t + 2)));
  }

  // Returns the region of each triangle, from 0 on. There are as many as asked for if so many triangles have area.
  std::vector<int> run(int number_of_regions)
  {
    int seed = 0;
    spread(seed, 0);
    seed = farthest_triangle();
    m_distance.clear();
    for(int region = 0; region < number_of_regions && seed >= 0; ++region) {
      spread(seed, region);
      seed = farthest_triangle();
    }
    unite_blocks();
    return connected_regions();
  }

private:
  const Chart::Point_3& point(int c) const { return m_surface.points[m_surface.vertex[c]]; }

  double length_across(int c) const
  {
    return std::isinf(m_cost[c])
               ? 0
               : std::sqrt(CGAL::squared_distance(m_center[c / 3], m_center[m_surface.opposite[c] / 3]));
  }

  // Gives the region all triangles that are nearer to its seed than to all earlier seeds.
  void spread(int seed, int region)
  {
    typedef std::pair<double, int> Entry; // distance, triangle
    m_distance.resize(m_center.size(), std::numeric_limits<double>::infinity());
    m_region.resize(m_center.size(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](int t, double distance) {
      if(distance < m_distance[t]) {
        m_distance[t] = distance;
        m_region[t] = region;
        queue.emplace(distance, t);
      }
    };
    reach(seed, 0);
    while(!queue.empty()) {
      Deadline::ask();
      const auto [distance, t] = queue.top();
      queue.pop();
      if(distance > m_distance[t])
        continue;
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(m_surface.opposite[c] >= 0)
          reach(m_surface.opposite[c] / 3, distance + length_across(c));
    }
  }

  // The triangle farthest from all seeds; -1 if no other triangle has an area. A triangle without area cannot be
  // flattened alone.
  int farthest_triangle() const
  {
    int farthest = -1;
    for(int t = 0; t < m_surface.number_of_triangles(); ++t)
      if(m_distance[t] > (farthest < 0 ? 0 : m_distance[farthest]) && surface_area(m_surface, t) > 0)
        farthest = t;
    return farthest;
  }

  // Equal distances could divide connected triangles.
  void unite_blocks()
  {
    const auto is_block = [this](int c) { return std::isinf(m_cost[c]); };
    const std::vector<int> block = connected_triangles(m_surface, is_block);
    std::vector<int> region_of_block(block.size(), -1);
    for(std::size_t t = 0; t < block.size(); ++t) {
      int& region = region_of_block[block[t]];
      region = region < 0 ? m_region[t] : region;
      m_region[t] = region;
    }
  }

  std::vector<int> connected_regions() const
  {
    return connected_triangles(
        m_surface, [this](int c) { return m_region[c / 3] == m_region[m_surface.opposite[c] / 3]; });
  }

  const Chart& m_surface;
  const std::vector<double>& m_cost;
  std::vector<Chart::Point_3> m_center; // of each triangle
  std::vector<double> m_distance;
  std::vector<int> m_region;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_DIVIDE_SURFACE_H
