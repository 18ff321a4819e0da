// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_ADD_NOISE_H
#define BENCHMARKS_COMMON_ADD_NOISE_H

#include "read_mesh.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_on_sphere.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace benchmarks {

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

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_ADD_NOISE_H
