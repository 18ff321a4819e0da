// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes seams away that separate tiny regions from larger ones. `mirror_seams.h` calls it: where mirror images of seams
// run beside other seams, slivers are between them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_JOIN_SMALL_REGIONS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_JOIN_SMALL_REGIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL::Texture_atlas::internal {

class Region_joining
{
  typedef std::array<std::size_t, 2> Pair;

public:
  Region_joining(const Triangle_arrays& mesh, const Edge_graph& graph)
      : m_graph(graph), m_faces(graph.ends.size(), {none, none})
  {
    for(std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      m_area.push_back(std::sqrt(mesh.normal(mesh.triangles[t]).squared_length()));
      for(std::size_t i = 0; i < 3; ++i) {
        Pair& faces = m_faces[graph.edge_between(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])];
        faces[faces[0] == none ? 0 : 1] = t;
      }
    }
  }

  // Joins regions with less than this share of the area to the neighbors with which they have the longest borders.
  void run(double share, std::vector<char>& is_seam) const
  {
    const double least = share * std::accumulate(m_area.begin(), m_area.end(), 0.);
    for(int round = 0; round < most_rounds && join_some(least, is_seam); ++round)
      ;
  }

private:
  // Each region changes once at most.
  bool join_some(double least, std::vector<char>& is_seam) const
  {
    Disjoint_sets regions(m_area.size());
    for(std::size_t e = 0; e < is_seam.size(); ++e)
      if(!is_seam[e] && m_faces[e][1] != none)
        regions.union_set(m_faces[e][0], m_faces[e][1]);
    std::vector<double> area(m_area.size(), 0);
    for(std::size_t t = 0; t < m_area.size(); ++t)
      area[regions.find_set(t)] += m_area[t];
    std::map<Pair, double> border; // of a small region and a neighbor
    const auto for_borders = [&](const auto& f) {
      for(std::size_t e = 0; e < is_seam.size(); ++e)
        if(is_seam[e] && m_faces[e][1] != none) {
          const std::size_t a = regions.find_set(m_faces[e][0]), b = regions.find_set(m_faces[e][1]);
          if(a != b)
            f(e, a, b);
        }
    };
    for_borders([&](std::size_t e, std::size_t a, std::size_t b) {
      if(area[a] < least)
        border[{a, b}] += m_graph.length(e);
      if(area[b] < least)
        border[{b, a}] += m_graph.length(e);
    });
    const std::vector<std::size_t> partner = partners(border, area);
    bool any = false;
    for_borders([&](std::size_t e, std::size_t a, std::size_t b) {
      if(partner[a] == b) {
        is_seam[e] = false;
        any = true;
      }
    });
    return any;
  }

  // What each region joins, if anything: the smallest regions choose first.
  static std::vector<std::size_t> partners(const std::map<Pair, double>& border,
                                           const std::vector<double>& area)
  {
    std::vector<std::array<double, 2>> keys;
    std::vector<Pair> pairs;
    for(const auto& [pair, length] : border) {
      keys.push_back({area[pair[0]], -length});
      pairs.push_back(pair);
    }
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return keys[i] < keys[j]; });
    std::vector<std::size_t> partner(area.size(), none);
    for(std::size_t i : order) {
      const auto [a, b] = pairs[i];
      if(partner[a] == none && partner[b] == none) {
        partner[a] = b;
        partner[b] = a;
      }
    }
    return partner;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr int most_rounds = 10;

  const Edge_graph& m_graph;
  std::vector<Pair> m_faces;  // at each edge
  std::vector<double> m_area; // of each triangle, twice
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_JOIN_SMALL_REGIONS_H
