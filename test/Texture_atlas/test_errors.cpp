// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors say what and where: bad vertices of meshes and soups are named by number and point, in messages and in reports
// of atlases, part by part, and condemn nothing else. A closed surface is called closed.

#include <boost/test/unit_test.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_atlas_of_soup.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/symmetrize_seams.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_errors)

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using SMP::Diagnosis;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

const double nan = std::numeric_limits<double>::quiet_NaN();

template <typename Surface>
using Vertex_of = typename boost::graph_traits<Surface>::vertex_descriptor;
template <typename Surface>
using Halfedge_of = typename boost::graph_traits<Surface>::halfedge_descriptor;
template <typename Surface>
using Edge_of = typename boost::graph_traits<Surface>::edge_descriptor;
template <typename Surface>
using Face_of = typename boost::graph_traits<Surface>::face_descriptor;

template <typename Surface>
Vertex_of<Surface> vertex_at(const Surface& mesh, const std::size_t position)
{
  return *std::next(vertices(mesh).begin(), static_cast<std::ptrdiff_t>(position));
}

template <typename Surface>
Face_of<Surface> face_at(const Surface& mesh, const std::size_t position)
{
  return *std::next(faces(mesh).begin(), static_cast<std::ptrdiff_t>(position));
}

template <typename Surface>
Surface grid(const bool has_triangles, const int n = 7)
{
  Surface mesh;
  CGAL::make_grid(
      n, n, mesh,
      [](const std::size_t i, const std::size_t j) {
        return Point_3(double(i), double(j), std::sin(0.3 * double(i)) * std::cos(0.4 * double(j)));
      },
      has_triangles);
  return mesh;
}

// A closed surface
template <typename Surface>
Surface ball()
{
  Surface mesh;
  CGAL::make_icosahedron<Surface, Point_3>(mesh);
  return mesh;
}

// What is wrong with some vertices, by their positions
using Bad_vertices = std::map<std::size_t, Diagnosis>;

Bad_vertices random_bad_vertices(const std::size_t size, std::mt19937& random)
{
  Bad_vertices bad;
  const int number = std::uniform_int_distribution<>(1, 6)(random);
  for(int i = 0; i < number; ++i)
    bad[std::uniform_int_distribution<std::size_t>(0, size - 1)(random)] =
        i % 3 == 2 ? Diagnosis::FAR_POINT : Diagnosis::NON_FINITE_POINT;
  return bad;
}

Point_3 bad_point(const Diagnosis what, const Point_3& p)
{
  return what == Diagnosis::FAR_POINT ? Point_3(p.x(), 1e30, 0) : Point_3(p.x(), nan, 3);
}

// The name of a vertex in messages
std::string name_of(const std::size_t number, const Point_3& p)
{
  std::ostringstream text;
  text << "vertex " << number << " (" << p.x() << ", " << p.y() << ", " << p.z() << ")";
  return text.str();
}

void check_contains(const std::string& text, const std::string& part)
{
  BOOST_TEST(text.find(part) != std::string::npos, "\"" << text << "\" contains no \"" << part << "\"");
}

// Whether some part of a text is among several
void check_contains_any(const std::string& text, const std::vector<std::string>& parts)
{
  bool contains = false;
  for(const std::string& part : parts)
    contains = contains || text.find(part) != std::string::npos;
  BOOST_TEST(contains, text);
}

// A mesh with coordinates and charts
template <typename Surface>
struct Charted
{
  Surface mesh;
  std::map<Halfedge_of<Surface>, Point_2> uv;
  std::map<Face_of<Surface>, int> charts;
  std::map<Edge_of<Surface>, bool> seams;

  explicit Charted(Surface&& surface) : mesh(std::move(surface))
  {
    for(const auto h : halfedges(mesh))
      uv[h] = Point_2(7, 7);
    for(const auto e : edges(mesh))
      seams[e] = false;
  }

  auto uv_map() { return boost::make_assoc_property_map(uv); }
  auto chart_map() { return boost::make_assoc_property_map(charts); }
  auto seam_map() { return boost::make_assoc_property_map(seams); }
};

// Makes vertices bad.
template <typename Surface>
void spoil(const Bad_vertices& bad, Surface& mesh)
{
  const auto points = get(CGAL::vertex_point, mesh);
  for(const auto& [position, what] : bad) {
    const auto v = vertex_at(mesh, position);
    put(points, v, bad_point(what, get(points, v)));
  }
}

// Checks what the report says of the parts of a mesh, the only faults of which are at bad vertices. `number` is that of
// the mesh.
template <typename Surface, typename Report>
void check_parts(const Surface& mesh, const Bad_vertices& bad, const Report& report, const std::size_t number)
{
  const auto points = get(CGAL::vertex_point, mesh);
  BOOST_TEST_REQUIRE(report.skipped_elements.size() == report.skipped.size());
  std::map<std::size_t, Diagnosis> found;
  std::set<Face_of<Surface>> skipped_faces, bad_faces;
  std::set<std::size_t> told_for_sure; // those with a face that is not bad for another reason as well
  for(std::size_t i = 0; i < report.skipped.size(); ++i) {
    const auto& part = report.skipped[i];
    const auto& elements = report.skipped_elements[i];
    if(part.mesh != number)
      continue;
    BOOST_TEST_REQUIRE(!elements.faces.empty());
    BOOST_TEST(part.number_of_faces == elements.faces.size());
    BOOST_TEST((face_at(mesh, part.first_face) == elements.faces.front()));
    for(const auto f : elements.faces)
      BOOST_TEST(skipped_faces.insert(f).second);
    BOOST_TEST_REQUIRE(part.vertices.size() == elements.vertices.size());
    BOOST_TEST_REQUIRE(!part.vertices.empty());
    std::vector<std::string> names;
    for(std::size_t k = 0; k < part.vertices.size(); ++k) {
      BOOST_TEST((vertex_at(mesh, part.vertices[k]) == elements.vertices[k]));
      found[part.vertices[k]] = part.status;
      names.push_back(name_of(part.vertices[k], get(points, elements.vertices[k])));
    }
    check_contains(part.message, names.front());
    check_contains(part.message, "first in face " + std::to_string(part.first_face));
    if(names.size() > 1)
      check_contains(part.message, "and " + std::to_string(names.size() - 1) + " other");
  }
  for(const auto f : faces(mesh)) {
    std::set<std::size_t> bad_corners;
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      for(const auto& [position, what] : bad)
        if(target(h, mesh) == vertex_at(mesh, position))
          bad_corners.insert(position);
    if(!bad_corners.empty())
      bad_faces.insert(f);
    if(bad_corners.size() == 1)
      told_for_sure.insert(*bad_corners.begin());
  }
  BOOST_TEST((skipped_faces == bad_faces)); // and no others
  for(const auto& [position, what] : found)
    BOOST_TEST((bad.at(position) == what));
  for(const std::size_t position : told_for_sure)
    BOOST_TEST(found.count(position) == 1u);
}

template <typename Surface>
void check_mesh(const bool has_triangles, const unsigned seed)
{
  BOOST_TEST_INFO_SCOPE("seed " << seed);
  std::mt19937 random(seed);
  Charted<Surface> charted(grid<Surface>(has_triangles));
  const Bad_vertices bad = random_bad_vertices(num_vertices(charted.mesh), random);
  spoil(bad, charted.mesh);
  const auto report = TA::make_atlas(charted.mesh, charted.seam_map(), charted.uv_map(), charted.chart_map());
  BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
  check_parts(charted.mesh, bad, report, 0);
  check_contains(report.message, report.skipped.front().message);
  std::set<Face_of<Surface>> skipped;
  std::vector<Vertex_of<Surface>> vertices;
  std::vector<Face_of<Surface>> faces_of_parts;
  for(const auto& elements : report.skipped_elements) {
    skipped.insert(elements.faces.begin(), elements.faces.end());
    vertices.insert(vertices.end(), elements.vertices.begin(), elements.vertices.end());
    faces_of_parts.push_back(elements.faces.front());
  }
  BOOST_TEST((report.offending_vertices == vertices));
  BOOST_TEST((report.offending_faces == faces_of_parts));
  for(const auto f : faces(charted.mesh))
    BOOST_TEST((charted.charts.at(f) < 0) == (skipped.count(f) > 0));
}

} // namespace

BOOST_AUTO_TEST_CASE(bad_vertices_of_meshes_are_named_and_condemn_nothing_else)
{
  for(unsigned seed = 0; seed < 6; ++seed) {
    check_mesh<Mesh>(true, seed);
    check_mesh<Mesh>(false, seed);
    check_mesh<Polyhedron>(true, seed);
    check_mesh<Polyhedron>(false, seed);
  }
}

BOOST_AUTO_TEST_CASE(meshes_that_share_an_atlas_name_their_own_elements)
{
  for(unsigned seed = 0; seed < 3; ++seed) {
    std::mt19937 random(seed);
    std::vector<Mesh> meshes = {grid<Mesh>(seed > 0), ball<Mesh>(), grid<Mesh>(true)};
    std::vector<Bad_vertices> bad(3);
    for(const std::size_t i : {0, 2}) {
      bad[i] = random_bad_vertices(num_vertices(meshes[i]), random);
      spoil(bad[i], meshes[i]);
    }
    std::vector<Mesh::Property_map<Mesh::Halfedge_index, Point_2>> uv;
    for(Mesh& mesh : meshes)
      uv.push_back(mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first);
    const auto report = TA::make_common_atlas(meshes, uv);
    BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
    for(std::size_t i = 0; i < 3; ++i)
      check_parts(meshes[i], bad[i], report, i);
    check_contains(report.message, "mesh 0: " + report.skipped.front().message);
    BOOST_TEST(report.offending_vertices.empty()); // nobody could tell of which mesh
  }
}

BOOST_AUTO_TEST_CASE(without_any_chart_the_status_is_the_reason)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, nan), mesh);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", Point_2(7, 7)).first;
  // One of the four faces is sound.
  auto report = TA::make_atlas(mesh, uv);
  BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
  for(const Mesh::Vertex_index v : {Mesh::Vertex_index(1), Mesh::Vertex_index(3)})
    mesh.point(v) = Point_3(nan, 0, 0);
  report = TA::make_atlas(mesh, uv);
  BOOST_TEST(report.status == Diagnosis::NON_FINITE_POINT);
  check_contains(report.message, "no part of the surface can be flattened: vertex ");
  check_contains(
      report.message,
      " (nan, 0, 0) and 1 other have coordinates that are not all finite numbers, first in face 0");
  BOOST_TEST(report.offending_vertices.size() == 2u);
  BOOST_TEST(!report.has_atlas());

  // The first of two reasons
  Mesh both;
  const auto add = [&both](const Point_3& p, const Point_3& q, const Point_3& r) {
    both.add_face(both.add_vertex(p), both.add_vertex(q), both.add_vertex(r));
  };
  add(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(2, 0, 0));
  add(Point_3(0, 0, 1), Point_3(1, 0, nan), Point_3(2, 1, 0));
  const auto both_uv = both.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto two = TA::make_atlas(both, both_uv);
  BOOST_TEST(two.status == Diagnosis::NO_AREA);
  check_contains(two.message, "no part of the surface can be flattened; the first: face 0, at vertex ");
  BOOST_TEST((two.offending_vertices == std::vector<Mesh::Vertex_index>{Mesh::Vertex_index(4)}));
  BOOST_TEST(
      (two.offending_faces == std::vector<Mesh::Face_index>{Mesh::Face_index(0), Mesh::Face_index(1)}));
}

// Parts that were read, but could not be cut
BOOST_AUTO_TEST_CASE(parts_that_cannot_be_cut_have_elements)
{
  for(const bool has_triangles : {true, false}) {
    Charted<Mesh> charted(grid<Mesh>(has_triangles));
    const std::size_t sheet = charted.mesh.number_of_faces();
    charted.mesh += ball<Mesh>();
    Charted<Mesh> both(std::move(charted.mesh));
    const auto never =
        boost::make_function_property_map<Mesh::Edge_index>([](Mesh::Edge_index) { return true; });
    const auto report = TA::make_atlas(both.mesh, both.uv_map(), TA::Atlas_options(),
                                       CGAL::parameters::edge_is_constrained_map(never));
    BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
    BOOST_TEST_REQUIRE(report.skipped_elements.size() == 1u);
    BOOST_TEST(report.skipped[0].status == Diagnosis::NO_CUT_ALLOWED);
    BOOST_TEST(report.skipped[0].first_face == sheet);
    BOOST_TEST_REQUIRE(report.skipped_elements[0].faces.size() == 20u);
    for(std::size_t i = 0; i < 20; ++i)
      BOOST_TEST((report.skipped_elements[0].faces[i] == face_at(both.mesh, sheet + i)));
    std::vector<std::string> names;
    for(std::size_t v = both.mesh.number_of_vertices() - 12; v < both.mesh.number_of_vertices(); ++v)
      names.push_back("with " + name_of(v, both.mesh.point(Mesh::Vertex_index(Mesh::size_type(v)))));
    check_contains_any(report.message, names);
  }
}

BOOST_AUTO_TEST_CASE(bad_points_of_soups_are_named_and_condemn_nothing_else)
{
  for(unsigned seed = 0; seed < 8; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    std::mt19937 random(seed);
    const Mesh mesh = grid<Mesh>(seed % 2 == 0);
    TA::Surface_soup soup;
    for(const auto v : mesh.vertices())
      soup.points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    for(const auto f : mesh.faces()) {
      std::vector<TA::Surface_soup::Index> polygon;
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        polygon.push_back(v.idx());
      soup.add_polygon(polygon);
    }
    const Bad_vertices bad = random_bad_vertices(soup.points.size(), random);
    for(const auto& [v, what] : bad) {
      const Point_3 p = bad_point(what, Point_3(soup.points[v].x(), 0, 0));
      soup.points[v] = TA::Surface_soup::Kernel::Point_3(p.x(), p.y(), p.z());
    }
    TA::Soup_atlas atlas;
    const TA::Soup_report report = TA::make_atlas(soup, atlas);
    BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
    Bad_vertices found;
    std::set<std::size_t> points;
    for(const auto& part : report.skipped) {
      BOOST_TEST_REQUIRE(!part.vertices.empty());
      for(const std::size_t v : part.vertices) {
        found[v] = part.status;
        points.insert(v);
      }
      const auto& p = soup.points[part.vertices.front()];
      check_contains(part.message, name_of(part.vertices.front() + 1, Point_3(p.x(), p.y(), p.z())));
    }
    // A polygon with both kinds of points counts for the first.
    for(const auto& [v, what] : found)
      BOOST_TEST((bad.at(v) == what));
    BOOST_TEST((std::vector<std::size_t>(points.begin(), points.end()) == report.offending_points));
    check_contains(report.message, report.skipped.front().message);
    for(TA::Surface_soup::Index p = 0; p < soup.number_of_polygons(); ++p) {
      bool is_bad = false;
      for(auto c = soup.first_corners[p]; c < soup.first_corners[p + 1]; ++c)
        is_bad = is_bad || bad.count(soup.vertices[c]) > 0;
      BOOST_TEST((atlas.charts[p] < 0) == is_bad);
    }
  }
}

// A part of a mesh that was made of a soup has the numbers of the soup, although other points come first in the mesh.
BOOST_AUTO_TEST_CASE(soups_that_share_an_atlas_are_named)
{
  TA::Surface_soup good, bad;
  good.name = "good";
  bad.name = "bad";
  for(TA::Surface_soup* const soup : {&good, &bad}) {
    for(const double x : {0., 1., 2.})
      for(const double y : {0., 1.})
        soup->points.emplace_back(x, y, x * y);
    soup->add_polygon({0, 2, 3, 1});
    soup->add_polygon({2, 4, 5, 3});
  }
  bad.points[5] = TA::Surface_soup::Kernel::Point_3(2, nan, 0);
  std::vector<TA::Soup_atlas> atlases(2);
  const TA::Soup_report report = TA::make_common_atlas(std::vector<TA::Surface_soup>{good, bad}, atlases);
  BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
  check_contains(report.message,
                 "'bad': vertex 6 (2, nan, 0) has coordinates that are not all finite numbers");
  BOOST_TEST(report.offending_soup == 1u);
  BOOST_TEST((report.offending_points == std::vector<std::size_t>{5}));
  BOOST_TEST_REQUIRE(report.skipped.size() == 1u);
  BOOST_TEST((report.skipped[0].vertices == std::vector<std::size_t>{5}));

  // What stops all is not called a fault of a part.
  TA::Soup_options hasty;
  hasty.time_limit = 1e-9;
  const TA::Soup_report late =
      TA::make_common_atlas(std::vector<TA::Surface_soup>{good, bad}, atlases, hasty);
  BOOST_TEST(late.status == Diagnosis::TIMED_OUT);
  BOOST_TEST(late.message.find("vertex") == std::string::npos, late.message);
}

BOOST_AUTO_TEST_CASE(messages_count_as_callers_want)
{
  const auto numbers = boost::make_function_property_map<Mesh::Vertex_index>(
      [](const Mesh::Vertex_index v) { return 1000 + v.idx(); });
  const auto face_numbers = boost::make_function_property_map<Mesh::Face_index>(
      [](const Mesh::Face_index f) { return 500 + f.idx(); });
  const auto np = CGAL::parameters::vertex_index_map(numbers);
  const std::string name = "vertex 1020 (0.5, nan, 3)";
  for(const bool has_triangles : {true, false}) {
    Charted<Mesh> charted(grid<Mesh>(has_triangles));
    charted.mesh.point(Mesh::Vertex_index(20)) = Point_3(0.5, nan, 3);
    const auto report =
        TA::make_atlas(charted.mesh, charted.uv_map(), TA::Atlas_options(), np.face_index_map(face_numbers));
    check_contains(report.message, name);
    check_contains(report.message, "face " + std::to_string(500 + report.offending_faces.front().idx()));
    BOOST_TEST((report.skipped[0].vertices == std::vector<std::size_t>{20})); // a position all the same
  }
  Mesh mesh = grid<Mesh>(true);
  mesh.point(Mesh::Vertex_index(20)) = Point_3(0.5, nan, 3);
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  const auto corner_uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto charts = mesh.add_property_map<Mesh::Face_index, int>("f:chart", 0).first;
  check_contains(SMP::flatten_surface(mesh, uv, np).message, name);
  check_contains(SMP::flatten_surface(mesh, uv, SMP::Hierarchical_options(), np).message, name);
  check_contains(SMP::measure_flattening(mesh, corner_uv, np).message, name);
  check_contains(TA::select_seams(mesh, seams, np).message, name);
  check_contains(TA::select_cones(mesh, 3, np).message, name);
  check_contains(TA::pack_charts(mesh, charts, corner_uv, np).message, name);
}

BOOST_AUTO_TEST_CASE(all_functions_name_vertices_by_number_and_point)
{
  const auto check = [](auto mesh, const auto& corner_uv, const auto& seams) {
    const std::string name = "vertex 20 (0.5, nan, 3)";
    put(get(CGAL::vertex_point, mesh), vertex_at(mesh, 20), Point_3(0.5, nan, 3));
    typedef decltype(mesh) Surface;
    std::map<Vertex_of<Surface>, Point_2> uv;
    check_contains(SMP::flatten_surface(mesh, boost::make_assoc_property_map(uv)).message, name);
    check_contains(
        SMP::flatten_surface(mesh, boost::make_assoc_property_map(uv), SMP::Hierarchical_options()).message,
        name);
    check_contains(SMP::measure_flattening(mesh, corner_uv).message, name);
    check_contains(TA::select_seams(mesh, seams).message, name);
    check_contains(TA::cut_to_disks(mesh, seams).message, name);
    check_contains(TA::select_cones(mesh, 3).message, name);
    check_contains(TA::find_mirror_plane(mesh).message, name);
    check_contains(SMP::polygon_angles(mesh, {{vertex_at(mesh, 20), 1.}}).message, name);
  };
  check(grid<Mesh>(true), boost::make_function_property_map<Mesh::Halfedge_index>([](Mesh::Halfedge_index) {
          return Point_2(0, 0);
        }),
        CGAL::Constant_property_map<Mesh::Edge_index, bool>(false));
  check(grid<Polyhedron>(true),
        boost::make_function_property_map<Halfedge_of<Polyhedron>>(
            [](const Halfedge_of<Polyhedron>&) { return Point_2(0, 0); }),
        CGAL::Constant_property_map<Edge_of<Polyhedron>, bool>(false));

  // A seam mesh has the numbers of the surface, and both copies of a vertex have the same.
  Mesh mesh = grid<Mesh>(true);
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const Mesh::Vertex_index v(20);
  for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
    if(!seams[mesh.edge(h)] && mesh.source(h).idx() % 8 == v.idx() % 8)
      seams[mesh.edge(h)] = true; // both edges along its line of the grid
  mesh.point(v) = Point_3(0.5, nan, 3);
  auto cut = TA::make_seam_mesh(mesh, seams);
  BOOST_TEST_REQUIRE(bool(cut));
  std::map<Vertex_of<TA::Cut_mesh<Mesh>>, Point_2> uv;
  check_contains(SMP::flatten_surface(cut.mesh, boost::make_assoc_property_map(uv)).message,
                 "vertex 20 (0.5, nan, 3)");
}

namespace {

template <typename Surface, typename Parameterizer>
void check_null_halfedge(Surface mesh, const Diagnosis status, const std::string& text)
{
  std::map<Vertex_of<Surface>, Point_2> uv;
  const auto null = boost::graph_traits<Surface>::null_halfedge();
  Parameterizer parameterizer;
  const auto code = SMP::parameterize(mesh, parameterizer, null, boost::make_assoc_property_map(uv));
  BOOST_TEST(parameterizer.report().status == status);
  BOOST_TEST(code == SMP::error_code(status));
  check_contains(parameterizer.report().message, text);
  const auto measured = SMP::measure_flattening(mesh, null, boost::make_assoc_property_map(uv));
  BOOST_TEST(measured.status == status);
  BOOST_TEST(measured.message == parameterizer.report().message);
  BOOST_TEST(uv.empty());
}

template <typename Surface>
void check_null_halfedges()
{
  typedef SMP::ABF_plus_plus_parameterizer_3<Surface> Direct;
  typedef SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Surface> Hierarchical;
  check_null_halfedge<Surface, Direct>(ball<Surface>(), Diagnosis::NO_BORDER, "closed");
  check_null_halfedge<Surface, Direct>(ball<Surface>(), Diagnosis::NO_BORDER, "make_atlas()");
  check_null_halfedge<Surface, Hierarchical>(ball<Surface>(), Diagnosis::NO_BORDER, "select_seams()");
  check_null_halfedge<Surface, Direct>(grid<Surface>(true), Diagnosis::NOT_ON_BORDER, "null");
  check_null_halfedge<Surface, Hierarchical>(grid<Surface>(true), Diagnosis::NOT_ON_BORDER, "null");
  check_null_halfedge<Surface, Direct>(Surface(), Diagnosis::EMPTY_MESH, "no faces");
}

} // namespace

BOOST_AUTO_TEST_CASE(a_null_halfedge_of_a_closed_surface_says_so)
{
  check_null_halfedges<Mesh>();
  check_null_halfedges<Polyhedron>();
  const Mesh closed = ball<Mesh>();
  const auto rectangle = SMP::rectangle_angles(closed, Mesh::null_halfedge(), 1);
  BOOST_TEST(rectangle.status == Diagnosis::NO_BORDER);
  const auto disk = TA::is_disk_cut(closed, CGAL::Constant_property_map<Mesh::Edge_index, bool>(false));
  BOOST_TEST(disk.status == Diagnosis::NO_BORDER);
  // A halfedge that is not null does not hide it either.
  std::map<Mesh::Vertex_index, Point_2> uv;
  const auto measured =
      SMP::measure_flattening(closed, Mesh::Halfedge_index(4), boost::make_assoc_property_map(uv));
  BOOST_TEST(measured.status == Diagnosis::NO_BORDER);
}

BOOST_AUTO_TEST_SUITE_END()
