// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SPLIT_OVERLAPS_H
#define CGAL_TEXTURE_ATLAS_SPLIT_OVERLAPS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Texture_atlas/internal/overlaps/split_charts.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

/// \file split_overlaps.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

splits charts whose maps overlap themselves into pieces whose maps are injective. Coordinates do not change.

A chart is a connected piece of the surface between its seams. Its overlapping pairs of faces are found by bounding
boxes and exact predicates. Connected pairs form two *sheets*, one over the other. A minimum cut of the dual graph,
where the capacity of each edge is its weight, separates the sheets of the largest overlap (Boykov and Kolmogorov's
algorithm, from Boost.Graph). This is repeated for each piece until none of its faces overlap. An overlap that winds
around so far that its sheets have common faces is cut in several steps.

Each piece finally has an injective map, by the exact certificate of `is_injective()`. Pieces are connected; if a chart
is a disk, so are its pieces. A chart whose map is injective gets no seam.

For \f$n\f$ faces without overlap, the time is \cgalBigO{n \log n}. With \f$k\f$ pairs of overlapping faces, each cut
takes time \cgalBigO{(n + k) \log n} and a maximum flow on a planar graph with at most \f$n\f$ nodes; in practice, this
is less than the time to flatten the chart. Memory is linear in \f$n\f$. The result does not depend on the number of
threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam UVMap a model of `ReadablePropertyMap` with a two-dimensional point as value type, of any kernel whose number
        type is exact, or whose numbers `double` can hold. The key type is
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` or
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor`.
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam FaceChartMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param uv the coordinates: each halfedge stores those of its target in its face. Around a vertex, they must be the same
       from seam to seam. Coordinates of vertices suffice if no vertex has several places within a chart.
\param seams the seams: marked edges stay seams, and new seams are marked; unchanged if anything is wrong. Marked border
       edges are ignored.
\param charts receives the number of the piece of each face, from 0 on, in the order of the first faces of the pieces;
       unchanged if anything is wrong
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

\return the number of pieces, the length of the added seams, and what is wrong, if anything

\sa `overlapping_faces()`
*/
template <typename TriangleMesh, typename UVMap, typename EdgeIsSeamMap, typename FaceChartMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Overlap_split_report>
split_overlaps(const TriangleMesh& mesh, UVMap uv, EdgeIsSeamMap seams, FaceChartMap charts,
               const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  internal::Check_face_map<TriangleMesh, FaceChartMap>();
  return internal::Chart_splitter<TriangleMesh, EdgeIsSeamMap, UVMap, NamedParameters>(mesh, seams, uv, np)
      .run(charts);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_SPLIT_OVERLAPS_H
