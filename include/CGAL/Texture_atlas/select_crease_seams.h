// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SELECT_CREASE_SEAMS_H
#define CGAL_TEXTURE_ATLAS_SELECT_CREASE_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Texture_atlas/Crease_report.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Texture_atlas/internal/seams/apply_seams.h>
#include <CGAL/Texture_atlas/internal/seams/crease_division.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_type_config.h>

#include <cstddef>
#include <string>
#include <utility>

/// \file select_crease_seams.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

divides a surface along its creases, as a hard surface is cut by hand: flat faces stay whole, a cylinder is cut around
its rims, and the faces of a cube unfold to a cross.

Creases divide the surface into patches. A crease that ends within a patch is no seam. Bent patches of less than 0.5 % of
the area of a component become parts of a larger bent patch beside them. Patches that unfold without
stretch are then joined along chains of edges that are equal in both plane layouts, the longest chains first, where the
union does not overlap itself and can be packed: it is no long strip, and fills 60 % of its convex hull, or as much as
one of both patches. Flat patches with holes stay apart, because `make_atlas()` keeps them whole.

The parts are of any topology: a mantle of a cylinder has two borders. `make_atlas()` and `select_seams()` cut them
further, and keep these seams. Give them the weights of `compute_crease_weights()`, so that further seams follow
creases too.

Patches are found and laid out in \cgalBigO{n \log n} time for \f$n\f$ triangles. An attempt to join two patches takes
linear time in their triangles.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param seams the seams: marked edges stay seams, and new seams are marked; unchanged if anything is wrong
\param options the options
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must not become seams}
    \cgalParamType{a model of `ReadablePropertyMap` with `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the patches, and what is wrong, if anything

\sa `make_atlas()`
\sa `compute_crease_weights()`
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Crease_report>
select_crease_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                    const Crease_options& options = Crease_options(),
                    const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  Mesh_report<TriangleMesh, Crease_report> report;
  if(!(options.angle > 0 && options.angle < CGAL_PI)) {
    report.status = Diagnosis::WRONG_OPTION;
    report.message =
        "the angle of a crease is " + std::to_string(options.angle) + ", and must be above 0 and below pi";
    return report;
  }
  double area = 0, flat_area = 0;
  internal::Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np, true);
  const auto applied = application.run([&](const internal::Surface_part& part) {
    internal::Crease_division division = internal::divide_at_creases(part.chart, part.cost, options.angle);
    report.number_of_patches += division.number_of_patches;
    area += division.area;
    flat_area += division.flat_area;
    report.is_developable = report.is_developable && division.is_developable();
    internal::Seams result;
    result.is_seam = std::move(division.is_seam);
    return result;
  });
  static_cast<Report&>(report) = applied;
  report.offending_vertices = applied.offending_vertices;
  report.offending_edges = applied.offending_edges;
  report.offending_faces = applied.offending_faces;
  report.number_of_parts = applied.number_of_disks;
  report.flat_share = area > 0 ? flat_area / area : 0;
  report.seam_length = applied.seam_length;
  report.relative_seam_length = applied.relative_seam_length;
  return report;
}

/// \ingroup PkgTextureAtlasRef
///
/// selects seams as above, with the default options.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Mesh_report<TriangleMesh, Crease_report> select_crease_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                             const CGAL_NP_CLASS& np)
{
  return select_crease_seams(mesh, seams, Crease_options(), np);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_SELECT_CREASE_SEAMS_H
