// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes the ranges of `make_common_atlas()` apart. Included by `make_atlas.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_COMMON_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_COMMON_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_atlas_builder.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Texture_atlas::internal {

template <typename Range>
using Element_of = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

template <typename Range>
std::size_t size_of(const Range& range)
{
  return static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
}

// Whether a parameter is a map of one mesh, and therefore none of several
template <typename NamedParameters>
inline constexpr bool has_maps_of_a_mesh =
    !(parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::edge_weight_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::face_size_map_t>::value &&
      parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value);

template <typename MeshRange, typename SeamMaps, typename UVMaps, typename ChartMaps,
          typename NamedParameters>
Atlas_report common_atlas(const MeshRange& meshes, const SeamMaps& seams, const UVMaps& uv,
                          const ChartMaps& charts, const Atlas_options& options, const NamedParameters& np)
{
  static_assert(!has_maps_of_a_mesh<NamedParameters>, "property maps as named parameters belong to one mesh");
  Atlas_report report;
  for(const std::size_t maps : {size_of(seams), size_of(uv), size_of(charts)})
    if(maps != size_of(meshes)) {
      report.status = Diagnosis::WRONG_OPTION;
      report.message = "there are " + std::to_string(size_of(meshes)) + " meshes, but " +
                       std::to_string(maps) + " property maps";
      return report;
    }
  Mesh_atlas_builder<Element_of<MeshRange>, Element_of<SeamMaps>, Element_of<UVMaps>, Element_of<ChartMaps>,
                     NamedParameters>
      builder(options, np);
  auto seam_map = std::begin(seams);
  auto uv_map = std::begin(uv);
  auto chart_map = std::begin(charts);
  for(const auto& mesh : meshes)
    builder.add(mesh, *seam_map++, *uv_map++, *chart_map++);
  return builder.run();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_COMMON_ATLAS_H
