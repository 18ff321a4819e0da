// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MAKE_ATLAS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MAKE_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_options.h>
#include <CGAL/Surface_mesh_parameterization/Atlas_report.h>
#include <CGAL/Surface_mesh_parameterization/Atlas_visitor.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/atlas_maker.h>

#include <cstddef>

/// \file make_atlas.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/*!
\ingroup PkgAngleBasedFlatteningRef

makes a texture atlas of any surface: cuts it open, flattens it without flips and overlaps, and packs the charts into the unit square.

Each connected part of the surface, of any genus and with any number of borders, is cut open to a disk along seams, as by `select_seams()`. ABF++ flattens the disk.
Disks of more than 20,000 triangles are flattened hierarchically. If the map overlaps itself, an injective one takes its place (`Flattening_options::injective`), so that
each part remains one chart; `Atlas_options::separate_overlaps` cuts it into several charts instead. If the map stretches by more than 3 % above
`Seam_options::stretch_bound`, as the long thin triangles of some models make it do, seams are added where it does, and the disk is flattened again, at most five times.
If an injective map still stretches that much, and that of ABF++ does not, the latter is separated. Where there is no map, or the chart is not good (`Atlas_report::Chart::is_good`), areas get a larger weight, and then the
part is divided into several charts; so is a chart that would leave most of the square empty. The report says which way was taken for each chart, and whether one is not good all the same.

Both sides of the seams within a chart, found or given, get equal lengths where ABF++ maps the part directly (`Atlas_options::equal_seam_lengths`).

Then the charts are packed with equal texel density, as by `pack_charts()`, and certified: with the final coordinates, rounded to the number type of `uv`, each chart is
injective, by exact predicates, and no two charts share a texel with its gutter. A map of ABF++ whose final coordinates have too few digits for that is replaced by an injective one,
whose border keeps a distance from itself.

A part that cannot be flattened is skipped, and named in the report with the reason. Its coordinates are unchanged, and all other parts get charts. Nothing is
written if anything else is wrong.

For \f$n\f$ triangles, it takes time \cgalBigO{n \log n}, and the factorization of matrices of bounded size for each part. Parts are flattened side by side if the program is linked with
`CGAL::TBB_support`. The result does not depend on the number of threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam HalfedgeUVMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a two-dimensional point as value type
\tparam FaceChartMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and a signed integer as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh, of any number of connected components
\param seams the seams. Those that are marked are kept; new ones are marked.
\param uv receives the coordinates: a halfedge of a face has those of its target at that face. Border halfedges get none.
\param charts receives the number of each face's chart, from 0 on, and -1 for a face without chart
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
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{what a seam along each edge costs}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
  \cgalParamNBegin{face_size_map}
    \cgalParamDescription{how many texels a length on each face gets, in proportion. A chart has the quadratic mean of its faces, by area.}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{1 for all faces}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{the polygon that each triangle is a part of. Other programs draw polygons as fans from any corner. So that these
    triangles do not overlap, vertices inside of charts are moved a little where polygons are not strictly convex in the plane, as far as
    that helps (`Atlas_report::number_of_mended_polygons`). Seams divide polygons unless `edge_is_constrained_map`
    keeps them off the diagonals.}
    \cgalParamType{a model of `ReadablePropertyMap` with a value type that can be compared}
    \cgalParamDefault{each triangle is a polygon}
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
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap,
          typename NamedParameters = parameters::Default_named_parameters>
Atlas_report make_atlas(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uv, FaceChartMap charts,
                        const Atlas_options& options = Atlas_options(),
                        const NamedParameters& np = parameters::default_values())
{
  return internal::ABF::Atlas_maker<TriangleMesh, EdgeIsSeamMap, HalfedgeUVMap, FaceChartMap,
                                    NamedParameters>(mesh, seams, uv, charts, options, np)
      .run();
}

/*!
\ingroup PkgAngleBasedFlatteningRef

makes an atlas without given seams, and marks neither seams nor charts. Everything else is as above.

\code{.cpp}
if(const auto report = make_atlas(mesh, uv); !report)
  std::cerr << report.message << "\n";
\endcode
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Atlas_report make_atlas(const TriangleMesh& mesh, HalfedgeUVMap uv,
                        const Atlas_options& options = Atlas_options(),
                        const NamedParameters& np = parameters::default_values())
{
  return internal::ABF::Atlas_maker<TriangleMesh, std::nullptr_t, HalfedgeUVMap, std::nullptr_t,
                                    NamedParameters>(mesh, nullptr, uv, nullptr, options, np)
      .run();
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MAKE_ATLAS_H
