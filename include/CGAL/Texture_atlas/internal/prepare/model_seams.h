// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Surface_soup.h>

#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Of each edge: whether the texture coordinates in the file differ on its two sides. Borders and diagonals of polygons
// are none.
inline std::vector<bool> texture_seams(const Surface_soup& model, const Mesh& mesh,
                                       const Corner_origins& origins)
{
  const auto is_same = [&model](const Index c, const Index d) {
    const Index s = model.texture_point(c), t = model.texture_point(d);
    return s == t || (s != no_index && t != no_index && model.texture[s] == model.texture[t]);
  };
  std::vector<bool> seams(mesh.number_of_edges(), false);
  for(const Edge e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e), o = mesh.opposite(h);
    if(!mesh.is_border(e)) {
      seams[e.idx()] = !is_same(origins.corners[h.idx()], origins.corners[mesh.prev(o).idx()]) ||
                       !is_same(origins.corners[o.idx()], origins.corners[mesh.prev(h).idx()]);
    }
  }
  return seams;
}

// Of each face: the number of its material in the file, or `no_index`
inline std::vector<Index> materials_of_faces(const Surface_soup& model, const Mesh& mesh,
                                             const Corner_origins& origins)
{
  std::vector<Index> materials(mesh.number_of_faces(), no_index);
  for(const Face f : mesh.faces()) {
    materials[f.idx()] = model.material(model.polygon_of_corner(origins.corners[mesh.halfedge(f).idx()]));
  }
  return materials;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_SEAMS_H
