// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificates, compared with known faults and with a search through all pairs.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>

#include "immersed_charts.h"
#include "mesh_of_chart.h"
#include "overlaps.h"
#include "test_charts.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_certify_flattening)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace abf = SMP::internal::ABF;
using test_charts::Chart;
using test_charts::Point_3;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact_kernel;
typedef Exact_kernel::Point_2 Point_2;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex;
typedef Surface_mesh::Face_index Face;
typedef Surface_mesh::Halfedge_index Halfedge;
typedef std::vector<std::pair<Halfedge, Halfedge>> Pairs;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::numeric_limits<double>::quiet_NaN();

// A mesh whose uv map is its projection along the z-axis.
template <typename Mesh = Surface_mesh, typename Kernel = Exact_kernel>
struct Planar
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef std::map<vertex_descriptor, typename Kernel::Point_2> Map;

  explicit Planar(const Chart& chart)
  {
    test_charts::make_mesh(chart, mesh);
    for(vertex_descriptor v : vertices(mesh)) {
      const auto p = get(CGAL::vertex_point, mesh, v);
      uv[v] = typename Kernel::Point_2(p.x(), p.y());
    }
  }
  explicit Planar(const std::vector<Point_3>& points, const test_charts::Triangles& triangles)
      : Planar(test_charts::make_chart(points, triangles))
  {}

  boost::const_associative_property_map<Map> uvmap() const { return {uv}; }
  bool is_locally_injective() const { return SMP::is_locally_injective(mesh, uvmap()); }
  bool is_injective() const { return SMP::is_injective(mesh, uvmap()); }

  std::vector<typename boost::graph_traits<Mesh>::face_descriptor> flipped() const
  {
    std::vector<typename boost::graph_traits<Mesh>::face_descriptor> faces;
    SMP::flipped_faces(mesh, uvmap(), std::back_inserter(faces));
    return faces;
  }
  std::size_t crossings() const
  {
    std::vector<std::pair<typename boost::graph_traits<Mesh>::halfedge_descriptor,
                          typename boost::graph_traits<Mesh>::halfedge_descriptor>>
        pairs;
    SMP::crossing_border_edges(mesh, uvmap(), std::back_inserter(pairs));
    for(const auto& [g, h] : pairs)
      BOOST_TEST((is_border(g, mesh) && is_border(h, mesh) && g != h));
    return pairs.size();
  }

  Mesh mesh;
  Map uv;
};

// A strip of quadrangles around the origin: `turn(i)` and `width(i)` are its angle and width at each of its ends.
template <typename Turn, typename Radii>
Chart ribbon(int n, const Turn& turn, const Radii& radii)
{
  std::vector<Point_3> points;
  test_charts::Triangles triangles;
  for(int i = 0; i <= n; ++i) {
    const auto [inner, outer] = radii(i);
    points.emplace_back(inner * std::cos(turn(i)), inner * std::sin(turn(i)), 0);
    points.emplace_back(outer * std::cos(turn(i)), outer * std::sin(turn(i)), 0);
    if(i < n) {
      triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
      triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
  }
  return test_charts::make_chart(points, triangles);
}

// Triangles around the origin, in steps of a given angle, closed or with a border on both sides.
Chart fan(int n, double step, bool closed)
{
  std::vector<Point_3> points{Point_3(0, 0, 0)};
  test_charts::Triangles triangles;
  for(int i = 0; i < (closed ? n : n + 1); ++i) {
    const double radius = 1 + 0.125 * (i % 3); // so that no two of the outer points are the same
    points.emplace_back(radius * std::cos(i * step), radius * std::sin(i * step), 0);
  }
  for(int i = 0; i < n; ++i)
    triangles.push_back({0, i + 1, closed ? (i + 1) % n + 1 : i + 2});
  return test_charts::make_chart(points, triangles);
}

// The coordinates as points of the kernel that certificates use
std::vector<abf::Exact_point_2> exact(const std::vector<Point_2>& uv)
{
  std::vector<abf::Exact_point_2> points;
  for(const Point_2& p : uv)
    points.emplace_back(p.x(), p.y());
  return points;
}

std::vector<std::pair<int, int>> all_touching(const std::vector<abf::Border_edge>& edges,
                                              const std::vector<Point_2>& uv)
{
  std::vector<std::pair<int, int>> pairs;
  for(int i = 0; i < static_cast<int>(edges.size()); ++i)
    for(int j = i + 1; j < static_cast<int>(edges.size()); ++j)
      if(abf::touch(edges[i], edges[j], uv))
        pairs.emplace_back(i, j);
  return pairs;
}

} // namespace

BOOST_AUTO_TEST_CASE(valid_maps)
{
  BOOST_TEST(Planar<>(test_charts::flat_grid(9, 1)).is_injective());
  BOOST_TEST(Planar<>(test_charts::annulus(7)).is_injective());
  BOOST_TEST(Planar<>(test_charts::pyramid(3, 1)).is_injective());
  BOOST_TEST(Planar<>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).is_injective());
  BOOST_TEST(Planar<>(test_charts::flat_grid(9, 1)).crossings() == 0u);
  BOOST_TEST(Planar<CGAL::Polyhedron_3<Chart::Kernel>>(test_charts::flat_grid(5, 2)).is_injective());
  BOOST_TEST(Planar<>(Chart()).is_injective()); // of nothing
}

BOOST_AUTO_TEST_CASE(flipped_faces_are_named)
{
  Planar<> planar(test_charts::flat_grid(6, 3));
  const Vertex center(24);
  planar.uv[center] = Point_2(2, 2);
  const auto flipped = planar.flipped();
  BOOST_TEST(!flipped.empty());
  for(Face f : faces(planar.mesh)) {
    std::vector<Point_2> p;
    for(Vertex v : vertices_around_face(halfedge(f, planar.mesh), planar.mesh))
      p.push_back(planar.uv[v]);
    const bool listed = std::find(flipped.begin(), flipped.end(), f) != flipped.end();
    BOOST_TEST(listed == (CGAL::orientation(p[0], p[1], p[2]) != CGAL::LEFT_TURN));
  }
  BOOST_TEST(!planar.is_locally_injective());
  BOOST_TEST(!planar.is_injective());
  BOOST_TEST(planar.crossings() == 0u);
}

BOOST_AUTO_TEST_CASE(no_area_counts_as_flipped)
{
  Planar<> planar({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  planar.uv[Vertex(2)] = Point_2(0.5, 0);
  BOOST_TEST(planar.flipped().size() == 1u);
  planar.uv[Vertex(2)] = Point_2(0.5, std::numeric_limits<double>::denorm_min());
  BOOST_TEST(planar.flipped().empty());
  BOOST_TEST(planar.is_injective());
}

BOOST_AUTO_TEST_CASE(coordinates_that_are_not_numbers)
{
  for(double bad : {infinity, -infinity, nan_value})
    for(int v : {0, 3, 24})
      for(const Point_2& p : {Point_2(bad, 0.5), Point_2(0.5, bad)}) {
        Planar<> planar(test_charts::flat_grid(6, 4));
        const std::size_t degree = faces_around_target(halfedge(Vertex(v), planar.mesh), planar.mesh).size();
        planar.uv[Vertex(v)] = p;
        BOOST_TEST(planar.flipped().size() == degree - (planar.mesh.is_border(Vertex(v)) ? 1 : 0));
        BOOST_TEST(!planar.is_locally_injective());
        BOOST_TEST(!planar.is_injective());
        BOOST_TEST(planar.crossings() == 0u);
      }
}

// All triangles are positive, but wind around the centre several times.
BOOST_AUTO_TEST_CASE(interior_vertex_with_several_turns)
{
  for(int turns : {1, 2, 3, 5})
    for(int n : {10, 11, 12, 32}) {
      const Planar<> planar(fan(n, 2 * CGAL_PI * turns / n, true));
      if(turns == 5 && n < 11)
        continue; // half a turn each
      BOOST_TEST(planar.flipped().empty());
      BOOST_TEST(planar.is_locally_injective() == (turns == 1));
      BOOST_TEST(planar.is_injective() == (turns == 1));
    }
}

// All triangles are positive, but those at a border vertex overlap one another.
BOOST_AUTO_TEST_CASE(border_vertex_with_more_than_a_turn)
{
  for(int k = 1; k < 100; ++k) {
    const double angle = 0.125 * k; // of the fan
    Chart chart = fan(16, angle / 16, false);
    const double tilt = 0.37 * k;
    for(Point_3& p : chart.points)
      p = Point_3(p.x() * std::cos(tilt) - p.y() * std::sin(tilt),
                  p.x() * std::sin(tilt) + p.y() * std::cos(tilt), 0);
    const Planar<> planar(chart);
    BOOST_TEST(planar.flipped().empty());
    BOOST_TEST(planar.is_locally_injective() == (angle < 2 * CGAL_PI));
    BOOST_TEST(planar.is_injective() == (angle < 2 * CGAL_PI));
  }
}

BOOST_AUTO_TEST_CASE(border_vertex_with_exactly_a_turn)
{
  const test_charts::Triangles triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for(const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)}) {
    auto point = [dx = dx, dy = dy](double x, double y) {
      return Point_3(dx * x - dy * y, dy * x + dx * y, 0);
    };
    std::vector<Point_3> points{point(0, 0),  point(1, 0),  point(0, 1),
                                point(-1, 0), point(0, -1), point(2, 0)};
    BOOST_TEST(Planar<>(points, triangles).flipped().empty());
    BOOST_TEST(!Planar<>(points, triangles).is_locally_injective());
    points.back() = point(2, -1e-300);
    BOOST_TEST(Planar<>(points, triangles).is_locally_injective());
    BOOST_TEST(Planar<>(points, triangles).is_injective());
  }
}

// Locally injective maps whose ends overlap.
BOOST_AUTO_TEST_CASE(overlapping_ends)
{
  auto radii = [](int) { return std::pair(1., 2.); };
  auto overlapping = [](int i) { return 0.07 * i; };
  const Planar<> planar(ribbon(99, overlapping, radii));
  BOOST_TEST(planar.is_locally_injective());
  BOOST_TEST(!planar.is_injective());
  BOOST_TEST(planar.crossings() > 0u);

  auto spiral = [](int i) { return std::pair(1 + 0.02 * i, 2 + 0.02 * i); };
  BOOST_TEST(Planar<>(ribbon(
                          99, [](int i) { return 0.07 * i; }, spiral))
                 .crossings() == 0u);
  BOOST_TEST(Planar<>(ribbon(
                          300, [](int i) { return 0.07 * i; }, spiral))
                 .is_injective());
}

// Touching counts as well: at a vertex, and within an edge.
BOOST_AUTO_TEST_CASE(touching_border)
{
  const test_charts::Triangles triangles{{0, 1, 2}, {1, 3, 2}, {3, 4, 2}};
  const std::vector<Point_3> points{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {3, 1, 0}, {3, 3, 0}};
  BOOST_TEST(Planar<>(points, triangles).is_injective());

  Chart ring = ribbon(
      8, [](int i) { return CGAL_PI / 4 * i; }, [](int) { return std::pair(1., 2.); });
  ring.points[16] = ring.points[0];
  ring.points[17] = ring.points[1];
  const Planar<> closed(ring); // both ends on one another
  BOOST_TEST(closed.is_locally_injective());
  BOOST_TEST(!closed.is_injective());
  BOOST_TEST(closed.crossings() == 7u); // the ends, and those beside them

  Chart dent = test_charts::flat_grid(1, 1); // a vertex on the edge across
  dent.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  Planar<> square(dent);
  for(auto& [v, p] : square.uv)
    if(p == Point_2(1, 1))
      p = Point_2(0.5, 0.5);
  BOOST_TEST(!square.is_injective());
}

// Fans that meet in a vertex may touch there, but no more than there.
BOOST_AUTO_TEST_CASE(pinched_vertex)
{
  for(int k = 0; k < 64; ++k) { // the second fan turns around the vertex
    const double angle = CGAL_PI / 32 * k;
    auto point = [](double direction) { return Point_3(std::cos(direction), std::sin(direction), 0); };
    const Planar<> bow_tie({{0, 0, 0}, point(0), point(1), point(angle), point(angle + 1.5)},
                           {{0, 1, 2}, {0, 3, 4}});
    const bool is_apart = angle > 1 && angle + 1.5 < 2 * CGAL_PI;
    BOOST_TEST(bow_tie.flipped().empty());
    BOOST_TEST(bow_tie.is_locally_injective() == is_apart);
    BOOST_TEST(bow_tie.is_injective() == is_apart);
  }
  // around a hole that touches the outer border
  const Planar<> ring({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {3, 2, 0}, {2, 3, 0}},
                      {{0, 1, 3}, {1, 2, 3}, {3, 2, 4}, {2, 0, 4}});
  BOOST_TEST(ring.is_injective());
  BOOST_TEST(ring.crossings() == 0u);
}

// The border of the hole may cross the outer one, or itself.
BOOST_AUTO_TEST_CASE(several_borders)
{
  Chart annulus = test_charts::annulus(12);
  BOOST_TEST(Planar<>(annulus).is_injective());
  for(int turns : {2, 3}) { // a covering
    std::vector<Point_3>& points = annulus.points;
    for(std::size_t v = 0; v < points.size(); ++v) {
      const double radius = v % 2 == 0 ? 1 : 2, angle = 2 * CGAL_PI * turns * (v / 2) / 12;
      points[v] = Point_3(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    const Planar<> covering(annulus);
    BOOST_TEST(covering.is_locally_injective());
    BOOST_TEST(!covering.is_injective());
  }
}

// Components may lie in a hole, but must not overlap. Each can be checked alone.
BOOST_AUTO_TEST_CASE(several_components)
{
  for(double shift : {0., 1.5, 5.}) {
    Chart chart = test_charts::annulus(24);
    std::vector<Point_3> points = chart.points;
    test_charts::Triangles triangles;
    for(int c = 0; c < chart.number_of_corners(); c += 3)
      triangles.push_back({chart.vertex[c], chart.vertex[c + 1], chart.vertex[c + 2]});
    const int v = static_cast<int>(points.size());
    for(const auto& [x, y] : {std::pair(0., 0.), std::pair(0.1, 0.), std::pair(0., 0.1)})
      points.emplace_back(shift + x, y, 0);
    triangles.push_back({v, v + 1, v + 2});
    Planar<> both(points, triangles);
    BOOST_TEST(both.is_locally_injective());
    BOOST_TEST(both.crossings() == 0u);
    BOOST_TEST(both.is_injective() == (shift != 1.5));

    both.uv[Vertex(v + 1)] = Point_2(shift, -1);
    both.uv[Vertex(v + 2)] = Point_2(shift, 1);
    both.uv[Vertex(0)] = Point_2(3, 3);
    const auto in_triangle = halfedge(Vertex(v), both.mesh), in_ring = halfedge(Vertex(0), both.mesh);
    for(Halfedge h : {in_triangle, opposite(in_triangle, both.mesh)}) {
      std::vector<Face> flipped;
      SMP::flipped_faces(both.mesh, h, both.uvmap(), std::back_inserter(flipped));
      BOOST_REQUIRE_EQUAL(flipped.size(), 1u);
      BOOST_TEST(flipped.front() == Face(static_cast<unsigned>(triangles.size()) - 1));
      BOOST_TEST(!SMP::is_locally_injective(both.mesh, h, both.uvmap()));
    }
    both.uv[Vertex(v + 1)] = Point_2(shift + 9, -1);
    both.uv[Vertex(v + 2)] = Point_2(shift + 9, 1);
    BOOST_TEST(SMP::is_injective(both.mesh, in_triangle, both.uvmap()));
    BOOST_TEST(!SMP::is_injective(both.mesh, in_ring, both.uvmap()));
    Pairs pairs;
    SMP::crossing_border_edges(both.mesh, in_triangle, both.uvmap(), std::back_inserter(pairs));
    BOOST_TEST(pairs.empty());
    SMP::crossing_border_edges(both.mesh, in_ring, both.uvmap(), std::back_inserter(pairs));
    BOOST_TEST(!pairs.empty());
  }
}

// Differences of one unit in the last place, in kernels of exact and of inexact numbers.
BOOST_AUTO_TEST_CASE(other_kernels)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  const Chart chart = test_charts::make_chart({{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}});
  Planar<Surface_mesh, CGAL::Simple_cartesian<float>> floats(chart);
  Planar<Surface_mesh, CGAL::Simple_cartesian<double>> doubles(chart);
  Planar<Surface_mesh, Exact> exact(chart);
  BOOST_TEST(floats.is_injective());
  BOOST_TEST(doubles.is_injective());
  BOOST_TEST(exact.is_injective());

  typedef CGAL::Simple_cartesian<float>::Point_2 Float_point;
  typedef CGAL::Simple_cartesian<double>::Point_2 Double_point;
  floats.uv[Vertex(2)] = Float_point(1 / 3.f, std::nextafter(1 / 3.f, 1.f));
  doubles.uv[Vertex(2)] = Double_point(1 / 3., std::nextafter(1 / 3., 1.));
  exact.uv[Vertex(2)] = Exact::Point_2(Exact::FT(1) / 3, Exact::FT(1) / 3 + Exact::FT(1e-300));
  BOOST_TEST(floats.is_injective());
  BOOST_TEST(doubles.is_injective());
  BOOST_TEST(exact.is_injective());

  floats.uv[Vertex(2)] = Float_point(1 / 3.f, 1 / 3.f);
  doubles.uv[Vertex(2)] = Double_point(1 / 3., 1 / 3.);
  exact.uv[Vertex(2)] = Exact::Point_2(Exact::FT(1) / 3, Exact::FT(1) / 3);
  BOOST_TEST(floats.flipped().size() == 1u);
  BOOST_TEST(doubles.flipped().size() == 1u);
  BOOST_TEST(exact.flipped().size() == 1u);
}

// A grid slit open along two edges, between which there is a vertex on either side.
BOOST_AUTO_TEST_CASE(seam_mesh)
{
  typedef boost::graph_traits<Surface_mesh>::edge_descriptor edge_descriptor;
  typedef Surface_mesh::Property_map<edge_descriptor, bool> Seam_edges;
  typedef Surface_mesh::Property_map<Vertex, bool> Seam_vertices;
  typedef CGAL::Seam_mesh<Surface_mesh, Seam_edges, Seam_vertices> Mesh;

  Surface_mesh grid = test_charts::mesh_of_chart<Surface_mesh>(test_charts::flat_grid(6, 5));
  auto is_seam_edge = grid.add_property_map<edge_descriptor, bool>("e:on_seam", false).first;
  auto is_seam_vertex = grid.add_property_map<Vertex, bool>("v:on_seam", false).first;
  Mesh mesh(grid, is_seam_edge, is_seam_vertex);
  const Vertex middle(24), left(23), right(25);
  BOOST_REQUIRE(mesh.add_seam(left, middle));
  BOOST_REQUIRE(mesh.add_seam(middle, right));

  std::map<Halfedge, Point_2> uv;
  for(auto v : vertices(mesh)) {
    const Point_3& p = grid.point(target(static_cast<Halfedge>(v), grid));
    uv[v] = Point_2(p.x(), p.y());
  }
  const boost::const_associative_property_map<std::map<Halfedge, Point_2>> uvmap(uv);
  const Mesh& const_mesh = mesh;
  BOOST_TEST(!SMP::is_injective(const_mesh, uvmap));         // closed, the slit touches itself
  BOOST_TEST(!SMP::is_locally_injective(const_mesh, uvmap)); // at its ends

  for(auto f : faces(mesh)) { // opened a little
    auto h = halfedge(f, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto v = target(h, mesh);
      if(grid.point(target(static_cast<Halfedge>(v), grid)) != grid.point(middle))
        continue;
      const auto c = CGAL::centroid(grid.point(target(static_cast<Halfedge>(h), grid)),
                                    grid.point(target(static_cast<Halfedge>(next(h, mesh)), grid)),
                                    grid.point(source(static_cast<Halfedge>(h), grid)));
      const Point_3 &l = grid.point(left), &r = grid.point(right), &m = grid.point(middle);
      const bool above = CGAL::orientation(Point_2(l.x(), l.y()), Point_2(m.x(), m.y()),
                                           Point_2(c.x(), c.y())) == CGAL::LEFT_TURN;
      const auto across = CGAL::cross_product(CGAL::Vector_3<Chart::Kernel>(0, 0, 1), r - l);
      const Point_3 moved = m + across * (above ? 0.05 : -0.05);
      uv[v] = Point_2(moved.x(), moved.y());
    }
  }
  BOOST_TEST(SMP::is_injective(const_mesh, uvmap));
}

namespace {

// How many maps there were of a kind
struct Tally
{
  int injective = 0, overlapping = 0;
  int only_apart = 0;    // overlapping, but not at a vertex
  int only_covering = 0; // overlapping without flipped triangles, and without border edges that touch
};

// Compares all that is said about a map with what all pairs of its triangles say.
template <typename Surface>
void compare_with_all_pairs(const Surface& surface, Tally& tally)
{
  const test_charts::Overlaps overlaps(surface.points(), surface.triangles());
  const Chart chart = test_charts::make_chart(surface.points(), surface.triangles());
  const Planar<> planar(chart);
  BOOST_REQUIRE(planar.flipped().empty() == overlaps.are_positive());
  BOOST_REQUIRE(planar.is_locally_injective() == overlaps.is_locally_injective());
  BOOST_REQUIRE(planar.is_injective() == overlaps.is_injective());
  const bool is_simple = abf::is_border_simple(chart, test_charts::projected(chart));
  BOOST_REQUIRE((overlaps.are_positive() && is_simple) == overlaps.is_injective());
  ++(overlaps.is_injective() ? tally.injective : tally.overlapping);
  if(overlaps.is_locally_injective() && !overlaps.is_injective())
    ++tally.only_apart;
  if(overlaps.are_positive() && !overlaps.is_injective() && planar.crossings() == 0)
    ++tally.only_covering;
}

} // namespace

// With holes, handles, pinched vertices and several components, all of them positively oriented.
BOOST_AUTO_TEST_CASE(random_surfaces_against_all_pairs)
{
  std::mt19937 random(9);
  Tally tally;
  for(int run = 0; run < 3000; ++run) {
    const int places = 3 + random() % 6, careful = random() % 16, careless = random() % 3;
    const test_charts::Random_surface surface(places, careful, careless, random);
    compare_with_all_pairs(surface, tally);
  }
  BOOST_TEST(tally.injective > 1000);
  BOOST_TEST(tally.only_covering > 20);
  BOOST_TEST(tally.only_apart > 200);
  BOOST_TEST(tally.overlapping - tally.only_apart > 200);
}

// Holes may be moved over the border or one another, outside, or turned inside out.
BOOST_AUTO_TEST_CASE(punched_grids_against_all_pairs)
{
  std::mt19937 random(10);
  Tally tally;
  for(int run = 0; run < 600; ++run) {
    const int n = 2 + random() % 4, moves = random() % 3;
    compare_with_all_pairs(test_charts::Punched_grid(n, moves, random), tally);
  }
  BOOST_TEST(tally.injective > 150);
  BOOST_TEST(tally.overlapping > 150);
}

// Borders that are simple and do not touch, and triangles that overlap.
BOOST_AUTO_TEST_CASE(crosswise_sheets)
{
  for(bool left_end_on_border : {false, true})
    for(bool right_end_on_border : {false, true}) {
      const test_charts::Crosswise_sheets sheets(left_end_on_border, right_end_on_border);
      Tally tally;
      compare_with_all_pairs(sheets, tally);
      BOOST_TEST(tally.overlapping == 1);
      const Chart chart = test_charts::make_chart(sheets.points(), sheets.triangles());
      BOOST_TEST(chart.borders.size() == 2u);
      BOOST_TEST(abf::border_crossings(chart, test_charts::projected(chart)).empty());
      const abf::Certificate certificate = abf::certify(chart, test_charts::projected(chart));
      BOOST_TEST(certificate.flipped_triangles == 0);
      BOOST_TEST(certificate.is_valid() == (left_end_on_border && right_end_on_border));
      BOOST_TEST(!certificate.border_is_simple);
    }
}

// The hole of a square frame, moved as a whole, and turned inside out.
BOOST_AUTO_TEST_CASE(moved_holes)
{
  auto frame = [](double shift, double width) {
    std::vector<Point_3> points;
    for(const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      points.emplace_back(4 * x, 4 * y, 0);
      points.emplace_back(shift + width * x, y, 0);
    }
    test_charts::Triangles triangles;
    for(int v = 0; v < 8; v += 2) {
      triangles.push_back({v, (v + 2) % 8, v + 1});
      triangles.push_back({v + 1, (v + 2) % 8, (v + 3) % 8});
    }
    return Planar<>(points, triangles);
  };
  BOOST_TEST(frame(0, 1).is_injective());
  BOOST_TEST(frame(2.875, 1).is_injective());
  for(const auto& [shift, width] :
      {std::pair(3, 1), std::pair(4, 1), std::pair(9, 1), std::pair(0, -1), std::pair(0, 5)})
    BOOST_TEST(!frame(shift, width).is_injective());
  BOOST_TEST(frame(0, -1).crossings() == 0u);
  BOOST_TEST(frame(9, 1).crossings() == 0u);
}

BOOST_AUTO_TEST_CASE(not_triangles)
{
  Surface_mesh quads;
  CGAL::make_grid(
      3, 3, quads, [](std::size_t i, std::size_t j) { return Point_3(i, j, 0); }, false);
  const auto uv = quads.add_property_map<Vertex, Point_2>("v:uv").first;
  for(Vertex v : quads.vertices())
    put(uv, v, Point_2(quads.point(v).x(), quads.point(v).y()));
  const auto uv_of_halfedge =
      boost::make_function_property_map<Halfedge>([&](Halfedge h) { return get(uv, quads.target(h)); });
  const auto check = [&](const auto& map, const std::vector<Face>& expected) {
    std::vector<Face> flipped, overlapping;
    SMP::flipped_faces(quads, map, std::back_inserter(flipped));
    BOOST_TEST((flipped == expected));
    BOOST_TEST(!SMP::is_injective(quads, map));
    BOOST_TEST(!SMP::is_locally_injective(quads, map));
    TA::overlapping_faces(quads, map, std::back_inserter(overlapping));
    BOOST_TEST(overlapping.empty());
  };
  const auto check_both = [&](const std::vector<Face>& expected) {
    check(uv, expected);
    check(uv_of_halfedge, expected);
  };
  const auto all = quads.faces();
  check_both(std::vector<Face>(all.begin(), all.end()));

  // Triangles, but for one square in the middle, whose neighbours touch at its corners, and one that is flipped
  const Face middle(4);
  for(Face f : std::vector<Face>(all.begin(), all.end()))
    if(f != middle)
      CGAL::Euler::split_face(quads.halfedge(f), quads.next(quads.next(quads.halfedge(f))), quads);
  check_both({middle});
  const Face last(static_cast<Surface_mesh::size_type>(quads.number_of_faces() - 1));
  const auto mirrored = boost::make_function_property_map<Halfedge>([&](Halfedge h) {
    const Point_2 p = get(uv, quads.target(h));
    return quads.face(h) == last ? Point_2(-1 - p.x(), p.y()) : p;
  });
  check(mirrored, {middle, last});
}

// Random polygons, compared with all pairs and CGAL's sweep. The grid is so coarse that every kind of contact is
// common.
BOOST_AUTO_TEST_CASE(sweep_against_all_pairs)
{
  std::mt19937 random(7);
  int simple = 0;
  for(int run = 0; run < 20000; ++run) {
    const int n = 3 + random() % 7, places = 3 + random() % 12;
    std::vector<Point_2> uv;
    std::vector<abf::Border_edge> edges;
    for(int i = 0; i < n; ++i) {
      uv.emplace_back(random() % places, random() % places);
      edges.push_back({i, (i + 1) % n});
    }
    const auto pairs = all_touching(edges, uv);
    BOOST_REQUIRE(abf::Border_sweep<abf::Exact_point_2>(edges, exact(uv)).finds_touching_edges() ==
                  !pairs.empty());
    BOOST_REQUIRE(abf::touching_edges(edges, exact(uv)) == pairs);
    BOOST_REQUIRE(CGAL::is_simple_2(uv.begin(), uv.end()) == pairs.empty());
    simple += pairs.empty();
  }
  BOOST_TEST(simple > 1000);
  BOOST_TEST(simple < 19000);
}

// Borders with many edges near to one another, or on one line
BOOST_AUTO_TEST_CASE(long_borders)
{
  const auto check = [](const auto& border) {
    const Chart chart = border(50000);
    BOOST_TEST(abf::is_border_simple(chart, test_charts::projected(chart)));
    BOOST_TEST(Planar<>(chart).is_injective());
  };
  check([](int n) {
    return ribbon(
        n, [](int i) { return 2 * CGAL_PI / 64 * i; },
        [](int i) { return std::pair(1 + 0.001 * i, 1.05 + 0.001 * i); });
  });
  for(double slope : {0., 1.}) // collinear, along an axis and exactly diagonal
    check([slope](int n) {
      Chart strip = ribbon(
          n, [](int) { return 0.; }, [](int) { return std::pair(0., 1.); });
      for(int v = 0; v < strip.number_of_vertices(); ++v)
        strip.points[v] = Point_3(v / 2, slope * (v / 2) - v % 2, 0);
      return strip;
    });
}

BOOST_AUTO_TEST_SUITE_END()
