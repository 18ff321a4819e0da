// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_TEXTURE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_TEXTURE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Surface_soup.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// New texture coordinates for a model.
struct Model_texture
{
  std::vector<Kernel::Point_2> uv; // of each corner; NaN where there are none
  std::vector<Index> charts;   // of each polygon: the chart that it is in, or `no_index`; empty: one chart
  bool is_second_set = false;  // after the coordinates of the model, which are then written as well
  std::vector<bool> is_turned; // of each polygon: to be written with its corners in reverse order
  std::vector<std::array<double, 4>> tangents; // of each corner, as in glTF, or empty
  std::string normal_picture, color_picture;   // PNG files that fit the coordinates, or empty
  std::vector<Model_triangle> triangles; // into which the polygons are divided where a format asks for it

  bool has_uv(const Index corner) const { return std::isfinite(uv[corner].x()); }

  bool has_pictures() const { return !normal_picture.empty() || !color_picture.empty(); }

  Index chart(const Index polygon) const { return charts.empty() ? 0 : charts[polygon]; }
};

// The first of two sets. Where a corner of the model has none, they are 0 in glTF.
inline Kernel::Point_2 first_of_two_uv(const Surface_soup& model, const Index corner)
{
  const Index point = model.texture_point(corner);
  return point == no_index || !std::isfinite(model.texture[point].x()) ||
                 !std::isfinite(model.texture[point].y())
             ? Kernel::Point_2(0, 1)
             : model.texture[point];
}

// Adds the triangles of the polygons that no face of the mesh is in. Polygons with a coordinate that is no number
// have none.
inline void add_left_out_triangles(const Surface_soup& model, Model_texture& texture)
{
  std::vector<bool> is_in_mesh(model.number_of_polygons(), false);
  for(const Model_triangle& triangle : texture.triangles) {
    is_in_mesh[triangle.polygon] = true;
  }
  const auto is_finite = [&model](const Index c) {
    const Kernel::Point_3& point = model.points[model.vertices[c]];
    return std::isfinite(point.x()) && std::isfinite(point.y()) && std::isfinite(point.z());
  };
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    const Index first = model.first_corners[p], end = model.first_corners[p + 1];
    bool is_left_out = !is_in_mesh[p];
    for(Index c = first; c < end && is_left_out; ++c) {
      is_left_out = is_finite(c);
    }
    for(Index c = first + 2; c < end && is_left_out; ++c) {
      texture.triangles.push_back({p, {first, c - 1, c}});
    }
  }
}

// Corners that repeat the vertex before get its coordinates.
inline void fill_repetitions(const Surface_soup& model, Model_texture& texture)
{
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    const Index first = model.first_corners[p], size = model.size(p);
    for(Index i = 1; texture.charts[p] != no_index && i < 2 * size; ++i) {
      const Index c = first + i % size, before = first + (i - 1) % size;
      if(!texture.has_uv(c) && model.vertices[c] == model.vertices[before]) {
        texture.uv[c] = texture.uv[before];
      }
    }
  }
}

// A texture without any coordinates, for the polygons of a mesh and those that were left out of it.
inline Model_texture empty_texture(const Surface_soup& model, const Mesh& mesh, const Corner_origins& origins)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  Model_texture texture;
  texture.uv.assign(model.number_of_corners(), {none, none});
  texture.is_turned = origins.is_turned;
  texture.triangles.reserve(mesh.number_of_faces());
  for(const Face f : mesh.faces()) {
    texture.triangles.push_back(origins.triangle(model, mesh, f));
  }
  add_left_out_triangles(model, texture);
  return texture;
}

// The texture of a model from an atlas of the mesh that was made of it: `uv(h)` is that of the halfedge's target in
// its face, `chart(f)` the number of the face's chart, and `no_index` for a face without. All triangles of a polygon
// have to agree at its corners: see `torn_polygons()`.
template <class Uv, class Chart_number>
Model_texture model_texture(const Surface_soup& model, const Mesh& mesh, const Corner_origins& origins,
                            const Uv& uv, const Chart_number& chart)
{
  Model_texture texture = empty_texture(model, mesh, origins);
  texture.charts.assign(model.number_of_polygons(), no_index);
  for(const Face f : mesh.faces()) {
    const Index number = chart(f);
    if(number != no_index) {
      texture.charts[model.polygon_of_corner(origins.corners[mesh.halfedge(f).idx()])] = number;
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        texture.uv[origins.corners[h.idx()]] = uv(h);
      }
    }
  }
  fill_repetitions(model, texture);
  return texture;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MODEL_TEXTURE_H
