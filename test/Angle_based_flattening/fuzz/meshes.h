// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_FUZZ_MESHES_H
#define ANGLE_BASED_FLATTENING_FUZZ_MESHES_H

#include "bytes.h"

#include <CGAL/Surface_mesh.h>

namespace fuzz {

typedef CGAL::Surface_mesh<Point_3> Mesh;

// Triangles between any points, made a mesh: with whatever components, handles and holes there are.
Mesh mesh_of_soup(Bytes& bytes);

// A triangle, and what a sequence of Euler operations makes of it: also parallel edges, vertices of degree 2, holes.
Mesh mesh_of_operations(Bytes& bytes);

} // namespace fuzz

#endif // ANGLE_BASED_FLATTENING_FUZZ_MESHES_H
