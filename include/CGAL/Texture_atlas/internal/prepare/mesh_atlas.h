// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MESH_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MESH_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_atlas_builder.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/prepare/Triangulated_copy.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <deque>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

template <typename Range>
using Element_of = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

template <typename Range>
std::size_t size_of(const Range& range)
{
  return static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
}

namespace prepare {

// One atlas of any meshes, with property maps of each. Polygons are divided in copies.
template <typename MeshRange, typename SeamMaps, typename UVMaps, typename ChartMaps,
          typename NamedParameters>
Mesh_report<Element_of<MeshRange>, Atlas_report>
make_atlas_of_polygon_meshes(const MeshRange& meshes, const SeamMaps& seams, const UVMaps& uv,
                             const ChartMaps& charts, const Atlas_options& options, const NamedParameters& np)
{
  typedef Element_of<MeshRange> PolygonMesh;
  typedef typename boost::property_traits<Element_of<UVMaps>>::value_type Point;
  Mesh_report<PolygonMesh, Atlas_report> report;
  if(options.given_charts != Atlas_options::REPLACE && !is_readable<Element_of<UVMaps>>) {
    report.status = Diagnosis::WRONG_OPTION;
    report.message = unreadable_text;
    return report;
  }
  std::deque<Triangulated_copy<PolygonMesh>> copies;
  std::vector<Mapped_mesh*> pointers;
  auto seam_map = std::begin(seams);
  auto uv_map = std::begin(uv);
  for(const PolygonMesh& mesh : meshes) {
    copies.emplace_back(mesh, np);
    copies.back().read(*seam_map++, *uv_map++, options.given_charts != Atlas_options::REPLACE);
    pointers.push_back(&copies.back());
  }
  const Report_on_atlas of_copies =
      make_atlas_of_mapped_meshes(pointers, options, linear_solvers(np), &round_to_points<Point>);
  static_cast<Atlas_report&>(report) = of_copies;
  for(Atlas_report::Skipped& part : report.skipped)
    copies[part.mesh].translate_part(part);
  if(copies.size() == 1) // elements of several meshes are not named
    copies.front().translate(of_copies, report);
  if(report.has_atlas()) {
    seam_map = std::begin(seams);
    uv_map = std::begin(uv);
    auto chart_map = std::begin(charts);
    for(const auto& copy : copies)
      copy.write(*seam_map++, *uv_map++, *chart_map++);
  }
  return report;
}

} // namespace prepare

// One atlas of meshes, with property maps of each
template <typename MeshRange, typename SeamMaps, typename UVMaps, typename ChartMaps,
          typename NamedParameters>
Mesh_report<Element_of<MeshRange>, Atlas_report>
atlas_of_meshes(const MeshRange& meshes, const SeamMaps& seams, const UVMaps& uv, const ChartMaps& charts,
                const Atlas_options& options, const NamedParameters& np)
{
  for(const auto& mesh : meshes)
    if(!is_triangle_mesh(mesh))
      return prepare::make_atlas_of_polygon_meshes(meshes, seams, uv, charts, options, np);
  Mesh_atlas_builder<Element_of<MeshRange>, Element_of<SeamMaps>, Element_of<UVMaps>, Element_of<ChartMaps>,
                     NamedParameters>
      builder(options, linear_solvers(np));
  auto seam_map = std::begin(seams);
  auto uv_map = std::begin(uv);
  auto chart_map = std::begin(charts);
  for(const auto& mesh : meshes)
    builder.add(mesh, *seam_map++, *uv_map++, *chart_map++, np);
  return builder.run();
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
  return atlas_of_meshes(meshes, seams, uv, charts, options, np);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MESH_ATLAS_H
