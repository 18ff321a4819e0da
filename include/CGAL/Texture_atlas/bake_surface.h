// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_BAKE_SURFACE_H
#define CGAL_TEXTURE_ATLAS_BAKE_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/baking/bake_mesh.h>

/// \file bake_surface.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

bakes the normals, the distance and the colours, if any, of a fine surface into textures of a simple surface. With the
texture of normals, the simple surface is shaded like the fine one (Section 6.1 and Figure 9 of the paper
\cgalCite{cgal:slmb-abf-05}).

Every texel that a triangle of the simple surface touches gets values. It belongs to the point of the simple surface at
its centre, or to the point of the chart that is closest to its centre in the plane. From this point, a ray goes along
the interpolated normal of the vertices, to each side as far as `Baking_options::ray_length`. The values are those of
the nearest point of the fine surface on the ray whose face has a normal along the ray. If there is none, the nearest
point is taken, and its normal is reversed. If the ray meets nothing, the closest point of the fine surface is taken,
and a normal against the ray is reversed. The report counts such texels, and `Baked_textures::texels` marks them. The
normals and colours of the fine surface are interpolated from its vertices.

Normals are in tangent space, in the convention of glTF: x along growing \f$u\f$, y along growing \f$v\f$, which is up
in the picture, and z along the normal. At each corner, the tangent is the mean of the tangents of the triangles around
the vertex in the same chart, weighted by their angles, and made orthogonal to the normal. Normals, tangents and
bitangents are interpolated, and each is scaled to length 1, as common glTF viewers do. Write the directions that
`frames` receives into the file, so that viewers use the same ones. Programs that read files without tangents compute
nearly the same directions.

Then `Baking_options::gutter` texels around each chart, in all directions, get the values of the nearest texel of a
chart, so that interpolation and smaller copies of the texture show no other values at seams.

For \f$n\f$ triangles of both surfaces and \f$t\f$ texels of charts, the time is usually \cgalBigO{n \log n + t \log n}.
The memory is 17 bytes for each texel of the square, or 29 with colours, and about 200 bytes for each triangle of the
fine surface. With `CGAL::TBB_support`, rows are baked in parallel. The result does not depend on the number of threads.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam HalfedgeUVMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as
        key type and a two-dimensional point of any kernel as value type
\tparam FineMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam TangentFrameMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `Tangent_frame` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam FineNamedParameters the same

\param mesh the simple surface, a triangle mesh
\param uv the texture coordinates in the unit square, as `make_atlas()` writes them: a halfedge stores those of its
       target in its face
\param fine_mesh the fine surface, a triangle mesh, in the same place as the simple one
\param frames receives the directions at each corner that normals in tangent space refer to: a halfedge stores those at
       its target in its face; faces without a chart get none
\param options the options
\param np optional named parameters for the simple surface:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_normal_map}
    \cgalParamDescription{the normals of the vertices, of any length. Rays go along them, and normals in tangent space
    refer to them.}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Vector_3` of any kernel as value type}
    \cgalParamDefault{the mean of the normals of the faces around each vertex, weighted by their angles}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{the chart number of each face, as `make_atlas()` writes it. A face with a negative number is
    left out.}
    \cgalParamType{a model of `ReadablePropertyMap` with an integer as value type}
    \cgalParamDefault{all faces have charts}
  \cgalParamNEnd
\cgalNamedParamsEnd

\param fine_np optional named parameters for the fine surface:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, fine_mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_normal_map}
    \cgalParamDescription{the normals of the vertices, of any length}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Vector_3` of any kernel as value type}
    \cgalParamDefault{the mean of the normals of the faces around each vertex, weighted by their angles}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_color_map}
    \cgalParamDescription{the colours of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with `CGAL::IO::Color` as value type}
    \cgalParamDefault{none: no colours are baked}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the textures, with a report that says what is wrong, if anything

\sa `make_atlas()`
*/
template <typename TriangleMesh, typename HalfedgeUVMap, typename FineMesh, typename TangentFrameMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename FineNamedParameters = parameters::Default_named_parameters>
Baked_surface<TriangleMesh, FineMesh>
bake_surface(const TriangleMesh& mesh, HalfedgeUVMap uv, const FineMesh& fine_mesh, TangentFrameMap frames,
             const Baking_options& options = Baking_options(),
             const NamedParameters& np = parameters::default_values(),
             const FineNamedParameters& fine_np = parameters::default_values())
{
  internal::Check_halfedge_map<TriangleMesh, HalfedgeUVMap>();
  internal::Check_halfedge_map<TriangleMesh, TangentFrameMap>();
  return internal::Mesh_baker<TriangleMesh, HalfedgeUVMap, FineMesh, TangentFrameMap, NamedParameters,
                              FineNamedParameters>(mesh, uv, fine_mesh, frames, options, np, fine_np)
      .run();
}

/*!
\ingroup PkgTextureAtlasRef

bakes a fine surface into textures of a simple one as above, without returning the tangent frames.
*/
template <typename TriangleMesh, typename HalfedgeUVMap, typename FineMesh,
          typename NamedParameters = parameters::Default_named_parameters,
          typename FineNamedParameters = parameters::Default_named_parameters>
Baked_surface<TriangleMesh, FineMesh>
bake_surface(const TriangleMesh& mesh, HalfedgeUVMap uv, const FineMesh& fine_mesh,
             const Baking_options& options = Baking_options(),
             const NamedParameters& np = parameters::default_values(),
             const FineNamedParameters& fine_np = parameters::default_values())
{
  return bake_surface(mesh, uv, fine_mesh, nullptr, options, np, fine_np);
}

/// \ingroup PkgTextureAtlasRef
///
/// bakes a fine surface as above, with the default options.
template <typename TriangleMesh, typename HalfedgeUVMap, typename FineMesh, typename TangentFrameMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT,
          typename FineNamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          typename = internal::Is_map<TangentFrameMap, Baking_options>
#endif
          >
Baked_surface<TriangleMesh, FineMesh>
bake_surface(const TriangleMesh& mesh, HalfedgeUVMap uv, const FineMesh& fine_mesh, TangentFrameMap frames,
             const CGAL_NP_CLASS& np, const FineNamedParameters& fine_np = parameters::default_values())
{
  return bake_surface(mesh, uv, fine_mesh, frames, Baking_options(), np, fine_np);
}

/// \ingroup PkgTextureAtlasRef
///
/// bakes a fine surface as above, without returning the tangent frames, and with the default options.
template <typename TriangleMesh, typename HalfedgeUVMap, typename FineMesh,
          typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT,
          typename FineNamedParameters = parameters::Default_named_parameters>
Baked_surface<TriangleMesh, FineMesh>
bake_surface(const TriangleMesh& mesh, HalfedgeUVMap uv, const FineMesh& fine_mesh, const CGAL_NP_CLASS& np,
             const FineNamedParameters& fine_np = parameters::default_values())
{
  return bake_surface(mesh, uv, fine_mesh, nullptr, Baking_options(), np, fine_np);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_BAKE_SURFACE_H
