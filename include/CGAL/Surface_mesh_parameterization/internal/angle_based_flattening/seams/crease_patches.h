// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface in patches between creases, and plane layouts of the patches that unfold without stretch.
// `merge_patches.h` joins them.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_CREASE_PATCHES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_CREASE_PATCHES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/flat_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/crease_normals.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A length in a layout may be wrong by this part of the square root of the area.
inline constexpr double layout_tolerance = 2e-3;

// Triangles between creases
struct Crease_patch
{
  std::vector<int> triangles;
  double area = 0;
  bool is_flat = false;
  bool unfolds = false; // without stretch, as laid out
  bool joins = false;   // others: it unfolds, and is no flat patch with holes, which would be cut otherwise
};

struct Crease_patches
{
  std::vector<Crease_patch> patches;
  std::vector<int> patch; // of each triangle
  // Of each corner, in the layout of its patch. Meaningless if the patch does not unfold.
  std::vector<Corner_table::Point_2> layout;
};

// Finds the patches between creases, and lays them out. A crease is an edge whose faces differ by more than `angle`;
// edges of infinite cost are none.
class Crease_patch_finder
{
  typedef Corner_table::Point_2 Point_2;
  typedef Corner_table::Kernel::Vector_2 Vector_2;
  typedef Corner_table::Kernel::Vector_3 Vector_3;

public:
  Crease_patch_finder(const Chart& surface, const std::vector<double>& cost, double angle)
      : m_surface(surface), m_cost(cost), m_cosine(std::cos(angle)), m_normal(crease_normals(surface)),
        m_is_laid_out(surface.number_of_triangles(), false)
  {}

  Crease_patches run()
  {
    find_patches();
    m_result.layout.assign(m_surface.vertex.size(), CGAL::ORIGIN);
    for(Crease_patch& patch : m_result.patches) {
      patch.is_flat = project(patch.triangles);
      patch.unfolds = patch.is_flat || unfold(patch);
      patch.joins = patch.unfolds && !(patch.is_flat && has_holes(patch));
    }
    absorb_scraps();
    return std::move(m_result);
  }

private:
  static constexpr double largest_scrap = 5e-3; // of the area

  bool is_crease(int c) const
  {
    const Vector_3 &n = m_normal[c / 3], &m = m_normal[m_surface.opposite[c] / 3];
    return std::isfinite(m_cost[c]) && n != CGAL::NULL_VECTOR && m != CGAL::NULL_VECTOR && n * m < m_cosine;
  }

  void find_patches()
  {
    const int n = m_surface.number_of_triangles();
    Disjoint_sets sets(static_cast<std::size_t>(n));
    for(int c = 0; c < m_surface.number_of_corners(); ++c)
      if(m_surface.opposite[c] > c && !is_crease(c))
        sets.union_set(c / 3, m_surface.opposite[c] / 3);
    std::vector<int> number(n, -1);
    for(int t = 0; t < n; ++t) {
      int& i = number[sets.find_set(t)];
      if(i < 0) {
        i = static_cast<int>(m_result.patches.size());
        m_result.patches.emplace_back();
      }
      m_result.patch.push_back(i);
      m_result.patches[i].triangles.push_back(t);
      m_result.patches[i].area += surface_area(m_surface, t);
    }
  }

  // Returns whether the triangles are flat, and lays them out then.
  bool project(const std::vector<int>& triangles)
  {
    const Flat_layout layout(m_surface, triangles);
    for(int t : triangles)
      for(int c = 3 * t; c < 3 * t + 3 && layout.is_flat(); ++c)
        m_result.layout[c] = layout(m_surface.points[m_surface.vertex[c]]);
    return layout.is_flat();
  }

  // Lays a patch out triangle by triangle, across long edges first. Returns whether all triangles fit together.
  bool unfold(const Crease_patch& patch)
  {
    typedef std::pair<double, int> Entry; // length of an edge, and the corner that faces it from outside
    std::priority_queue<Entry> queue;
    const auto add = [&](int t) {
      m_is_laid_out[t] = true;
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(is_inside(c))
          queue.emplace(edge_length(m_surface, c), m_surface.opposite[c]);
    };
    const auto is_smaller = [&](int s, int t) {
      return surface_area(m_surface, s) < surface_area(m_surface, t);
    };
    const int first = *std::max_element(patch.triangles.begin(), patch.triangles.end(), is_smaller);
    m_result.layout[3 * first] = Point_2(0, 0);
    m_result.layout[3 * first + 1] = Point_2(edge_length(m_surface, 3 * first + 2), 0);
    place(3 * first + 2);
    add(first);
    while(!queue.empty()) {
      const int c = queue.top().second, across = m_surface.opposite[c];
      queue.pop();
      if(m_is_laid_out[c / 3])
        continue;
      m_result.layout[next_corner(c)] = m_result.layout[previous_corner(across)];
      m_result.layout[previous_corner(c)] = m_result.layout[next_corner(across)];
      place(c);
      add(c / 3);
    }
    return fits_together(patch);
  }

  // By Euler's characteristic
  bool has_holes(const Crease_patch& patch) const
  {
    std::vector<int> vertices;
    int sides = 0; // of edges, two of each
    for(int t : patch.triangles)
      for(int c = 3 * t; c < 3 * t + 3; ++c) {
        vertices.push_back(m_surface.vertex[c]);
        sides += is_inside(c) ? 1 : 2;
      }
    std::sort(vertices.begin(), vertices.end());
    const auto end = std::unique(vertices.begin(), vertices.end());
    return (end - vertices.begin()) - sides / 2 + static_cast<int>(patch.triangles.size()) < 1;
  }

  bool is_inside(int c) const
  {
    const int across = m_surface.opposite[c];
    return across >= 0 && m_result.patch[across / 3] == m_result.patch[c / 3];
  }

  // Places a corner on the left of the edge that it faces.
  void place(int c)
  {
    const auto point = [&](int corner) { return m_surface.points[m_surface.vertex[corner]]; };
    const Vector_3 side = point(previous_corner(c)) - point(next_corner(c)),
                   v = point(c) - point(next_corner(c));
    const Point_2& p = m_result.layout[next_corner(c)];
    const Vector_2 e = m_result.layout[previous_corner(c)] - p;
    const double square = side.squared_length();
    const double along = square > 0 ? v * side / square : 0,
                 across = square > 0 ? std::sqrt(CGAL::cross_product(side, v).squared_length()) / square : 0;
    m_result.layout[c] = p + along * e + across * Vector_2(-e.y(), e.x());
  }

  bool fits_together(const Crease_patch& patch) const
  {
    const double square = layout_tolerance * layout_tolerance * patch.area;
    for(int t : patch.triangles)
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(is_inside(c) &&
           CGAL::squared_distance(m_result.layout[next_corner(c)],
                                  m_result.layout[previous_corner(m_surface.opposite[c])]) > square)
          return false;
    return true;
  }

  // Scraps are small bent disks beside a patch that does not unfold: rough places of its shape. They become parts of the
  // patch that they share the longest border with.
  void absorb_scraps()
  {
    double area = 0;
    for(const Crease_patch& patch : m_result.patches)
      area += patch.area;
    const auto is_scrap = [&](const Crease_patch& patch) {
      return patch.unfolds && patch.area < largest_scrap * area &&
             !(patch.is_flat && patch.triangles.size() > 1);
    };
    std::map<int, std::map<int, double>> borders; // of scraps: their lengths beside each patch
    for(int c = 0; c < m_surface.number_of_corners(); ++c)
      if(const int across = m_surface.opposite[c]; across >= 0) {
        const int here = m_result.patch[c / 3], there = m_result.patch[across / 3];
        if(is_scrap(m_result.patches[here]) && !m_result.patches[there].unfolds)
          borders[here][there] += edge_length(m_surface, c);
      }
    for(const auto& [scrap, lengths] : borders) {
      const auto is_shorter = [](const auto& p, const auto& q) { return p.second < q.second; };
      absorb(scrap, std::max_element(lengths.begin(), lengths.end(), is_shorter)->first);
    }
  }

  void absorb(int scrap, int patch)
  {
    Crease_patch& whole = m_result.patches[patch];
    for(int t : m_result.patches[scrap].triangles) {
      m_result.patch[t] = patch;
      whole.triangles.push_back(t);
    }
    whole.area += m_result.patches[scrap].area;
    m_result.patches[scrap] = Crease_patch();
  }

  const Chart& m_surface;
  const std::vector<double>& m_cost;
  double m_cosine;
  std::vector<Vector_3> m_normal; // of each triangle; zero if it has none
  std::vector<char> m_is_laid_out;
  Crease_patches m_result;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_CREASE_PATCHES_H
