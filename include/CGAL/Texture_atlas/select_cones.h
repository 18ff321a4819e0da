// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SELECT_CONES_H
#define CGAL_TEXTURE_ATLAS_SELECT_CONES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Cone_selection.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/cones/choose_cones.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

/// \file select_cones.h

namespace CGAL {

namespace Texture_atlas {

/*!
\ingroup PkgTextureAtlasRef

chooses cones: vertices whose planar angles need not sum to \f$2\pi\f$, so that a map along few seams can have little
stretch.

As for `select_seams()`, the cotangent Laplacian predicts the scale \f$e^u\f$ of a conformal map: \f$L u = -K\f$, where
\f$K\f$ is the angle defect of a vertex, and \f$u\f$ vanishes at cones and borders. The vertex with the largest
\f$|u|\f$ becomes the next cone. The first cone of a closed surface is the vertex where the scale of the map to a
surface of constant curvature is farthest from its mean.

With the angles of the cones, the predicted \f$u\f$ vanishes at all cones, or varies as little as possible
(`Cone_options::angles`). On a closed surface of genus \f$g\f$, the angles of \f$k\f$ cones sum to
\f$2\pi(k - 2 + 2g)\f$; the largest angle is corrected by the rounding error of this sum. A sphere needs at least three
cones.

With `Cone_options::angle_multiple`, the angles are multiples of an angle such as \f$\pi/2\f$. On a sphere, the values
\f$2\pi - \theta\f$ with the largest remainders are rounded up, and the others down; on a disk, each is rounded to the
nearest multiple. Cones whose angle becomes \f$2\pi\f$ are dropped.

There are fewer than `n` cones if fewer make the scale constant, if the surface has fewer interior vertices, or if some
are dropped.

For \f$m\f$ vertices, the function factors the Laplacian once, and takes time \cgalBigO{m \log m} and two solutions for
each cone.

\tparam TriangleMesh a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph` whose vertex descriptors are
        ordered by `<`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a connected triangle mesh, of any genus and with any number of borders
\param n the number of cones, at most 1000
\param options the options
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{the solver of the linear systems}
    \cgalParamType{a model of `SparseLinearAlgebraTraits_d`}
    \cgalParamDefault{`SuperLU_solver_traits<>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the cones with their angles, or what is wrong. `Diagnosis::INFEASIBLE_ANGLE_SUMS` means that the angle of a cone
with \f$d\f$ triangles would not be in \f$(0, d\pi)\f$: try another number of cones.

\sa `flatten_with_cones()`
*/
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Cone_selection<TriangleMesh> select_cones(const TriangleMesh& mesh, std::size_t n,
                                          const Cone_options& options = Cone_options(),
                                          const NamedParameters& np = parameters::default_values())
{
  Cone_selection<TriangleMesh> selection;
  const Report end = internal::run_bounded(options.parameterizer.time_limit, [&] {
    selection = internal::select_cones_of_mesh(mesh, n, options, np);
  });
  if(!end)
    static_cast<Report&>(selection) = end;
  return selection;
}

/// \ingroup PkgTextureAtlasRef
///
/// selects cones as above, with the default options.
template <typename TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Cone_selection<TriangleMesh> select_cones(const TriangleMesh& mesh, std::size_t n, const CGAL_NP_CLASS& np)
{
  return select_cones(mesh, n, Cone_options(), np);
}

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_SELECT_CONES_H
