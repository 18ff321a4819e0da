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
#include <CGAL/Texture_atlas/Cone_selection.h>
#include <CGAL/Texture_atlas/internal/prepare/components.h>

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

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;

// A component of the input as a mesh of its own, with the seams along which it is cut open
struct Seamed_component : Component
{
  Cut_mesh part;
  Edge_marks seams;
  Edge_marks forbidden; // edges that must not become seams, because the input does not have them
  std::optional<TA::Cone_selection<Mesh>> cones; // if their angles are prescribed
};

inline Seamed_component make_seamed_component(Mesh& mesh, const Component& component)
{
  const CGAL::Constant_property_map<Edge, bool> uncut(false);
  Seamed_component result{component, cut_open(mesh, component.faces, component.vertices, uncut), {}, {}, {}};
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
  // Of each halfedge without a face: the one across the seam, if there is one
  std::vector<Halfedge> seam_sides;

  // Only if angles are prescribed:
  std::optional<SMP::Vertex_angles<Mesh>> angles;
  std::map<Vertex, double> marks; // corners, or the copies of cones, with their angles

  Sheet() = default;
  Sheet(const Component& component, Mesh& mesh) : Component(component), input(&mesh) {}

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

inline void choose_border(const std::size_t border, Sheet& sheet)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh& mesh = sheet.mesh();
  PMP::extract_boundary_cycles(mesh, std::back_inserter(sheet.borders));
  sheet.borders.erase(std::remove_if(sheet.borders.begin(), sheet.borders.end(),
                                     [&](const Halfedge h) {
                                       return !std::binary_search(sheet.vertices.begin(),
                                                                  sheet.vertices.end(), mesh.target(h));
                                     }),
                      sheet.borders.end());
  std::map<Halfedge, double> length;
  for(const Halfedge h : sheet.borders) {
    length[h] = PMP::face_border_length(h, mesh);
  }
  std::stable_sort(sheet.borders.begin(), sheet.borders.end(),
                   [&](const Halfedge g, const Halfedge h) { return length[g] > length[h]; });
  if(sheet.borders.empty()) {
    throw Input_error("the surface is closed" +
                      (sheet.components == 1 ? std::string()
                                             : ", at least its component " + std::to_string(sheet.number) +
                                                   " of " + std::to_string(sheet.components)) +
                      ": it has no border to flatten it from; --cut auto cuts it open" +
                      other_component_text(mesh, sheet.number));
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
  Sheet sheet(component, mesh);
  internal::choose_border(border, sheet);
  return sheet;
}

// The largest disk that the seams leave. All copies of a cone have the sum of the angles around it.
inline Sheet cut_sheet(Mesh& input, const Seamed_component& component, const std::size_t border)
{
  const Mesh& part = component.part.mesh;
  auto cut =
      std::make_unique<Cut_mesh>(cut_open(part, {part.faces_begin(), part.faces_end()},
                                          {part.vertices_begin(), part.vertices_end()}, component.seams));
  Sheet sheet(choose_component(cut->mesh, 0), input);
  sheet.cut = std::move(cut);
  sheet.face_origins = component.faces;
  internal::choose_border(border, sheet);
  sheet.seam_sides = internal::seam_sides(*sheet.cut);
  if(component.cones) {
    const SMP::Vertex_angles<Mesh> angles = component.cones->angles();
    sheet.angles.emplace();
    for(const Vertex v : sheet.mesh().vertices()) {
      if(const auto angle = angles[sheet.input_vertex(v)]) {
        sheet.angles->set(v, angle);
        sheet.marks[v] = *angle;
      }
    }
  }
  for(Vertex& v : sheet.cut->origins) {
    v = component.part.origins[v.idx()];
  }
  for(Edge& e : sheet.cut->edge_origins) {
    e = component.part.edge_origins[e.idx()];
  }
  return sheet;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SHEET_H
