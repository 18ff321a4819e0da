// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_PAGE_H
#define FLATTEN_MESH_REPORT_PAGE_H

#include "flatten_mesh/report/Report_contents.h"

#include <string>

namespace flatten_mesh {

// The report as a page for browsers that refers to nothing outside of it. The same contents give the same page, with
// whatever number of threads. Surfaces of many triangles are thinned for display.
std::string report_page(const Report_contents& contents, int threads);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_PAGE_H
