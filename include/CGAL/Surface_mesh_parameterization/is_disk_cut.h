// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_IS_DISK_CUT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_IS_DISK_CUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Disk_cut_check.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/check_parts.h>

#include <cstddef>
#include <string>
#include <vector>

/// \file is_disk_cut.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns whether the seams cut the surface into topological disks that can be flattened, and if not why and where.
///
/// The surface is opened along its seams. Its parts are the sets of faces that are connected across edges that are
/// neither seams nor border edges. Around a vertex, each sector of faces between seams or borders is a vertex of the opened
/// surface: a vertex where a seam ends has one sector, a vertex in the middle of a seam has two, and a pinched vertex
/// has one or more for each fan of faces. A seam may end anywhere, and may touch the border in a vertex. A marked
/// border edge is no seam. If the result is `true`, then the parameterizers of this package accept
/// each part of `make_seam_mesh(mesh, seams)`, provided that coordinates are finite.
///
/// \code{.cpp}
/// if(const auto check = is_disk_cut(mesh, seams); !check)
///   std::cerr << check.message << "\n";
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
/// \return a check that is `true` if all parts are disks that can be flattened. Bad input is no
///         exception, but a defect.
template <typename TriangleMesh, typename EdgeIsSeamMap>
Disk_cut_check<TriangleMesh> is_disk_cut(const TriangleMesh& mesh, EdgeIsSeamMap seams)
{
  Disk_cut_check<TriangleMesh> check;
  if(faces(mesh).empty()) {
    check.defect = Disk_cut_defect::EMPTY_MESH;
    check.message = "the mesh has no faces";
    return check;
  }
  check.parts = internal::ABF::Part_checker<TriangleMesh>(mesh, seams).parts();
  check.defective_part = check.parts.size();
  for(std::size_t p = check.parts.size(); p-- > 0;)
    if(check.parts[p].defect == Disk_cut_defect::NOTHING_WRONG)
      ++check.number_of_disks;
    else
      check.defective_part = p;
  if(check.defective_part < check.parts.size()) {
    check.defect = check.parts[check.defective_part].defect;
    check.message = internal::ABF::message(check.parts[check.defective_part], mesh);
  }
  return check;
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_IS_DISK_CUT_H
