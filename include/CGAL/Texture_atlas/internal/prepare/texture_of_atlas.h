// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TEXTURE_OF_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TEXTURE_OF_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Atlas.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>
#include <CGAL/Texture_atlas/internal/prepare/Surface_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/texture_of_polygons_without_area.h>

namespace CGAL::Texture_atlas::internal::prepare {

// `no_index` without chart
inline Index chart_number(const Atlas& atlas, const Face f)
{
  return atlas.chart[f] < 0 ? no_index : static_cast<Index>(atlas.chart[f]);
}

inline Model_texture texture_of(const Surface_soup& model, const Mesh& mesh, const Corner_origins& origins,
                                const Atlas& atlas)
{
  const auto uv = [&atlas](const Halfedge h) { return atlas.uv[h]; };
  const auto chart = [&atlas](const Face f) { return chart_number(atlas, f); };
  Model_texture texture = model_texture(model, mesh, origins, uv, chart);
  fill_polygons_without_area(model, origins.has_no_area, texture);
  return texture;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TEXTURE_OF_ATLAS_H
