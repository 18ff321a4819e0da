// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CERTIFY_FLATTENING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CERTIFY_FLATTENING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <iterator>
#include <utility>
#include <vector>

/// \file certify_flattening.h

namespace CGAL {

namespace Surface_mesh_parameterization {

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

template <typename TriangleMesh, typename UVMap>
Planar_map<TriangleMesh, UVMap> planar_map(const TriangleMesh& mesh, UVMap uvmap)
{
  return Planar_map<TriangleMesh, UVMap>(mesh, faces(mesh), uvmap);
}

template <typename TriangleMesh, typename UVMap>
Planar_map<TriangleMesh, UVMap> planar_map(const TriangleMesh& mesh,
                                           typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                                           UVMap uvmap)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> component;
  const auto inner = CGAL::is_border(h, mesh) ? opposite(h, mesh) : h;
  if(!CGAL::is_border(inner, mesh))
    Polygon_mesh_processing::connected_component(face(inner, mesh), mesh, std::back_inserter(component));
  return Planar_map<TriangleMesh, UVMap>(mesh, component, uvmap);
}

template <typename TriangleMesh, typename UVMap, typename FaceOutputIterator>
FaceOutputIterator flipped_faces(const Planar_map<TriangleMesh, UVMap>& map, FaceOutputIterator out)
{
  auto polygon = map.polygons.begin();
  const auto write_polygons = [&](std::size_t number_of_triangles) {
    for(; polygon != map.polygons.end() && polygon->first <= number_of_triangles; ++polygon)
      *out++ = polygon->second;
  };
  for(int t : flipped_triangles(map.vertex, map.points)) {
    write_polygons(static_cast<std::size_t>(t));
    *out++ = map.face_descriptors[t];
  }
  write_polygons(map.face_descriptors.size());
  return out;
}

template <typename TriangleMesh, typename UVMap, typename HalfedgePairOutputIterator>
HalfedgePairOutputIterator crossing_border_edges(const Planar_map<TriangleMesh, UVMap>& map,
                                                 HalfedgePairOutputIterator out)
{
  for(const auto& [i, j] : touching_edges(map.border, map.points))
    *out++ = std::make_pair(map.border_halfedges[i], map.border_halfedges[j]);
  return out;
}

} // namespace internal::ABF
#endif

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes the faces of `mesh` that are no positively oriented triangles in the plane to `out`: those that are flipped,
/// those whose vertices are collinear, those with a coordinate that is infinite or not a number, and those with more
/// than three vertices.
///
/// Nothing is rounded: like all functions of this header, the function uses exact predicates on the stored
/// coordinates. It takes linear time.
///
/// \tparam TriangleMesh a model of `FaceGraph`.
/// \tparam UVMap a model of `ReadablePropertyMap` with a two-dimensional point as value type, of any kernel whose
///         number type is exact, or whose numbers `double` can hold. The key type is
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` or `%halfedge_descriptor`.
/// \tparam FaceOutputIterator a model of `OutputIterator` that accepts
///         `boost::graph_traits<TriangleMesh>::%face_descriptor`.
///
/// \param mesh a surface.
/// \param uvmap the coordinates of all vertices of faces, or of all their halfedges. It does not matter which
///        parameterizer computed them. A halfedge of a face has the coordinates of its target at that face, as
///        `make_atlas()` writes them. The surface is then cut open along the edges whose two sides have different
///        coordinates, and each chart between them counts.
/// \param out receives the faces, in the order of the mesh.
///
/// \return `out`, behind what was written.
template <typename TriangleMesh, typename UVMap, typename FaceOutputIterator>
FaceOutputIterator flipped_faces(const TriangleMesh& mesh, UVMap uvmap, FaceOutputIterator out)
{
  return internal::ABF::flipped_faces(internal::ABF::planar_map(mesh, uvmap), out);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes the faces of the connected component of `h` that are not positively oriented, as above. `h` may be any
/// halfedge.
template <typename TriangleMesh, typename UVMap, typename FaceOutputIterator>
FaceOutputIterator flipped_faces(const TriangleMesh& mesh,
                                 typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                                 UVMap uvmap, FaceOutputIterator out)
{
  return internal::ABF::flipped_faces(internal::ABF::planar_map(mesh, h, uvmap), out);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns whether every point of the surface has a neighbourhood that is mapped injectively and with positive
/// orientation. This holds if and only if
/// - no face is in `flipped_faces()`,
/// - the faces around each interior vertex go around it once (positively oriented faces may do so more often),
/// - the faces around each border vertex take less than a full turn; if they form several fans, the fans have only the
///   vertex in common.
///
/// The time is \cgalBigO{n + b \log b} for \f$n\f$ faces and \f$b\f$ border edges. Parameters and requirements are
/// those of `flipped_faces()`.
template <typename TriangleMesh, typename UVMap>
bool is_locally_injective(const TriangleMesh& mesh, UVMap uvmap)
{
  return internal::ABF::planar_map(mesh, uvmap).is_locally_injective();
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns whether the map is locally injective on the connected component of `h`, as above.
template <typename TriangleMesh, typename UVMap>
bool is_locally_injective(const TriangleMesh& mesh,
                          typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, UVMap uvmap)
{
  return internal::ABF::planar_map(mesh, h, uvmap).is_locally_injective();
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns whether the map is injective and keeps the orientation: no two points of the surface have the same image.
///
/// The function compares no pairs of faces. The map is injective if and only if
/// - no face is in `flipped_faces()`,
/// - no pair of edges is in `crossing_border_edges()`, and
/// - the border winds around no point more than once. (The surface is on its left.)
///
/// This is because the border winds around each point as often as positively oriented faces cover the point
/// \cgalCite{cgal:l-bmtmb-14}.
/// - A disk needs no more than the first two conditions: its border is a simple polygon.
/// - A chart with holes meets the conditions if and only if it has no flipped faces, each border is a simple polygon,
///   the holes are within the outer border and turn the other way, and borders do not touch or contain one another
///   otherwise.
/// - A surface with several components meets them if and only if each component does, their borders do not touch, and
///   none lies within another. A hole of a component may contain other components.
/// - Where the border runs through a vertex several times, the fans of faces there may touch in the vertex.
///
/// The third condition does not follow from the others, even on a connected surface: two sheets, one over the other,
/// that are cut and glued crosswise have two simple borders, but points in the middle have two preimages.
///
/// The time is \cgalBigO{n + b \log b} for \f$n\f$ faces and \f$b\f$ border edges. Parameters and requirements are
/// those of `flipped_faces()`.
template <typename TriangleMesh, typename UVMap>
bool is_injective(const TriangleMesh& mesh, UVMap uvmap)
{
  return internal::ABF::planar_map(mesh, uvmap).is_injective();
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns whether the map is injective on the connected component of `h`, as above.
template <typename TriangleMesh, typename UVMap>
bool is_injective(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h,
                  UVMap uvmap)
{
  return internal::ABF::planar_map(mesh, h, uvmap).is_injective();
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes to `out` all pairs of border edges that have a point in common in the plane, except a common vertex. There is
/// no such pair if and only if the borders are simple polygons that do not touch one another, except in vertices where
/// they meet on the surface. Edges with a coordinate that is infinite or not a number, and those of faces with more
/// than three vertices are left out. Their faces are in `flipped_faces()`.
///
/// If there is no such pair, the time is \cgalBigO{n + b \log b} for \f$n\f$ faces and \f$b\f$ border edges. Otherwise
/// it depends on the number of pairs of edges whose bounding boxes intersect.
///
/// \tparam HalfedgePairOutputIterator a model of `OutputIterator` that accepts pairs (`std::pair`) of
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`.
///
/// \param mesh, uvmap as for `flipped_faces()`.
/// \param out receives the pairs of border halfedges, each pair once.
///
/// \return `out`, behind what was written.
template <typename TriangleMesh, typename UVMap, typename HalfedgePairOutputIterator>
HalfedgePairOutputIterator crossing_border_edges(const TriangleMesh& mesh, UVMap uvmap,
                                                 HalfedgePairOutputIterator out)
{
  return internal::ABF::crossing_border_edges(internal::ABF::planar_map(mesh, uvmap), out);
}

/// \ingroup PkgAngleBasedFlatteningRef
///
/// writes the pairs of border edges of the connected component of `h` that have a point in common, as above.
template <typename TriangleMesh, typename UVMap, typename HalfedgePairOutputIterator>
HalfedgePairOutputIterator
crossing_border_edges(const TriangleMesh& mesh,
                      typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, UVMap uvmap,
                      HalfedgePairOutputIterator out)
{
  return internal::ABF::crossing_border_edges(internal::ABF::planar_map(mesh, h, uvmap), out);
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CERTIFY_FLATTENING_H
