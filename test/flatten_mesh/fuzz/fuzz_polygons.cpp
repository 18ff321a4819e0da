// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A target of libFuzzer: makes a model of polygons of bytes, and a triangle mesh of it as `flatten_mesh` does. Each
// polygon must have triangles at all its corners, or be named.

#include "bytes.h"

#include "flatten_mesh/atlas/Atlas_input.h"

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

using namespace flatten_mesh;

void require(bool condition, const std::string& what)
{
  if(condition)
    return;
  std::cerr << "FAULT: " << what << std::endl;
  std::abort();
}

// Polygons between any points, most of them at a side of an earlier one
Model model_of(Bytes& bytes)
{
  const bool extreme = bytes.below(4) == 0;
  Model model;
  for(int n = 3 + bytes.below(40); n > 0; --n)
    model.points.push_back(bytes.point(model.points, extreme));
  const int points = static_cast<int>(model.points.size());
  for(int n = 0; n < 30 && !bytes.is_empty(); ++n) {
    std::vector<Index> corners;
    if(const std::size_t size = model.vertices.size(); size > 1 && bytes.below(4) > 0) {
      const std::size_t c = static_cast<std::size_t>(bytes.byte()) % (size - 1);
      corners = {model.vertices[c + 1], model.vertices[c]};
    }
    for(int k = bytes.below(20); k > 0; --k)
      corners.push_back(static_cast<Index>(bytes.below(points)));
    model.vertices.insert(model.vertices.end(), corners.begin(), corners.end());
    model.end_polygon();
  }
  return model;
}

// The polygons that the mesh has; with all corners that do not repeat a vertex, and one triangle for two edges to be cut
std::set<Index> require_whole(const Atlas_input& input)
{
  const Model& model = input.model;
  std::map<Index, std::set<Index>> corners;
  std::map<Index, std::size_t> triangles;
  std::set<Index> polygons;
  for(const Face f : input.mesh.faces()) {
    require(CGAL::is_triangle(input.mesh.halfedge(f), input.mesh), "a face is not a triangle");
    const Model_triangle triangle = input.origins.triangle(model, input.mesh, f);
    ++triangles[triangle.polygon];
    corners[triangle.polygon].insert(triangle.corners.begin(), triangle.corners.end());
    polygons.insert(triangle.polygon);
    for(const Index c : triangle.corners)
      require(model.polygon_of_corner(c) == triangle.polygon, "a triangle in two polygons");
  }
  for(const Index p : polygons) {
    Polygon polygon;
    for(const Index c : corners_without_repetition(model, p))
      polygon.push_back(model.vertices[c]);
    require(triangles[p] + 2 == polygon.size(), "a polygon with too few triangles");
    require(corners[p].size() == polygon.size(), "a corner without triangle");
  }
  return polygons;
}

// With diagonals, no two vertices have two edges that had one before.
void require_simple(Atlas_input& input)
{
  std::set<std::pair<Vertex, Vertex>> joined, crossing;
  const Edge_marks is_diagonal = diagonals(input.mesh);
  for(const Edge e : input.mesh.edges()) {
    const std::pair<Vertex, Vertex> ends = std::minmax(input.mesh.vertex(e, 0), input.mesh.vertex(e, 1));
    if(is_diagonal[e])
      require(crossing.insert(ends).second, "two diagonals between the same vertices");
    else
      joined.insert(ends);
  }
  for(const auto& ends : crossing)
    require(joined.count(ends) == 0, "a diagonal beside an edge");
}

void make_mesh(const Model& model, bool repair)
{
  Command_line command;
  command.quiet = true;
  Notes notes = notes_of(command);
  try {
    Atlas_input input = atlas_input_of(model, repair, notes);
    const std::set<Index> polygons = require_whole(input);
    require_simple(input);
    std::size_t named = 0;
    for(const TA::Atlas_report::Skipped& part : input.set_aside)
      named += part.number_of_faces;
    const std::vector<bool>& has_no_area = input.origins.has_no_area; // which is told with the atlas
    named += static_cast<std::size_t>(std::count(has_no_area.begin(), has_no_area.end(), true));
    if(notes.texts().empty())
      require(named + polygons.size() == model.number_of_polygons(), "a polygon is lost, and not named");
  } catch(const Input_error& error) {
    require(!std::string(error.what()).empty(), "an error without text");
  }
}

} // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  using namespace fuzz;
  Bytes bytes(data, size);
  const bool repair = bytes.below(4) > 0;
  make_mesh(model_of(bytes), repair);
  return 0;
}
