// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Edge_marks.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/model_seams.h>
#include <CGAL/Texture_atlas/internal/prepare/orient_texture.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Seam_way.h>
#include <CGAL/Texture_atlas/internal/prepare/Surface_soup.h>

#include <limits>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Marks the edges where texture coordinates differ. Throws an `Input_error` if there are no coordinates.
inline void keep_seams_of_texture(const Surface_soup& soup, const Prepared_surface& surface,
                                  const Edge_marks& seams)
{
  if(soup.texture.empty()) {
    throw Input_error("the input has no texture coordinates that could be kept");
  }
  const std::vector<bool> is_seam = texture_seams(soup, surface.mesh, surface.origins);
  for(const Edge e : surface.mesh.edges()) {
    seams[e] = seams[e] || is_seam[e.idx()];
  }
}

// Marks the edges where materials differ. Throws an `Input_error` if there are no materials.
inline void keep_seams_of_materials(const Surface_soup& soup, const Prepared_surface& surface,
                                    const Edge_marks& seams)
{
  if(soup.material_names.empty()) {
    throw Input_error("the input has no materials that could divide it into charts");
  }
  const Mesh& mesh = surface.mesh;
  const std::vector<Index> materials = materials_of_faces(soup, mesh, surface.origins);
  for(const Edge e : mesh.edges()) {
    if(!mesh.is_border(e)) {
      const Halfedge h = mesh.halfedge(e);
      seams[e] = seams[e] || materials[mesh.face(h).idx()] != materials[mesh.face(mesh.opposite(h)).idx()];
    }
  }
}

// Marks the seams of the coordinates in the file, and sets `uv(h)` to these for each corner; no numbers where there are
// none. Mirrored charts are turned over. If charts are repaired, there may be no coordinates at all, and charts that
// are mirrored in part are not divided. Otherwise throws an `Input_error` if there are none.
template <class Uv>
Mirrored_charts take_texture(const bool repairs, const Surface_soup& soup, Prepared_surface& surface,
                             const Edge_marks& seams, const Uv& uv)
{
  if(!(soup.texture.empty() && repairs)) {
    keep_seams_of_texture(soup, surface, seams);
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  for(const Halfedge h : surface.mesh.halfedges()) {
    if(!surface.mesh.is_border(h)) {
      const Index t = soup.texture_point(surface.origins.corners[h.idx()]);
      uv(h) = t == no_index ? Kernel::Point_2(none, none) : soup.texture[t];
    }
  }
  return orient_texture(!repairs, surface.mesh, seams, uv);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SEAMS_H
