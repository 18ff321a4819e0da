// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_TEST_MESHES_H
#define HIERARCHICAL_TEST_MESHES_H

#include "Command_line.h"
#include "Runner.h"

#include "../common/Temporary_folder.h"
#include "../common/resize_mesh.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_on_sphere.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace hierarchical {

typedef benchmarks::Mesh Mesh;

inline void write_mesh(const Mesh& mesh, const std::string& file)
{
  if(!CGAL::IO::write_polygon_mesh(file, mesh, CGAL::parameters::use_binary_mode(true))) {
    throw std::runtime_error("cannot write '" + file + "'");
  }
}

// Moves every vertex by a tenth of its shortest edge, so that subdivided meshes do not have regular angles only.
inline void add_noise(Mesh& mesh)
{
  boost::random::mt19937 generator; // the same noise in every run
  boost::random::uniform_on_sphere<double> direction(3);
  const Mesh smooth = mesh;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    double shortest = (std::numeric_limits<double>::max)();
    for(const Mesh::Vertex_index w : vertices_around_target(smooth.halfedge(v), smooth)) {
      shortest = (std::min)(shortest, CGAL::squared_distance(smooth.point(v), smooth.point(w)));
    }
    const std::vector<double> d = direction(generator);
    const Mesh::Point::R::Vector_3 noise(d[0], d[1], d[2]);
    mesh.point(v) = smooth.point(v) + std::sqrt(shortest) / 10 * noise;
  }
}

// A mesh of about so many triangles in a temporary file, made from the mesh of the command line
inline std::string resized_mesh(const Command_line& command, const Temporary_folder& folder,
                                const std::size_t triangles, const bool noise = false)
{
  Mesh mesh = resize_mesh(read_mesh(command.mesh), triangles);
  if(noise) {
    add_noise(mesh);
  }
  const std::string file = folder.file(name_of_file(command.mesh) + "_" +
                                       std::to_string((mesh.number_of_faces() + 500) / 1000) + "k.ply");
  write_mesh(mesh, file);
  return file;
}

} // namespace hierarchical

#endif // HIERARCHICAL_TEST_MESHES_H
