// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_TEXTURED_ATLAS_H
#define PICTURES_TEXTURED_ATLAS_H

#include "pictures/Textured_surface.h"
#include "pictures/seam_chains.h"

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pictures {

using namespace CGAL::Texture_atlas::internal::prepare;

// Whether the chart of a halfedge's face ends there
inline bool is_chart_border(const Mesh& mesh, const Atlas& atlas, const Halfedge h)
{
  return mesh.is_border(mesh.edge(h)) || atlas.seams[mesh.edge(h)];
}

namespace internal {

// The next halfedge along the border of a chart
inline Halfedge next_on_chart_border(const Mesh& mesh, const Atlas& atlas, Halfedge h)
{
  h = mesh.next(h);
  while(!is_chart_border(mesh, atlas, h)) {
    h = mesh.next(mesh.opposite(h));
  }
  return h;
}

} // namespace internal

// All triangles of a mesh, or only those in charts. Their halfedges begin with the one that the mesh gives for the face.
inline Textured_surface textured_atlas(const Mesh& mesh, const Atlas& atlas, const bool has_all = true)
{
  Textured_surface surface;
  surface.points.assign(mesh.points().begin(), mesh.points().end());
  std::vector<std::uint8_t> corner(mesh.number_of_halfedges(), 0); // at the source of each halfedge
  std::vector<Textured_surface::Index> number(mesh.number_of_faces());
  for(const Face f : mesh.faces()) {
    number[f.idx()] = static_cast<Textured_surface::Index>(surface.triangles.size());
    if(atlas.chart[f] < 0 && !has_all) {
      continue;
    }
    surface.triangles.emplace_back();
    surface.uv.emplace_back();
    surface.charts.push_back(atlas.chart[f]);
    Halfedge h = mesh.halfedge(f);
    for(std::uint8_t i = 0; i < 3; ++i, h = mesh.next(h)) {
      corner[h.idx()] = i;
      surface.triangles.back()[i] = mesh.source(h).idx();
      surface.uv.back()[i] = atlas.uv[mesh.prev(h)];
    }
  }
  const std::vector<int> seams = seam_chains(mesh, atlas.seams);
  std::vector<bool> is_done(mesh.number_of_halfedges(), false);
  for(const Halfedge start : mesh.halfedges()) {
    if(mesh.is_border(start) || is_done[start.idx()] || !is_chart_border(mesh, atlas, start) ||
       atlas.chart[mesh.face(start)] < 0) {
      continue;
    }
    surface.borders.push_back({atlas.chart[mesh.face(start)], {}});
    for(Halfedge h = start; !is_done[h.idx()]; h = internal::next_on_chart_border(mesh, atlas, h)) {
      is_done[h.idx()] = true;
      surface.borders.back().sides.push_back(
          {number[mesh.face(h).idx()], corner[h.idx()], seams[mesh.edge(h).idx()]});
    }
  }
  return surface;
}

// In the plane of a map to unit squares with that many texels along their sides
inline void make_texels_squares(const int width, const int height, Textured_surface& surface)
{
  for(std::array<Kernel::Point_2, 3>& corners : surface.uv) {
    for(Kernel::Point_2& p : corners) {
      p = Kernel::Point_2(p.x(), p.y() * height / width);
    }
  }
}

} // namespace pictures

#endif // PICTURES_TEXTURED_ATLAS_H
