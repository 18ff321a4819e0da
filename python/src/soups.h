// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_PYTHON_SOUPS_H
#define ABF_PYTHON_SOUPS_H

#include "arrays.h"

#include <CGAL/Texture_atlas/Surface_soup.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

using CGAL::Texture_atlas::Surface_soup;
using Index = Surface_soup::Index;
using Kernel = Surface_soup::Kernel;

// Edges, each as its vertices
using Vertex_pairs = std::vector<std::pair<Index, Index>>;

inline std::string name_of(const std::string& array, const std::string& mesh)
{
  return mesh.empty() ? array : array + " of " + mesh;
}

namespace internal {

inline void read_faces(const abf_mesh& given, const std::string& mesh, Surface_soup& soup)
{
  if(static_cast<std::uint64_t>(given.indices.shape[0] * given.indices.shape[1]) >= Surface_soup::none) {
    throw Wrong_value(name_of("faces", mesh) + " has more than 4294967294 corners");
  }
  soup.vertices = read_indices(given.indices, soup.points.size(), name_of("faces", mesh), "vertices");
  if(!is_given(given.offsets)) {
    for(Index c = 3; c <= soup.vertices.size(); c += 3) {
      soup.first_corners.push_back(c);
    }
    return;
  }
  soup.first_corners = read_indices(given.offsets, soup.vertices.size() + 1, name_of("offsets", mesh),
                                    "indices, and one more may be an offset");
  for(std::size_t p = 1; p < soup.first_corners.size(); ++p) {
    if(soup.first_corners[p] < soup.first_corners[p - 1]) {
      throw Wrong_value(name_of("offsets", mesh) + "[" + std::to_string(p) + "] is less than the one before");
    }
  }
  if(soup.first_corners.front() != 0 || soup.first_corners.back() != soup.vertices.size()) {
    throw Wrong_value(name_of("offsets", mesh) + " must begin with 0 and end with the number of indices");
  }
}

inline void read_texture(const abf_array& uv, Surface_soup& soup)
{
  soup.texture = read_points<Kernel::Point_2, 2>(uv);
  soup.corner_texture.resize(soup.texture.size());
  for(Index c = 0; c < soup.corner_texture.size(); ++c) {
    const Kernel::Point_2& p = soup.texture[c];
    soup.corner_texture[c] = std::isfinite(p.x()) && std::isfinite(p.y()) ? c : Surface_soup::none;
  }
}

} // namespace internal

inline Surface_soup soup_of(const abf_mesh& given, const std::string& mesh)
{
  Surface_soup soup;
  soup.name = mesh;
  soup.points = read_points<Kernel::Point_3, 3>(given.vertices);
  internal::read_faces(given, mesh, soup);
  if(is_given(given.uv)) {
    internal::read_texture(given.uv, soup);
  }
  const Elements<bool> is_ignored(given.ignored_faces);
  for(std::int64_t p = 0; is_given(given.ignored_faces) && p < given.ignored_faces.shape[0]; ++p) {
    soup.is_ignored.push_back(is_ignored(p));
  }
  if(is_given(given.marked_seams)) {
    const std::vector<Index> vertices =
        read_indices(given.marked_seams, soup.points.size(), name_of("marked_seams", mesh), "vertices");
    for(std::size_t i = 0; i < vertices.size(); i += 2) {
      soup.marked_seams.emplace_back(vertices[i], vertices[i + 1]);
    }
  }
  return soup;
}

} // namespace abf_python

#endif // ABF_PYTHON_SOUPS_H
