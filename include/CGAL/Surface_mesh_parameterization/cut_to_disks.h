// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CUT_TO_DISKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CUT_TO_DISKS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Mesh_report.h>
#include <CGAL/Surface_mesh_parameterization/Seam_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/apply_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/find_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/read_surface.h>

/// \file cut_to_disks.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/*!
\ingroup PkgAngleBasedFlatteningRef

cuts a surface of any topology to disks along short seams, without regard to its shape.

Borders are joined by shortest paths, in the manner of Mehlhorn's approximation of Steiner trees. Handles are cut along
the greedy homotopy basis of Erickson and Whittlesey (2005). Key-path exchange then shortens the seams: without one path
between two branches, the disk is an annulus, and the shortest path between the two borders of the annulus makes it a
disk again. A sphere is cut along a path between two vertices that are far from each other.

The seams reach all given vertices (`vertex_is_constrained_map`), and then have no other ends inside the surface: a
sphere with two or more given vertices is cut along a tree that joins them. Given vertices on borders and on given seams
count as reached.

Given seams remain seams, and count as borders. A seam of one edge on a sphere becomes longer, because a border of two
edges is not a polygon. To get disks that can be flattened with little stretch, call `select_seams()`.

For \f$n\f$ triangles and genus \f$g\f$, the time is \f$O(n \log n)\f$, and \f$O(g\,n\log n)\f$ for the exchanges, whose
searches visit each vertex at most 100 times.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param seams the seams: marked edges stay seams, and new seams are marked; unchanged if anything is wrong
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
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the vertices that seams must reach, such as cones}
    \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key
    type and `bool` as value type. `TriangleMesh` must then also be a model of `VertexListGraph`.}
    \cgalParamDefault{no vertex}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the length of all seams, and what is wrong, if anything. `Diagnosis::NO_CUT_ALLOWED` means that the edges that
may become seams leave no way to cut. `Diagnosis::WRONG_OPTION` means that a given vertex has no face.
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Seam_report> cut_to_disks(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                    const NamedParameters& np = parameters::default_values())
{
  namespace ABF = internal::ABF;
  ABF::Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np, true);
  Mesh_report<TriangleMesh, Seam_report> report;
  if(!ABF::can_reach_terminals(mesh, np, report))
    return report;
  return application.run([&](const ABF::Surface_part& part) {
    return ABF::find_topological_seams(part.chart, part.cost, application.terminals_of(part));
  });
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CUT_TO_DISKS_H
