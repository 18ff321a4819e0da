// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_FLATTENING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_FLATTENING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/Cone_selection.h>
#include <CGAL/Surface_mesh_parameterization/Seam_report.h>

#include <string>

/// \file Cone_flattening.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Which part of `flatten_with_cones()` failed.
enum class Cone_flattening_defect
{
  NOTHING_WRONG, ///< There is a map.
  CONES,         ///< There are no cones: `Cone_flattening::cones` tells why.
  SEAMS,         ///< No seams lead through the cones: `Cone_flattening::seams` tells why.
  MAP            ///< There is no map with these cones: `Cone_flattening::map` tells why.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a defect, such as `"CONES"`.
inline std::string to_string(Cone_flattening_defect defect)
{
  switch(defect) {
  case Cone_flattening_defect::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Cone_flattening_defect::CONES:
    return "CONES";
  case Cone_flattening_defect::SEAMS:
    return "SEAMS";
  case Cone_flattening_defect::MAP:
    return "MAP";
  }
  return "unknown";
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `flatten_with_cones()` reports.
///
/// \tparam TriangleMesh a model of `FaceGraph` whose vertex descriptors are ordered by `<`
template <typename TriangleMesh>
struct Cone_flattening
{
  /// which part failed, if any
  Cone_flattening_defect diagnosis = Cone_flattening_defect::NOTHING_WRONG;

  std::string message; ///< what is wrong, for people; empty if nothing is

  Cone_selection<TriangleMesh> cones; ///< the cones with their angles
  Seam_report seams;                  ///< the seams through the cones
  ABF_plus_plus_report map;           ///< the map
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_FLATTENING_H
