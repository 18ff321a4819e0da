// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_READ_MESH_H
#define BENCHMARKS_COMMON_READ_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <stdexcept>
#include <string>

namespace benchmarks {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

inline Mesh read_mesh(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    throw std::runtime_error("cannot read a triangle mesh from '" + file + "'");
  }
  return mesh;
}

inline void write_mesh(const Mesh& mesh, const std::string& file)
{
  if(!CGAL::IO::write_polygon_mesh(file, mesh, CGAL::parameters::use_binary_mode(true))) {
    throw std::runtime_error("cannot write '" + file + "'");
  }
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_READ_MESH_H
