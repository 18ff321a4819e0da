// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_ORIENT_TEXTURE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_ORIENT_TEXTURE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Seam_way.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Turns mirrored charts over. Models of games often show one half of the texture on both sides, one of them mirrored:
// where the orientation changes, a seam is added if `adds_seams`, but not within polygons. Charts of both orientations
// stay as they are. `uv(h)` is a reference; a map without numbers has no orientation.
template <class Uv>
Mirrored_charts orient_texture(const bool adds_seams, Mesh& mesh, const Edge_marks& seams, const Uv& uv)
{
  std::vector<double> area(mesh.number_of_faces()); // its sign is the orientation
  for(const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Kernel::Point_2 p = uv(h), q = uv(mesh.next(h)), r = uv(mesh.prev(h));
    area[f.idx()] = (q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y());
  }
  Mirrored_charts result;
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : mesh.edges()) {
    if(adds_seams && !mesh.is_border(e) && !seams[e] && !is_diagonal[e]) {
      const Halfedge h = mesh.halfedge(e);
      const double first = area[mesh.face(h).idx()], second = area[mesh.face(mesh.opposite(h)).idx()];
      seams[e] = (first < 0 && second > 0) || (first > 0 && second < 0);
      result.new_seam_edges += seams[e];
    }
  }
  auto chart = mesh.add_property_map<Face, std::size_t>().first;
  const std::size_t charts =
      Polygon_mesh_processing::connected_components(mesh, chart, parameters::edge_is_constrained_map(seams));
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 2>> range(charts, {infinity, -infinity}); // of u
  std::vector<bool> is_mirrored(charts, false), is_upright(charts, false);
  for(const Face f : mesh.faces()) {
    const std::size_t c = chart[f];
    is_mirrored[c] = is_mirrored[c] || area[f.idx()] < 0;
    is_upright[c] = is_upright[c] || area[f.idx()] > 0;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      range[c] = {(std::min)(range[c][0], uv(h).x()), (std::max)(range[c][1], uv(h).x())};
    }
  }
  for(const Face f : mesh.faces()) {
    const std::size_t c = chart[f];
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      if(is_mirrored[c] && !is_upright[c]) {
        uv(h) = Kernel::Point_2(range[c][0] + (range[c][1] - uv(h).x()), uv(h).y());
      }
    }
  }
  for(std::size_t c = 0; c < charts; ++c) {
    result.number += is_mirrored[c] && !is_upright[c];
  }
  mesh.remove_property_map(chart);
  return result;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_ORIENT_TEXTURE_H
