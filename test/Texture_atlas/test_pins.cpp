// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices with given positions, by both parameterizers, and whether maps are one-to-one.

#include <boost/test/unit_test.hpp>

#include "mesh_of_chart.h"
#include "overlapping_charts.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_pins)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using SMP::Diagnosis;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Vector_2 Vector_2;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Vertex, Point_2> UV_map;
typedef std::map<Vertex, Point_2> Pins;
typedef SMP::ABF_plus_plus_parameterizer_3<Mesh> Direct;
typedef SMP::Hierarchical_parameterizer_3<Mesh> Hierarchical;
typedef boost::mpl::list<Direct, Hierarchical> Parameterizers;

namespace {

template <typename Parameterizer>
struct Options_of
{
  typedef SMP::ABF_plus_plus_options type;
};

template <>
struct Options_of<Hierarchical>
{
  typedef SMP::Hierarchical_options type;
};

template <typename Key, typename Point>
auto pin_map(const std::map<Key, Point>& pins)
{
  return boost::make_function_property_map<Key>([pins](const Key& v) {
    const auto pin = pins.find(v);
    return pin == pins.end() ? std::optional<Point>() : std::optional<Point>(pin->second);
  });
}

// A mesh with a map for each call, and the report of the last one
template <typename Parameterizer>
struct Surface
{
  explicit Surface(Mesh surface) : mesh(std::move(surface)) {}

  UV_map flatten(const Pins& pins = {})
  {
    const UV_map uv =
        mesh.template add_property_map<Vertex, Point_2>("v:uv" + std::to_string(maps++), unset).first;
    Parameterizer parameterizer(options);
    if(!pins.empty())
      parameterizer.set_pins(pin_map(pins));
    code = SMP::parameterize(mesh, parameterizer, test_meshes::border(mesh), uv);
    report = parameterizer.report();
    offending_vertices = parameterizer.report().offending_vertices;
    offending_faces = parameterizer.report().offending_faces;
    BOOST_TEST((code == SMP::OK) == report.message.empty());
    if(code == SMP::OK)
      BOOST_TEST(SMP::is_locally_injective(mesh, test_meshes::border(mesh), uv));
    else
      for(Vertex v : mesh.vertices())
        BOOST_REQUIRE(uv[v] == unset);
    return uv;
  }

  double angle(const UV_map& uv, Mesh::Halfedge_index h) const
  {
    const Point_2 p = uv[mesh.target(h)];
    const Vector_2 a = uv[mesh.target(mesh.next(h))] - p, b = uv[mesh.source(h)] - p;
    return std::atan2(CGAL::determinant(a, b), a * b);
  }

  double largest_angle_change(const UV_map& uv, const UV_map& other) const
  {
    double largest = 0;
    for(Mesh::Halfedge_index h : mesh.halfedges())
      if(!mesh.is_border(h))
        largest = (std::max)(largest, std::abs(angle(uv, h) - angle(other, h)));
    return largest;
  }

  std::vector<Vertex> some_vertices(int number, unsigned seed) const
  {
    std::vector<Vertex> vertices(mesh.vertices().begin(), mesh.vertices().end());
    std::mt19937 random(seed);
    for(int i = 0; i < number; ++i)
      std::swap(vertices[i], vertices[i + random() % (vertices.size() - i)]);
    vertices.resize(number);
    return vertices;
  }

  // Positions near to those of the map, turned by a quarter
  Pins pins_near(const UV_map& uv, int number, double distance, unsigned seed) const
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-distance, distance);
    Pins pins;
    for(Vertex v : some_vertices(number, seed)) {
      const double x = shift(random), y = shift(random);
      pins[v] = Point_2(-uv[v].y() + x, uv[v].x() + y);
    }
    return pins;
  }

  const Point_2 unset{-7, 7};
  Mesh mesh;
  typename Options_of<Parameterizer>::type options;
  int maps = 0;
  SMP::Error_code code = SMP::OK;
  std::decay_t<decltype(std::declval<Parameterizer>().report())> report;
  std::vector<Vertex> offending_vertices;
  std::vector<Mesh::Face_index> offending_faces;
};

Mesh overlapping_strip()
{
  return test_charts::mesh_of_chart<Mesh>(test_charts::winding_strip(2, 3, 2));
}

template <typename Parameterizer>
void check_error(Surface<Parameterizer>& surface, const Pins& pins, Diagnosis diagnosis)
{
  surface.flatten(pins);
  BOOST_TEST(surface.report.status == diagnosis, surface.report.message);
  BOOST_TEST(surface.code == SMP::error_code(diagnosis));
  for(Vertex v : surface.offending_vertices)
    BOOST_TEST(pins.count(v) == 1);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(one_pin_moves_the_map, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(test_meshes::bump<Mesh>(9));
  const UV_map free = surface.flatten();
  BOOST_TEST(surface.report.pins == 0);
  const Vertex pinned(17);
  const UV_map uv = surface.flatten({{pinned, Point_2(3, -5)}});
  BOOST_TEST(uv[pinned] == Point_2(3, -5));
  BOOST_TEST(surface.report.pins == 1);
  for(Vertex v : surface.mesh.vertices()) {
    const Vector_2 difference = (uv[v] - uv[pinned]) - (free[v] - free[pinned]);
    BOOST_TEST(std::hypot(difference.x(), difference.y()) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(two_pins_keep_all_angles, Parameterizer, Parameterizers)
{
  for(int n : {1, 2, 5, 12}) {
    Surface<Parameterizer> surface(test_meshes::bump<Mesh>(n));
    const UV_map free = surface.flatten();
    for(double size : {1., 1e-200, 1e-30, 1e30, 1e100}) {
      const std::vector<Vertex> v = surface.some_vertices(2, n);
      const Pins pins{{v[0], Point_2(0.2 * size, 0.1 * size)}, {v[1], Point_2(-0.7 * size, 0.4 * size)}};
      const UV_map uv = surface.flatten(pins);
      BOOST_REQUIRE(surface.code == SMP::OK);
      for(const auto& [vertex, position] : pins)
        BOOST_TEST(uv[vertex] == position);
      BOOST_TEST(surface.report.pins == 2);
      BOOST_TEST(surface.report.largest_pin_distance == 0);
      BOOST_TEST(surface.report.largest_pin_angle_change < 1e-10);
      if(size > 1e-100 && size < 1e50) // the test's own products are in the range of numbers
        BOOST_TEST(surface.largest_angle_change(uv, free) < 1e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(more_pins_cost_what_is_reported, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(test_meshes::bump<Mesh>(20));
  const UV_map free = surface.flatten();
  double change_of_three = 0;
  for(int number : {3, 10, 50})
    for(double distance : {0., 0.004}) {
      const Pins pins = surface.pins_near(free, number, distance, number);
      const UV_map uv = surface.flatten(pins);
      BOOST_REQUIRE(surface.code == SMP::OK);
      BOOST_TEST(surface.report.pins == number);
      BOOST_TEST(surface.report.largest_pin_distance == 0);
      for(const auto& [vertex, position] : pins)
        BOOST_TEST(uv[vertex] == position);
      const double change = surface.largest_angle_change(uv, free);
      BOOST_TEST(std::abs(surface.report.largest_pin_angle_change - change) < 1e-9);
      BOOST_TEST(surface.report.mean_pin_angle_change <= change);
      if(distance == 0)
        BOOST_TEST(change < 1e-8);
      else
        BOOST_TEST(surface.report.mean_pin_angle_change > 1e-6);
      if(number == 3)
        change_of_three = change;
      else if(distance > 0)
        BOOST_TEST(change > change_of_three);
    }
}

// The largest of some weights come nearest to the positions, and cost most.
BOOST_AUTO_TEST_CASE_TEMPLATE(weights_trade_distances_for_angles, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(test_meshes::bump<Mesh>(20));
  const UV_map free = surface.flatten();
  const Pins pins = surface.pins_near(free, 10, 0.05, 3);
  double distance = (std::numeric_limits<double>::infinity)(), change = 0;
  for(double weight : {1e-6, 1e-3, 1., 1e3}) {
    surface.options.pin_weight = weight;
    const UV_map uv = surface.flatten(pins);
    BOOST_REQUIRE(surface.code == SMP::OK);
    double largest = 0;
    for(const auto& [vertex, position] : pins)
      largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(uv[vertex], position)));
    BOOST_TEST(surface.report.largest_pin_distance == largest, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(largest < distance);
    BOOST_TEST(surface.report.mean_pin_angle_change > change);
    distance = largest;
    change = surface.report.mean_pin_angle_change;
  }
  BOOST_TEST(distance < 1e-3);
}

// Maps are valid for any positions, or an error names pins and faces.
BOOST_AUTO_TEST_CASE(any_positions_are_met_or_refused)
{
  Surface<Direct> surface(test_meshes::bump<Mesh>(12));
  const UV_map free = surface.flatten();
  int met = 0, refused = 0;
  for(unsigned seed = 0; seed < 30; ++seed) {
    const int number = 3 + seed % 5;
    const double distance = 0.04 * (1 + seed % 10);
    const Pins pins = surface.pins_near(free, number, distance, seed);
    const UV_map uv = surface.flatten(pins);
    if(surface.code == SMP::OK) {
      ++met;
      for(const auto& [vertex, position] : pins)
        BOOST_TEST(uv[vertex] == position);
    } else {
      ++refused;
      BOOST_TEST(surface.report.status == Diagnosis::INFEASIBLE_PINS, surface.report.message);
      BOOST_TEST(!surface.offending_vertices.empty());
      BOOST_TEST(!surface.offending_faces.empty());
      surface.options.pin_weight = 1e-6;
      surface.flatten(pins);
      BOOST_TEST(surface.code == SMP::OK); // they give way
      surface.options = {};
    }
  }
  BOOST_TEST(met >= 10);
  BOOST_TEST(refused >= 3);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(wrong_pins_are_named, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(test_meshes::bump<Mesh>(6));
  const UV_map free = surface.flatten();
  const Vertex a(3), b(10), c(30), d(44);
  for(double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    check_error(surface, {{a, Point_2(0, 0)}, {b, Point_2(1, wrong)}, {c, Point_2(wrong, 1)}},
                Diagnosis::WRONG_PIN);
    BOOST_TEST(surface.offending_vertices.size() == 2);
    BOOST_TEST(surface.offending_vertices != std::vector<Vertex>({a, b}));
  }

  check_error(surface, {{a, Point_2(0, 0)}, {b, Point_2(1, 1)}, {c, Point_2(1, 1)}, {d, Point_2(2, 0)}},
              Diagnosis::WRONG_PIN);
  std::vector<Vertex> offenders = surface.offending_vertices;
  std::sort(offenders.begin(), offenders.end());
  BOOST_TEST(offenders == std::vector<Vertex>({b, c}));

  Pins mirrored;
  for(Vertex v : surface.some_vertices(12, 1))
    mirrored[v] = Point_2(-free[v].x(), free[v].y());
  check_error(surface, mirrored, Diagnosis::INFEASIBLE_PINS);
  BOOST_TEST(surface.offending_vertices.size() == 12);
  BOOST_TEST(!surface.offending_faces.empty());
  BOOST_TEST(surface.report.message.find("mirrored") != std::string::npos);

  // One of them is far from all others.
  Pins astray;
  for(Vertex v : {a, b, c, d})
    astray[v] = free[v];
  astray[c] = astray[c] + Vector_2(30, 0);
  check_error(surface, astray, Diagnosis::INFEASIBLE_PINS);
  BOOST_TEST(surface.offending_vertices.size() == 1);
  BOOST_TEST(surface.report.message.find("pin_weight") != std::string::npos);

  for(double weight : {0., -1., std::nan("")}) {
    surface.options.pin_weight = weight;
    check_error(surface, {{a, Point_2(0, 0)}}, Diagnosis::WRONG_OPTION);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(numbers_that_cannot_hold_the_map_are_an_error, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(test_meshes::bump<Mesh>(6));
  const Vertex a(3), b(30);
  check_error(surface, {{a, Point_2(1e16, 0)}, {b, Point_2(1e16 + 4, 0)}}, Diagnosis::PRECISION_EXCEEDED);
  check_error(surface, {{a, Point_2(-1.7e308, 0)}, {b, Point_2(1.7e308, 0)}}, Diagnosis::PRECISION_EXCEEDED);
  check_error(surface, {{a, Point_2(0, 0)}, {b, Point_2(1e-323, 0)}}, Diagnosis::PRECISION_EXCEEDED);
}

BOOST_AUTO_TEST_CASE(prescribed_angles_go_with_two_pins)
{
  Surface<Direct> surface(test_meshes::bump<Mesh>(6));
  Mesh& mesh = surface.mesh;
  Vertex corner = *mesh.vertices().begin();
  for(Vertex v : mesh.vertices())
    if(mesh.is_border(v) && mesh.degree(v) > 3)
      corner = v;
  const auto sums = boost::make_function_property_map<Vertex>(
      [=](Vertex v) { return v == corner ? std::optional<double>(2.5) : std::nullopt; });
  for(int number : {2, 3}) {
    Pins pins;
    for(int i = 0; i < number; ++i)
      pins[Vertex(8 * i)] = Point_2(i, i * i);
    const UV_map uv = mesh.add_property_map<Vertex, Point_2>("v:angles" + std::to_string(number)).first;
    Direct parameterizer;
    parameterizer.set_angle_sums(sums);
    parameterizer.set_pins(pin_map(pins));
    const SMP::Error_code code = SMP::parameterize(mesh, parameterizer, test_meshes::border(mesh), uv);
    if(number == 2) {
      BOOST_TEST(code == SMP::OK, parameterizer.report().message);
      BOOST_TEST(parameterizer.report().largest_angle_error < 1e-5);
      BOOST_TEST(uv[Vertex(8)] == Point_2(1, 1));
    } else {
      BOOST_TEST(parameterizer.report().status == Diagnosis::WRONG_OPTION);
      BOOST_TEST(parameterizer.report().offending_vertices.size() == 3);
    }
  }
}

// The concept's way and the function give the same map. What counts as parameterized has the last word.
BOOST_AUTO_TEST_CASE_TEMPLATE(parameterized_vertices_are_pins, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(test_meshes::bump<Mesh>(8));
  Mesh& mesh = surface.mesh;
  const Pins pins{{Vertex(5), Point_2(0, 0)}, {Vertex(50), Point_2(1, 0)}, {Vertex(20), Point_2(0.4, 0.5)}};
  const UV_map expected = surface.flatten(pins);
  BOOST_REQUIRE(surface.code == SMP::OK);

  const auto uv = mesh.template add_property_map<Vertex, Point_2>("v:given").first;
  const auto parameterized = mesh.template add_property_map<Vertex, bool>("v:parameterized", false).first;
  for(const auto& [vertex, position] : pins) {
    uv[vertex] = position;
    parameterized[vertex] = true;
  }
  Parameterizer parameterizer;
  parameterizer.set_pins(pin_map(Pins{{Vertex(5), Point_2(9, 9)}}));
  BOOST_TEST(parameterizer.parameterize(mesh, test_meshes::border(mesh), uv, get(boost::vertex_index, mesh),
                                        parameterized) == SMP::OK);
  for(Vertex v : mesh.vertices())
    BOOST_TEST(uv[v] == expected[v]);
}

// Pins of another component are not looked at.
BOOST_AUTO_TEST_CASE(other_components_have_pins_of_their_own)
{
  Mesh mesh = test_meshes::bump<Mesh>(5);
  const Mesh other = test_meshes::bump<Mesh>(4);
  const std::size_t first = mesh.number_of_vertices();
  CGAL::copy_face_graph(other, mesh);
  Surface<Direct> surface(mesh);
  const Vertex inside(3), outside(static_cast<unsigned>(first + 2));
  const UV_map uv = surface.flatten({{inside, Point_2(1, 2)}, {outside, Point_2(std::nan(""), 0)}});
  (void)uv;
}

BOOST_AUTO_TEST_CASE(polyhedra_have_pins)
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  typedef boost::graph_traits<Polyhedron>::vertex_descriptor Polyhedron_vertex;
  Polyhedron mesh;
  test_meshes::make_bump(7, mesh);
  const auto border = test_meshes::border(mesh);
  std::map<Polyhedron_vertex, Point_2> coordinates;
  const auto uv = boost::make_assoc_property_map(coordinates);
  SMP::ABF_plus_plus_parameterizer_3<Polyhedron> parameterizer;
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, border, uv) == SMP::OK);
  std::map<Polyhedron_vertex, Point_2> pins;
  int number = 0;
  for(Polyhedron_vertex v : CGAL::vertices_around_face(border, mesh))
    if(number++ % 10 == 0)
      pins[v] = coordinates[v] + Vector_2(1, 1e-3 * number);
  BOOST_REQUIRE(pins.size() == 3);
  parameterizer.set_pins(pin_map(pins));
  BOOST_TEST(SMP::parameterize(mesh, parameterizer, border, uv) == SMP::OK);
  BOOST_TEST(parameterizer.report().pins == 3);
  for(const auto& [vertex, position] : pins)
    BOOST_TEST(coordinates[vertex] == position);
  BOOST_TEST(parameterizer.is_one_to_one_mapping(mesh, border, uv));
}

// The copies of a vertex on a seam are vertices of their own.
BOOST_AUTO_TEST_CASE(copies_of_vertices_have_pins_of_their_own)
{
  typedef TA::Cut_mesh<Mesh> Seam_mesh;
  typedef boost::graph_traits<Seam_mesh>::vertex_descriptor Seam_vertex;
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Kernel::Point_3>(mesh);
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  TA::select_seams(mesh, seams);
  Seam_mesh cut = TA::make_seam_mesh(mesh, seams).mesh;
  const auto border = TA::border_halfedge(cut);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Seam_mesh> parameterizer;
  BOOST_REQUIRE(SMP::parameterize(cut, parameterizer, border, uv) == SMP::OK);
  BOOST_TEST(parameterizer.is_one_to_one_mapping(cut, border, uv) == parameterizer.report().border_is_simple);

  // Two copies of one vertex
  std::map<Vertex, std::vector<Seam_vertex>> copies;
  for(Seam_vertex v : CGAL::vertices(cut))
    copies[mesh.target(Mesh::Halfedge_index(v))].push_back(v);
  const auto cut_vertex =
      std::find_if(copies.begin(), copies.end(), [](const auto& c) { return c.second.size() > 1; });
  BOOST_REQUIRE((cut_vertex != copies.end()));
  const std::map<Seam_vertex, Point_2> pins{{cut_vertex->second[0], Point_2(0, 0)},
                                            {cut_vertex->second[1], Point_2(1, 0)}};
  parameterizer.set_pins(pin_map(pins));
  BOOST_TEST(SMP::parameterize(cut, parameterizer, border, uv) == SMP::OK);
  for(const auto& [vertex, position] : pins)
    BOOST_TEST(get(uv, vertex) == position);
  BOOST_TEST(parameterizer.report().largest_seam_jump < 1e-4);
  BOOST_TEST(SMP::is_locally_injective(cut, border, uv));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(injective_maps_have_pins, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(overlapping_strip());
  const UV_map overlapping = surface.flatten();
  BOOST_TEST(!surface.report.border_is_simple);
  surface.options.injective = true;
  const UV_map free = surface.flatten();
  BOOST_REQUIRE(surface.code == SMP::OK);
  BOOST_TEST(surface.report.injective);
  for(int number : {2, 3}) {
    const UV_map uv = surface.flatten(surface.pins_near(free, number, 1e-3, 5));
    BOOST_REQUIRE(surface.code == SMP::OK);
    BOOST_TEST(surface.report.injective);
    BOOST_TEST(SMP::is_injective(surface.mesh, uv));
  }
  // Positions as in the map that overlaps itself
  Pins pins;
  for(Vertex v : surface.mesh.vertices())
    pins[v] = overlapping[v];
  for(auto pin = pins.begin(); pin != pins.end();)
    pin = std::any_of(pins.begin(), pin, [&](const auto& p) { return p.second == pin->second; })
              ? pins.erase(pin)
              : std::next(pin);
  check_error(surface, pins, Diagnosis::INFEASIBLE_PINS);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(one_to_one_maps_are_injective, Parameterizer, Parameterizers)
{
  Surface<Parameterizer> surface(test_meshes::bump<Mesh>(7));
  Mesh& mesh = surface.mesh;
  const auto border = test_meshes::border(mesh);
  const UV_map uv = surface.flatten();
  const Parameterizer parameterizer;
  BOOST_TEST(parameterizer.is_one_to_one_mapping(mesh, border, uv));
  const Point_2 old = uv[Vertex(30)];
  uv[Vertex(30)] = Point_2(5, 5);
  BOOST_TEST(!parameterizer.is_one_to_one_mapping(mesh, border, uv));
  uv[Vertex(30)] = old;
  for(Vertex v : mesh.vertices())
    uv[v] = Point_2(-uv[v].x(), uv[v].y());
  BOOST_TEST(!parameterizer.is_one_to_one_mapping(mesh, border, uv));
  BOOST_TEST(!parameterizer.is_one_to_one_mapping(mesh, mesh.opposite(border), uv)); // not on the border

  Surface<Parameterizer> strip(overlapping_strip());
  const UV_map overlapping = strip.flatten();
  BOOST_TEST(SMP::is_locally_injective(strip.mesh, overlapping));
  BOOST_TEST(!parameterizer.is_one_to_one_mapping(strip.mesh, test_meshes::border(strip.mesh), overlapping));
}

BOOST_AUTO_TEST_SUITE_END()
