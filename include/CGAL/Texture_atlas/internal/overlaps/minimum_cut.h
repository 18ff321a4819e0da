// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The two sheets of an overlap, which are sets of triangles that lie over each other, and the cheapest seam between
// them, as a minimum cut of the dual graph. `separate_overlaps.h` makes one such cut after the other. The paper splits
// its charts by Sheffer and Hart (2002) instead.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/triangle_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/maximum_flow.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// No sheet, or one of the two that lie over each other
enum class Sheet : char
{
  NONE,
  FIRST,
  SECOND
};

// Finds sheets of a piece: two connected sets of triangles, of which each triangle of one overlaps one of the other.
//
// A layer is a triangle together with one that it overlaps. Layers are next to each other if one of the two triangles
// is the same, and the others are neighbours: so does a point pass on that moves within the overlap. The layers that
// hang together give two sheets, unless they wind around so far that a triangle is in both.
class Sheet_finder
{
  typedef std::vector<int> Layers;

public:
  // `block` has the same number for triangles that are always in the same sheet.
  Sheet_finder(const Chart& piece, const std::vector<Triangle_pair>& pairs, const std::vector<int>& block)
      : m_piece(piece), m_block(block), m_first_layer(piece.number_of_triangles() + 1, 0),
        m_sheet(block.size(), Sheet::NONE)
  {
    for(const auto& [s, t] : pairs) {
      ++m_first_layer[s + 1];
      ++m_first_layer[t + 1];
    }
    for(std::size_t t = 1; t < m_first_layer.size(); ++t)
      m_first_layer[t] += m_first_layer[t - 1];
    m_upper.resize(2 * pairs.size());
    m_lower.resize(2 * pairs.size());
    std::vector<int> next(m_first_layer.begin(), m_first_layer.end() - 1);
    const auto add = [&](int lower, int upper) {
      m_lower[next[lower]] = lower;
      m_upper[next[lower]++] = upper;
    };
    for(const auto& [s, t] : pairs)
      add(t, s); // sorted, because pairs are, and come first as all of these are less than t
    for(const auto& [s, t] : pairs)
      add(s, t);
    m_visited.resize(m_lower.size(), false);
  }

  // The sheet of each triangle: of the largest overlap that has two, or else a part of the largest one
  std::vector<Sheet> find()
  {
    Layers largest;
    bool has_sheets = false;
    for(int layer = 0; layer < static_cast<int>(m_lower.size()); ++layer) {
      if(m_visited[layer])
        continue;
      Layers layers = connected_layers(layer);
      for(int l : layers)
        m_visited[mirrored(l)] = true;
      const bool are_apart = have_sheets(layers);
      if(std::make_pair(are_apart, layers.size()) > std::make_pair(has_sheets, largest.size())) {
        largest = std::move(layers);
        has_sheets = are_apart;
      }
    }
    if(has_sheets)
      for(int l : largest)
        put_on_sheets(l);
    else
      grow_sheets(largest[largest.size() / 2]);
    std::vector<Sheet> result;
    for(int block : m_block)
      result.push_back(m_sheet[block]);
    return result;
  }

private:
  // -1 if the triangles do not overlap
  int layer(int lower, int upper) const
  {
    const auto begin = m_upper.begin() + m_first_layer[lower],
               end = m_upper.begin() + m_first_layer[lower + 1];
    const auto found = std::lower_bound(begin, end, upper);
    return found != end && *found == upper ? static_cast<int>(found - m_upper.begin()) : -1;
  }

  int mirrored(int l) const { return layer(m_upper[l], m_lower[l]); }

  template <typename Visit>
  void visit_neighbours(int l, const Visit& visit) const
  {
    const auto visit_if = [&](int lower, int upper) {
      if(const int other = layer(lower, upper); other >= 0)
        visit(other);
    };
    for(int k = 0; k < 3; ++k) {
      if(const int across = m_piece.opposite[3 * m_lower[l] + k]; across >= 0)
        visit_if(across / 3, m_upper[l]);
      if(const int across = m_piece.opposite[3 * m_upper[l] + k]; across >= 0)
        visit_if(m_lower[l], across / 3);
    }
  }

  Layers connected_layers(int start)
  {
    Layers layers{start};
    m_visited[start] = true;
    for(std::size_t i = 0; i < layers.size(); ++i)
      visit_neighbours(layers[i], [&](int l) {
        if(!m_visited[l]) {
          m_visited[l] = true;
          layers.push_back(l);
        }
      });
    return layers;
  }

  Sheet& sheet(int triangle) { return m_sheet[m_block[triangle]]; }

  // Returns whether that is possible, and if not changes nothing.
  bool put_on_sheets(int l)
  {
    Sheet &lower = sheet(m_lower[l]), &upper = sheet(m_upper[l]);
    if(&lower == &upper || lower == Sheet::SECOND || upper == Sheet::FIRST)
      return false;
    lower = Sheet::FIRST;
    upper = Sheet::SECOND;
    return true;
  }

  bool have_sheets(const Layers& layers)
  {
    const bool result = std::all_of(layers.begin(), layers.end(), [&](int l) { return put_on_sheets(l); });
    for(int l : layers)
      sheet(m_lower[l]) = sheet(m_upper[l]) = Sheet::NONE;
    return result;
  }

  // As far as they stay apart
  void grow_sheets(int start)
  {
    std::vector<char> is_in(m_lower.size(), false);
    Layers layers;
    const auto add = [&](int l) {
      if(!is_in[l] && put_on_sheets(l)) {
        is_in[l] = true;
        layers.push_back(l);
      }
    };
    add(start);
    for(std::size_t i = 0; i < layers.size(); ++i)
      visit_neighbours(layers[i], add);
  }

  const Chart& m_piece;
  const std::vector<int>& m_block;
  std::vector<int> m_first_layer;    // of each triangle as the lower one
  std::vector<int> m_lower, m_upper; // of each layer, sorted
  std::vector<char> m_visited;
  std::vector<Sheet> m_sheet; // of each block
};

// The cheapest cut of a piece between two sheets, as a maximum flow on its dual graph. Each sheet is one node, and so
// is each block of triangles that must not be separated.
class Minimum_cut
{
public:
  Minimum_cut(const Piece& piece, const std::vector<Sheet>& sheet, const std::vector<int>& block)
      : m_piece(piece)
  {
    number_nodes(sheet, block);
    find_maximum_flow();
  }

  // Whether a triangle is on the side of the first sheet
  bool is_on_first_side(int triangle) const { return m_on_first_side[m_node[triangle]]; }

private:
  void number_nodes(const std::vector<Sheet>& sheet, const std::vector<int>& block)
  {
    std::vector<int> node_of_block(block.size(), -1);
    for(std::size_t t = 0; t < block.size(); ++t) {
      int& node = node_of_block[block[t]];
      if(node < 0)
        node = sheet[t] == Sheet::FIRST    ? static_cast<int>(Flow_network::SOURCE)
               : sheet[t] == Sheet::SECOND ? static_cast<int>(Flow_network::SINK)
                                           : m_network.number_of_nodes++;
      m_node.push_back(node);
    }
  }

  // A corner that faces an edge between two nodes is an edge of the dual graph, from its triangle to the other one.
  void find_maximum_flow()
  {
    const std::vector<int>& opposite = m_piece.chart.opposite;
    const auto node = [&](int corner) { return m_node[corner / 3]; };
    std::vector<int> corners;
    for(int c = 0; c < static_cast<int>(opposite.size()); ++c)
      if(opposite[c] >= 0 && node(c) != node(opposite[c]))
        corners.push_back(c);
    std::stable_sort(corners.begin(), corners.end(), [&](int c, int d) { return node(c) < node(d); });

    std::vector<int> rank(opposite.size(), -1);
    for(int c : corners) {
      rank[c] = static_cast<int>(m_network.edges.size());
      m_network.edges.emplace_back(node(c), node(opposite[c]));
      m_network.capacity.push_back(m_piece.cost[c]);
    }
    for(int c : corners)
      m_network.reverse.push_back(rank[opposite[c]]);
    m_on_first_side = maximum_flow(m_network).is_reached;
  }

  const Piece& m_piece;
  Flow_network m_network;
  std::vector<int> m_node; // of each triangle
  std::vector<char> m_on_first_side;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H
