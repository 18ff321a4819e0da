// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the figure of the manual's part on baking: a fine surface, a simple one, and the simple one with the normals of
// the fine one.

#include "pictures/Canvas.h"
#include "pictures/Surface_view.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Origin.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/make_atlas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pictures {

namespace TA = CGAL::Texture_atlas;

using namespace CGAL::Texture_atlas::internal::prepare;

namespace {

using Vector = Kernel::Vector_3;
using Weights = std::array<double, 3>;
constexpr int texels = 1024;

Mesh read_surface(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh)) {
    throw std::runtime_error("cannot read " + file);
  }
  return mesh;
}

Mesh simplified(Mesh mesh, const std::size_t triangles)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  SMS::edge_collapse(
      mesh,
      [&mesh, triangles](const auto&, const auto&, auto, auto) {
        return mesh.number_of_faces() <= triangles;
      },
      CGAL::parameters::filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
  return mesh;
}

std::array<Halfedge, 3> corners(const Mesh& mesh, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return {h, mesh.next(h), mesh.prev(h)};
}

template <class Value_of>
Vector interpolated(const std::array<Halfedge, 3>& h, const Weights& weights, const Value_of& value_of)
{
  return weights[0] * value_of(h[0]) + weights[1] * value_of(h[1]) + weights[2] * value_of(h[2]);
}

// Grey, lit from the upper left
Color shaded(const Vector& normal, const Surface_view& view)
{
  const Vector n = Surface_view::normalized(view(normal)),
               light = Surface_view::normalized(Vector(-0.5, 0.6, 0.6)),
               half = Surface_view::normalized(light + Vector(0, 0, 1));
  const double diffuse = (std::max)(n * light, 0.), shine = std::pow((std::max)(n * half, 0.), 25);
  const double brightness = 0.16 + 0.72 * diffuse + 0.18 * shine;
  return {brightness, 0.97 * brightness, 0.92 * brightness};
}

// Draws a mesh; `normal(h, weights)` is that in a triangle with these halfedges.
template <class Normal>
void draw(Canvas& canvas, const Mesh& mesh, const Projection& projection, const Normal& normal)
{
  for(const Face f : mesh.faces()) {
    const std::array<Halfedge, 3> h = corners(mesh, f);
    std::array<Canvas::Corner, 3> places;
    for(std::size_t k = 0; k < 3; ++k) {
      places[k] = projection(mesh.point(mesh.target(h[k])));
      places[k].values[k] = 1;
    }
    canvas.draw_triangle(places[0], places[1], places[2],
                         [&](const std::array<double, Canvas::number_of_values>& values) {
                           return shaded(normal(h, {values[0], values[1], values[2]}), projection.view());
                         });
  }
}

// The simple surface, with what is baked
class Baked_mesh
{
public:
  Baked_mesh(Mesh mesh, const Mesh& fine)
      : m_mesh(std::move(mesh)), m_atlas(empty_atlas(m_mesh)),
        m_frames(m_mesh.add_property_map<Halfedge, TA::Tangent_frame>("h:frame").first)
  {
    const auto np = CGAL::parameters::face_patch_map(m_atlas.chart);
    TA::Atlas_options atlas_options(TA::Atlas_options::FEW_CHARTS);
    atlas_options.resolution = texels;
    const auto report = TA::make_atlas(m_mesh, m_atlas.uv, atlas_options, np);
    if(!report) {
      throw std::runtime_error(report.message);
    }
    TA::Baking_options baking_options;
    baking_options.resolution = texels;
    m_textures = TA::bake_surface(m_mesh, m_atlas.uv, fine, m_frames, baking_options, np);
    if(!m_textures) {
      throw std::runtime_error(m_textures.message);
    }
    m_pixels = m_textures.normal_pixels<std::uint8_t>();
    std::cout << fine.number_of_faces() << " triangles baked into " << m_mesh.number_of_faces() << ", "
              << report.charts.size() << " chart(s), " << m_textures.number_of_chart_texels << " texels, "
              << m_textures.number_of_missed_rays << " rays missed, " << m_textures.number_of_back_faces
              << " met back faces, largest distance " << m_textures.largest_distance << '\n';
  }

  const Mesh& mesh() const { return m_mesh; }

  Vector normal(const std::array<Halfedge, 3>& h, const Weights& weights) const
  {
    return interpolated(h, weights, [this](const Halfedge g) { return vector_of(m_frames[g].normal); });
  }

  // As viewers compute it from the picture
  Vector baked_normal(const std::array<Halfedge, 3>& h, const Weights& weights) const
  {
    double u = 0, v = 0;
    for(std::size_t k = 0; k < 3; ++k) {
      u += weights[k] * m_atlas.uv[h[k]].x();
      v += weights[k] * m_atlas.uv[h[k]].y();
    }
    const Vector n = read(u * texels - 0.5, (1 - v) * texels - 0.5);
    const Vector tangent = Surface_view::normalized(
        interpolated(h, weights, [this](const Halfedge g) { return vector_of(m_frames[g].tangent); }));
    const Vector bitangent = Surface_view::normalized(interpolated(h, weights, [this](const Halfedge g) {
      const TA::Tangent_frame& frame = m_frames[g];
      return frame.sign * CGAL::cross_product(vector_of(frame.normal), vector_of(frame.tangent));
    }));
    return n.x() * tangent + n.y() * bitangent + n.z() * Surface_view::normalized(normal(h, weights));
  }

private:
  static Vector vector_of(const std::array<double, 3>& v) { return Vector(v[0], v[1], v[2]); }

  Vector pixel(const int x, const int y) const
  {
    const std::uint8_t* p =
        &m_pixels[3 * (static_cast<std::size_t>(y) * texels + static_cast<std::size_t>(x))];
    return Vector(p[0], p[1], p[2]) * (2. / 255) - Vector(1, 1, 1);
  }

  Vector read(const double x, const double y) const
  {
    const int i = (std::min)((std::max)(static_cast<int>(std::floor(x)), 0), texels - 2),
              j = (std::min)((std::max)(static_cast<int>(std::floor(y)), 0), texels - 2);
    const double s = x - i, t = y - j;
    return (1 - t) * ((1 - s) * pixel(i, j) + s * pixel(i + 1, j)) +
           t * ((1 - s) * pixel(i, j + 1) + s * pixel(i + 1, j + 1));
  }

  Mesh m_mesh;
  Atlas m_atlas;
  Mesh::Property_map<Halfedge, TA::Tangent_frame> m_frames;
  TA::Baked_textures m_textures;
  std::vector<std::uint8_t> m_pixels;
};

void draw_baking(const std::string& input, const std::string& file)
{
  const int column = 300, height = 345;
  Mesh fine = read_surface(input);
  const auto normals = fine.add_property_map<Vertex, Vector>("v:normal").first;
  CGAL::Polygon_mesh_processing::compute_vertex_normals(fine, normals);
  const Baked_mesh baked(simplified(fine, 1500), fine);

  const Surface_view view(Vector(0.35, 0.15, -1), Vector(0, 1, 0));
  CGAL::Bbox_2 box;
  for(const Vertex v : fine.vertices()) {
    const Vector p = view(fine.point(v) - CGAL::ORIGIN);
    box += CGAL::Bbox_2(p.x(), p.y(), p.x(), p.y());
  }
  Canvas canvas(3 * column, height);
  const auto projection = [&](const int number) {
    return Projection(view, box, Frame{number * column + 4., 4, column - 8., height - 8.});
  };
  draw(canvas, fine, projection(0), [&](const std::array<Halfedge, 3>& h, const Weights& weights) {
    return interpolated(h, weights, [&](const Halfedge g) { return normals[fine.target(g)]; });
  });
  draw(canvas, baked.mesh(), projection(1),
       [&](const std::array<Halfedge, 3>& h, const Weights& weights) { return baked.normal(h, weights); });
  draw(canvas, baked.mesh(), projection(2), [&](const std::array<Halfedge, 3>& h, const Weights& weights) {
    return baked.baked_normal(h, weights);
  });
  std::ofstream(file, std::ios::binary) << canvas.png(63);
}

} // namespace

} // namespace pictures

int main(int argc, char* argv[])
{
  if(argc != 3) {
    std::cerr << "usage: draw_baking MESH PICTURE.png\n";
    return 2;
  }
  try {
    pictures::draw_baking(argv[1], argv[2]);
  } catch(const std::exception& error) {
    std::cerr << "draw_baking: " << error.what() << '\n';
    return 1;
  }
}
