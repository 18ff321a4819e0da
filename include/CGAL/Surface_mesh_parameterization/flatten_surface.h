// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTEN_SURFACE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTEN_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

/// \file flatten_surface.h

namespace CGAL {

#ifndef DOXYGEN_RUNNING
namespace internal_np {

enum face_importance_t
{
  face_importance
};

} // namespace internal_np
#endif // DOXYGEN_RUNNING

namespace parameters {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// begins a sequence of named parameters with the importance of faces, for `flatten_surface()`. Other parameters follow
/// it: `face_importance_map(importance).visitor(visitor)`. Elsewhere in a sequence it does not compile, because the
/// class of sequences is \cgal's.
template <typename FaceImportanceMap>
#ifndef DOXYGEN_RUNNING
Named_function_parameters<FaceImportanceMap, internal_np::face_importance_t>
#else
unspecified_type
#endif
face_importance_map(const FaceImportanceMap& map)
{
  return Named_function_parameters<FaceImportanceMap, internal_np::face_importance_t>(map);
}

} // namespace parameters

namespace Surface_mesh_parameterization {

#ifndef DOXYGEN_RUNNING
template <typename TriangleMesh, typename CoarseParameterizer, typename SolverTraits>
class Hierarchical_parameterizer_3;

namespace internal::ABF {

// A halfedge on the longest border, or on any one if lengths are not finite; the null halfedge for a closed surface
template <typename TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
halfedge_on_border(const TriangleMesh& mesh, const Vertex_points<TriangleMesh>& given_points)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  const auto points = boost::make_function_property_map<vertex_descriptor>(
      [&](const vertex_descriptor& v) { return given_points(v, mesh); });
  const auto longest =
      given_points ? Polygon_mesh_processing::longest_border(mesh, parameters::vertex_point_map(points)).first
                   : Polygon_mesh_processing::longest_border(mesh).first;
  if(longest != boost::graph_traits<TriangleMesh>::null_halfedge())
    return longest;
  const auto all = halfedges(mesh);
  const auto any = std::find_if(all.begin(), all.end(), [&](auto h) { return CGAL::is_border(h, mesh); });
  return any == all.end() ? longest : *any;
}

// Notes coordinates for a property map of the caller's, which is written when nothing can fail any more.
template <typename VertexUVMap>
struct Noted_map
{
  typedef typename boost::property_traits<VertexUVMap>::key_type key_type;
  typedef typename boost::property_traits<VertexUVMap>::value_type value_type;
  typedef value_type reference;
  typedef boost::writable_property_map_tag category;

  std::vector<std::pair<key_type, value_type>>* notes;

  friend void put(const Noted_map& map, const key_type& key, const value_type& value)
  {
    map.notes->emplace_back(key, value);
  }
};

// The parameterizer that options are for. Anything else is a parameterizer.
template <typename TriangleMesh, typename Method>
struct Parameterizer_of
{
  typedef Method type;
};

template <typename TriangleMesh>
struct Parameterizer_of<TriangleMesh, ABF_plus_plus_options>
{
  typedef ABF_plus_plus_parameterizer_3<TriangleMesh> type;
};

template <typename TriangleMesh>
struct Parameterizer_of<TriangleMesh, Hierarchical_options>
{
  typedef Hierarchical_parameterizer_3<TriangleMesh, Default, Default> type;
};

template <typename TriangleMesh, typename Method>
using Report_of_method =
    std::decay_t<decltype(std::declval<typename Parameterizer_of<TriangleMesh, Method>::type&>().report())>;

} // namespace internal::ABF
#endif // DOXYGEN_RUNNING

/*!
\ingroup PkgAngleBasedFlatteningRef

flattens the connected component of the longest border of `mesh`. If this is not possible, the report says why.

A closed or empty mesh has the diagnosis `Diagnosis::NO_BORDER` or `Diagnosis::EMPTY_MESH`. Coordinates, requirements
on the surface, errors and complexity are those of `parameterize()`. Finding the longest border takes linear time.

\code{.cpp}
const auto report = flatten_surface(mesh, uvmap); // or flatten_surface(mesh, uvmap, options, np)
if(!report)
  std::cerr << report.message << "\n";
\endcode

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with an internal vertex point property map
\tparam VertexUVMap a model of `WritablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_2` of any kernel as value type
\tparam Method `ABF_plus_plus_options`, `Hierarchical_options` (include `Hierarchical_parameterizer_3.h`), or a
        parameterizer of this package
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a triangle mesh
\param uvmap receives the planar coordinates; on any error it is unchanged
\param method the options of a parameterizer, or a parameterizer
\param np optional named parameters:

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` as for `ABF_plus_plus_parameterizer_3::set_points()`}
    \cgalParamDefault{those of the parameterizer}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{the numbers of vertices in messages}
    \cgalParamType{a model of `ReadablePropertyMap` as for `ABF_plus_plus_parameterizer_3::set_vertex_numbers()`}
    \cgalParamDefault{those of the parameterizer}
  \cgalParamNEnd
  \cgalParamNBegin{face_importance_map}
    \cgalParamDescription{how much the angles of each face count}
    \cgalParamType{a model of `ReadablePropertyMap` as for `ABF_plus_plus_parameterizer_3::set_importance()`}
    \cgalParamDefault{that of the parameterizer}
    \cgalParamExtra{It is the first parameter of a sequence: `parameters::face_importance_map()`.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{follows the computation, and may stop it}
    \cgalParamType{a model of `FlatteningVisitor`, or a `std::reference_wrapper` of one. Parameterizers have
                   `Flattening_options::visitor` instead.}
    \cgalParamDefault{`Flattening_options::visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a copy of the report of the parameterizer, with all its members: a `Mesh_report` with an `ABF_plus_plus_report`
or a `Hierarchical_report`, which are kinds of `Flattening_report`. `error_code()` returns the error code of its
diagnosis.
*/
template <typename TriangleMesh, typename VertexUVMap, typename Method,
          typename NamedParameters = parameters::Default_named_parameters>
#ifndef DOXYGEN_RUNNING
internal::ABF::Report_of_method<TriangleMesh, Method>
#else
unspecified_type
#endif
flatten_surface(TriangleMesh& mesh, VertexUVMap uvmap, Method method,
                const NamedParameters& np = parameters::default_values())
{
  internal::ABF::Check_vertex_map<TriangleMesh, VertexUVMap>();
  internal::ABF::Visitor_parameter<Flattening_visitor, NamedParameters> visitor(np);
  if constexpr(std::is_base_of<Flattening_options, Method>::value)
    method.visitor = visitor.pointer(method.visitor);
  else
    static_assert(parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value,
                  "The visitor of a parameterizer is one of its options.");
  typename internal::ABF::Parameterizer_of<TriangleMesh, Method>::type parameterizer(std::move(method));
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
    parameterizer.set_points(parameters::get_parameter(np, internal_np::vertex_point));
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::vertex_index_t>::value)
    parameterizer.set_vertex_numbers(parameters::get_parameter(np, internal_np::vertex_index));
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_importance_t>::value)
    parameterizer.set_importance(parameters::get_parameter(np, internal_np::face_importance));
  const auto border = internal::ABF::halfedge_on_border(mesh, internal::ABF::given_points<TriangleMesh>(np));
  typedef internal::ABF::Noted_map<VertexUVMap> Noted_map;
  std::vector<std::pair<typename Noted_map::key_type, typename Noted_map::value_type>> notes;
  parameterize(mesh, parameterizer, border, Noted_map{&notes}); // which names a closed or empty mesh
  auto report = parameterizer.report();
  for(const auto& [vertex, point] : notes)
    put(uvmap, vertex, point);
  return report;
}

/*!
\ingroup PkgAngleBasedFlatteningRef

flattens a surface as above, by `ABF_plus_plus_parameterizer_3` with its default options.
*/
template <typename TriangleMesh, typename VertexUVMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifndef DOXYGEN_RUNNING
internal::ABF::Report_of_method<TriangleMesh, ABF_plus_plus_options>
#else
unspecified_type
#endif
flatten_surface(TriangleMesh& mesh, VertexUVMap uvmap, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return flatten_surface(mesh, uvmap, ABF_plus_plus_options(), np);
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FLATTEN_SURFACE_H
