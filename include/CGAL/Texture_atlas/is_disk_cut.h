// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_IS_DISK_CUT_H
#define CGAL_TEXTURE_ATLAS_IS_DISK_CUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Texture_atlas/internal/seams/check_parts.h>

#include <cstddef>
#include <string>
#include <vector>

/// \file is_disk_cut.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// returns whether the seams cut the surface into topological disks that can be flattened, and if not, why and where.
///
/// The surface is opened along its seams. Its parts are the sets of faces that are connected across edges that are
/// neither seams nor border edges. Around a vertex, each sector of faces between seams or borders is a vertex of the
/// opened surface: a vertex where a seam ends has one sector, a vertex in the middle of a seam has two, and a pinched
/// vertex has one or more for each fan of faces. A seam may end anywhere, and may touch the border in a vertex. A
/// marked border edge is not a seam. If the result is `true`, then the parameterizers of this package accept each part
/// of `make_seam_mesh(mesh, seams)`, provided that coordinates are finite.
///
/// \code{.cpp}
/// if(const auto report = is_disk_cut(mesh, seams); !report)
///   std::cerr << report.message << "\n";
/// \endcode
///
/// Time and memory are linear in the size of the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`.
/// \tparam EdgeIsSeamMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type.
///
/// \param mesh the surface. Isolated vertices do not matter.
/// \param seams is `true` for the edges to be cut open.
///
/// \return a report that converts to `true` if all parts are disks that can be flattened
template <typename TriangleMesh, typename EdgeIsSeamMap>
Disk_cut_report<TriangleMesh> is_disk_cut(const TriangleMesh& mesh, EdgeIsSeamMap seams)
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  Disk_cut_report<TriangleMesh> report;
  if(faces(mesh).empty()) {
    report.status = Diagnosis::EMPTY_MESH;
    report.message = "the mesh has no faces";
    return report;
  }
  report.parts = internal::Part_checker<TriangleMesh>(mesh, seams).parts();
  report.defective_part = report.parts.size();
  for(std::size_t p = report.parts.size(); p-- > 0;)
    if(report.parts[p].status == Diagnosis::NOTHING_WRONG)
      ++report.number_of_disks;
    else
      report.defective_part = p;
  if(report.defective_part < report.parts.size()) {
    report.status = report.parts[report.defective_part].status;
    report.message = internal::message(report.parts[report.defective_part], mesh);
    internal::name_offenders(report.parts[report.defective_part], mesh, report);
  }
  return report;
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_IS_DISK_CUT_H
