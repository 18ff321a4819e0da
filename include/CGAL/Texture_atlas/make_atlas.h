// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_MAKE_ATLAS_H
#define CGAL_TEXTURE_ATLAS_MAKE_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/prepare/mesh_atlas.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <vector>

/// \file make_atlas.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

makes a texture atlas of any mesh: cuts it open, flattens it, and packs the charts into the unit square, or, with
`Packing_options::texels_per_unit`, into as many such pages as they take. Charts larger than a page are then cut in two.

Each connected part of the surface, of any genus and with any number of borders, is cut to a disk along seams with a
predicted stretch of at most `Seam_options::stretch_bound`. ABF++ flattens the disk. If the map overlaps itself, an
injective map replaces it. If the chart stretches too much all the same, it gets more seams, more weight of areas, or is
divided into several charts. A flat part is its own map, and keeps its holes. Section \ref ABF_atlases_steps describes all steps.

Exact predicates certify the final coordinates, rounded to the number type of `uv`: no triangle is flipped, no chart
overlaps itself, and no two charts come nearer to one another than the gutter. Stretch is measured, not certified:
`Diagnosis::STRETCH_BOUND_MISSED` says that some chart is not good (`Atlas_report::Chart::is_good`).

A part that cannot be flattened is skipped and reported. Its coordinates are unchanged, and all other parts get charts.
Faces with vertices that are not finite or a billion times as far away as most are such parts by themselves. Faces whose
corners are exactly on one line change no chart: each gets coordinates on an edge of a neighbor
(`Atlas_report::degenerate_triangles`). Edges where a chart ends beside such faces are seams, too. If anything else is
wrong, nothing is written.

Faces may have any number of corners. Larger ones are divided into triangles in a copy of the mesh, by diagonals that do
not become seams, and each is strictly convex in the plane where that is possible, as with `face_patch_map`. The report
counts faces of charts as triangles.

For \f$n\f$ triangles, the time is \cgalBigO{n \log n}, plus factorizations of matrices of bounded size for each part.
With `CGAL::TBB_support`, parts are flattened in parallel. The result does not depend on the number of threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam HalfedgeUVMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a two-dimensional point as value type
\tparam FaceChartMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and a signed integer as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a mesh, of any number of connected components
\param seams the seams: marked edges stay seams, and new seams are marked
\param uv receives the coordinates: each halfedge of a face stores those of its target in this face
\param charts receives the chart number of each face, from 0 on, and -1 for a face without chart
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
    \cgalParamDescription{the cost of a seam along each edge}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
  \cgalParamNBegin{face_size_map}
    \cgalParamDescription{relative texel density of each face. A chart gets the quadratic mean over its area.}
    \cgalParamType{a model of `ReadablePropertyMap` with numbers of at least 0}
    \cgalParamDefault{1 for all faces}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{the polygon that contains each triangle. Interior vertices of charts are moved a little where
    that makes polygons strictly convex in the plane (`Atlas_report::number_of_mended_polygons`), so that other
    programs can triangulate them in any way. To keep seams off the diagonals, constrain these in
    `edge_is_constrained_map`.}
    \cgalParamType{a model of `ReadablePropertyMap` with a value type that can be compared}
    \cgalParamDefault{each triangle is a polygon}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{the numbers of vertices in messages}
    \cgalParamType{a model of `ReadablePropertyMap` with an integer as value type}
    \cgalParamDefault{positions in the sequence of vertices, from 0}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{the numbers of faces in messages}
    \cgalParamType{a model of `ReadablePropertyMap` with an integer as value type}
    \cgalParamDefault{positions in the sequence of faces, from 0}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{the solver of the linear systems}
    \cgalParamType{a model of `SparseLinearAlgebraTraits_d`}
    \cgalParamDefault{`SuperLU_solver_traits<>`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{follows the computation, and may cancel it}
    \cgalParamType{a model of `AtlasVisitor`, or a `std::reference_wrapper` of one}
    \cgalParamDefault{`Atlas_options::visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the charts, their distortion, and what is wrong, if anything

\sa `select_seams()`
\sa `split_overlaps()`
\sa `pack_charts()`
*/
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap,
          typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          typename = internal::Is_map<FaceChartMap, Atlas_options>
#endif
          >
Mesh_atlas_report<TriangleMesh> make_atlas(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uv,
                                           FaceChartMap charts,
                                           const Atlas_options& options = Atlas_options(),
                                           const NamedParameters& np = parameters::default_values())
{
  const auto one = [](const auto& value) { return CGAL::make_range(&value, &value + 1); };
  return internal::atlas_of_meshes(one(mesh), one(seams), one(uv), one(charts), options, np);
}

/// \ingroup PkgTextureAtlasRef
///
/// makes an atlas as above, with the default options.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Mesh_atlas_report<TriangleMesh> make_atlas(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uv,
                                           FaceChartMap charts, const CGAL_NP_CLASS& np)
{
  return make_atlas(mesh, seams, uv, charts, Atlas_options(), np);
}

/*!
\ingroup PkgTextureAtlasRef

makes an atlas as above, without given seams. Neither seams nor chart numbers are returned.

\code{.cpp}
if(const auto report = make_atlas(mesh, uv); !report)
  std::cerr << report.message << "\n";
\endcode
*/
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_atlas_report<TriangleMesh> make_atlas(const TriangleMesh& mesh, HalfedgeUVMap uv,
                                           const Atlas_options& options = Atlas_options(),
                                           const NamedParameters& np = parameters::default_values())
{
  return make_atlas(mesh, nullptr, uv, nullptr, options, np);
}

/// \ingroup PkgTextureAtlasRef
///
/// makes an atlas as above, without given seams, and with the default options.
template <typename TriangleMesh, typename HalfedgeUVMap, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Mesh_atlas_report<TriangleMesh> make_atlas(const TriangleMesh& mesh, HalfedgeUVMap uv,
                                           const CGAL_NP_CLASS& np)
{
  return make_atlas(mesh, uv, Atlas_options(), np);
}

/*!
\ingroup PkgTextureAtlasRef

makes one texture atlas of several meshes, with the same texel density, as `make_atlas()` does of one.

The result is, bit by bit, that of one mesh with all faces in their order. Meshes that touch are not joined. Charts are
numbered through, those of the first mesh first. `Atlas_report::Chart::mesh` and `Atlas_report::Skipped::mesh` say which
mesh they belong to. `Atlas_report::Skipped::first_face`, `Mesh_atlas_report::skipped_elements` and messages are about
this mesh. If anything but a part is wrong, nothing is written to any mesh.

\tparam MeshRange a range of models of `FaceListGraph` and `HalfedgeListGraph` of one type
\tparam EdgeIsSeamMapRange, HalfedgeUVMapRange, FaceChartMapRange ranges of property maps as those of `make_atlas()`,
        one map for each mesh
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param meshes meshes, of any number of connected components
\param seams the seams of each mesh: marked edges stay seams, and new seams are marked
\param uv receives the coordinates: each halfedge of a face stores those of its target in this face
\param charts receives the chart number of each face, from 0 on, and -1 for a face without chart
\param options the options
\param np optional: `sparse_linear_solver` and `visitor`, as of `make_atlas()`. Its other named parameters belong to one
       mesh, and do not compile.

\return the charts, their distortion, and what is wrong, if anything: a `Mesh_atlas_report` of the type of the meshes

\sa `make_atlas()`
*/
template <typename MeshRange, typename EdgeIsSeamMapRange, typename HalfedgeUVMapRange,
          typename FaceChartMapRange, typename NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          typename = internal::Is_map<FaceChartMapRange, Atlas_options>
#endif
          >
#ifndef DOXYGEN_RUNNING
Mesh_atlas_report<internal::Element_of<MeshRange>>
#else
unspecified_type
#endif
make_common_atlas(const MeshRange& meshes, const EdgeIsSeamMapRange& seams, const HalfedgeUVMapRange& uv,
                  const FaceChartMapRange& charts, const Atlas_options& options = Atlas_options(),
                  const NamedParameters& np = parameters::default_values())
{
  return internal::common_atlas(meshes, seams, uv, charts, options, np);
}

/// \ingroup PkgTextureAtlasRef
///
/// makes one atlas of several meshes as above, with the default options.
template <typename MeshRange, typename EdgeIsSeamMapRange, typename HalfedgeUVMapRange,
          typename FaceChartMapRange, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
#ifndef DOXYGEN_RUNNING
Mesh_atlas_report<internal::Element_of<MeshRange>>
#else
unspecified_type
#endif
make_common_atlas(const MeshRange& meshes, const EdgeIsSeamMapRange& seams, const HalfedgeUVMapRange& uv,
                  const FaceChartMapRange& charts, const CGAL_NP_CLASS& np)
{
  return make_common_atlas(meshes, seams, uv, charts, Atlas_options(), np);
}

/*!
\ingroup PkgTextureAtlasRef

makes one atlas of several meshes as above, without given seams. Neither seams nor chart numbers are returned.

\code{.cpp}
std::vector<Mesh> meshes;
std::vector<UV_map> uv; // one for each mesh
if(const auto report = make_common_atlas(meshes, uv); !report)
  std::cerr << report.message << "\n";
\endcode
*/
template <typename MeshRange, typename HalfedgeUVMapRange,
          typename NamedParameters = parameters::Default_named_parameters>
#ifndef DOXYGEN_RUNNING
Mesh_atlas_report<internal::Element_of<MeshRange>>
#else
unspecified_type
#endif
make_common_atlas(const MeshRange& meshes, const HalfedgeUVMapRange& uv,
                  const Atlas_options& options = Atlas_options(),
                  const NamedParameters& np = parameters::default_values())
{
  const std::vector<std::nullptr_t> none(internal::size_of(meshes), nullptr);
  return internal::common_atlas(meshes, none, uv, none, options, np);
}

/// \ingroup PkgTextureAtlasRef
///
/// makes one atlas of several meshes as above, without given seams, and with the default options.
template <typename MeshRange, typename HalfedgeUVMapRange, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
#ifndef DOXYGEN_RUNNING
Mesh_atlas_report<internal::Element_of<MeshRange>>
#else
unspecified_type
#endif
make_common_atlas(const MeshRange& meshes, const HalfedgeUVMapRange& uv, const CGAL_NP_CLASS& np)
{
  return make_common_atlas(meshes, uv, Atlas_options(), np);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_MAKE_ATLAS_H
