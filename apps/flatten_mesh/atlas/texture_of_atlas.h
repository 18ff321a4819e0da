// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXTURE_OF_ATLAS_H
#define FLATTEN_MESH_TEXTURE_OF_ATLAS_H

#include "flatten_mesh/atlas/Atlas.h"
#include "flatten_mesh/model/Corner_origins.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Model_texture.h"
#include "flatten_mesh/model/texture_of_polygons_without_area.h"

namespace flatten_mesh {

// `no_index` without chart
inline Index chart_number(const Atlas& atlas, const Face f)
{
  return atlas.chart[f] < 0 ? no_index : static_cast<Index>(atlas.chart[f]);
}

inline Model_texture texture_of(const Model& model, const Mesh& mesh, const Corner_origins& origins,
                                const Atlas& atlas)
{
  const auto uv = [&atlas](const Halfedge h) { return atlas.uv[h]; };
  const auto chart = [&atlas](const Face f) { return chart_number(atlas, f); };
  Model_texture texture = model_texture(model, mesh, origins, uv, chart);
  fill_polygons_without_area(model, origins.has_no_area, texture);
  return texture;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXTURE_OF_ATLAS_H
