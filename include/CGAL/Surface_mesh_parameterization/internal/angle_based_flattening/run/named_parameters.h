// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Visitors as named parameters, and checks of the types of property maps. A wrong type ends in one sentence, not in the
// templates of boost.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_NAMED_PARAMETERS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_NAMED_PARAMETERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

template <class T>
struct Is_named_parameters : std::false_type
{};

template <class T, class Tag, class Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base>> : std::true_type
{};

// Tells a map from options or named parameters, which are in the same place where maps are left out.
template <class Map, class Options>
using Is_map = std::enable_if_t<!Is_named_parameters<Map>::value && !std::is_convertible_v<Map, Options>>;

// Whether a property map takes keys of this type. `nullptr` stands for no map.
template <class Map, class Key, class = void>
struct Has_key : std::is_same<Map, std::nullptr_t>
{};

template <class Map, class Key>
struct Has_key<Map, Key, std::enable_if_t<!std::is_void_v<typename boost::property_traits<Map>::key_type>>>
    : std::is_convertible<Key, typename boost::property_traits<Map>::key_type>
{};

// A class is instantiated where it is used, and so its assertion comes before other errors.
template <class Mesh, class Map>
struct Check_vertex_map
{
  static_assert(Has_key<Map, typename boost::graph_traits<Mesh>::vertex_descriptor>::value,
                "This property map must have the vertex descriptor of the mesh as its key type.");
};

template <class Mesh, class Map>
struct Check_halfedge_map
{
  static_assert(Has_key<Map, typename boost::graph_traits<Mesh>::halfedge_descriptor>::value,
                "This property map must have the halfedge descriptor of the mesh as its key type.");
};

template <class Mesh, class Map>
struct Check_edge_map
{
  static_assert(Has_key<Map, typename boost::graph_traits<Mesh>::edge_descriptor>::value,
                "This property map must have the edge descriptor of the mesh as its key type.");
};

template <class Mesh, class Map>
struct Check_face_map
{
  static_assert(Has_key<Map, typename boost::graph_traits<Mesh>::face_descriptor>::value,
                "This property map must have the face descriptor of the mesh as its key type.");
};

// The visitor among named parameters: a copy, or the object that a `std::reference_wrapper` refers to
template <class Visitor, class NamedParameters>
class Visitor_parameter
{
  typedef typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Visitor>::type
      Given;

public:
  explicit Visitor_parameter(const NamedParameters& np)
      : m_given(parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor), Visitor()))
  {}

  // Options have a visitor, too.
  Visitor* pointer(Visitor* otherwise)
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value) {
      return otherwise;
    } else {
      static_assert(std::is_convertible<decltype(object(m_given)), Visitor*>::value,
                    "This visitor must be derived from Flattening_visitor or Atlas_visitor.");
      return object(m_given);
    }
  }

private:
  template <class Object>
  static Object* object(Object& given)
  {
    return &given;
  }

  template <class Object>
  static Object* object(std::reference_wrapper<Object>& given)
  {
    return &given.get();
  }

  Given m_given;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_RUN_NAMED_PARAMETERS_H
