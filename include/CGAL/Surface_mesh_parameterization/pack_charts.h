// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PACK_CHARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PACK_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Packing_options.h>
#include <CGAL/Surface_mesh_parameterization/Packing_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/pack_mesh.h>

/// \file pack_charts.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/*!
\ingroup PkgAngleBasedFlatteningRef

turns, scales and moves charts so that they fill the unit square, as a texture atlas. Charts are not mirrored, and the
maps of the charts stay as they are up to a similarity.

The square has `Packing_options::resolution`\f$^2\f$ *texels*. All charts get the same number of texels for their area
in space, or as many as the weights of the faces say, and the largest number is searched for which all charts fit. Then
a texel that one chart touches, and a texel that another one touches, have at least `Packing_options::gutter` texels
between them, in a row or in a column; next to the border of the square, half as many, rounded up, are free. So charts
have the gutter between them also where the texture is repeated. This is certified for the coordinates as they are in
the map, rounded to its number type: all triangles are drawn, and rounding errors make them larger only.

Charts are sets of texels. They come by the areas of their convex hulls, the largest first, and each is put where its
upper end is lowest; all places are tried, 64 at a time, also those within the holes and between the branches of other
charts. Charts of at least 2 % of the area are tried in `Packing_options::number_of_rotations` directions and that of
their smallest enclosing square, others in the four of their smallest enclosing rectangle. Charts of less than 0.2 % are
not tried in rows where a chart of about the same size had no place just before. The report counts these charts. Several
rules of placement are tried, the fewer the more charts there are. With a resolution above 1024, charts are put at every
second, third, ... texel.

Within a chart, triangles may be mirrored or overlap; `is_injective()` and `split_overlaps()` deal with that. A
similarity rounds the coordinates: what is less than about \f$10^{-16}\f$ wide in the unit square, or \f$10^{-7}\f$ with
`float`, may lose its orientation.

For \f$n\f$ faces, it takes time and memory \cgalBigO{n} to find the outlines of the charts, and to certify the result.
The result does not depend on the number of threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeGraph`
\tparam FaceChartMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer as value type
\tparam HalfedgeUVMap a model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
        as key type and a two-dimensional point of any kernel as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh
\param charts the number of each face's chart. A face with a negative number has none: it is ignored, and its
       coordinates stay as they are. Faces of a chart need not be connected.
\param uv the coordinates. A halfedge of a face has those of its target at that face; those of border halfedges are not
       used. Unchanged if anything is wrong
\param options the options
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{face_size_map}
    \cgalParamDescription{how many texels a length on each face gets, in proportion. A chart has the quadratic mean of
    its faces, by area.}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{1 for all faces}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what is wrong, if anything, and what share of the square the charts cover
*/
template <typename TriangleMesh, typename FaceChartMap, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Packing_report pack_charts(const TriangleMesh& mesh, FaceChartMap charts, HalfedgeUVMap uv,
                           const Packing_options& options = Packing_options(),
                           const NamedParameters& np = parameters::default_values())
{
  return internal::ABF::Chart_packer<TriangleMesh, FaceChartMap, HalfedgeUVMap, NamedParameters>(
             mesh, charts, uv, options, np)
      .run();
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PACK_CHARTS_H
