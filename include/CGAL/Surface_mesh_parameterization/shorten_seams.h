// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SHORTEN_SEAMS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SHORTEN_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Mesh_report.h>
#include <CGAL/Surface_mesh_parameterization/Seam_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/apply_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/read_surface.h>

/// \file shorten_seams.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/*!
\ingroup PkgAngleBasedFlatteningRef

shortens seams that leave disks. The shorter seams leave disks as well.

The method is key-path exchange, as in `cut_to_disks()`. The ends of seams inside the surface do not move. Seams that
leave anything else than disks are shortened where a path has the same border on both sides.

Searches visit each vertex 100 times at most.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param seams which edges are seams; unchanged if anything is wrong
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
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{the cost of a seam along each edge}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the length of all seams, and what is wrong, if anything
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Seam_report> shorten_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                     const NamedParameters& np = parameters::default_values())
{
  namespace ABF = internal::ABF;
  ABF::Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np, false);
  return application.run([&](const ABF::Surface_part& part) {
    return ABF::shorten_seams(part.chart, part.cost, application.seams_of(part));
  });
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SHORTEN_SEAMS_H
