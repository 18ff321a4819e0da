// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_MARKED_EDGES_H
#define ABF_PYTHON_MARKED_EDGES_H

#include "arrays.h"
#include "models.h"

#include "flatten_mesh/atlas/Atlas_input.h"

#include <CGAL/Texture_atlas/internal/prepare/Edge_marks.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

// Edges, each as its vertices in increasing order
using Vertex_pairs = std::vector<std::pair<Index, Index>>;

inline Vertex_pairs pairs_of(const py::object& rows, const std::size_t number_of_vertices,
                             const std::string& mesh)
{
  Vertex_pairs pairs;
  if(rows.is_none()) {
    return pairs;
  }
  const std::vector<Index> vertices =
      read_indices(rows.cast<py::array>(), number_of_vertices, name_of("marked_seams", mesh), "vertices");
  for(std::size_t i = 0; i < vertices.size(); i += 2) {
    pairs.emplace_back(std::minmax(vertices[i], vertices[i + 1]));
  }
  return pairs;
}

// The source and the target of a halfedge that is in a face, as vertices of the model, in increasing order
inline std::pair<Index, Index> vertices_in_model(const flatten_mesh::Atlas_input& input,
                                                 const flatten_mesh::Halfedge h)
{
  const Index source = input.model.vertices[input.origins.corners[input.mesh.prev(h).idx()]],
              target = input.model.vertices[input.origins.corners[h.idx()]];
  return std::minmax(source, target);
}

// Marks edges as seams. Throws a `value_error` that names the first pair that is no edge of a face.
inline void mark_edges(const Vertex_pairs& pairs, const std::string& mesh, flatten_mesh::Atlas_input& input)
{
  if(pairs.empty()) {
    return;
  }
  const flatten_mesh::Edge_marks is_seam = flatten_mesh::seam_marks(input.mesh),
                                 is_diagonal = flatten_mesh::diagonals(input.mesh);
  std::vector<std::pair<std::pair<Index, Index>, flatten_mesh::Edge>> edges;
  for(const flatten_mesh::Halfedge h : input.mesh.halfedges()) {
    if(!input.mesh.is_border(h) && !is_diagonal[input.mesh.edge(h)]) {
      edges.emplace_back(vertices_in_model(input, h), input.mesh.edge(h));
    }
  }
  const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(edges.begin(), edges.end(), before);
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [begin, end] =
        std::equal_range(edges.begin(), edges.end(), std::pair(pairs[i], flatten_mesh::Edge()), before);
    if(begin == end) {
      throw py::value_error(name_of("marked_seams", mesh) + "[" + std::to_string(i) + "]: vertices " +
                            std::to_string(pairs[i].first) + " and " + std::to_string(pairs[i].second) +
                            " are not the ends of an edge of a face that is flattened");
    }
    for(auto edge = begin; edge != end; ++edge) {
      is_seam[edge->second] = true;
    }
  }
}

} // namespace abf_python

#endif // ABF_PYTHON_MARKED_EDGES_H
