// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAPPING_FACES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAPPING_FACES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/overlaps/triangle_pairs.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

/// \file overlapping_faces.h

namespace CGAL {

namespace Surface_mesh_parameterization {

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

// For each edge of each triangle a corner of the triangle across, or -1: in any order, as only neighbours matter
template <typename TriangleMesh, typename VertexUVMap>
std::vector<int> neighbouring_corners(const TriangleMesh& mesh,
                                      const Planar_map<TriangleMesh, VertexUVMap>& map)
{
  std::unordered_map<typename boost::graph_traits<TriangleMesh>::face_descriptor, int> rank;
  for(std::size_t t = 0; t < map.face_descriptors.size(); ++t)
    rank[map.face_descriptors[t]] = static_cast<int>(t);
  std::vector<int> result;
  for(const auto f : map.face_descriptors)
    for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      result.push_back(CGAL::is_border(opposite(h, mesh), mesh) ? -1
                                                                : 3 * rank[face(opposite(h, mesh), mesh)]);
  return result;
}

template <typename TriangleMesh, typename VertexUVMap, typename FaceOutputIterator>
FaceOutputIterator overlapping_faces(const TriangleMesh& mesh,
                                     const Planar_map<TriangleMesh, VertexUVMap>& map, FaceOutputIterator out)
{
  const std::vector<int> neighbours = neighbouring_corners(mesh, map);
  std::vector<char> overlaps(map.face_descriptors.size(), false);
  Overlapping_triangles<typename Planar_map<TriangleMesh, VertexUVMap>::Point_2>(map.vertex, neighbours,
                                                                                 map.points)
      .visit_pairs([&](int s, int t) { overlaps[s] = overlaps[t] = true; });
  for(std::size_t t = 0; t < overlaps.size(); ++t)
    if(overlaps[t])
      *out++ = map.face_descriptors[t];
  return out;
}

} // namespace internal::ABF
#endif

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes the faces of `mesh` that overlap other faces in the plane to `out`.
///
/// Two faces overlap if their images, as closed triangles, have more in common than the faces have on the surface: a point of one
/// and another point of the other have the same image. Faces that touch in a common vertex or edge only do not overlap; faces that touch
/// anywhere else do, so that `is_injective()` is true if and only if there are neither flipped nor overlapping faces.
/// Flipped faces count as those with the other orientation. A flipped face overlaps its neighbours that are not. Faces whose vertices are
/// collinear in the plane and those with a coordinate that is infinite or not a number overlap none; they are in `flipped_faces()`.
///
/// The faces are found by the intersections of their bounding boxes, and then by exact predicates. For \f$n\f$ faces, of whose boxes \f$k\f$ pairs
/// intersect, the time is \cgalBigO{n \log n + k}, and the memory is linear in \f$n\f$. `is_injective()` is faster
/// where only the answer is wanted.
///
/// \tparam TriangleMesh a model of `FaceGraph`.
/// \tparam VertexUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a two-dimensional point as
///         value type, of any kernel whose number type is exact or has only numbers that `double` has too.
/// \tparam FaceOutputIterator a model of `OutputIterator` that accepts
///         `boost::graph_traits<TriangleMesh>::%face_descriptor`.
///
/// \param mesh a triangulated surface; a `Seam_mesh` if it is cut open along seams.
/// \param uvmap the coordinates of all vertices of faces. It does not matter which parameterizer computed them.
/// \param out receives the faces, each once, in the order of the mesh.
///
/// \return `out`, behind what was written.
///
/// \exception std::invalid_argument if a face is not a triangle.
///
/// \sa `split_overlaps()`
template <typename TriangleMesh, typename VertexUVMap, typename FaceOutputIterator>
FaceOutputIterator overlapping_faces(const TriangleMesh& mesh, VertexUVMap uvmap, FaceOutputIterator out)
{
  return internal::ABF::overlapping_faces(mesh, internal::ABF::planar_map(mesh, uvmap), out);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes the faces of the connected component of `h` that overlap other faces of it, as above. `h` may be any halfedge.
template <typename TriangleMesh, typename VertexUVMap, typename FaceOutputIterator>
FaceOutputIterator overlapping_faces(const TriangleMesh& mesh,
                                     typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                                     VertexUVMap uvmap, FaceOutputIterator out)
{
  return internal::ABF::overlapping_faces(mesh, internal::ABF::planar_map(mesh, h, uvmap), out);
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAPPING_FACES_H
