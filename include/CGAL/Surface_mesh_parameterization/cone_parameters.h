// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_PARAMETERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/Cone_selection.h>

#include <CGAL/Named_function_parameters.h>

/// \file cone_parameters.h

namespace CGAL {

#ifndef DOXYGEN_RUNNING
namespace internal_np {

enum cone_angles_t
{
  cone_angles
};
enum cone_angle_quantum_t
{
  cone_angle_quantum
};
enum cones_are_free_t
{
  cones_are_free
};
enum cone_parameterizer_options_t
{
  cone_parameterizer_options
};

} // namespace internal_np
#endif

namespace parameters {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `select_cones()` and `flatten_with_cones()` how to find the angles of cones. `np` are further named parameters; those of \cgal may
/// follow after a dot as well.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<Surface_mesh_parameterization::Cone_angles, internal_np::cone_angles_t,
                          NamedParameters>
cone_angles(Surface_mesh_parameterization::Cone_angles angles, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<Surface_mesh_parameterization::Cone_angles, internal_np::cone_angles_t,
                                   NamedParameters>(angles, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// makes the angles of the cones of `select_cones()` and `flatten_with_cones()` multiples of an angle in radians, of which
/// \f$2\pi\f$ is a multiple. `np` is as for `cone_angles()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<double, internal_np::cone_angle_quantum_t, NamedParameters>
angle_quantum(double angle, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<double, internal_np::cone_angle_quantum_t, NamedParameters>(angle, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `flatten_with_cones()` whether the angle sums of all vertices on seams are free, and `select_cones()` whether the angles of cones
/// do not matter. `np` is as for `cone_angles()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<bool, internal_np::cones_are_free_t, NamedParameters>
free_cones(bool are_free, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<bool, internal_np::cones_are_free_t, NamedParameters>(are_free, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `flatten_with_cones()` the options of its parameterizer. `np` is as for `cone_angles()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<Surface_mesh_parameterization::ABF_plus_plus_options,
                          internal_np::cone_parameterizer_options_t, NamedParameters>
parameterizer_options(const Surface_mesh_parameterization::ABF_plus_plus_options& options,
                      const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<Surface_mesh_parameterization::ABF_plus_plus_options,
                                   internal_np::cone_parameterizer_options_t, NamedParameters>(options, np);
}

} // namespace parameters

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_PARAMETERS_H
