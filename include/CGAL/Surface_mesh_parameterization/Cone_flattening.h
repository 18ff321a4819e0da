// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_FLATTENING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_FLATTENING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/Cone_selection.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_report.h>
#include <CGAL/Surface_mesh_parameterization/Seam_report.h>

#include <string>

/// \file Cone_flattening.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `flatten_with_cones()` reports. If anything is wrong, `status`, `message` and the offending elements are those
/// of the first part that failed.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
struct Cone_flattening : Mesh_report<TriangleMesh>
{
  Cone_selection<TriangleMesh> cones; ///< the cones with their angles
  Seam_report seams;                  ///< the seams through the cones
  ABF_plus_plus_report map;           ///< the map
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_FLATTENING_H
