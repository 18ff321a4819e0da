// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_PARTS_H
#define FLATTEN_MESH_PAGE_PARTS_H

namespace flatten_mesh {

// The page, which embed_page.cmake takes from the folder `page` when the program is built: its text before, between and
// behind the places of the title and of the data. In pieces, because compilers limit the length of literals; a null
// pointer is the end.
extern const char* const page_before_title[];
extern const char* const page_before_data[];
extern const char* const page_after_data[];

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_PARTS_H
