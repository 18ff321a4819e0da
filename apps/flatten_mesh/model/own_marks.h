// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OWN_MARKS_H
#define FLATTEN_MESH_OWN_MARKS_H

namespace flatten_mesh {

// By these comments, the program knows its own files. Only in these, coordinates may stand for none: see
// `Model_obj_writer` and `Model_ply_writer`.
constexpr const char* first_obj_line = "# texture coordinates 'vt' by flatten_mesh";
constexpr const char* end_of_ply_comment = "by flatten_mesh";

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OWN_MARKS_H
