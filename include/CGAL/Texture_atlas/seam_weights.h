// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SEAM_WEIGHTS_H
#define CGAL_TEXTURE_ATLAS_SEAM_WEIGHTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

/// \file seam_weights.h

namespace CGAL {

namespace Texture_atlas {

#ifndef DOXYGEN_RUNNING
namespace internal {

// The cheapest edge has this share of its length as its weight: a detour of more than three times the length is not
// worth it.
inline constexpr double cheapest_edge = 0.3;

// From `cheapest` times the length at factor 0 to the length at factor 1. `prepare(arrays, face_numbers)` returns a
// function that gives the factor of an edge and its ends.
template <typename TriangleMesh, typename EdgeWeightMap, typename NamedParameters, typename Prepare>
Mesh_report<TriangleMesh> put_seam_weights(const TriangleMesh& mesh, EdgeWeightMap weights,
                                           const NamedParameters& np, double cheapest, const Prepare& prepare)
{
  Check_edge_map<TriangleMesh, EdgeWeightMap>();
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  const auto vertex_numbers = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  const auto face_numbers = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  Triangle_arrays arrays;
  Mesh_report<TriangleMesh> report;
  if(!read_triangles(mesh, points, vertex_numbers, face_numbers, arrays, report))
    return report;
  const auto factor = prepare(arrays, face_numbers);
  for(auto e : edges(mesh)) {
    const std::size_t a = get(vertex_numbers, source(e, mesh)), b = get(vertex_numbers, target(e, mesh));
    const double length = std::sqrt(CGAL::squared_distance(arrays.points[a], arrays.points[b]));
    const double f = factor(e, a, b);
    put(weights, e, length * (cheapest + (1 - cheapest) * f * f));
  }
  return report;
}

} // namespace internal
#endif

/// \ingroup PkgTextureAtlasRef
///
/// computes edge weights that draw seams to hidden places: into folds and cavities, and behind and below other parts.
///
/// The visibility of a vertex is the share of outward directions from which it is visible. There are 48 fixed
/// directions, spread evenly over the sphere; the directions in the half space of the vertex normal count. The vertex
/// is visible from a direction if a ray in this direction does not meet the surface. The weight of an edge of length
/// \f$l\f$ is \f$l\,(0.3 + 0.7\,v^2)\f$, where \f$v\f$ is the mean visibility of its ends. On a convex surface, weights
/// are lengths.
///
/// The surface is seen from the side where the vertices of faces are counterclockwise. Vertices without a normal, such
/// as isolated ones, have visibility 1.
///
/// The function builds an `AABB_tree` of the \f$n\f$ faces, and shoots about 24 rays for each vertex, with \tbb in
/// parallel. In practice, the time grows like \f$n \log n\f$. It is large: one thread took 1.3 s for 52,000 faces. The
/// result has the same bits for any number of threads.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`.
/// \tparam EdgeWeightMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `double` as value type.
/// \tparam NamedParameters a sequence of \cgal's named parameters.
///
/// \param mesh the surface, open or closed.
/// \param weights receives the weights, in units of the coordinates.
/// \param np `vertex_point_map` gives points other than the internal ones. Coordinates are converted to `double`.
///
/// \return what is wrong, if anything: a face is not a triangle (`Diagnosis::NOT_TRIANGULATED`), or a coordinate is not
///   finite (`Diagnosis::NON_FINITE_POINT`). `weights` is then unchanged.
template <typename TriangleMesh, typename EdgeWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh> compute_visibility_weights(const TriangleMesh& mesh, EdgeWeightMap weights,
                                                     const NamedParameters& np = parameters::default_values())
{
  return internal::put_seam_weights(
      mesh, weights, np, internal::cheapest_edge, [](const internal::Triangle_arrays& arrays, const auto&) {
        return [visibility = internal::visibility(arrays)](const auto&, std::size_t a, std::size_t b) {
          return (visibility[a] + visibility[b]) / 2;
        };
      });
}

/// \ingroup PkgTextureAtlasRef
///
/// computes edge weights that draw seams to creases.
///
/// The weight of an edge of length \f$l\f$ is \f$l\,(p + (1 - p)\,c^2)\f$, where \f$p\f$ is `cheapest`. Here, \f$c\f$
/// is the cosine of the angle between the normals of the two faces, or 0 if the cosine is negative. The weight of an
/// edge in a flat region is its length; by default, a bend by 30 degrees gives 0.83 times the length, and a bend by 90
/// degrees or more gives 0.3 times the length. Convex and concave creases count the same. The weight of border edges
/// and of edges of degenerate faces is their length. A rounded crease consists of small bends, and hardly counts.
///
/// Time and memory are linear. Requirements and the report are those of `compute_visibility_weights()`.
///
/// \param mesh a triangle mesh.
/// \param weights receives the weights.
/// \param cheapest the least weight per length, from 0 to 1: the larger, the shorter are seams, and the fewer are on
///   creases.
/// \param np named parameters, as those of `compute_visibility_weights()`.
template <typename TriangleMesh, typename EdgeWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh> compute_crease_weights(const TriangleMesh& mesh, EdgeWeightMap weights,
                                                 double cheapest = 0.3,
                                                 const NamedParameters& np = parameters::default_values())
{
  if(!(cheapest >= 0 && cheapest <= 1)) {
    Mesh_report<TriangleMesh> report;
    report.status = Diagnosis::WRONG_OPTION;
    report.message = "the cheapest edge has " + std::to_string(cheapest) +
                     " of its length as its weight, and must have 0 to 1";
    return report;
  }
  return internal::put_seam_weights(
      mesh, weights, np, cheapest,
      [&mesh](const internal::Triangle_arrays& arrays, const auto& face_numbers) {
        return [&arrays, &mesh, face_numbers](const auto& e, std::size_t, std::size_t) {
          if(CGAL::is_border(e, mesh))
            return 1.;
          const auto h = halfedge(e, mesh);
          const auto n = arrays.normal(arrays.triangles[get(face_numbers, face(h, mesh))]);
          const auto m = arrays.normal(arrays.triangles[get(face_numbers, face(opposite(h, mesh), mesh))]);
          const double product = std::sqrt(n.squared_length()) * std::sqrt(m.squared_length());
          return product > 0 ? (std::max)(0., (n * m) / product) : 1.;
        };
      });
}

/// \ingroup PkgTextureAtlasRef
///
/// computes edge weights as above, with the default weight of the cheapest edge.
template <typename TriangleMesh, typename EdgeWeightMap, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Mesh_report<TriangleMesh> compute_crease_weights(const TriangleMesh& mesh, EdgeWeightMap weights,
                                                 const CGAL_NP_CLASS& np)
{
  return compute_crease_weights(mesh, weights, 0.3, np);
}

} // namespace Texture_atlas

} // namespace CGAL

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/seams/visibility_impl.h>
#endif

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_SEAM_WEIGHTS_H
