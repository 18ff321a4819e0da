// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_PARAMETERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>

/// \file packing_parameters.h

namespace CGAL {

#ifndef DOXYGEN_RUNNING
namespace internal_np {

enum packing_resolution_t
{
  packing_resolution
};
enum packing_gutter_t
{
  packing_gutter
};
enum packing_rotations_t
{
  packing_rotations
};
enum packing_face_weight_t
{
  packing_face_weight
};

} // namespace internal_np
#endif

namespace parameters {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `pack_charts()` the number of texels along a side of the unit square, from 1 to 32768. `np` are further named
/// parameters; those of \cgal may follow after a dot as well.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<int, internal_np::packing_resolution_t, NamedParameters>
resolution(int texels, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<int, internal_np::packing_resolution_t, NamedParameters>(texels, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `pack_charts()` the number of texels that are free between two charts, from 0 to 1024. `np` is as for `resolution()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<int, internal_np::packing_gutter_t, NamedParameters>
gutter(int texels, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<int, internal_np::packing_gutter_t, NamedParameters>(texels, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `pack_charts()` the number of directions in which large charts are tried, from 1 to 1024. `np` is as for `resolution()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<int, internal_np::packing_rotations_t, NamedParameters>
number_of_rotations(int number, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<int, internal_np::packing_rotations_t, NamedParameters>(number, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `pack_charts()` the weights of faces: a model of `ReadablePropertyMap` with numbers that are not negative. Where a chart has the
/// weight 2, it has twice as many texels along each length. `np` is as for `resolution()`.
template <typename FaceWeightMap, typename NamedParameters = Default_named_parameters>
Named_function_parameters<FaceWeightMap, internal_np::packing_face_weight_t, NamedParameters>
face_weight_map(FaceWeightMap weights, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<FaceWeightMap, internal_np::packing_face_weight_t, NamedParameters>(
      weights, np);
}

} // namespace parameters

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_PARAMETERS_H
