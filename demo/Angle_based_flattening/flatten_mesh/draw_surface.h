// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DRAW_SURFACE_H
#define FLATTEN_MESH_DRAW_SURFACE_H

#include "Canvas.h"
#include "Chart.h"
#include "build_mesh.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace flatten_mesh {

// A part of the canvas, in pixels.
struct Frame
{
  double left, top, width, height;
};

// From where a surface is seen; without perspective.
class Surface_view
{
  using Vector = Kernel::Vector_3;

public:
  // `towards_eye` is a direction; `up` is upright in the picture.
  Surface_view(const Vector& towards_eye, const Vector& up)
      : m_depth(normalized(towards_eye)), m_right(normalized(CGAL::cross_product(up, m_depth))),
        m_up(CGAL::cross_product(m_depth, m_right))
  {}

  // A surface that faces mainly one way is seen from there, others from the front, slightly from above and from the
  // right.
  static Surface_view of(const Mesh& mesh, const std::vector<Face>& faces)
  {
    Vector sum(0, 0, 0);
    double area = 0;
    for(const Face f : faces) {
      const Vector normal = doubled_area_vector(mesh, f);
      sum = sum + normal;
      area += std::sqrt(normal.squared_length());
    }
    const double one_sided = std::sqrt(sum.squared_length()) / area;
    const Vector towards_eye = one_sided > 0.25 ? sum : Vector(0.5, -1, 0.45);
    const bool from_above = std::abs(normalized(towards_eye).z()) > 0.9;
    return Surface_view(towards_eye, from_above ? Vector(0, 1, 0) : Vector(0, 0, 1));
  }

  // Right, up, and towards the eye.
  Vector operator()(const Vector& v) const { return Vector(v * m_right, v * m_up, v * m_depth); }

  static Vector doubled_area_vector(const Mesh& mesh, const Face f)
  {
    const Halfedge h = mesh.halfedge(f);
    const Kernel::Point_3& p = mesh.point(mesh.source(h));
    return CGAL::cross_product(mesh.point(mesh.target(h)) - p, mesh.point(mesh.target(mesh.next(h))) - p);
  }

  static Vector normalized(const Vector& v)
  {
    const double length = std::sqrt(v.squared_length());
    return length > 0 ? v / length : v;
  }

private:
  Vector m_depth, m_right, m_up;
};

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
    const double scale = (std::min)(frame.width / (std::max)(box.x_span(), 1e-300),
                                    frame.height / (std::max)(box.y_span(), 1e-300));
    const double left = frame.left + (frame.width - scale * box.x_span()) / 2;
    const double top = frame.top + (frame.height - scale * box.y_span()) / 2;
    for_each_corner(mesh, faces, [&](const Vertex v) {
      const auto p = view(mesh.point(v) - CGAL::ORIGIN);
      m_corners[v.idx()].x = left + scale * (p.x() - box.xmin());
      m_corners[v.idx()].y = top + scale * (box.ymax() - p.y());
      m_corners[v.idx()].depth = scale * p.z();
    });
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

// Draws the surface with a checkerboard in the plane of its map; the squares have the given side there. The back of
// the surface is grey.
template <class UV_map>
void draw_checkerboard(Canvas& canvas, const Mesh& mesh, const std::vector<Face>& faces, const UV_map& uv,
                       const double side, const Surface_view& view, const Frame& frame)
{
  Projected_surface corners(mesh, faces, view, frame);
  for(const Face f : faces) {
    const auto normal = view(Surface_view::doubled_area_vector(mesh, f));
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      auto& values = corners[v].values;
      values[0] = uv[v].x() / side;
      values[1] = uv[v].y() / side;
      for(int i = 0; i < 3; ++i) {
        values[static_cast<std::size_t>(2 + i)] += normal[i];
      }
    }
  }
  const Color light = {0.97, 0.96, 0.92}, dark = {0.13, 0.36, 0.57}, behind = {0.62, 0.62, 0.62};
  const auto shader = [&](const std::array<double, Canvas::number_of_values>& values) {
    const Kernel::Vector_3 normal =
        Surface_view::normalized(Kernel::Vector_3(values[2], values[3], values[4]));
    const bool odd = std::fmod(std::abs(std::floor(values[0]) + std::floor(values[1])), 2) == 1;
    const Color paint = mix(odd ? dark : light, behind, normal.z() < 0 ? 0.75 : 0.);
    const double lamp = std::abs(normal * Surface_view::normalized(Kernel::Vector_3(-0.35, 0.5, 0.8)));
    return mix(Color{0.03, 0.05, 0.1}, paint, 0.38 + 0.62 * lamp);
  };
  for(const Face f : faces) {
    draw_face(canvas, mesh, f, corners, shader);
  }
}

// Draws the edges for which `is_drawn(edge)` as dark lines, slightly in front of the surface.
template <class Is_drawn>
void draw_edges(Canvas& canvas, const Mesh& mesh, const std::vector<Face>& faces, const Surface_view& view,
                const Frame& frame, const Is_drawn& is_drawn)
{
  const double width = 3, in_front = 3; // in pixels
  const Color ink = {0.08, 0.02, 0.02};
  const Projected_surface corners(mesh, faces, view, frame);
  for(const Face f : faces) {
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      if(is_drawn(mesh.edge(h))) {
        Canvas::Corner a = corners[mesh.source(h)], b = corners[mesh.target(h)];
        a.depth += in_front;
        b.depth += in_front;
        canvas.draw_line(a, b, width, ink);
      }
    }
  }
}

// A picture of the surface with a checkerboard, as a PNG file. Seams are dark lines. The square root of the surface's area is about
// `squares` squares long.
template <class UV_map>
std::string checkerboard_picture(const Mesh& mesh, const Chart& chart, const UV_map& uv)
{
  const std::vector<Face>& faces = chart.faces;
  const int size = 900, squares = 20;
  double area = 0;
  for(const Face f : faces) {
    area += std::sqrt(Surface_view::doubled_area_vector(mesh, f).squared_length()) / 2;
  }
  Canvas canvas(size, size);
  const Frame frame{20, 20, size - 40., size - 40.};
  const Surface_view view = Surface_view::of(mesh, faces);
  draw_checkerboard(canvas, mesh, faces, uv, std::sqrt(area) / squares, view, frame);
  if(chart.is_cut()) {
    draw_edges(canvas, mesh, faces, view, frame, [&chart](const Edge e) { return chart.seam(e) >= 0; });
  }
  return canvas.png();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DRAW_SURFACE_H
