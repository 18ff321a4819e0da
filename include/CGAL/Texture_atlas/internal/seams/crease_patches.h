// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface in patches between creases, and plane layouts of the patches that unfold without stretch.
// `crease_division_impl.h` joins them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_PATCHES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_PATCHES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/patch_layouts.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Origin.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

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
  // The place of each corner in the layout of its patch. Meaningless if the patch does not unfold.
  std::vector<Corner_table::Point_2> layout;
};

// Finds the patches between creases, and lays them out. A crease is an edge whose faces differ by more than `angle`;
// edges of infinite cost are none.
class Crease_patch_finder
{
  typedef Corner_table::Point_2 Point_2;
  typedef Corner_table::Kernel::Vector_3 Vector_3;

public:
  Crease_patch_finder(const Chart& surface, const std::vector<double>& cost, double angle)
      : m_surface(surface), m_cost(cost), m_cosine(std::cos(angle))
  {}

  Crease_patches run()
  {
    find_normals();
    find_patches();
    m_result.layout.assign(m_surface.vertex.size(), CGAL::ORIGIN);
    Patch_unfolding unfolding(m_surface, m_result.patch, m_result.layout);
    for(Crease_patch& patch : m_result.patches) {
      patch.is_flat = project(patch.triangles);
      patch.unfolds = patch.is_flat || unfolding.run(patch.triangles, patch.area);
      patch.joins = patch.unfolds && !(patch.is_flat && has_holes(patch));
    }
    absorb_scraps();
    return std::move(m_result);
  }

private:
  static constexpr double largest_scrap = 5e-3; // of the area
  static constexpr double least_height =
      1e-4; // of triangles that are no needles, relative to their longest sides

  // The direction of a needle is mostly rounding: it takes the normal across its longest side.
  void find_normals()
  {
    std::vector<int> needles; // the corners that face their longest sides
    for(int t = 0; t < m_surface.number_of_triangles(); ++t) {
      const Vector_3 normal = triangle_normal(m_surface, t);
      const double length = std::sqrt(normal.squared_length());
      int longest = 3 * t;
      for(int c : {3 * t + 1, 3 * t + 2})
        longest = edge_length(m_surface, c) > edge_length(m_surface, longest) ? c : longest;
      const double side = edge_length(m_surface, longest);
      const bool is_needle = !(length > least_height * side * side);
      m_normal.push_back(is_needle ? CGAL::NULL_VECTOR : normal / length);
      if(is_needle)
        needles.push_back(longest);
    }
    // twice, because needles come in pairs
    for(int round = 0; round < 2; ++round)
      for(int c : needles)
        if(m_normal[c / 3] == CGAL::NULL_VECTOR && m_surface.opposite[c] >= 0)
          m_normal[c / 3] = m_normal[m_surface.opposite[c] / 3];
  }

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

  bool is_inside(int c) const { return is_within_patch(m_surface, m_result.patch, c); }

  // Scraps are small bent disks beside a patch that does not unfold: rough places of its shape. They become parts of
  // the patch that they share the longest border with.
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
  Crease_patches m_result;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_PATCHES_H
