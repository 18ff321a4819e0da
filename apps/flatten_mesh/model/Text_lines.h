// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXT_LINES_H
#define FLATTEN_MESH_TEXT_LINES_H

#include <CGAL/Texture_atlas/internal/files/text_lines.h>

namespace flatten_mesh {

using CGAL::Texture_atlas::internal::Text_lines;

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXT_LINES_H
