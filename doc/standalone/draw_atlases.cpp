// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws OBJ files with texture coordinates: each surface from one side, and its atlas.
// Prints a line of JSON for each, with the topology of the repaired surface. `scripts/gallery` calls it.

#include "draw_tile.h"

#include "pictures/textured_atlas.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Texture_atlas/internal/files/read_obj_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/given_seams.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>

#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pictures {

namespace PMP = CGAL::Polygon_mesh_processing;

Surface_soup read_soup(const std::string& file)
{
  std::ifstream in(file);
  CGAL::Texture_atlas::internal::Obj_soup given;
  if(const auto report = CGAL::Texture_atlas::internal::read_obj_soup(in, given); !report) {
    throw std::runtime_error(file + ": " + report.message);
  }
  Surface_soup soup;
  for(const auto& [x, y, z] : given.points) {
    soup.points.emplace_back(x, y, z);
  }
  for(const auto& [u, v] : given.coordinates) {
    soup.texture.emplace_back(u, v);
  }
  soup.vertices.assign(given.vertices.begin(), given.vertices.end());
  soup.first_corners.assign(given.first_corners.begin(), given.first_corners.end());
  for(const std::size_t t : given.corner_coordinates) {
    soup.corner_texture.push_back(t == given.none ? no_index : static_cast<Index>(t));
  }
  return soup;
}

// The charts that the texture coordinates of a file form: parts that are connected without crossing a seam
Atlas atlas_in_file(const Surface_soup& soup, Prepared_surface& surface)
{
  Mesh& mesh = surface.mesh;
  const Atlas atlas = empty_atlas(mesh);
  const std::vector<bool> seams = texture_seams(soup, mesh, surface.origins);
  for(const Edge e : mesh.edges()) {
    atlas.seams[e] = seams[e.idx()];
  }
  PMP::connected_components(mesh, atlas.chart, CGAL::parameters::edge_is_constrained_map(atlas.seams));
  for(const Halfedge h : mesh.halfedges()) {
    if(mesh.is_border(h)) {
      continue;
    }
    const Index t = soup.texture_point(surface.origins.corners[h.idx()]);
    if(t == no_index) {
      atlas.chart[mesh.face(h)] = -1;
    } else {
      atlas.uv[h] = soup.texture[t];
    }
  }
  return atlas;
}

// Of all components together
std::string topology_json(Mesh& mesh)
{
  std::vector<Halfedge> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  const auto component = mesh.add_property_map<Face, std::size_t>("f:component").first;
  const long components = static_cast<long>(PMP::connected_components(mesh, component)),
             holes = static_cast<long>(borders.size());
  long vertices = 0;
  for(const Vertex v : mesh.vertices()) {
    vertices += mesh.is_isolated(v) ? 0 : 1;
  }
  const long characteristic =
      vertices - static_cast<long>(mesh.number_of_edges()) + static_cast<long>(mesh.number_of_faces());
  return "{\"components\": " + std::to_string(components) + ", \"borders\": " + std::to_string(holes) +
         ", \"handles\": " + std::to_string((2 * components - holes - characteristic) / 2) + "}";
}

// Three numbers with commas between them
Kernel::Vector_3 direction(const std::string& text)
{
  std::istringstream stream(text);
  double x, y, z;
  char first, second;
  if(!(stream >> x >> first >> y >> second >> z) || first != ',' || second != ',') {
    throw std::invalid_argument("'" + text + "' is no direction: write X,Y,Z");
  }
  return {x, y, z};
}

// A file of the command line: its name, the direction towards the eye, and what is upwards
struct Request
{
  std::string file;
  Surface_view view;
};

struct Layout
{
  int size; // of a square tile, in pixels
  bool is_row;
  static constexpr int margin = 8;

  Frame frame(const int column, const int row) const
  {
    return {column * size + double(margin), row * size + double(margin), size - 2. * margin,
            size - 2. * margin};
  }
};

// In a row, each atlas is below its surface; otherwise the only one is to the right.
std::string picture_of(const std::vector<Request>& requests, const Layout& layout)
{
  const int columns = layout.is_row ? static_cast<int>(requests.size()) : 2, rows = layout.is_row ? 2 : 1;
  const double squares = 20;
  Canvas canvas(columns * layout.size, rows * layout.size);
  for(int i = 0; i < static_cast<int>(requests.size()); ++i) {
    const Request& request = requests[static_cast<std::size_t>(i)];
    Notes notes;
    const Surface_soup soup = read_soup(request.file);
    Prepared_surface prepared = prepare_surface(soup, {true, {Welding::ALL, 0}, {}}, notes);
    const Textured_surface surface = textured_atlas(prepared.mesh, atlas_in_file(soup, prepared));
    const double side = side_of_squares(surface, squares);
    draw_textured_surface(canvas, surface, side, request.view, layout.frame(i, 0));
    draw_atlas_square(canvas, surface, side, layout.is_row ? layout.frame(i, 1) : layout.frame(1, 0));
    std::cout << topology_json(prepared.mesh) << std::endl;
  }
  const int levels = 25; // of a colour
  return canvas.png(levels);
}

void run(const std::vector<std::string>& arguments)
{
  if(arguments.size() < 6 || arguments.size() % 3 != 0 || (arguments[0] != "row" && arguments.size() != 6)) {
    throw std::invalid_argument("usage: draw_atlases row|pair PICTURE.png SIZE (FILE TOWARDS_EYE UP)...");
  }
  std::vector<Request> requests;
  for(std::size_t i = 3; i < arguments.size(); i += 3) {
    requests.push_back(
        {arguments[i], Surface_view(direction(arguments[i + 1]), direction(arguments[i + 2]))});
  }
  const std::string png = picture_of(requests, {std::stoi(arguments[2]), arguments[0] == "row"});
  std::ofstream file(arguments[1], std::ios::binary);
  if(!file.write(png.data(), static_cast<std::streamsize>(png.size()))) {
    throw std::runtime_error("cannot write " + arguments[1]);
  }
}

} // namespace pictures

int main(int argc, char* argv[])
{
  try {
    pictures::run({argv + 1, argv + argc});
  } catch(const std::exception& error) {
    std::cerr << "draw_atlases: " << error.what() << '\n';
    return 1;
  }
}
