// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_IO_OBJ_H
#define CGAL_TEXTURE_ATLAS_IO_OBJ_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Texture_atlas/IO/OBJ_material.h>
#include <CGAL/Texture_atlas/internal/files/build_obj_mesh.h>
#include <CGAL/Texture_atlas/internal/files/read_obj_soup.h>
#include <CGAL/Texture_atlas/internal/files/write_obj_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <fstream>
#include <istream>
#include <ostream>
#include <string>
#include <vector>

/// \file OBJ.h

namespace CGAL {

namespace Texture_atlas {

namespace IO {

/*!
\ingroup PkgTextureAtlasRef

writes a mesh with texture coordinates to a stream, in the OBJ format.

Vertices and faces keep the order of the mesh. Corners at a vertex share their texture coordinates where these are
equal. Any program may have made the coordinates. `read_OBJ()` reads the same bits back. If a number is not finite,
nothing is written.

\tparam PolygonMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam UVMap a model of `ReadablePropertyMap` with a two-dimensional point as value type. The key type is
        `boost::graph_traits<PolygonMesh>::%vertex_descriptor` or `%halfedge_descriptor`. A halfedge of a face has the
        coordinates of its target at that face, as `make_atlas()` writes them.
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
  \cgalParamNBegin{vertex_normal_map}
    \cgalParamDescription{the normals of the vertices, such as those to which `bake_surface()` refers}
    \cgalParamType{a model of `ReadablePropertyMap` with a `Vector_3` of any kernel as value type}
    \cgalParamDefault{no normals are written}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{the number of each face's chart. Charts do not share coordinates, also where they are equal,
    and a face with a negative number gets none.}
    \cgalParamType{a model of `ReadablePropertyMap` with an integer as value type}
    \cgalParamDefault{all faces are in one chart}
  \cgalParamNEnd
  \cgalParamNBegin{stream_precision}
    \cgalParamDescription{the number of digits of coordinates, from 1 to 17. With 17, numbers have as many digits as are
    needed to read them back as they are. The settings of the stream play no role.}
    \cgalParamType{`int`}
    \cgalParamDefault{`17`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what is wrong, if anything. Vertices and faces in messages are numbered from 0, in the order of the mesh.
*/
template <typename PolygonMesh, typename UVMap,
          typename NamedParameters = parameters::Default_named_parameters>
OBJ_report write_OBJ(std::ostream& out, const PolygonMesh& mesh, UVMap uv,
                     const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<PolygonMesh>::face_descriptor face_descriptor;
  typedef CGAL::Constant_property_map<face_descriptor, int> No_materials;
  const std::vector<OBJ_material> none;
  internal::Obj_mesh_writer<PolygonMesh, UVMap, No_materials, NamedParameters> writer(
      mesh, uv, No_materials(0), none, np);
  const OBJ_report report = writer.check();
  if(report)
    writer.write(out, std::string());
  return report && !out.good() ? internal::obj_failure(Diagnosis::CANNOT_WRITE, "writing failed") : report;
}

/*!
\ingroup PkgTextureAtlasRef

writes a mesh with texture coordinates to the file `fname`, as above.
*/
template <typename PolygonMesh, typename UVMap,
          typename NamedParameters = parameters::Default_named_parameters>
OBJ_report write_OBJ(const std::string& fname, const PolygonMesh& mesh, UVMap uv,
                     const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<PolygonMesh>::face_descriptor face_descriptor;
  return internal::write_obj_files(fname, mesh, uv, CGAL::Constant_property_map<face_descriptor, int>(0),
                                   std::vector<OBJ_material>(), np);
}

/*!
\ingroup PkgTextureAtlasRef

writes a mesh with texture coordinates and one material for all faces, as above. The material is written to a file of
the same name that ends with `.mtl`: `atlas.mtl` beside `atlas.obj`.

\code{.cpp}
SMP::OBJ_material material;
material.color_image = "atlas.png";
SMP::IO::write_OBJ("atlas.obj", mesh, uv, material);
\endcode
*/
template <typename PolygonMesh, typename UVMap,
          typename NamedParameters = parameters::Default_named_parameters>
OBJ_report write_OBJ(const std::string& fname, const PolygonMesh& mesh, UVMap uv,
                     const OBJ_material& material, const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<PolygonMesh>::face_descriptor face_descriptor;
  return internal::write_obj_files(fname, mesh, uv, CGAL::Constant_property_map<face_descriptor, int>(0),
                                   std::vector<OBJ_material>(1, material), np);
}

/*!
\ingroup PkgTextureAtlasRef

writes a mesh with texture coordinates and several materials, as above.

\tparam FaceMaterialMap a model of `ReadablePropertyMap` with `boost::graph_traits<PolygonMesh>::%face_descriptor` as
        key type and an integer as value type

\param fname the name of the file
\param mesh a mesh
\param uv the texture coordinates
\param face_materials which of the materials each face has, numbered from 0
\param materials the materials
\param np optional named parameters, as above
*/
template <typename PolygonMesh, typename UVMap, typename FaceMaterialMap,
          typename NamedParameters = parameters::Default_named_parameters>
OBJ_report write_OBJ(const std::string& fname, const PolygonMesh& mesh, UVMap uv,
                     FaceMaterialMap face_materials, const std::vector<OBJ_material>& materials,
                     const NamedParameters& np = parameters::default_values())
{
  return internal::write_obj_files(fname, mesh, uv, face_materials, materials, np);
}

/*!
\ingroup PkgTextureAtlasRef

reads a mesh with texture coordinates from a stream, in the OBJ format.

The vertices and faces of the file are added to the mesh, in the order of the file. Vertices without faces are kept.
Faces may have any number of vertices, may come before the vertices that they name, and may count them backwards. A line
that ends with a backslash goes on in the next one. Normals, groups, materials, lines and all other statements are
ignored.

A face has texture coordinates at all corners or at none. Where there are none, `uv` keeps the value that it has, and
the report counts these faces.

If a vertex of the file lies on a seam, its corners have several places in the plane, and only a map of halfedges can
hold them.

\tparam PolygonMesh a model of `MutableFaceGraph`
\tparam UVMap a model of `WritablePropertyMap` with a two-dimensional point of any kernel as value type. The key type is
        `boost::graph_traits<PolygonMesh>::%vertex_descriptor` or `%halfedge_descriptor`. It must grow with the mesh,
        like the property maps of `Surface_mesh`, `boost::associative_property_map` and
        `CGAL::dynamic_halfedge_property_t`.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param in the stream, which is read to its end
\param mesh receives the vertices and faces. Unchanged if anything is wrong
\param uv receives the texture coordinates. A halfedge of a face gets those of its target at that face; border
       halfedges get none. Unchanged if anything is wrong
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{receives the points of the vertices}
    \cgalParamType{a model of `WritablePropertyMap` with a `Point_3` of any kernel as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what is wrong in which line. Vertices, texture coordinates and faces in messages are numbered from 1, as in the
file:

- `EMPTY_MESH`: there is no face;
- `NON_FINITE_POINT`, `NON_FINITE_COORDINATE`, `NOT_A_NUMBER`, `TOO_FEW_NUMBERS`, `NUMBER_OUT_OF_RANGE`: of a line;
- `NO_TEXTURE_COORDINATES`: a face has them at some corners only;
- `REPEATED_VERTEX`, `NON_MANIFOLD_EDGE`, `NON_MANIFOLD_VERTEX`: a face does not fit to the others. Nothing is repaired;
- `INCONSISTENT_COORDINATES`: `uv` is a map of vertices, and the corners of a vertex have different coordinates;
- `PRECISION_EXCEEDED`: a number is too large for the number type of the points or of `uv`;
- `CANNOT_READ`: the stream failed.
*/
template <typename PolygonMesh, typename UVMap,
          typename NamedParameters = parameters::Default_named_parameters>
OBJ_report read_OBJ(std::istream& in, PolygonMesh& mesh, UVMap uv,
                    const NamedParameters& np = parameters::default_values())
{
  internal::Obj_soup soup;
  OBJ_report report = internal::read_obj_soup(in, soup);
  if(!report)
    return report;
  const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                   get_property_map(CGAL::vertex_point, mesh));
  const OBJ_report built = internal::build_obj_mesh(soup, mesh, uv, points);
  return built ? report : built;
}

/*!
\ingroup PkgTextureAtlasRef

reads a mesh with texture coordinates from the file `fname`, as above. If the file cannot be opened, the status is
`CANNOT_OPEN`.
*/
template <typename PolygonMesh, typename UVMap,
          typename NamedParameters = parameters::Default_named_parameters>
OBJ_report read_OBJ(const std::string& fname, PolygonMesh& mesh, UVMap uv,
                    const NamedParameters& np = parameters::default_values())
{
  std::ifstream in(fname, std::ios::binary);
  if(!in)
    return internal::obj_failure(Diagnosis::CANNOT_OPEN, "cannot open " + fname);
  OBJ_report report = read_OBJ(in, mesh, uv, np);
  if(!report)
    report.message = fname + ": " + report.message;
  return report;
}

} // namespace IO

} // namespace Texture_atlas

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TEXTURE_ATLAS_IO_OBJ_H
