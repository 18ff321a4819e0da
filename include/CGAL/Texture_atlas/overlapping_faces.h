// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_OVERLAPPING_FACES_H
#define CGAL_TEXTURE_ATLAS_OVERLAPPING_FACES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/triangle_pairs.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <cstddef>
#include <vector>

/// \file overlapping_faces.h

namespace CGAL {

namespace Texture_atlas {

#ifndef DOXYGEN_RUNNING
namespace internal {

template <typename TriangleMesh, typename UVMap, typename FaceOutputIterator>
FaceOutputIterator overlapping_faces(const Planar_map<TriangleMesh, UVMap>& map, FaceOutputIterator out)
{
  const std::vector<int> opposite = map.opposite_corners();
  std::vector<char> overlaps(map.face_descriptors.size(), false);
  Overlapping_triangles<typename Planar_map<TriangleMesh, UVMap>::Point_2>(map.vertex, opposite, map.points)
      .visit_pairs([&](int s, int t) { overlaps[s] = overlaps[t] = true; });
  for(std::size_t t = 0; t < overlaps.size(); ++t)
    if(overlaps[t])
      *out++ = map.face_descriptors[t];
  return out;
}

} // namespace internal
#endif

/// \ingroup PkgTextureAtlasRef
///
/// writes the faces of `mesh` that overlap other faces in the plane to `out`.
///
/// Two faces overlap if their images, as closed triangles, have more in common than the faces have on the surface: a
/// point of one and another point of the other have the same image. Faces that touch in a common vertex or edge only do
/// not overlap; faces that touch anywhere else do, so that `is_injective()` is true if and only if there are neither
/// flipped nor overlapping faces. Flipped faces count as those with the other orientation. A flipped face overlaps its
/// neighbours that are not. Faces whose vertices are collinear in the plane, those with a coordinate that is infinite
/// or not a number, and those with more than three vertices overlap none; they are in `flipped_faces()`.
///
/// Pairs of faces are found by their bounding boxes, and tested by exact predicates. For \f$n\f$ faces and \f$k\f$
/// pairs of boxes that intersect, the time is \cgalBigO{n \log n + k}, and the memory is linear in \f$n\f$.
/// `is_injective()` is faster if you need no list of faces.
///
/// \tparam TriangleMesh a model of `FaceGraph`.
/// \tparam UVMap a model of `ReadablePropertyMap` with a two-dimensional point as value type, of any kernel whose
///         number type is exact, or whose numbers `double` can hold. The key type is
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` or `%halfedge_descriptor`.
/// \tparam FaceOutputIterator a model of `OutputIterator` that accepts
///         `boost::graph_traits<TriangleMesh>::%face_descriptor`.
///
/// \param mesh a surface; a `Seam_mesh` if it is cut open along seams.
/// \param uvmap the coordinates of all vertices of faces, or of all their halfedges. It does not matter which
///        parameterizer computed them. A halfedge of a face has the coordinates of its target at that face, as
///        `make_atlas()` writes them. The surface is then cut open along the edges whose two sides have different
///        coordinates, and each chart between them counts.
/// \param out receives the faces, each once, in the order of the mesh.
///
/// \return `out` after the last face.
///
/// \sa `split_overlaps()`
template <typename TriangleMesh, typename UVMap, typename FaceOutputIterator>
FaceOutputIterator overlapping_faces(const TriangleMesh& mesh, UVMap uvmap, FaceOutputIterator out)
{
  return internal::overlapping_faces(internal::planar_map(mesh, uvmap), out);
}

/// \ingroup PkgTextureAtlasRef
///
/// writes the faces of the connected component of `h` that overlap other faces of this component, as above. `h` may be
/// any halfedge.
template <typename TriangleMesh, typename UVMap, typename FaceOutputIterator>
FaceOutputIterator overlapping_faces(const TriangleMesh& mesh,
                                     typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                                     UVMap uvmap, FaceOutputIterator out)
{
  return internal::overlapping_faces(internal::planar_map(mesh, h, uvmap), out);
}

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_OVERLAPPING_FACES_H
