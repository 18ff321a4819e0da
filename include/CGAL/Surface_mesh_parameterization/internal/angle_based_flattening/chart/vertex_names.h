// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The names of vertices in messages: "vertex 17 (0.1, nan, 3)". Numbers are those of the caller, or positions in the
// sequence of vertices, from 0; of a `Seam_mesh`, in that of the mesh that it cuts.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_NAMES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_NAMES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_sides.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/inline.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The number of each vertex of a mesh in messages. It hides the type of the caller's property map.
template <typename TriangleMesh>
using Vertex_numbers =
    std::function<std::ptrdiff_t(const typename boost::graph_traits<TriangleMesh>::vertex_descriptor&)>;

template <typename TriangleMesh, typename VertexIndexMap>
Vertex_numbers<TriangleMesh> vertex_numbers_of(VertexIndexMap map)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  return [map](const vertex_descriptor& v) { return static_cast<std::ptrdiff_t>(get(map, v)); };
}

// The positions in the sequence of vertices
template <typename TriangleMesh>
Vertex_numbers<TriangleMesh> vertex_positions(const TriangleMesh& mesh)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  if constexpr(Seam_sides<TriangleMesh>::has_seams)
    return [&mesh, position = vertex_positions(mesh.mesh())](const vertex_descriptor& v) {
      return position(Seam_sides<TriangleMesh>::surface_vertex(v, mesh));
    };
  else {
    const auto position = get(CGAL::dynamic_vertex_property_t<std::ptrdiff_t>(), mesh);
    std::ptrdiff_t next = 0;
    for(const vertex_descriptor& v : vertices(mesh))
      put(position, v, next++);
    return vertex_numbers_of<TriangleMesh>(position);
  }
}

// Those that `vertex_index_map` gives; empty if it is not given
template <typename TriangleMesh, typename NamedParameters>
Vertex_numbers<TriangleMesh> given_numbers([[maybe_unused]] const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_index_t>::value)
    return {};
  else
    return vertex_numbers_of<TriangleMesh>(parameters::get_parameter(np, internal_np::vertex_index));
}

// The same, or positions
template <typename TriangleMesh, typename NamedParameters>
Vertex_numbers<TriangleMesh> vertex_numbers(const TriangleMesh& mesh, const NamedParameters& np)
{
  Vertex_numbers<TriangleMesh> numbers = given_numbers<TriangleMesh>(np);
  return numbers ? numbers : vertex_positions(mesh);
}

// How a sentence about such a vertex goes on
inline constexpr const char* non_finite_text = " has coordinates that are not all finite numbers";

// The position of an element in a range of the mesh
template <typename Range, typename Descriptor>
std::string rank_text(const Range& range, const Descriptor& descriptor)
{
  return std::to_string(std::distance(range.begin(), std::find(range.begin(), range.end(), descriptor)));
}

// A point in parentheses
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string point_text(double x, double y, double z);

template <typename Point>
std::string point_text(const Point& p)
{
  return point_text(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

template <typename Point>
std::string vertex_text(std::ptrdiff_t number, const Point& p)
{
  return "vertex " + std::to_string(number) + " " + point_text(p);
}

// A vertex of a chart. Vertices that fill holes have no numbers.
CGAL_ANGLE_BASED_FLATTENING_INLINE std::string vertex_text(const Corner_table& chart, int v);

template <typename TriangleMesh, typename = void>
inline constexpr bool has_points = false;

template <typename TriangleMesh>
inline constexpr bool has_points<
    TriangleMesh, std::void_t<decltype(get(CGAL::vertex_point, std::declval<const TriangleMesh&>()))>> = true;

// A vertex of a mesh, for functions that are not given points: without coordinates if the mesh has none. Takes linear
// time without given numbers.
template <typename TriangleMesh, typename NamedParameters = parameters::Default_named_parameters>
std::string vertex_of_mesh_text(const TriangleMesh& mesh,
                                const typename boost::graph_traits<TriangleMesh>::vertex_descriptor& v,
                                const NamedParameters& np = parameters::default_values())
{
  const std::ptrdiff_t number = vertex_numbers(mesh, np)(v);
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
    return vertex_text(number, get(parameters::get_parameter(np, internal_np::vertex_point), v));
  else if constexpr(has_points<TriangleMesh>)
    return vertex_text(number, get(get(CGAL::vertex_point, mesh), v));
  else
    return "vertex " + std::to_string(number);
}

// A face by its corners: "the face of vertex 3 (0, 0, 0), vertex 5 (1, 0, 0) and vertex 9 (0, 1, 0)"; the first three
// of more
template <typename TriangleMesh, typename VertexPointMap>
std::string face_text(const typename boost::graph_traits<TriangleMesh>::face_descriptor& f,
                      const TriangleMesh& mesh, VertexPointMap points,
                      const Vertex_numbers<TriangleMesh>& numbers)
{
  std::string text = "the face of ";
  auto h = halfedge(f, mesh);
  for(const char* separator : {"", ", ", " and "}) {
    text += separator + vertex_text(numbers(target(h, mesh)), get(points, target(h, mesh)));
    h = next(h, mesh);
  }
  return text;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_NAMES_H
