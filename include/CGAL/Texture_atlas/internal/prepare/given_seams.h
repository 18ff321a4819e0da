// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/Soup_report.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Turns mirrored charts over. Models of games often show one half of the texture on both sides, one of them mirrored:
// where the orientation changes, a seam is added if `adds_seams`, but not within polygons. Charts of both orientations
// stay as they are, and `report` counts what was changed. `uv(h)` is a reference; a map without numbers has no
// orientation.
template <class Uv>
void orient_texture(const bool adds_seams, Mesh& mesh, const Edge_marks& seams, const Uv& uv,
                    Soup_report::Seams& report)
{
  std::vector<double> area(mesh.number_of_faces()); // its sign is the orientation
  for(const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    const Kernel::Point_2 p = uv(h), q = uv(mesh.next(h)), r = uv(mesh.prev(h));
    area[f.idx()] = (q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y());
  }
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : mesh.edges()) {
    if(adds_seams && !mesh.is_border(e) && !seams[e] && !is_diagonal[e]) {
      const Halfedge h = mesh.halfedge(e);
      const double first = area[mesh.face(h).idx()], second = area[mesh.face(mesh.opposite(h)).idx()];
      seams[e] = (first < 0 && second > 0) || (first > 0 && second < 0);
      report.mirror_edges += seams[e];
    }
  }
  auto chart = mesh.add_property_map<Face, std::size_t>().first;
  const std::size_t charts =
      Polygon_mesh_processing::connected_components(mesh, chart, parameters::edge_is_constrained_map(seams));
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 2>> range(charts, {infinity, -infinity}); // of u
  std::vector<bool> is_mirrored(charts, false), is_upright(charts, false);
  for(const Face f : mesh.faces()) {
    const std::size_t c = chart[f];
    is_mirrored[c] = is_mirrored[c] || area[f.idx()] < 0;
    is_upright[c] = is_upright[c] || area[f.idx()] > 0;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      range[c] = {(std::min)(range[c][0], uv(h).x()), (std::max)(range[c][1], uv(h).x())};
    }
  }
  for(const Face f : mesh.faces()) {
    const std::size_t c = chart[f];
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      if(is_mirrored[c] && !is_upright[c]) {
        uv(h) = Kernel::Point_2(range[c][0] + (range[c][1] - uv(h).x()), uv(h).y());
      }
    }
  }
  for(std::size_t c = 0; c < charts; ++c) {
    report.turned_charts += is_mirrored[c] && !is_upright[c];
  }
  mesh.remove_property_map(chart);
}

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

// Marks the edges where texture coordinates differ. Throws an `Input_error` if there are no coordinates.
inline void keep_seams_of_texture(const Surface_soup& soup, const Prepared_surface& surface,
                                  const Edge_marks& seams)
{
  if(soup.texture.empty()) {
    throw Input_error("there are no texture coordinates that could be kept", {}, {},
                      Diagnosis::NO_TEXTURE_COORDINATES);
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
    throw Input_error("there are no materials that could divide the surface into charts", {}, {},
                      Diagnosis::WRONG_OPTION);
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

// The source and the target of a halfedge of a face, as points of the soup, in increasing order
inline std::pair<Index, Index> points_of(const Surface_soup& soup, const Prepared_surface& surface,
                                         const Halfedge h)
{
  const std::vector<Index>& corners = surface.origins.corners;
  return std::minmax(Index(soup.vertices[corners[surface.mesh.prev(h).idx()]]),
                     Index(soup.vertices[corners[h.idx()]]));
}

// Marks the edges that the soup names. Throws an `Input_error` that names the first pair that is no edge.
inline void mark_seams_of_soup(const Surface_soup& soup, Prepared_surface& surface, const Edge_marks& seams)
{
  if(soup.marked_seams.empty()) {
    return;
  }
  const Mesh& mesh = surface.mesh;
  const Edge_marks is_diagonal = diagonals(surface.mesh);
  std::vector<std::pair<std::pair<Index, Index>, Edge>> edges;
  for(const Halfedge h : mesh.halfedges()) {
    if(!mesh.is_border(h) && !is_diagonal[mesh.edge(h)]) {
      edges.emplace_back(points_of(soup, surface, h), mesh.edge(h));
    }
  }
  const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(edges.begin(), edges.end(), before);
  for(std::size_t i = 0; i < soup.marked_seams.size(); ++i) {
    const std::pair<Index, Index> pair =
        std::minmax(Index(soup.marked_seams[i].first), Index(soup.marked_seams[i].second));
    const auto [begin, end] = std::equal_range(edges.begin(), edges.end(), std::pair(pair, Edge()), before);
    if(begin == end) {
      throw Input_error("marked_seams[" + std::to_string(i) + "]: vertices " + std::to_string(pair.first) +
                            " and " + std::to_string(pair.second) +
                            " are not the ends of an edge of a face that is flattened",
                        {}, {pair.first, pair.second}, Diagnosis::NO_SUCH_EDGE);
    }
    for(auto edge = begin; edge != end; ++edge) {
      seams[edge->second] = true;
    }
  }
}

// Marks the seams of the coordinates in the file, and sets `uv(h)` to these for each corner; no numbers where there are
// none. Mirrored charts are turned over. If charts are repaired, there may be no coordinates at all, and charts that
// are mirrored in part are not divided. Otherwise throws an `Input_error` if there are none.
template <class Uv>
void take_texture(const bool repairs, const Surface_soup& soup, Prepared_surface& surface,
                  const Edge_marks& seams, const Uv& uv, Soup_report::Seams& report)
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
  orient_texture(!repairs, surface.mesh, seams, uv, report);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SEAMS_H
