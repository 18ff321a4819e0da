// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_IO_OBJ_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_IO_OBJ_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <fstream>
#include <locale>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// \file OBJ.h

namespace CGAL {

namespace Surface_mesh_parameterization {

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

// Writes a mesh with texture coordinates. Corners at one vertex share those that are equal, within each patch.
template <typename PolygonMesh, typename UVMap, typename NamedParameters>
class Obj_writer
{
  typedef boost::graph_traits<PolygonMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef std::tuple<double, double, long> Corner; // coordinates and patch
  static constexpr bool has_patches =
      !parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value;

public:
  Obj_writer(std::ostream& out, const PolygonMesh& mesh, UVMap uv, const NamedParameters& np)
      : m_out(out), m_mesh(mesh), m_coordinates(mesh, uv), m_np(np)
  {}

  bool run()
  {
    const std::streamsize precision = m_out.precision(
        parameters::choose_parameter(parameters::get_parameter(m_np, internal_np::stream_precision), 17));
    write_vertices();
    write_faces();
    m_out.precision(precision);
    return m_out.good();
  }

private:
  long patch(face_descriptor f) const
  {
    if constexpr(has_patches)
      return static_cast<long>(get(parameters::get_parameter(m_np, internal_np::face_patch), f));
    else {
      (void)f;
      return 0;
    }
  }

  void write_vertices()
  {
    const auto points =
        parameters::choose_parameter(parameters::get_parameter(m_np, internal_np::vertex_point),
                                     get_const_property_map(CGAL::vertex_point, m_mesh));
    m_number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), m_mesh);
    std::size_t count = 0;
    for(const auto v : vertices(m_mesh)) {
      const auto& p = get(points, v);
      m_out << "v " << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' '
            << CGAL::to_double(p.z()) << '\n';
      put(m_number, v, count++);
    }
    m_corners.resize(count);
  }

  // The number of the coordinates of a corner, which are written when they first occur
  std::size_t number_of(halfedge_descriptor h)
  {
    const auto& p = m_coordinates[h];
    const Corner corner(CGAL::to_double(p.x()), CGAL::to_double(p.y()), patch(face(h, m_mesh)));
    auto& corners = m_corners[get(m_number, target(h, m_mesh))];
    for(const auto& [other, number] : corners)
      if(other == corner)
        return number;
    m_out << "vt " << std::get<0>(corner) << ' ' << std::get<1>(corner) << '\n';
    corners.emplace_back(corner, ++m_count);
    return m_count;
  }

  void write_faces()
  {
    for(const face_descriptor f : faces(m_mesh)) {
      const bool has_uv = patch(f) >= 0;
      std::vector<std::size_t> numbers;
      if(has_uv)
        for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
          numbers.push_back(number_of(h));
      m_out << 'f';
      std::size_t k = 0;
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        m_out << ' ' << get(m_number, target(h, m_mesh)) + 1;
        if(has_uv)
          m_out << '/' << numbers[k++];
      }
      m_out << '\n';
    }
  }

  std::ostream& m_out;
  const PolygonMesh& m_mesh;
  const Corner_coordinates<PolygonMesh, UVMap> m_coordinates;
  const NamedParameters& m_np;
  typename boost::property_map<PolygonMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type
      m_number;
  std::vector<std::vector<std::pair<Corner, std::size_t>>> m_corners; // of each vertex
  std::size_t m_count = 0;
};

} // namespace internal::ABF
#endif // DOXYGEN_RUNNING

namespace IO {

/*!
\ingroup PkgAngleBasedFlatteningRef

writes a mesh with texture coordinates to a stream, in the OBJ format.

Vertices and faces keep the order of the mesh. Corners at a vertex share equal texture coordinates. The coordinates may
come from any program.

\tparam PolygonMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam UVMap a model of `ReadablePropertyMap` with a two-dimensional point as value type. The key type is
        `boost::graph_traits<PolygonMesh>::%vertex_descriptor` or `%halfedge_descriptor`. A halfedge stores the
        coordinates of its target in its face, as `make_atlas()` writes them.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param out the stream
\param mesh a mesh
\param uv the texture coordinates
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{the chart number of each face. Charts do not share coordinates, even if these are equal. A
    face with a negative number gets no coordinates.}
    \cgalParamType{a model of `ReadablePropertyMap` with an integer as value type}
    \cgalParamDefault{all faces are in one chart}
  \cgalParamNEnd
  \cgalParamNBegin{stream_precision}
    \cgalParamDescription{the number of digits of coordinates}
    \cgalParamType{`int`}
    \cgalParamDefault{`17`: reading gives back the same numbers of type `double`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether writing succeeded
*/
template <typename PolygonMesh, typename UVMap,
          typename NamedParameters = parameters::Default_named_parameters>
bool write_OBJ(std::ostream& out, const PolygonMesh& mesh, UVMap uv,
               const NamedParameters& np = parameters::default_values())
{
  return internal::ABF::Obj_writer<PolygonMesh, UVMap, NamedParameters>(out, mesh, uv, np).run();
}

/*!
\ingroup PkgAngleBasedFlatteningRef

writes a mesh with texture coordinates to a file, as above.
*/
template <typename PolygonMesh, typename UVMap,
          typename NamedParameters = parameters::Default_named_parameters>
bool write_OBJ(const std::string& fname, const PolygonMesh& mesh, UVMap uv,
               const NamedParameters& np = parameters::default_values())
{
  std::ofstream out(fname);
  out.imbue(std::locale::classic());
  return write_OBJ(out, mesh, uv, np) && out.flush();
}

} // namespace IO

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_IO_OBJ_H
