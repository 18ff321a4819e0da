// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_PARTS_H
#define FLATTEN_MESH_PAGE_PARTS_H

namespace flatten_mesh {

// A page, which embed_page.cmake takes from a folder when the program is built: its text before, between and behind the
// places of the title and of the data. In pieces, because compilers limit the length of literals; a null pointer is the
// end.
struct Page_parts
{
  const char* const* before_title;
  const char* const* before_data;
  const char* const* after_data;
};

extern const Page_parts report_page_parts;  // from the folder `page`
extern const Page_parts summary_page_parts; // from the folder `summary_page`

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_PARTS_H
