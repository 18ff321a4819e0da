// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What an edge costs as a seam, from the named parameters: its length or weight, or infinity if it is constrained.
// `apply_seams.h`, `overlaps/split_charts.h` and `atlas/mesh_atlas_builder.h` read costs by it, so that all follow the same
// parameters.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SEAM_COST_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SEAM_COST_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <limits>

// The named parameter `edge_weight_map`, which CGAL has from the version on that has this header
#if !__has_include(<CGAL/boost/graph/dijkstra_shortest_path.h>)
namespace CGAL {

namespace internal_np {

enum edge_weight_t
{
  edge_weight
};

} // namespace internal_np

namespace parameters {

template <typename EdgeWeightMap>
Named_function_parameters<EdgeWeightMap, internal_np::edge_weight_t>
edge_weight_map(const EdgeWeightMap& weights)
{
  return Named_function_parameters<EdgeWeightMap, internal_np::edge_weight_t>(weights);
}

} // namespace parameters

} // namespace CGAL
#endif

namespace CGAL::Texture_atlas::internal {

// What an edge of a given length costs as a seam, by the named parameters: its weight or length, and infinity if it
// must not be one.
template <typename Edge, typename NamedParameters>
auto seam_cost(const NamedParameters& np)
{
  using parameters::get_parameter;
  const auto is_constrained = parameters::choose_parameter(
      get_parameter(np, internal_np::edge_is_constrained), Static_boolean_property_map<Edge, false>());
  return [is_constrained, &np](const Edge& e, double length) {
    if(get(is_constrained, e))
      return (std::numeric_limits<double>::infinity)();
    (void)np; // not used without weights
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::edge_weight_t>::value)
      return length;
    else
      return static_cast<double>(get(get_parameter(np, internal_np::edge_weight), e));
  };
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SEAM_COST_H
