// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_TEST_MESHES_H
#define ANGLE_BASED_FLATTENING_TEST_MESHES_H

#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <cmath>
#include <cstddef>
#include <random>

// Meshes for tests of functions on meshes.
namespace test_meshes {

// A bump over n times n cells.
template <typename Mesh>
void make_bump(int n, Mesh& mesh)
{
  typedef typename boost::property_traits<
      typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type Point;
  std::mt19937 random(n);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  CGAL::make_grid(
      n, n, mesh,
      [&](std::size_t i, std::size_t j) {
        const double x = (i + jitter(random)) / n, y = (j + jitter(random)) / n;
        return Point(x, y, std::exp(-8 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5))));
      },
      true);
}

// The only border of a mesh.
template <typename Mesh>
typename boost::graph_traits<Mesh>::halfedge_descriptor border(const Mesh& mesh)
{
  for(auto h : halfedges(mesh))
    if(CGAL::is_border(h, mesh))
      return h;
  return boost::graph_traits<Mesh>::null_halfedge();
}

template <typename Mesh>
Mesh bump(int n)
{
  Mesh mesh;
  make_bump(n, mesh);
  return mesh;
}

} // namespace test_meshes

#endif // ANGLE_BASED_FLATTENING_TEST_MESHES_H
