// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_DRAW_MESH_H
#define PICTURES_DRAW_MESH_H

#include "pictures/Canvas.h"
#include "pictures/Surface_view.h"
#include "pictures/draw_checkerboard.h"
#include "pictures/Textured_surface.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Origin.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <cstddef>
#include <vector>

namespace pictures {

inline Kernel::Vector_3 doubled_area_vector(const Mesh& mesh, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  const Kernel::Point_3& p = mesh.point(mesh.source(h));
  return CGAL::cross_product(mesh.point(mesh.target(h)) - p, mesh.point(mesh.target(mesh.next(h))) - p);
}

// The projection of a surface into a frame: a corner for each vertex, without values.
class Projected_surface
{
public:
  Projected_surface(const Mesh& mesh, const std::vector<Face>& faces, const Surface_view& view,
                    const Frame& frame)
      : m_corners(mesh.number_of_vertices(), Canvas::Corner{0, 0, 0, {}})
  {
    CGAL::Bbox_2 box;
    for_each_corner(mesh, faces, [&](const Vertex v) {
      const auto p = view(mesh.point(v) - CGAL::ORIGIN);
      box += CGAL::Bbox_2(p.x(), p.y(), p.x(), p.y());
    });
    const Projection projection(view, box, frame);
    for_each_corner(mesh, faces, [&](const Vertex v) { m_corners[v.idx()] = projection(mesh.point(v)); });
  }

  Canvas::Corner& operator[](const Vertex v) { return m_corners[v.idx()]; }

  const Canvas::Corner& operator[](const Vertex v) const { return m_corners[v.idx()]; }

  template <class Function>
  static void for_each_corner(const Mesh& mesh, const std::vector<Face>& faces, const Function& f)
  {
    for(const Face face : faces) {
      for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) {
        f(v);
      }
    }
  }

private:
  std::vector<Canvas::Corner> m_corners;
};

template <class Shader>
void draw_face(Canvas& canvas, const Mesh& mesh, const Face f, const Projected_surface& corners,
               const Shader& color)
{
  const Halfedge h = mesh.halfedge(f);
  canvas.draw_triangle(corners[mesh.source(h)], corners[mesh.target(h)], corners[mesh.target(mesh.next(h))],
                       color);
}

// Faces with coordinates at their vertices, as one chart without borders. All points of the mesh are kept.
template <class UV_map>
Textured_surface textured_faces(const Mesh& mesh, const std::vector<Face>& faces, const UV_map& uv)
{
  Textured_surface surface;
  surface.points.assign(mesh.points().begin(), mesh.points().end());
  surface.charts.assign(faces.size(), 0);
  for(const Face f : faces) {
    surface.triangles.emplace_back();
    surface.uv.emplace_back();
    Halfedge h = mesh.halfedge(f);
    for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h)) {
      surface.triangles.back()[i] = mesh.source(h).idx();
      surface.uv.back()[i] = uv[mesh.source(h)];
    }
  }
  return surface;
}

// Draws the surface with a checkerboard in the plane of its map; the squares have the given side there.
template <class UV_map>
void draw_checkerboard(Canvas& canvas, const Mesh& mesh, const std::vector<Face>& faces, const UV_map& uv,
                       const double side, const Surface_view& view, const Frame& frame)
{
  const Textured_surface surface = textured_faces(mesh, faces, uv);
  draw_checkerboard(canvas, surface, point_normals(surface), side,
                    Projection(view, box_of(surface, view), frame));
}

} // namespace pictures

#endif // PICTURES_DRAW_MESH_H
