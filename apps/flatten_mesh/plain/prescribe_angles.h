// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PRESCRIBE_ANGLES_H
#define FLATTEN_MESH_PRESCRIBE_ANGLES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/plain/Sheet.h"
#include "flatten_mesh/plain/choose_corners.h"
#include "flatten_mesh/plain/corner_numbers.h"
#include "flatten_mesh/plain/flatten_sheet.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

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

// Reads a line for each vertex: its number, from 1, and its angle in degrees. Lines that start with '#' are comments.
inline SMP::Vertex_angles<Mesh> read_border_angles(const std::string& file, const std::vector<Vertex>& border)
{
  std::ifstream in(file);
  if(!in) {
    throw Input_error("cannot open '" + file + "'");
  }
  SMP::Vertex_angles<Mesh> angles;
  std::string line;
  for(std::size_t i = 1; std::getline(in, line); ++i) {
    const std::vector<std::string> words = words_of(line, " \t");
    if(words.empty() || words.front().front() == '#') {
      continue;
    }
    const std::string place = "'" + file + "', line " + std::to_string(i);
    const auto number = number_of<std::size_t>(words.front());
    const auto degrees = number_of<double>(words.back());
    if(words.size() != 2 || !number || !degrees || !std::isfinite(*degrees)) {
      throw Input_error(place + ": expected the number of a vertex and an angle in degrees, as in '17 90'");
    }
    const Vertex v = border_vertex(*number, border, place);
    if(angles[v]) {
      throw Input_error(place + ": vertex " + std::to_string(*number) + " has an angle already");
    }
    angles.set(v, *degrees == 180 ? CGAL_PI : *degrees / 180 * CGAL_PI);
  }
  if(in.bad()) {
    throw Input_error("cannot read '" + file + "'");
  }
  return angles;
}

// The corners that are asked for. A map without prescribed angles tells where to put them otherwise; if there is none,
// returns nothing, and why in `attempt`.
inline std::optional<std::array<Vertex, 4>> corners(const Sheet& sheet, Command_line command,
                                                    Progress& progress, std::optional<Flattening>& attempt)
{
  const std::vector<Vertex> border = sheet.outer_border();
  if(const auto numbers = corner_numbers(command.rectangle)) {
    std::array<Vertex, 4> result;
    for(std::size_t i = 0; i < result.size(); ++i) {
      result[i] = border_vertex((*numbers)[i], border, "--rectangle");
    }
    return result;
  }
  if(border.size() < 4) {
    throw Input_error("--rectangle: the outer border has only " +
                      count_text(border.size(), "vertex", "vertices"));
  }
  command.options.injective = false;
  attempt = flatten_sheet(sheet, command, progress);
  if(!attempt->succeeded()) {
    return std::nullopt;
  }
  return choose_corners(border, attempt->uv);
}

// Splits edges that would make triangles flat. The new edges are no sides of polygons, as far as seams are concerned.
inline void split_edges(Sheet& sheet)
{
  Mesh& mesh = sheet.mesh();
  const auto is_diagonal = diagonals(mesh);
  const auto old_faces = mesh.number_of_faces();
  sheet.split_edges = SMP::split_flat_chords(mesh, sheet.border, *sheet.angles).edges;
  for(const auto& split : sheet.split_edges) {
    sheet.vertices.push_back(split.middle);
    for(const Halfedge h : CGAL::halfedges_around_target(split.middle, mesh)) {
      is_diagonal[mesh.edge(h)] = true;
    }
  }
  for(auto f = old_faces; f < mesh.number_of_faces(); ++f) {
    sheet.faces.push_back(Face(f));
  }
}

} // namespace internal

// Sets the angles of an uncut sheet that are asked for, and splits edges that are in their way. Vertices with other
// angles than those inside of straight sides are marked. Returns why that is not possible, or nothing.
inline std::optional<Flattening> prescribe_angles(Sheet& sheet, const Command_line& command,
                                                  Progress& progress)
{
  if(command.rectangle.empty()) {
    sheet.angles = internal::read_border_angles(command.border_angles, sheet.outer_border());
  } else {
    std::optional<Flattening> attempt;
    const auto corners = internal::corners(sheet, command, progress, attempt);
    if(!corners) {
      return attempt;
    }
    sheet.angles = SMP::rectangle_angles(sheet.mesh(), *corners).angles;
  }
  for(const Vertex v : sheet.outer_border()) {
    if(const auto angle = (*sheet.angles)[v]; angle && std::abs(*angle - CGAL_PI) > 1e-9) {
      sheet.marks[v] = *angle;
    }
  }
  internal::split_edges(sheet);
  return std::nullopt;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PRESCRIBE_ANGLES_H
