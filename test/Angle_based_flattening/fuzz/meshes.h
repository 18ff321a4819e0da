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

// A mesh of triangles between any points, with any components, handles and holes.
Mesh mesh_of_soup(Bytes& bytes);

// A triangle after a sequence of Euler operations. It may have parallel edges, vertices of degree 2, and holes.
Mesh mesh_of_operations(Bytes& bytes);

} // namespace fuzz

#endif // ANGLE_BASED_FLATTENING_FUZZ_MESHES_H
