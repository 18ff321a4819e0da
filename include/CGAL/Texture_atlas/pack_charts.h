// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_PACK_CHARTS_H
#define CGAL_TEXTURE_ATLAS_PACK_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/packing/pack_mesh.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

/// \file pack_charts.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

turns, scales and moves charts so that they fill the unit square, as in a texture atlas. The map of each chart changes
by a similarity, without reflection.

The square is a *page* of `Packing_options::resolution`\f$^2\f$ *texels*. All charts get the same number of texels per
area in space, times their weights, and this number is as large as the search finds. Only long charts with hardly any
area get fewer (`Packing_report::scale_of_chart`). At least `Packing_options::gutter` texels are free between the texels
of two charts, in a row or in a column, and half as many, rounded up, at the border of the square. Charts are therefore
also apart where the texture is repeated. This is certified for the coordinates in the map, rounded to its number type:
all triangles are drawn, enlarged by a margin for rounding errors.

With `Packing_options::texels_per_unit`, there are as many pages as the charts take, and coordinates on page \f$k\f$ are
shifted by \f$(k \bmod 10, \lfloor k/10 \rfloor)\f$, as in UDIM. With `Packing_options::height`, pages are rectangles
of texels, and each chart changes by a similarity in texels: a page stays a unit square (Section \ref
ABF_packing_pages).

With `Packing_options::quantization_bits`, vertices then move to a grid (Section \ref ABF_packing_grid).

Section \ref ABF_packing_method explains how places are found. Above a resolution of 1024, charts are placed only at
every second, third, ... texel, so that the time hardly grows.

Within a chart, triangles may be flipped or overlap; see `is_injective()` and `split_overlaps()`. The similarity rounds
coordinates: a triangle that is less than about \f$10^{-16}\f$ wide in the unit square, or \f$10^{-7}\f$ with `float`,
may lose its orientation.

For \f$n\f$ faces, finding the outlines of the charts and certifying the result takes time and memory \cgalBigO{n}. The
result does not depend on the number of threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeGraph`
\tparam FaceChartMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and an integer as value type
\tparam HalfedgeUVMap a model of `ReadWritePropertyMap` with `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
        as key type and a two-dimensional point of any kernel as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh
\param charts the chart number of each face. Faces with a negative number are ignored, and keep their coordinates. The
       faces of a chart need not be connected.
\param uv the coordinates: a halfedge stores those of its target in its face; border halfedges are ignored. Unchanged if
       anything is wrong
\param options the options
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{face_size_map}
    \cgalParamDescription{relative texel density of each face. A chart gets the quadratic mean over its area.}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{1 for all faces}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the pages of the charts, the share of them that the charts cover, and what is wrong, if anything
*/
template <typename TriangleMesh, typename FaceChartMap, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Packing_report>
pack_charts(const TriangleMesh& mesh, FaceChartMap charts, HalfedgeUVMap uv,
            const Packing_options& options = Packing_options(),
            const NamedParameters& np = parameters::default_values())
{
  internal::Check_face_map<TriangleMesh, FaceChartMap>();
  internal::Check_halfedge_map<TriangleMesh, HalfedgeUVMap>();
  return internal::Chart_packer<TriangleMesh, FaceChartMap, HalfedgeUVMap, NamedParameters>(mesh, charts, uv,
                                                                                            options, np)
      .run();
}

/// \ingroup PkgTextureAtlasRef
///
/// packs charts as above, with the default options.
template <typename TriangleMesh, typename FaceChartMap, typename HalfedgeUVMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Mesh_report<TriangleMesh, Packing_report> pack_charts(const TriangleMesh& mesh, FaceChartMap charts,
                                                      HalfedgeUVMap uv, const CGAL_NP_CLASS& np)
{
  return pack_charts(mesh, charts, uv, Packing_options(), np);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_PACK_CHARTS_H
