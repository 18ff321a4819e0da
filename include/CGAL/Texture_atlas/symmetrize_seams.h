// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SYMMETRIZE_SEAMS_H
#define CGAL_TEXTURE_ATLAS_SYMMETRIZE_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Texture_atlas/Symmetry_report.h>
#include <CGAL/Texture_atlas/internal/seams/symmetry.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

/// \file symmetrize_seams.h

namespace CGAL {

namespace Texture_atlas {

#ifndef DOXYGEN_RUNNING
namespace internal {

// A mesh as arrays, for what mirrors it
template <typename TriangleMesh>
struct Mirrored_mesh
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;

  // Returns whether it is right, and says what is wrong if it is not.
  template <typename NamedParameters, typename Report>
  bool read(const TriangleMesh& mesh, const NamedParameters& np, Mesh_report<TriangleMesh, Report>& report)
  {
    const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                     get_const_property_map(CGAL::vertex_point, mesh));
    const auto vertex_numbers = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
    const auto face_numbers = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    if(!read_triangles(mesh, points, vertex_numbers, face_numbers, arrays, report))
      return false;
    if(arrays.proper_triangles().empty()) {
      report.status = Diagnosis::NO_AREA;
      report.message = "the surface has no area";
      return false;
    }
    for(edge_descriptor e : edges(mesh)) {
      edge_descriptors.push_back(e);
      ends.push_back({get(vertex_numbers, source(e, mesh)), get(vertex_numbers, target(e, mesh))});
    }
    return true;
  }

  template <typename EdgeMap>
  std::vector<char> marks(EdgeMap map) const
  {
    std::vector<char> result;
    for(edge_descriptor e : edge_descriptors)
      result.push_back(get(map, e));
    return result;
  }

  Triangle_arrays arrays;
  std::vector<edge_descriptor> edge_descriptors;
  std::vector<Edge_graph::Ends> ends; // of each edge
};

// Says what is wrong with a plane, if anything.
template <typename TriangleMesh, typename Report>
bool is_plane(const Mirror_plane_report& plane, Mesh_report<TriangleMesh, Report>& report)
{
  const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
  if(std::abs(length - 1) < 1e-6 && std::isfinite(plane.offset))
    return true;
  report.status = Diagnosis::WRONG_OPTION;
  report.message = "the mirror plane has a normal of length " + std::to_string(length) +
                   " and an offset of " + std::to_string(plane.offset) +
                   ": the length must be 1, and the offset finite";
  return false;
}

inline Mirror_plane mirror_plane(const Mirror_plane_report& plane)
{
  return {Seam_kernel::Vector_3(plane.normal[0], plane.normal[1], plane.normal[2]), plane.offset,
          plane.deviation};
}

// What is measured of seams
inline void measure_symmetry(const Edge_graph& graph, const std::vector<char>& is_seam,
                             const Mirror_plane& plane, Symmetry_report& report)
{
  report.asymmetry = asymmetry_of_seams(graph, is_seam, plane) / diagonal_of(graph.points);
  for(std::size_t e = 0; e < is_seam.size(); ++e)
    report.seam_length += is_seam[e] ? graph.length(e) : 0;
}

} // namespace internal
#endif

/*!
\ingroup PkgTextureAtlasRef

finds the plane in which a surface is most nearly symmetric.

Planes through the centroid, along the principal axes and in 24 other directions, are fitted: each plane is replaced by
the one that best maps points of the surface to the points that are nearest to their mirror images. Of all fitted
planes, the one with the least `Mirror_plane_report::deviation` is returned. The triangles need not be symmetric. Posed
figures are not: their limbs have no mirror image. Deviations of up to 0.015 are small enough for `symmetrize_seams()`.

The time is that of some 100,000 queries to an `AABB_tree` of the faces.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh
\param np `vertex_point_map` gives points other than the internal ones. Coordinates are converted to `double`.

\return the plane, and what is wrong, if anything: a face is not a triangle (`Diagnosis::NOT_TRIANGULATED`), a
coordinate is not finite (`Diagnosis::NON_FINITE_POINT`), or no face has an area (`Diagnosis::NO_AREA`)
*/
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Mirror_plane_report>
find_mirror_plane(const TriangleMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  Mesh_report<TriangleMesh, Mirror_plane_report> report;
  internal::Mirrored_mesh<TriangleMesh> read_mesh;
  if(!read_mesh.read(mesh, np, report))
    return report;
  const internal::Mirror_plane plane = internal::fit_mirror_plane(read_mesh.arrays);
  report.normal = {plane.normal.x(), plane.normal.y(), plane.normal.z()};
  report.offset = plane.offset;
  report.deviation = plane.deviation / internal::diagonal_of(read_mesh.arrays.points);
  return report;
}

/*!
\ingroup PkgTextureAtlasRef

makes seams symmetric with respect to a plane: those on one side are kept, and replace those on the other side. Call it
with the seams of `make_atlas()`, and then `make_atlas()` again, which keeps them and adds more where charts need them.

Each kept seam, from branch to branch or to the plane, is drawn on the other side as a short path near its mirror image.
The triangles need not be symmetric. Seams that begin and end at the plane and keep within 2 % of the diagonal of the
bounding box beside it become a single seam along the plane. Regions of less than 0.2 % of the area join the neighbor
with which they have the longest border, so that no slivers remain between seams.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam EdgeIsSeamMap a model of `ReadWritePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh
\param seams the seams; unchanged if anything is wrong
\param plane the plane, such as `find_mirror_plane()` finds it
\param keeps_upper_side whether the seams on the side to which the normal points are kept, or those on the other side
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
\cgalNamedParamsEnd

\return how symmetric the seams are, and what is wrong, if anything: as by `find_mirror_plane()`, or the normal does not
have length 1 (`Diagnosis::WRONG_OPTION`)
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Symmetry_report>
symmetrize_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams, const Mirror_plane_report& plane,
                 bool keeps_upper_side = true, const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  Mesh_report<TriangleMesh, Symmetry_report> report;
  internal::Mirrored_mesh<TriangleMesh> read_mesh;
  if(!internal::is_plane(plane, report) || !read_mesh.read(mesh, np, report))
    return report;
  std::vector<char> may_be_seam = read_mesh.marks(parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::edge_is_constrained),
      Static_boolean_property_map<typename boost::graph_traits<TriangleMesh>::edge_descriptor, false>()));
  for(char& may_be : may_be_seam)
    may_be = !may_be;
  const internal::Edge_graph graph(read_mesh.arrays.points, read_mesh.ends);
  const internal::Mirror_plane mirror = internal::mirror_plane(plane);
  const std::vector<char> is_seam = internal::mirror_seams(read_mesh.arrays, graph, mirror, may_be_seam,
                                                           read_mesh.marks(seams), keeps_upper_side ? 1 : -1);
  internal::measure_symmetry(graph, is_seam, mirror, report);
  for(std::size_t e = 0; e < is_seam.size(); ++e)
    put(seams, read_mesh.edge_descriptors[e], bool(is_seam[e]));
  return report;
}

/// \ingroup PkgTextureAtlasRef
///
/// makes seams symmetric as above, and keeps those of the upper side.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename CGAL_NP_TEMPLATE_PARAMETERS_NO_DEFAULT>
Mesh_report<TriangleMesh, Symmetry_report> symmetrize_seams(const TriangleMesh& mesh, EdgeIsSeamMap seams,
                                                            const Mirror_plane_report& plane,
                                                            const CGAL_NP_CLASS& np)
{
  return symmetrize_seams(mesh, seams, plane, true, np);
}

/*!
\ingroup PkgTextureAtlasRef

measures how symmetric seams are with respect to a plane.

\param mesh a triangle mesh
\param seams which edges are seams
\param plane the plane
\param np as for `find_mirror_plane()`

\return the symmetry, and what is wrong, if anything: as by `symmetrize_seams()`
*/
template <typename TriangleMesh, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh, Symmetry_report>
measure_symmetry(const TriangleMesh& mesh, EdgeIsSeamMap seams, const Mirror_plane_report& plane,
                 const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeIsSeamMap>();
  Mesh_report<TriangleMesh, Symmetry_report> report;
  internal::Mirrored_mesh<TriangleMesh> read_mesh;
  if(internal::is_plane(plane, report) && read_mesh.read(mesh, np, report))
    internal::measure_symmetry(internal::Edge_graph(read_mesh.arrays.points, read_mesh.ends),
                               read_mesh.marks(seams), internal::mirror_plane(plane), report);
  return report;
}

/*!
\ingroup PkgTextureAtlasRef

makes edges along a plane cheap, so that seams run there: multiplies their weights by 0.6. Where no edges are in the
plane, those count that join the nearer ends of the edges which cross it.

\param mesh a triangle mesh
\param plane the plane
\param weights a model of `ReadWritePropertyMap`: the weights of the edges, such as their lengths
\param np as for `find_mirror_plane()`

\return what is wrong, if anything: as by `symmetrize_seams()`
*/
template <typename TriangleMesh, typename EdgeWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Mesh_report<TriangleMesh> favor_mirror_plane(const TriangleMesh& mesh, const Mirror_plane_report& plane,
                                             EdgeWeightMap weights,
                                             const NamedParameters& np = parameters::default_values())
{
  internal::Check_edge_map<TriangleMesh, EdgeWeightMap>();
  Mesh_report<TriangleMesh> report;
  internal::Mirrored_mesh<TriangleMesh> read_mesh;
  if(!internal::is_plane(plane, report) || !read_mesh.read(mesh, np, report))
    return report;
  const internal::Edge_graph graph(read_mesh.arrays.points, read_mesh.ends);
  const std::vector<signed char> side = internal::sides_of_vertices(graph, internal::mirror_plane(plane));
  for(std::size_t e = 0; e < graph.ends.size(); ++e)
    if(side[graph.ends[e][0]] == 0 && side[graph.ends[e][1]] == 0)
      put(weights, read_mesh.edge_descriptors[e], 0.6 * get(weights, read_mesh.edge_descriptors[e]));
  return report;
}

} // namespace Texture_atlas

} // namespace CGAL

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/seams/symmetry_impl.h>
#endif

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_SYMMETRIZE_SEAMS_H
