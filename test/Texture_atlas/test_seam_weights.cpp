// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Edge weights that hide seams or draw them to creases, selection files, and what parameterizers make of seam meshes.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/seam_selection.h>
#include <CGAL/Texture_atlas/seam_weights.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seam_weights)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using seam_surfaces::Point_3;
using seam_surfaces::Surface;
typedef seam_surfaces::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;
typedef CGAL::Polyhedron_3<seam_surfaces::Kernel> Polyhedron;
typedef seam_surfaces::Kernel::Point_2 Point_2;
typedef std::set<std::pair<std::size_t, std::size_t>> Pairs;

namespace {

typedef std::map<Edge, double> Weights;

enum Kind
{
  VISIBILITY,
  CREASES
};

Weights weights(const Mesh& mesh, Kind kind)
{
  Weights result;
  const auto map = boost::make_assoc_property_map(result);
  kind == VISIBILITY ? TA::compute_visibility_weights(mesh, map) : TA::compute_crease_weights(mesh, map);
  return result;
}

double length(const Mesh& mesh, Edge e)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

// The weight of an edge by its length
double factor(const Mesh& mesh, const Weights& weights, Edge e)
{
  return weights.at(e) / length(mesh, e);
}

typedef Mesh::Property_map<Edge, bool> Edge_map;

Edge_map seam_map(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:seam", false).first;
}

Pairs marked(const Mesh& mesh, Edge_map seams)
{
  Pairs result;
  for(Edge e : mesh.edges())
    if(get(seams, e))
      result.insert(
          std::minmax<std::size_t>({std::size_t(mesh.vertex(e, 0)), std::size_t(mesh.vertex(e, 1))}));
  return result;
}

// Reads a text as the seams of an octahedron.
struct Octahedron
{
  auto read(const std::string& text)
  {
    std::istringstream in(text);
    return TA::read_seam_selection(in, mesh, seams);
  }

  Mesh mesh = seam_surfaces::octahedron().mesh();
  Edge_map seams = seam_map(mesh);
};

} // namespace

BOOST_AUTO_TEST_CASE(convex_surfaces_are_visible)
{
  for(const Surface& surface :
      {seam_surfaces::sphere(2), seam_surfaces::icosahedron(), seam_surfaces::slab(0)}) {
    const Mesh mesh = surface.mesh();
    for(const auto& [e, weight] : weights(mesh, VISIBILITY))
      BOOST_TEST(weight == length(mesh, e), boost::test_tools::tolerance(1e-12));
  }
}

// What is inside of a torus is seen less than what is outside.
BOOST_AUTO_TEST_CASE(inside_of_a_torus)
{
  const Mesh mesh = seam_surfaces::torus(40, 20).mesh();
  const Weights result = weights(mesh, VISIBILITY);
  int inner = 0, outer = 0;
  for(Edge e : mesh.edges()) {
    const auto radius = [&](int i) {
      const Point_3& p = mesh.point(mesh.vertex(e, i));
      return std::hypot(p.x(), p.y());
    };
    if(radius(0) > 3.5 && radius(1) > 3.5) {
      ++outer;
      BOOST_TEST(factor(mesh, result, e) > 0.99);
    }
    if(radius(0) < 2.3 && radius(1) < 2.3) {
      ++inner;
      BOOST_TEST(factor(mesh, result, e) < 0.9);
      BOOST_TEST(factor(mesh, result, e) > 0.3);
    }
  }
  BOOST_TEST(inner > 100);
  BOOST_TEST(outer > 100);
}

// A tube seen from its inside: from the middle of its wall, few directions lead out.
BOOST_AUTO_TEST_CASE(side_of_the_surface)
{
  Surface tube = seam_surfaces::tube(24, 40);
  const Mesh outside = tube.mesh();
  for(auto& face : tube.faces)
    std::swap(face[0], face[1]);
  const Mesh inside = tube.mesh();
  const Weights seen_outside = weights(outside, VISIBILITY), seen_inside = weights(inside, VISIBILITY);
  for(Edge e : outside.edges())
    BOOST_TEST(factor(outside, seen_outside, e) > 0.999);
  for(Edge e : inside.edges())
    if(std::abs(inside.point(inside.vertex(e, 0)).z() - 10) < 1)
      BOOST_TEST(factor(inside, seen_inside, e) < 0.35);
}

// Size and place do not matter, except for rounding; the same input gives the same bits.
BOOST_AUTO_TEST_CASE(sizes)
{
  Surface surface = seam_surfaces::slab(3);
  const Mesh mesh = surface.mesh();
  const Weights once = weights(mesh, VISIBILITY);
  BOOST_TEST((weights(mesh, VISIBILITY) == once));
  for(Point_3& p : surface.points)
    p = Point_3(p.x() * 1024, p.y() * 1024, p.z() * 1024);
  for(const auto& [e, weight] : weights(surface.mesh(), VISIBILITY))
    BOOST_TEST(weight == 1024 * once.at(e), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(creases)
{
  const Mesh cube = seam_surfaces::slab(0).mesh();
  for(const auto& [e, weight] : weights(cube, CREASES)) {
    const auto n = CGAL::unit_normal(cube.point(cube.target(cube.halfedge(e))),
                                     cube.point(cube.target(cube.next(cube.halfedge(e)))),
                                     cube.point(cube.source(cube.halfedge(e))));
    const auto h = cube.opposite(cube.halfedge(e));
    const auto m = CGAL::unit_normal(cube.point(cube.target(h)), cube.point(cube.target(cube.next(h))),
                                     cube.point(cube.source(h)));
    BOOST_TEST(weight == length(cube, e) * (n * m > 0.5 ? 1 : 0.3), boost::test_tools::tolerance(1e-12));
  }
  const Mesh tube = seam_surfaces::tube(12, 1).mesh(); // bends by 30 degrees
  const Weights bends = weights(tube, CREASES);
  int uprights = 0;
  for(Edge e : tube.edges()) {
    const Point_3 &p = tube.point(tube.vertex(e, 0)), &q = tube.point(tube.vertex(e, 1));
    const bool is_upright = p.x() == q.x() && p.y() == q.y();
    uprights += is_upright;
    BOOST_TEST(factor(tube, bends, e) == (is_upright ? 0.3 + 0.7 * 0.75 : 1),
               boost::test_tools::tolerance(1e-9)); // borders and diagonals have their lengths
  }
  BOOST_TEST(uprights == 12);
}

BOOST_AUTO_TEST_CASE(cheapest_creases)
{
  const Mesh tube = seam_surfaces::tube(7, 2).mesh();
  const Weights usual = weights(tube, CREASES);
  for(const double cheapest : {0., 0.3, 0.475, 1.}) {
    Weights result;
    const auto map = boost::make_assoc_property_map(result);
    BOOST_TEST(bool(TA::compute_crease_weights(tube, map, cheapest)));
    for(Edge e : tube.edges())
      BOOST_TEST(factor(tube, result, e) == 1 - (1 - cheapest) / 0.7 * (1 - factor(tube, usual, e)),
                 boost::test_tools::tolerance(1e-9));
  }
  for(const double cheapest : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    Weights result;
    const auto map = boost::make_assoc_property_map(result);
    const auto report = TA::compute_crease_weights(tube, map, cheapest);
    BOOST_TEST((report.status == SMP::Diagnosis::WRONG_OPTION));
    BOOST_TEST(report.message.find("cheapest") != std::string::npos);
    BOOST_TEST(result.empty());
  }
}

BOOST_AUTO_TEST_CASE(points_of_another_map)
{
  const Mesh mesh = seam_surfaces::slab(2).mesh();
  std::map<Vertex, Point_3> doubled;
  for(Vertex v : mesh.vertices())
    doubled[v] = CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN);
  for(Kind kind : {VISIBILITY, CREASES}) {
    Weights result;
    const auto map = boost::make_assoc_property_map(result);
    const auto np = CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(doubled));
    kind == VISIBILITY ? TA::compute_visibility_weights(mesh, map, np)
                       : TA::compute_crease_weights(mesh, map, 0.3, np);
    for(const auto& [e, weight] : weights(mesh, kind))
      BOOST_TEST(result.at(e) == 2 * weight, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(weights_of_bad_meshes)
{
  const auto message = [](const Mesh& mesh) {
    Weights result;
    const auto report = TA::compute_visibility_weights(mesh, boost::make_assoc_property_map(result));
    if(!report)
      BOOST_TEST(result.empty());
    BOOST_TEST(report.offending_vertices.size() == (report.status == SMP::Diagnosis::NON_FINITE_POINT));
    BOOST_TEST(report.offending_faces.size() == (report.status == SMP::Diagnosis::NOT_TRIANGULATED));
    return report.message;
  };
  Mesh mesh = seam_surfaces::octahedron().mesh();
  mesh.point(Vertex(3)) = Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  BOOST_TEST(message(mesh) == "vertex 3 (0, nan, 0) has coordinates that are not all finite numbers");
  mesh.point(Vertex(3)) = Point_3(0, -1, 0);
  BOOST_TEST(message(mesh).empty());
  CGAL::Euler::join_face(mesh.halfedge(Edge(0)), mesh);
  mesh.collect_garbage();
  BOOST_TEST(message(mesh).find("is not a triangle") != std::string::npos);
  BOOST_TEST(message(Mesh()).empty());
  mesh.clear();
  for(const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(2, 0, 0), Point_3(9, 9, 9)})
    mesh.add_vertex(p); // the last one is isolated
  mesh.add_face(Vertex(0), Vertex(1), Vertex(2));
  for(Kind kind : {VISIBILITY, CREASES})
    for(const auto& [e, weight] : weights(mesh, kind)) // a degenerate face has no sides
      BOOST_TEST(weight == length(mesh, e));
}

BOOST_AUTO_TEST_CASE(selections)
{
  Octahedron o;
  const auto report = o.read("7 8\n1 2\n0 2 2 4 \n");
  BOOST_TEST(report.message == "");
  BOOST_TEST(static_cast<bool>(report));
  BOOST_TEST(report.number_of_seams == 2u);
  BOOST_TEST((marked(o.mesh, o.seams) == Pairs{{0, 2}, {2, 4}}));
  // Others are kept; lines may end as on Windows, or not at all, and may be several.
  BOOST_TEST(static_cast<bool>(o.read("\r\n\r\n3 1\r\n5 1 1 3")));
  BOOST_TEST((marked(o.mesh, o.seams) == Pairs{{0, 2}, {1, 3}, {1, 5}, {2, 4}}));

  std::ostringstream out;
  out.imbue(std::locale(""));
  BOOST_TEST(TA::write_seam_selection(out, o.mesh, o.seams).number_of_seams == 4u);
  Octahedron copy;
  BOOST_TEST(copy.read(out.str()).number_of_seams == 4u);
  BOOST_TEST((marked(copy.mesh, copy.seams) == marked(o.mesh, o.seams)));
  BOOST_TEST(static_cast<bool>(Octahedron().read("\n\n\n")));
}

BOOST_AUTO_TEST_CASE(wrong_selections)
{
  const auto check = [](const std::string& text, SMP::Diagnosis diagnosis, std::size_t line,
                        std::size_t element, const std::string& message) {
    Octahedron o;
    const auto report = o.read(text);
    BOOST_TEST(!static_cast<bool>(report));
    BOOST_TEST(SMP::to_string(report.status) == SMP::to_string(diagnosis));
    BOOST_TEST(report.line == line);
    BOOST_TEST(report.element == element);
    BOOST_TEST(report.message == message);
    BOOST_TEST(marked(o.mesh, o.seams).empty());
  };
  check("", SMP::Diagnosis::TOO_FEW_LINES, 0, 0,
        "there are only 0 lines, but edges are in the third line (after vertices and faces)");
  check("\n\n", SMP::Diagnosis::TOO_FEW_LINES, 0, 0,
        "there are only 2 lines, but edges are in the third line (after vertices and faces)");
  check("\n\n0 2 2 x4", SMP::Diagnosis::NOT_A_NUMBER, 3, 4,
        "line 3: number 4: \"x4\" is not a vertex number");
  check("\n\n0 2\n2.5 1", SMP::Diagnosis::NOT_A_NUMBER, 4, 1,
        "line 4: number 1: \"2.5\" is not a vertex number");
  check("\n\n-", SMP::Diagnosis::NOT_A_NUMBER, 3, 1, "line 3: number 1: \"-\" is not a vertex number");
  for(const std::string number : {"6", "-1", "99999999999999999999999"})
    check("\n\n0 2 2 " + number, SMP::Diagnosis::NUMBER_OUT_OF_RANGE, 3, 4,
          "line 3: number 4: there is no vertex " + number + ": the mesh has 6 vertices, numbered from 0");
  check("\n\n0 2 2", SMP::Diagnosis::ODD_COUNT, 3, 3,
        "line 3: number 3: vertex 2 has no partner: an edge is a pair of numbers");
  check("\n\n0 2 5 4 1 0", SMP::Diagnosis::NO_SUCH_EDGE, 3, 3,
        "line 3: number 3: there is no edge between vertices 5 and 4");
  check("\n\n0 2\n3 3", SMP::Diagnosis::NO_SUCH_EDGE, 4, 1,
        "line 4: number 1: there is no edge between vertices 3 and 3");
}

BOOST_AUTO_TEST_CASE(selection_files)
{
  Octahedron o;
  const auto missing = TA::read_seam_selection("no such folder/a.selection.txt", o.mesh, o.seams);
  BOOST_TEST(SMP::to_string(missing.status) == "CANNOT_OPEN");
  BOOST_TEST(missing.message == "cannot open no such folder/a.selection.txt");
  BOOST_TEST(
      SMP::to_string(TA::write_seam_selection("no such folder/a.selection.txt", o.mesh, o.seams).status) ==
      "CANNOT_OPEN");

  // What we write is what CGAL reads.
  BOOST_REQUIRE(static_cast<bool>(o.read("\n\n0 2 2 1 4 0")));
  const std::string name = "test_seam_weights.selection.txt";
  BOOST_TEST(static_cast<bool>(TA::write_seam_selection(name, o.mesh, o.seams)));
  Octahedron copy;
  const auto vertex_map = copy.mesh.add_property_map<Vertex, bool>("v:seam", false).first;
  CGAL::Seam_mesh<Mesh, Edge_map, Mesh::Property_map<Vertex, bool>> seam_mesh(copy.mesh, copy.seams,
                                                                              vertex_map);
  seam_mesh.add_seams(name.c_str());
  BOOST_TEST(seam_mesh.number_of_seam_edges() == 3u);
  BOOST_TEST((marked(copy.mesh, copy.seams) == marked(o.mesh, o.seams)));
  std::remove(name.c_str());
}

// Border edges are no seams, neither of files nor of seam meshes.
BOOST_AUTO_TEST_CASE(marked_borders)
{
  Mesh mesh = seam_surfaces::tube(5, 2).mesh();
  const Edge_map seams = seam_map(mesh);
  std::istringstream in("\n\n0 1 0 5 5 10");
  const auto report = TA::read_seam_selection(in, mesh, seams);
  BOOST_TEST(report.number_of_border_edges == 1u);
  BOOST_TEST(report.number_of_seams == 2u);
  BOOST_TEST((marked(mesh, seams) == Pairs{{0, 5}, {5, 10}}));
  for(Edge e : mesh.edges())
    if(mesh.is_border(e))
      put(seams, e, true);
  BOOST_TEST(static_cast<bool>(TA::is_disk_cut(mesh, seams)));
  const auto seam_mesh = TA::make_seam_mesh(mesh, seams).mesh;
  BOOST_TEST(seam_mesh.number_of_seam_edges() == 2u);
  BOOST_TEST(num_vertices(seam_mesh) == 18u);
  BOOST_TEST(num_edges(seam_mesh) == mesh.number_of_edges() + 2);
  std::ostringstream out;
  BOOST_TEST(TA::write_seam_selection(out, mesh, seams).number_of_border_edges == 10u);
}

namespace {

// A surface of which all edges are seams that are not in a tree of faces: one disk
template <typename TriangleMesh, typename EdgeIsSeamMap>
void open_along_dual_tree(const TriangleMesh& mesh, EdgeIsSeamMap seams)
{
  for(auto e : edges(mesh))
    put(seams, e, true);
  std::set<typename boost::graph_traits<TriangleMesh>::face_descriptor> reached{*faces(mesh).begin()};
  auto queue = std::vector(reached.begin(), reached.end());
  for(std::size_t i = 0; i < queue.size(); ++i)
    for(auto h : halfedges_around_face(halfedge(queue[i], mesh), mesh)) {
      const auto f = face(opposite(h, mesh), mesh);
      if(f == boost::graph_traits<TriangleMesh>::null_face() || !reached.insert(f).second)
        continue;
      put(seams, edge(h, mesh), false);
      queue.push_back(f);
    }
}

template <typename TriangleMesh>
void check_flattening(const Surface& surface)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  TriangleMesh mesh = surface.mesh<TriangleMesh>();
  const auto seams = get(CGAL::dynamic_edge_property_t<bool>(), const_cast<const TriangleMesh&>(mesh));
  open_along_dual_tree(mesh, seams);
  BOOST_REQUIRE(static_cast<bool>(TA::is_disk_cut(mesh, seams)));

  auto seam_mesh = TA::make_seam_mesh(mesh, seams).mesh;
  for(auto e : edges(mesh)) // it has its own marks
    put(seams, e, false);
  typedef decltype(seam_mesh) Seam_mesh;
  std::unordered_map<halfedge_descriptor, Point_2> uv;
  const auto uvmap = boost::make_assoc_property_map(uv);
  SMP::ABF_plus_plus_parameterizer_3<Seam_mesh> parameterizer;
  BOOST_TEST(SMP::parameterize(seam_mesh, parameterizer, TA::border_halfedge(seam_mesh), uvmap) == SMP::OK);
  BOOST_TEST(parameterizer.report().message == "");
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> flipped;
  SMP::flipped_faces(seam_mesh, uvmap, std::back_inserter(flipped));
  BOOST_TEST(flipped.empty());
  BOOST_TEST(uv.size() == num_vertices(seam_mesh));
}

} // namespace

BOOST_AUTO_TEST_CASE(seam_meshes_are_flattened)
{
  for(const Surface& surface :
      {seam_surfaces::tetrahedron(), seam_surfaces::sphere(1), seam_surfaces::torus(6, 5),
       seam_surfaces::slab(2), seam_surfaces::sphere_with_holes(3, 1)})
    BOOST_TEST_CONTEXT(surface.name)
  check_flattening<Mesh>(surface);
  check_flattening<Polyhedron>(seam_surfaces::octahedron());
}

// An octahedron cut along its equator: two caps, of which one is larger.
BOOST_AUTO_TEST_CASE(borders_of_parts)
{
  Octahedron o;
  BOOST_REQUIRE(static_cast<bool>(o.read("\n\n0 2 2 1 1 3 3 0 4 0")));
  const auto seam_mesh = TA::make_seam_mesh(o.mesh, o.seams).mesh;
  for(auto f : o.mesh.faces()) {
    const auto border = TA::border_halfedge(seam_mesh, f);
    BOOST_REQUIRE(is_border(border, seam_mesh));
    std::set<Mesh::Face_index> along;
    for(auto h : halfedges_around_face(border, seam_mesh))
      along.insert(face(opposite(h, seam_mesh), seam_mesh));
    BOOST_TEST(along.count(f) == 1u);
    BOOST_TEST(along.size() == 4u);
  }
  // The slit within the upper cap makes its border the longer one.
  const auto longest = TA::border_halfedge(seam_mesh);
  std::size_t size = 0;
  for(auto h : halfedges_around_face(longest, seam_mesh)) {
    (void)h;
    ++size;
  }
  BOOST_TEST(size == 6u);

  // Of a closed part, and of a mesh without seams
  const Octahedron closed;
  const auto without = TA::make_seam_mesh(closed.mesh, closed.seams).mesh;
  BOOST_TEST((TA::border_halfedge(without) == decltype(without)::halfedge_descriptor()));
  BOOST_TEST(without.number_of_seam_edges() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
