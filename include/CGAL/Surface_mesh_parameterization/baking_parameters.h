// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_PARAMETERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>

/// \file baking_parameters.h

namespace CGAL {

#ifndef DOXYGEN_RUNNING
namespace internal_np {

enum baking_distance_t
{
  baking_distance
};
enum baking_object_space_t
{
  baking_object_space
};
enum baking_frame_map_t
{
  baking_frame_map
};

} // namespace internal_np
#endif

namespace parameters {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `bake_surface()` the largest distance between the simple and the fine surface, in units of the surface, on both sides: a number above 0.
/// `np` are further named parameters; those of \cgal may follow after a dot as well.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<double, internal_np::baking_distance_t, NamedParameters>
ray_length(double distance, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<double, internal_np::baking_distance_t, NamedParameters>(distance, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `bake_surface()` whether the normals are in the coordinates of the surface, instead of the tangent space. `np` is as for
/// `ray_length()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<bool, internal_np::baking_object_space_t, NamedParameters>
normals_in_object_space(bool in_object_space, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<bool, internal_np::baking_object_space_t, NamedParameters>(in_object_space,
                                                                                              np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `bake_surface()` a map for the directions at each corner, to which normals in tangent space refer: a model of `WritablePropertyMap` with
/// halfedges as keys and `Surface_mesh_parameterization::Tangent_frame` as value type. A halfedge gets the frame at its target in its face. `np` is as
/// for `ray_length()`.
template <typename TangentFrameMap, typename NamedParameters = Default_named_parameters>
Named_function_parameters<TangentFrameMap, internal_np::baking_frame_map_t, NamedParameters>
tangent_frame_map(TangentFrameMap frames, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<TangentFrameMap, internal_np::baking_frame_map_t, NamedParameters>(frames,
                                                                                                      np);
}

} // namespace parameters

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_PARAMETERS_H
