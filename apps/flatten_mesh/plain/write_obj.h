// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_OBJ_H
#define FLATTEN_MESH_WRITE_OBJ_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/model/Corner_origins.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Model_texture.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/model/concave_polygons.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Writes the text, and empties it, if it is long.
inline void pass_on(std::string& text, Output_file& file)
{
  if(text.size() > 1000000) {
    file.write(text);
    text.clear();
  }
}

inline void append_obj_vertices(std::string& text, const Polygon_soup& soup, Output_file& file)
{
  for(const Kernel::Point_3& point : soup.points) {
    pass_on(text, file);
    text += "v ";
    append_number(text, point.x());
    text += ' ';
    append_number(text, point.y());
    text += ' ';
    append_number(text, point.z());
    text += '\n';
  }
}

// The numbers of a chart's vertices among the texture coordinates.
class Texture_numbers
{
public:
  Texture_numbers(const Mesh& mesh, const Chart& chart) : m_numbers(mesh.number_of_vertices(), 0)
  {
    for(const Vertex v : chart.vertices) {
      m_numbers[v.idx()] = ++m_count;
    }
    for(const Face f : chart.is_cut() ? chart.faces : std::vector<Face>()) {
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        const Vertex v = mesh.source(h), next = mesh.target(h);
        m_sides.push_back({chart.input_vertex(v).idx(), chart.input_vertex(next).idx(), m_numbers[v.idx()]});
      }
    }
    std::sort(m_sides.begin(), m_sides.end());
  }

  // From 1; 0 outside the chart. At a corner of a larger polygon all its triangles have the same vertex, because
  // seams run along its sides.
  std::size_t operator()(const Polygon& polygon, const std::size_t corner) const
  {
    const std::size_t v = polygon[corner], next = polygon[(corner + 1) % polygon.size()];
    if(m_sides.empty()) {
      return m_numbers[v];
    }
    const auto side = std::lower_bound(m_sides.begin(), m_sides.end(), Side{v, next, 0});
    return side != m_sides.end() && (*side)[0] == v && (*side)[1] == next ? (*side)[2] : 0;
  }

private:
  using Side = std::array<std::size_t, 3>; // its vertices in the input, and the number at the first

  std::size_t m_count = 0;
  std::vector<std::size_t> m_numbers; // of each vertex
  std::vector<Side> m_sides;          // only if the chart was cut open
};

inline void append_obj_texture(std::string& text, const Chart& chart, const Flattening& flattening,
                               Output_file& file)
{
  for(const Vertex v : chart.vertices) {
    pass_on(text, file);
    const Kernel::Point_2& uv = flattening.uv[v];
    text += "vt ";
    append_number(text, uv.x());
    text += ' ';
    append_number(text, uv.y());
    text += '\n';
  }
}

inline void append_obj_faces(std::string& text, const Polygon_soup& soup, const Texture_numbers& numbers,
                             Output_file& file)
{
  for(const Polygon& polygon : soup.polygons) {
    pass_on(text, file);
    text += 'f';
    for(std::size_t corner = 0; corner < polygon.size(); ++corner) {
      text += ' ';
      append_number(text, polygon[corner] + 1);
      if(const std::size_t number = numbers(polygon, corner); number != 0) {
        text += '/';
        append_number(text, number);
      }
    }
    text += '\n';
  }
}

} // namespace internal

// The input's vertices and faces in the input's order, with texture coordinates for the chart: several of them for a
// vertex on a seam.
inline void write_obj(Output_file& file, const Polygon_soup& soup, const Mesh& mesh, const Chart& chart,
                      const Flattening& flattening)
{
  std::string text =
      "# flattened by flatten_mesh: 'vt' are the coordinates in the plane, on the scale of the surface\n";
  internal::append_obj_vertices(text, soup, file);
  internal::append_obj_texture(text, chart, flattening, file);
  internal::append_obj_faces(text, soup, internal::Texture_numbers(mesh, chart), file);
  file.write(text);
}

// The same as the texture of the model, for the other formats
inline Model_texture texture_of_chart(const Model& model, const Mesh& input, const Corner_origins& origins,
                                      const Mesh& mesh, const Chart& chart, const Flattening& flattening)
{
  Model_texture texture = empty_texture(model, input, origins);
  const internal::Texture_numbers numbers(mesh, chart);
  for(const Halfedge h : input.halfedges()) {
    if(!input.is_border(h)) {
      const Polygon side = {input.target(h).idx(), input.target(input.next(h)).idx()};
      if(const std::size_t number = numbers(side, 0); number != 0) {
        texture.uv[origins.corners[h.idx()]] = flattening.uv[chart.vertices[number - 1]];
      }
    }
  }
  return texture;
}

// Of each polygon of a soup: whether it is in the chart, and has a fan that must not be drawn
inline std::vector<bool> concave_polygons(const Polygon_soup& soup, const Mesh& mesh, const Chart& chart,
                                          const Flattening& flattening, const Float_grid& grid)
{
  const internal::Texture_numbers numbers(mesh, chart);
  std::vector<bool> is_concave(soup.polygons.size(), false);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const Polygon& polygon = soup.polygons[p];
    std::vector<Kernel::Point_2> corners;
    for(std::size_t i = 0; i < polygon.size() && polygon.size() > 3; ++i) {
      if(const std::size_t number = numbers(polygon, i); number != 0) {
        corners.push_back(flattening.uv[chart.vertices[number - 1]]);
      }
    }
    is_concave[p] = !corners.empty() && !(corners.size() == polygon.size() && has_good_fans(corners, grid));
  }
  return is_concave;
}

// Replaces polygons of a soup by their triangles. `origins` has the polygon of the model that each face is in.
inline void divide_polygons(Polygon_soup& soup, const Mesh& input, const std::vector<Index>& origins,
                            const std::vector<bool>& is_divided)
{
  std::vector<std::pair<Index, Face>> faces;
  for(const Face f : input.faces()) {
    faces.push_back({origins[f.idx()], f});
  }
  std::sort(faces.begin(), faces.end());
  Polygon_soup after;
  after.points = soup.points;
  const auto add = [&](Polygon polygon, const std::size_t p) {
    after.polygons.push_back(std::move(polygon));
    after.origins.push_back(soup.origins[p]);
    after.is_turned.push_back(soup.is_turned[p]);
  };
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    if(!is_divided[p]) {
      add(std::move(soup.polygons[p]), p);
      continue;
    }
    for(auto face = std::lower_bound(faces.begin(), faces.end(), std::make_pair(soup.origins[p], Face(0)));
        face != faces.end() && face->first == soup.origins[p]; ++face) {
      Polygon triangle;
      for(const Vertex v : input.vertices_around_face(input.halfedge(face->second))) {
        triangle.push_back(v.idx());
      }
      add(std::move(triangle), p);
    }
  }
  soup = std::move(after);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_OBJ_H
