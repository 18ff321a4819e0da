// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SHEET_H
#define FLATTEN_MESH_SHEET_H

#include "flatten_mesh/choose_component.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/property_map.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/internal/prepare/components.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace SMP = CGAL::Surface_mesh_parameterization;

// A component of the input as a mesh of its own, with the seams along which it is cut open
struct Seamed_component : Component
{
  Cut_mesh part;
  Edge_marks seams;
  Edge_marks forbidden; // edges that must not become seams, because the input does not have them
  std::optional<std::map<Vertex, double>> cones; // of the part, with their angle sums, if they are prescribed

  bool has_seams() const
  {
    return std::any_of(part.mesh.edges_begin(), part.mesh.edges_end(),
                       [this](const Edge e) { return seams[e]; });
  }
};

inline Seamed_component make_seamed_component(Mesh& mesh, const Component& component)
{
  Seamed_component result{component, {}, {}, {}, {}};
  const CGAL::Constant_property_map<Edge, bool> uncut(false);
  result.part = cut_open(mesh, component.faces, component.vertices, uncut);
  Mesh& part = result.part.mesh;
  result.seams = seam_marks(part);
  result.forbidden = diagonals(part);
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : part.edges()) {
    result.forbidden[e] = is_diagonal[result.part.edge_origins[e.idx()]];
  }
  return result;
}

// What becomes a chart: a component of the mesh of the input with its outer border, or the largest disk of the mesh
// that seams leave of it
struct Sheet : Component
{
  Mesh* input = nullptr;
  std::unique_ptr<Cut_mesh> cut; // null without seams; its origins are those of the input
  std::vector<Face> face_origins;
  std::vector<Halfedge> borders; // one halfedge without a face on each border, the longest border first
  Halfedge border;               // the outer one of these
  std::vector<Halfedge>
      seam_sides; // of each halfedge without a face: the one across the seam, if there is one

  // Only if angles are prescribed:
  std::optional<SMP::Vertex_angles<Mesh>> angles;
  std::map<Vertex, double> marks;                 // corners, or the copies of cones, with their angles
  std::vector<SMP::Split_edge<Mesh>> split_edges; // which were in the way

  Mesh& mesh() const { return cut ? cut->mesh : *input; }
  Vertex input_vertex(const Vertex v) const { return cut ? cut->origins[v.idx()] : v; }
  Edge input_edge(const Edge e) const { return cut ? cut->edge_origins[e.idx()] : e; }
  Face input_face(const Face f) const { return cut ? face_origins[f.idx()] : f; }
  std::vector<Vertex> outer_border() const
  {
    const auto range = mesh().vertices_around_face(border);
    return {range.begin(), range.end()};
  }
};

namespace internal {

// One halfedge of each border of the component with these vertices, the longest border first.
inline std::vector<Halfedge> borders_by_length(const Mesh& mesh, const std::vector<Vertex>& vertices)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<Halfedge> all;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(all));
  std::vector<std::pair<double, Halfedge>> borders;
  for(const Halfedge h : all) {
    if(std::binary_search(vertices.begin(), vertices.end(), mesh.target(h))) {
      borders.emplace_back(PMP::face_border_length(h, mesh), h);
    }
  }
  std::stable_sort(borders.begin(), borders.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Halfedge> result;
  for(const auto& border : borders) {
    result.push_back(border.second);
  }
  return result;
}

inline void choose_border(const std::size_t border, Sheet& sheet)
{
  sheet.borders = borders_by_length(sheet.mesh(), sheet.vertices);
  if(sheet.borders.empty()) {
    throw Input_error("the surface is closed" +
                      (sheet.components == 1 ? std::string()
                                             : ", at least its component " + std::to_string(sheet.number) +
                                                   " of " + std::to_string(sheet.components)) +
                      ": it has no border to flatten it from; --cut auto cuts it open" +
                      other_component_text(sheet.mesh(), sheet.number));
  }
  if(border >= sheet.borders.size()) {
    throw Input_error("no border " + std::to_string(border) + ": " +
                      choice_text(sheet.borders.size(), "border") + "; choose with --border");
  }
  sheet.border = sheet.borders[border];
}

// Both sides of a seam are copies of one edge.
inline std::vector<Halfedge> seam_sides(const Cut_mesh& cut)
{
  std::vector<Halfedge> sides(cut.mesh.number_of_halfedges());
  std::map<Edge, Halfedge> first;
  for(const Halfedge h : cut.mesh.halfedges()) {
    if(cut.mesh.is_border(h)) {
      const auto [other, is_new] = first.emplace(cut.edge_origins[cut.mesh.edge(h).idx()], h);
      if(!is_new) {
        sides[h.idx()] = other->second;
        sides[other->second.idx()] = h;
      }
    }
  }
  return sides;
}

} // namespace internal

// A component with the outer border that `--border` chooses. Throws an `Input_error` if there is none.
inline Sheet uncut_sheet(Mesh& mesh, const Component& component, const std::size_t border)
{
  Sheet sheet;
  static_cast<Component&>(sheet) = component;
  sheet.input = &mesh;
  internal::choose_border(border, sheet);
  return sheet;
}

// The largest disk that the seams leave. All copies of a cone have the sum of the angles around it.
inline Sheet cut_sheet(Mesh& input, const Seamed_component& component, const std::size_t border)
{
  const Mesh& part = component.part.mesh;
  Sheet sheet;
  sheet.input = &input;
  sheet.cut =
      std::make_unique<Cut_mesh>(cut_open(part, {part.faces_begin(), part.faces_end()},
                                          {part.vertices_begin(), part.vertices_end()}, component.seams));
  Cut_mesh& cut = *sheet.cut;
  static_cast<Component&>(sheet) = choose_component(cut.mesh, 0);
  internal::choose_border(border, sheet);
  sheet.seam_sides = internal::seam_sides(cut);
  if(component.cones) {
    sheet.angles.emplace();
    for(const Vertex v : cut.mesh.vertices()) {
      if(const auto cone = component.cones->find(cut.origins[v.idx()]); cone != component.cones->end()) {
        sheet.angles->set(v, cone->second);
        sheet.marks[v] = cone->second;
      }
    }
  }
  sheet.face_origins = component.faces;
  for(Vertex& v : cut.origins) {
    v = component.part.origins[v.idx()];
  }
  for(Edge& e : cut.edge_origins) {
    e = component.part.edge_origins[e.idx()];
  }
  return sheet;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SHEET_H
