// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Texture_atlas/internal/prepare/mesh_atlas.h>

namespace CGAL::Texture_atlas::internal::prepare {

template Mesh_report<Mesh, Atlas_report>
make_atlas_of_copies(const std::vector<Mapped_mesh<Kernel::Point_2>*>&, const Atlas_options&,
                     const Linear_solvers&);

} // namespace CGAL::Texture_atlas::internal::prepare
