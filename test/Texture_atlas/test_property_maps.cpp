// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Both parameterizers, measures and certificates with every usual kind of property map: the same result.

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

// With CGAL 6 a dynamic map takes a default value by reference, and that of a point has no coordinates.
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

BOOST_AUTO_TEST_SUITE(test_property_maps)

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;

namespace {

template <typename UV_map>
std::vector<std::pair<double, double>> coordinates(const Mesh& mesh, UV_map uv)
{
  std::vector<std::pair<double, double>> result;
  for(Vertex v : vertices(mesh))
    result.emplace_back(CGAL::to_double(get(uv, v).x()), CGAL::to_double(get(uv, v).y()));
  return result;
}

// A parameterizer on the same bump, with all kinds of maps.
template <template <typename, typename> class Parameterizer>
struct Bump
{
  template <typename UV_map, typename Vertex_index_map>
  std::vector<std::pair<double, double>> flatten(UV_map uv, Vertex_index_map indices)
  {
    Parameterizer<Mesh, CGAL::Default> parameterizer;
    const auto parameterized = boost::make_constant_property<Vertex>(false);
    BOOST_TEST(parameterizer.parameterize(mesh, test_meshes::border(mesh), uv, indices, parameterized) ==
               SMP::OK);
    BOOST_TEST(parameterizer.report().message == "");
    const Mesh& unchanged = mesh;
    BOOST_TEST(SMP::is_injective(unchanged, uv));
    BOOST_TEST(SMP::measure_flattening(unchanged, test_meshes::border(unchanged), uv).flipped_triangles == 0);
    return coordinates(mesh, uv);
  }

  template <typename UV_map>
  std::vector<std::pair<double, double>> flatten_into(UV_map uv)
  {
    return flatten(uv, get(boost::vertex_index, mesh));
  }

  template <typename Vertex_index_map>
  std::vector<std::pair<double, double>> flatten_by(Vertex_index_map indices)
  {
    return flatten(get(CGAL::dynamic_vertex_property_t<Point_2>(), mesh), indices);
  }

  Mesh mesh = test_meshes::bump<Mesh>(14);
};

// Reads and writes by calling functions.
struct Function_map
{
  typedef Vertex key_type;
  typedef Point_2 value_type;
  typedef Point_2 reference;
  typedef boost::read_write_property_map_tag category;

  friend Point_2 get(const Function_map& map, Vertex v) { return map.read(v); }
  friend void put(const Function_map& map, Vertex v, const Point_2& p) { map.write(v, p); }

  std::function<Point_2(Vertex)> read;
  std::function<void(Vertex, const Point_2&)> write;
};

template <template <typename, typename> class Parameterizer>
void check_uv_maps()
{
  Bump<Parameterizer> bump;
  Mesh& mesh = bump.mesh;
  const auto internal = mesh.template add_property_map<Vertex, Point_2>("v:uv").first;
  const auto expected = bump.flatten_into(internal);

  BOOST_TEST((bump.flatten_into(get(CGAL::dynamic_vertex_property_t<Point_2>(), mesh)) == expected));

  std::map<Vertex, Point_2> tree;
  BOOST_TEST((bump.flatten_into(boost::make_assoc_property_map(tree)) == expected));

  std::vector<Point_2> array(num_vertices(mesh));
  const auto in_array = boost::make_iterator_property_map(array.begin(), get(boost::vertex_index, mesh));
  BOOST_TEST((bump.flatten_into(in_array) == expected));

  std::vector<Point_2> behind(num_vertices(mesh));
  const Function_map functions{[&behind](Vertex v) { return behind[v]; },
                               [&behind](Vertex v, const Point_2& p) { behind[v] = p; }};
  BOOST_TEST((bump.flatten_into(functions) == expected));
}

// The indices only have to be different, and may exceed the range of `int`.
template <template <typename, typename> class Parameterizer>
void check_index_maps()
{
  Bump<Parameterizer> bump;
  Mesh& mesh = bump.mesh;
  const auto expected = bump.flatten_by(get(boost::vertex_index, mesh));

  const auto internal = mesh.template add_property_map<Vertex, std::size_t>("v:index").first;
  const auto dynamic = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  std::map<Vertex, long> tree;
  for(Vertex v : vertices(mesh)) {
    internal[v] = v.idx();
    put(dynamic, v, 3 * static_cast<int>(v.idx()) - 100);
    tree[v] = -static_cast<long>(v.idx());
  }
  BOOST_TEST((bump.flatten_by(internal) == expected));
  BOOST_TEST((bump.flatten_by(dynamic) == expected));
  BOOST_TEST((bump.flatten_by(boost::make_assoc_property_map(tree)) == expected));
  const auto large = [](Vertex v) { return std::uint64_t(v.idx()) << 40; };
  BOOST_TEST((bump.flatten_by(boost::make_function_property_map<Vertex>(large)) == expected));
}

// Values may be of any type that is convertible to `double`.
template <template <typename, typename> class Parameterizer>
void check_importance_maps()
{
  typedef Mesh::Face_index Face;
  Mesh mesh = test_meshes::bump<Mesh>(12);
  const auto flatten = [&](auto importance) {
    std::map<Vertex, Point_2> uv;
    Parameterizer<Mesh, CGAL::Default> parameterizer;
    parameterizer.set_importance(importance);
    const auto parameterized = boost::make_constant_property<Vertex>(false);
    BOOST_TEST(parameterizer.parameterize(mesh, test_meshes::border(mesh), boost::make_assoc_property_map(uv),
                                          get(boost::vertex_index, mesh), parameterized) == SMP::OK);
    return coordinates(mesh, boost::make_assoc_property_map(uv));
  };
  const auto value = [](Face f) { return 1 + static_cast<int>(f.idx()) % 4; };
  const auto expected = flatten(boost::make_function_property_map<Face>(value));

  const auto internal = mesh.add_property_map<Face, float>("f:importance").first;
  const auto dynamic = get(CGAL::dynamic_face_property_t<double>(), mesh);
  std::map<Face, int> tree;
  for(Face f : faces(mesh)) {
    internal[f] = static_cast<float>(value(f));
    put(dynamic, f, value(f));
    tree[f] = value(f);
  }
  BOOST_TEST((flatten(internal) == expected));
  BOOST_TEST((flatten(dynamic) == expected));
  BOOST_TEST((flatten(boost::make_assoc_property_map(tree)) == expected));
  BOOST_TEST((flatten(boost::make_constant_property<Face>(1.)) != expected));
}

template <typename T, typename S = CGAL::Default>
using Direct = SMP::ABF_plus_plus_parameterizer_3<T, S>;

template <typename T, typename S = CGAL::Default>
using Hierarchical = SMP::Hierarchical_parameterizer_3<T, S>;

} // namespace

BOOST_AUTO_TEST_CASE(uv_maps)
{
  check_uv_maps<Direct>();
  check_uv_maps<Hierarchical>();
}

BOOST_AUTO_TEST_CASE(vertex_index_maps)
{
  check_index_maps<Direct>();
  check_index_maps<Hierarchical>();
}

BOOST_AUTO_TEST_CASE(face_importance_maps)
{
  check_importance_maps<Direct>();
  check_importance_maps<Hierarchical>();
}

BOOST_AUTO_TEST_SUITE_END()
