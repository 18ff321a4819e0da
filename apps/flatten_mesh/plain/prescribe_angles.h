// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PRESCRIBE_ANGLES_H
#define FLATTEN_MESH_PRESCRIBE_ANGLES_H

#include "flatten_mesh/model/file_content.h"
#include "flatten_mesh/model/Text_lines.h"
#include "flatten_mesh/plain/corner_numbers.h"
#include "flatten_mesh/plain/flatten_sheet.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/corners_of_map.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flatten_mesh {

inline bool prescribes_angles(const Command_line& command)
{
  return !command.rectangle.empty() || !command.border_angles.empty();
}

namespace internal {

// A vertex on the outer border of a sheet, by its number from 1. `place` says where the number is.
inline Vertex border_vertex(const std::size_t number, const std::vector<Vertex>& border,
                            const std::string& place)
{
  const auto found = std::find_if(border.begin(), border.end(),
                                  [&](const Vertex v) { return std::size_t(v.idx()) + 1 == number; });
  if(found == border.end()) {
    throw Input_error(place + ": vertex " + std::to_string(number) +
                      " is not on the outer border of the surface; vertices count from 1, as in OBJ files");
  }
  return *found;
}

// Reads a line for each vertex: its number, from 1, and its angle in degrees. '#' begins a comment.
inline SMP::Vertex_angles<Mesh> read_border_angles(const std::string& file, const std::vector<Vertex>& border)
{
  check_file_is_there(file);
  const std::string content = bytes_of_file(file);
  SMP::Vertex_angles<Mesh> angles;
  for(Text_lines lines(content); lines.next();) {
    const std::string_view number_word = lines.word();
    if(number_word.empty()) {
      continue;
    }
    const std::string place = "'" + file + "', line " + std::to_string(lines.number());
    std::size_t number;
    double degrees;
    if(!read_count(number_word, number) || !read_finite_number(lines.word(), degrees) ||
       !lines.word().empty()) {
      throw Input_error(place + ": expected the number of a vertex and an angle in degrees, as in '17 90'");
    }
    const Vertex v = border_vertex(number, border, place);
    if(angles[v]) {
      throw Input_error(place + ": vertex " + std::to_string(number) + " has an angle already");
    }
    angles.set(v, degrees == 180 ? CGAL_PI : degrees / 180 * CGAL_PI);
  }
  return angles;
}

// The corners that are asked for. A map without prescribed angles tells where to put them otherwise; if there is none,
// returns nothing, and why in `attempt`.
inline std::optional<std::array<Vertex, 4>> corners(const Sheet& sheet, Command_line command,
                                                    Progress& progress, Flattening& attempt)
{
  const std::vector<Vertex> border = sheet.outer_border();
  if(const auto numbers = corner_numbers(command.rectangle)) {
    std::array<Vertex, 4> result;
    std::transform(numbers->begin(), numbers->end(), result.begin(),
                   [&](const std::size_t number) { return border_vertex(number, border, "--rectangle"); });
    return result;
  }
  if(border.size() < 4) {
    throw Input_error("--rectangle: the outer border has only " +
                      count_text(border.size(), "vertex", "vertices"));
  }
  command.options.injective = false;
  attempt = flatten_sheet(sheet, command, progress);
  return attempt.succeeded() ? std::optional(SMP::internal::ABF::corners_of_map(border, attempt.uv))
                             : std::nullopt;
}

// Splits edges that would make triangles flat, and returns how many. The new edges are no sides of polygons, as far as
// seams are concerned.
inline std::size_t split_edges(Sheet& sheet)
{
  Mesh& mesh = sheet.mesh();
  const auto is_diagonal = diagonals(mesh);
  const auto old_faces = mesh.number_of_faces();
  const auto edges = SMP::split_flat_chords(mesh, sheet.border, *sheet.angles).edges;
  for(const auto& split : edges) {
    sheet.vertices.push_back(split.middle);
    for(const Halfedge h : CGAL::halfedges_around_target(split.middle, mesh)) {
      is_diagonal[mesh.edge(h)] = true;
    }
  }
  for(auto f = old_faces; f < mesh.number_of_faces(); ++f) {
    sheet.faces.push_back(Face(f));
  }
  return edges.size();
}

} // namespace internal

// Sets the angles of an uncut sheet that are asked for, and splits edges that are in their way. Vertices with other
// angles than those inside of straight sides are marked, and are the corners of the record. If that is not possible,
// returns false, and why in `attempt`.
inline bool prescribe_angles(Sheet& sheet, const Command_line& command, Progress& progress,
                             Chart_record& record, Flattening& attempt)
{
  if(command.rectangle.empty()) {
    sheet.angles = internal::read_border_angles(command.border_angles, sheet.outer_border());
  } else if(const auto corners = internal::corners(sheet, command, progress, attempt)) {
    sheet.angles = SMP::rectangle_angles(sheet.mesh(), *corners).angles;
  } else {
    return false;
  }
  for(const Vertex v : sheet.outer_border()) {
    if(const auto angle = (*sheet.angles)[v]; angle && std::abs(*angle - CGAL_PI) > 1e-9) {
      sheet.marks[v] = *angle;
      record.corners.push_back(v.idx());
    }
  }
  record.split_edges = internal::split_edges(sheet);
  return true;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PRESCRIBE_ANGLES_H
