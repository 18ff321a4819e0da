// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MAKE_ATLAS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MAKE_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_report.h>
#include <CGAL/Surface_mesh_parameterization/Atlas_visitor.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameters.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/atlas_maker.h>

/// \file make_atlas.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/*!
\ingroup PkgAngleBasedFlatteningRef

makes a texture atlas of any surface: cuts it open, flattens it without flips and overlaps, and packs the charts into the unit square.

Each connected part of the surface, of any genus and with any number of borders, is cut open to a disk along seams, as by `select_seams()`. ABF++ flattens the disk.
Disks of more than 20,000 triangles are flattened hierarchically. If the map overlaps itself, an injective one takes its place (`Flattening_options::injective`), so that
each part remains one chart; `parameters::separate_overlaps()` cuts it into several charts instead. If the map stretches by more than 3 % above
`stretch_bound`, as the long thin triangles of some models make it do, seams are added where it does, and the disk is flattened again, at most five times.
If an injective map still stretches that much, and that of ABF++ does not, the latter is separated. Where there is no map, or the chart is not good (`Atlas_report::Chart::is_good`), areas get a larger weight, and then the
part is divided into several charts; so is a chart that would leave most of the square empty. The report says which way was taken for each chart, and whether one is not good all the same.

Both sides of the seams within a chart, found or given, get equal lengths where ABF++ maps the part directly (see `parameters::equal_seam_lengths()`).

Then the charts are packed with equal texel density, as by `pack_charts()`, and certified: with the final coordinates, rounded to the number type of `uv`, each chart is
injective, by exact predicates, and no two charts share a texel with its gutter. A map of ABF++ whose final coordinates have too few digits for that is replaced by an injective one,
whose border keeps a distance from itself.

A part that cannot be flattened is skipped, and named in the report with the reason. Its coordinates are unchanged, and all other parts get charts. Nothing is
written if anything else is wrong.

For \f$n\f$ triangles, it takes time \cgalBigO{n \log n}, and the factorization of matrices of bounded size for each part. Parts are flattened side by side if the program is linked with
`CGAL::TBB_support`. The result does not depend on the number of threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam HalfedgeUVMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a two-dimensional point as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param uv receives the coordinates: a halfedge of a face has those of its target at that face. Border halfedges get none.
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_seam_map}
    \cgalParamDescription{the seams. Those that are marked are kept; new ones are marked (see `parameters::edge_is_seam_map()`)}
    \cgalParamType{a model of `ReadWritePropertyMap` with `bool` as value type}
    \cgalParamDefault{no seam is given, and none is written}
  \cgalParamNEnd
  \cgalParamNBegin{face_chart_map}
    \cgalParamDescription{receives the number of each face's chart, from 0 on, and -1 for faces without one (see `parameters::face_chart_map()`)}
    \cgalParamType{a model of `WritablePropertyMap` with a signed integer as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges that must not become seams}
    \cgalParamType{a model of `ReadablePropertyMap` with `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_diagonal_map}
    \cgalParamDescription{the edges that divide larger polygons into triangles; the polygons become convex in the plane where small moves of vertices do that (see
    `parameters::edge_is_diagonal_map()`)}
    \cgalParamType{a model of `ReadablePropertyMap` with `bool` as value type}
    \cgalParamDefault{no edge}
  \cgalParamNEnd
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{what a seam along each edge costs (see `parameters::edge_weight_map()`)}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
  \cgalParamNBegin{stretch_bound}
    \cgalParamDescription{the largest stretch of a chart (see `parameters::stretch_bound()`). With an infinite bound, parts are cut to disks and no further.}
    \cgalParamType{`double`, at least 1}
    \cgalParamDefault{`1.1`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_terminals}
    \cgalParamDescription{the largest number of vertices of each part that are joined to seams because of their scale}
    \cgalParamType{`int`, at least 0}
    \cgalParamDefault{`100`}
  \cgalParamNEnd
  \cgalParamNBegin{area_weight}
    \cgalParamDescription{how much injective maps keep areas (see `Flattening_options::area_weight`)}
    \cgalParamType{`double`, from 0 to 1}
    \cgalParamDefault{`0.02`: in an atlas, less stretch of areas is worth a little more of angles}
  \cgalParamNEnd
  \cgalParamNBegin{separate_overlaps}
    \cgalParamDescription{whether maps of ABF++ that overlap themselves are cut into several charts, as by `split_overlaps()`, instead of replaced by injective ones}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{cut_necks}
    \cgalParamDescription{whether branches of charts are cut off where that takes a short seam, so that the charts cover more of the square}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{equal_seam_lengths}
    \cgalParamDescription{whether both sides of the seams within a chart get equal lengths in the plane (see `parameters::equal_seam_lengths()`)}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{pack_into_square}
    \cgalParamDescription{whether the charts are packed. Otherwise, each has the area of its surface, and the lower left corner of its bounding box at the origin.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{resolution}
    \cgalParamDescription{the number of texels along a side of the square (see `pack_charts()`)}
    \cgalParamType{`int`}
    \cgalParamDefault{`1024`}
  \cgalParamNEnd
  \cgalParamNBegin{gutter}
    \cgalParamDescription{the number of texels between charts (see `pack_charts()`)}
    \cgalParamType{`int`}
    \cgalParamDefault{`2`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_rotations}
    \cgalParamDescription{the number of directions that are tried for large charts (see `pack_charts()`)}
    \cgalParamType{`int`}
    \cgalParamDefault{`32`}
  \cgalParamNEnd
  \cgalParamNBegin{face_weight_map}
    \cgalParamDescription{the texel density of each face (see `pack_charts()`)}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{1 for all faces}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_threads}
    \cgalParamDescription{the number of threads (see `Flattening_options::threads`)}
    \cgalParamType{`int`}
    \cgalParamDefault{`0`: one for each processor}
  \cgalParamNEnd
  \cgalParamNBegin{atlas_visitor}
    \cgalParamDescription{follows the progress, and may stop it}
    \cgalParamType{a reference to an `Atlas_visitor`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{the solver of the linear systems}
    \cgalParamType{a model of `SparseLinearAlgebraTraits_d`}
    \cgalParamDefault{`SuperLU_solver_traits<>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what is wrong, if anything, the charts, what was skipped and why, and the distortion

\sa `select_seams()`
\sa `split_overlaps()`
\sa `pack_charts()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Atlas_report make_atlas(const TriangleMesh& mesh, HalfedgeUVMap uv,
                        const NamedParameters& np = parameters::default_values())
{
  return internal::ABF::Atlas_maker<TriangleMesh, HalfedgeUVMap, NamedParameters>(mesh, uv, np).run();
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MAKE_ATLAS_H
