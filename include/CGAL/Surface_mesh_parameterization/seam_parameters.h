// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_PARAMETERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>

/// \file seam_parameters.h

namespace CGAL {

#ifndef DOXYGEN_RUNNING
namespace internal_np {

enum stretch_bound_t
{
  stretch_bound
};
enum maximum_number_of_terminals_t
{
  maximum_number_of_terminals
};
enum seam_edge_weight_t
{
  seam_edge_weight
};
enum seam_terminals_t
{
  seam_terminals
};

} // namespace internal_np
#endif

namespace parameters {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `select_seams()` the largest \f$L_2\f$ stretch that it may predict: a number of at least 1. `np` are further named
/// parameters; those of \cgal may follow after a dot as well.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<double, internal_np::stretch_bound_t, NamedParameters>
stretch_bound(double bound, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<double, internal_np::stretch_bound_t, NamedParameters>(bound, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `select_seams()` the largest number of terminals of each part of the surface. `np` is as for `stretch_bound()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<int, internal_np::maximum_number_of_terminals_t, NamedParameters>
maximum_number_of_terminals(int number, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<int, internal_np::maximum_number_of_terminals_t, NamedParameters>(number,
                                                                                                     np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `cut_to_disks()`, `select_seams()` and `shorten_seams()` the weights of edges, which are lengths otherwise: a model of
/// `ReadablePropertyMap` with numbers that are not negative. `np` is as for `stretch_bound()`.
template <typename EdgeWeightMap, typename NamedParameters = Default_named_parameters>
Named_function_parameters<EdgeWeightMap, internal_np::seam_edge_weight_t, NamedParameters>
edge_weight_map(EdgeWeightMap weights, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<EdgeWeightMap, internal_np::seam_edge_weight_t, NamedParameters>(weights,
                                                                                                    np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `cut_to_disks()` the vertices that the seams have to reach, such as cones: a range of vertex descriptors, of which a copy is kept.
/// `np` is as for `stretch_bound()`.
template <typename VertexRange, typename NamedParameters = Default_named_parameters>
Named_function_parameters<VertexRange, internal_np::seam_terminals_t, NamedParameters>
terminals(const VertexRange& vertices, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<VertexRange, internal_np::seam_terminals_t, NamedParameters>(vertices, np);
}

} // namespace parameters

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_PARAMETERS_H
