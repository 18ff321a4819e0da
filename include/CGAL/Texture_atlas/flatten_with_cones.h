// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_FLATTEN_WITH_CONES_H
#define CGAL_TEXTURE_ATLAS_FLATTEN_WITH_CONES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Cone_selection.h>
#include <CGAL/Texture_atlas/internal/cones/cone_flattener.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

/// \file flatten_with_cones.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

flattens a surface of any topology, cut open along short seams through cones, so that a rigid motion maps one side of
each seam to the other.

`select_cones()` chooses the cones, `cut_to_disks()` leads seams through them, and ABF++ flattens the resulting disk.
The planar angles around each cone sum to the chosen angle, and around all other interior vertices, also on seams, to
\f$2\pi\f$. Both sides of a seam have the same lengths and turns: up to the tolerance, a rotation and a translation map
one side to the other, between any two successive cones or branches of the seams. If the angles are multiples of
\f$\pi/2\f$ (`Cone_options::angle_multiple`), so are these rotations on a sphere, and a grid of the plane continues
across all seams, up to a shift.

With `Cone_angles::FREE`, the sums at all vertices on seams are free. Lengths on both sides of a seam are still equal,
and the distortion is about as small as that of the surface that was cut open.

The map is locally injective, has the area of the surface and positive orientation, and its bounding box starts at the
origin.

The time is that of `select_cones()`, `cut_to_disks()` and `ABF_plus_plus_parameterizer_3`.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph` whose vertex descriptors are
        ordered by `<`
\tparam EdgeIsSeamMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam HalfedgeUVMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a two-dimensional point as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a connected triangle mesh, of any genus and with any number of borders
\param n the number of cones (see `select_cones()`)
\param seams receives whether each edge is a seam; unchanged if anything is wrong
\param uv receives the coordinates: a halfedge stores those of its target in its face, and a border halfedge those in
       the face on the other side of its edge. The vertices of `make_seam_mesh(mesh, seams)` are also keys of these
       coordinates. It is unchanged if anything is wrong.
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
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{the solver of the linear systems}
    \cgalParamType{a model of `SparseLinearAlgebraTraits_d`}
    \cgalParamDefault{`SuperLU_solver_traits<>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the reports of all three steps, and what is wrong, if anything

\exception std::bad_alloc if memory runs out. Exceptions of a visitor or a property map pass through.

\sa `select_cones()`
\sa `cut_to_disks()`
\sa `ABF_plus_plus_parameterizer_3`
*/
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Cone_flattening<TriangleMesh> flatten_with_cones(const TriangleMesh& mesh, std::size_t n, EdgeIsSeamMap seams,
                                                 HalfedgeUVMap uv,
                                                 const Cone_options& options = Cone_options(),
                                                 const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  internal::Check_halfedge_map<TriangleMesh, HalfedgeUVMap>();
  return internal::Cone_flattener<TriangleMesh, EdgeIsSeamMap, HalfedgeUVMap, NamedParameters>(
             mesh, seams, uv, options, np)
      .run(n);
}

/// \ingroup PkgTextureAtlasRef
///
/// flattens a surface as above, with the default options.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Cone_flattening<TriangleMesh> flatten_with_cones(const TriangleMesh& mesh, std::size_t n, EdgeIsSeamMap seams,
                                                 HalfedgeUVMap uv, const CGAL_NP_CLASS& np)
{
  return flatten_with_cones(mesh, n, seams, uv, Cone_options(), np);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_FLATTEN_WITH_CONES_H
