// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>

/// \file atlas_parameters.h

namespace CGAL {

#ifndef DOXYGEN_RUNNING
namespace internal_np {

enum atlas_seam_map_t
{
  atlas_seam_map
};
enum atlas_chart_map_t
{
  atlas_chart_map
};
enum atlas_area_weight_t
{
  atlas_area_weight
};
enum atlas_separates_t
{
  atlas_separates
};
enum atlas_cuts_necks_t
{
  atlas_cuts_necks
};
enum atlas_equal_seams_t
{
  atlas_equal_seams
};
enum atlas_packs_t
{
  atlas_packs
};
enum atlas_diagonals_t
{
  atlas_diagonals
};
enum atlas_threads_t
{
  atlas_threads
};
enum atlas_visitor_t
{
  atlas_visitor
};

} // namespace internal_np
#endif

namespace parameters {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `make_atlas()` the seams: a model of `ReadWritePropertyMap` with edges as keys and `bool` as value type. Those that are marked
/// stay seams, and new ones are marked. `np` are further named parameters; those of \cgal may follow after a dot as well.
template <typename EdgeIsSeamMap, typename NamedParameters = Default_named_parameters>
Named_function_parameters<EdgeIsSeamMap, internal_np::atlas_seam_map_t, NamedParameters>
edge_is_seam_map(EdgeIsSeamMap seams, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<EdgeIsSeamMap, internal_np::atlas_seam_map_t, NamedParameters>(seams, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `make_atlas()` a map for the number of each face's chart: a model of `WritablePropertyMap` with faces as keys and a signed integer
/// as value type. Faces without a chart get -1. `np` is as for `edge_is_seam_map()`.
template <typename FaceChartMap, typename NamedParameters = Default_named_parameters>
Named_function_parameters<FaceChartMap, internal_np::atlas_chart_map_t, NamedParameters>
face_chart_map(FaceChartMap charts, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<FaceChartMap, internal_np::atlas_chart_map_t, NamedParameters>(charts, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `make_atlas()` the weight of areas in injective maps (`Flattening_options::area_weight`): a number from 0 to 1. `np` is as for
/// `edge_is_seam_map()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<double, internal_np::atlas_area_weight_t, NamedParameters>
area_weight(double weight, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<double, internal_np::atlas_area_weight_t, NamedParameters>(weight, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `make_atlas()` whether to cut maps of ABF++ that overlap themselves into several charts, instead of making one injective map.
/// `np` is as for `edge_is_seam_map()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<bool, internal_np::atlas_separates_t, NamedParameters>
separate_overlaps(bool separates, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<bool, internal_np::atlas_separates_t, NamedParameters>(separates, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `make_atlas()` whether to cut branches of charts off, along chords that are shorter than the square root of the area that they cut off.
/// The charts then cover more of the square. `np` is as for `edge_is_seam_map()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<bool, internal_np::atlas_cuts_necks_t, NamedParameters>
cut_necks(bool cuts, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<bool, internal_np::atlas_cuts_necks_t, NamedParameters>(cuts, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `make_atlas()` whether both sides of each edge on a seam within a chart get the same length in the plane, as by
/// `ABF_plus_plus_options::equal_seam_lengths`. That goes for the maps that ABF++ makes directly, and the pieces that are cut out of them, and
/// not for hierarchical and injective ones. Where the solver does not reach equal lengths, the chart is mapped without them;
/// `Atlas_report::Chart::seam_lengths` says so. `np` is as for `edge_is_seam_map()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<bool, internal_np::atlas_equal_seams_t, NamedParameters>
equal_seam_lengths(bool equal, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<bool, internal_np::atlas_equal_seams_t, NamedParameters>(equal, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `make_atlas()` whether to pack the charts into the unit square. `np` is as for `edge_is_seam_map()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<bool, internal_np::atlas_packs_t, NamedParameters>
pack_into_square(bool packs, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<bool, internal_np::atlas_packs_t, NamedParameters>(packs, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// tells `make_atlas()` which edges divide larger polygons into triangles: a model of `ReadablePropertyMap` with edges as keys and `bool` as
/// value type. Other programs draw polygons as fans from any corner. So that these triangles do not overlap, vertices inside of charts are
/// moved a little where polygons are not strictly convex in the plane, as far as that helps (`Atlas_report::number_of_mended_polygons`).
/// `np` is as for `edge_is_seam_map()`.
template <typename EdgeIsDiagonalMap, typename NamedParameters = Default_named_parameters>
Named_function_parameters<EdgeIsDiagonalMap, internal_np::atlas_diagonals_t, NamedParameters>
edge_is_diagonal_map(EdgeIsDiagonalMap diagonals, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<EdgeIsDiagonalMap, internal_np::atlas_diagonals_t, NamedParameters>(
      diagonals, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `make_atlas()` the number of threads, as `Flattening_options::threads`. `np` is as for `edge_is_seam_map()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<int, internal_np::atlas_threads_t, NamedParameters>
number_of_threads(int threads, const NamedParameters& np = NamedParameters())
{
  return Named_function_parameters<int, internal_np::atlas_threads_t, NamedParameters>(threads, np);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives `make_atlas()` a visitor. `np` is as for `edge_is_seam_map()`.
template <typename NamedParameters = Default_named_parameters>
Named_function_parameters<std::reference_wrapper<Surface_mesh_parameterization::Atlas_visitor>,
                          internal_np::atlas_visitor_t, NamedParameters>
atlas_visitor(Surface_mesh_parameterization::Atlas_visitor& visitor,
              const NamedParameters& np = NamedParameters())
{
  typedef std::reference_wrapper<Surface_mesh_parameterization::Atlas_visitor> Visitor;
  return Named_function_parameters<Visitor, internal_np::atlas_visitor_t, NamedParameters>(std::ref(visitor),
                                                                                           np);
}

} // namespace parameters

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERS_H
