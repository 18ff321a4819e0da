// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Texture_atlas/internal/baking/bake_impl.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option_impl.h>
#include <CGAL/Texture_atlas/internal/overlaps/separate_overlaps.h>
#include <CGAL/Texture_atlas/internal/packing/pack_impl.h>

namespace CGAL::Texture_atlas::internal {

template Separation separate_overlaps(const Chart&, const std::vector<double>&,
                                      const std::vector<Exact_point_2>&);

} // namespace CGAL::Texture_atlas::internal
