// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// OBJ files: what is written is read back, and what is wrong in a file is named.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef ABF_WITH_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/scene.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <ios>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_OBJ)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef std::vector<std::size_t> Polygon;
typedef std::mt19937 Random;

namespace {

std::size_t below(Random& random, std::size_t end)
{
  return random() % end;
}

// Any finite number: also -0, denormalized and very large ones
template <typename Number = double>
Number any_number(Random& random)
{
  for(;;) {
    Number number;
    const std::uint64_t bits = (std::uint64_t(random()) << 32) | random();
    std::memcpy(&number, &bits, sizeof(number));
    if(below(random, 20) == 0)
      number = Number(below(random, 2) == 0 ? -0. : 0.);
    if(std::isfinite(number))
      return number;
  }
}

std::uint64_t bits(double x)
{
  std::uint64_t result;
  std::memcpy(&result, &x, sizeof(x));
  return result;
}

// Faces of a grid of three, four and six vertices, in any order, with holes that touch at vertices
struct Grid
{
  std::size_t width, height;
  std::vector<Polygon> faces;

  explicit Grid(Random& random) : width(2 + below(random, 6)), height(2 + below(random, 6))
  {
    for(std::size_t y = 0; y + 1 < height; ++y)
      for(std::size_t x = 0; x + 1 < width; ++x) {
        const std::size_t a = y * width + x, b = a + 1, c = b + width, d = a + width;
        const std::size_t kind = below(random, 4);
        if(kind == 0 && x + 2 < width) {
          faces.push_back({a, b, b + 1, c + 1, c, d});
          ++x;
        } else if(kind == 1) {
          faces.push_back({a, b, c});
          faces.push_back({a, c, d});
        } else if(kind == 2)
          faces.push_back({a, b, c, d});
      }
    if(faces.empty())
      faces.push_back({0, 1, width});
    std::shuffle(faces.begin(), faces.end(), random);
    for(Polygon& face : faces)
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(below(random, face.size())),
                  face.end());
  }
};

// A mesh with texture coordinates of halfedges, and faces that have none
template <typename Mesh_, typename Point = Point_2>
struct Textured
{
  typedef Mesh_ Type;
  typedef boost::graph_traits<Type> Traits;
  typedef typename Traits::halfedge_descriptor Halfedge;
  typedef typename Traits::face_descriptor Face;

  Type mesh;
  typename boost::property_map<Type, CGAL::dynamic_halfedge_property_t<Point>>::type uv;
  typename boost::property_map<Type, CGAL::dynamic_face_property_t<int>>::type patch;

  Textured()
      : uv(get(CGAL::dynamic_halfedge_property_t<Point>(), mesh)),
        patch(get(CGAL::dynamic_face_property_t<int>(), mesh))
  {}

  Textured(const Textured&) = delete;
  Textured& operator=(const Textured&) = delete;

  void generate(Random& random)
  {
    typedef typename CGAL::Kernel_traits<Point>::Kernel::FT FT;
    const Grid grid(random);
    std::vector<typename Traits::vertex_descriptor> added;
    std::vector<std::array<Point, 3>> places;
    for(std::size_t i = 0; i < grid.width * grid.height; ++i) {
      added.push_back(add_vertex(mesh));
      put(get(CGAL::vertex_point, mesh), added.back(),
          Point_3(any_number(random), any_number(random), any_number(random)));
      places.emplace_back();
      for(Point& place : places.back())
        place = Point(any_number<FT>(random), any_number<FT>(random));
    }
    for(const Polygon& polygon : grid.faces) {
      std::vector<typename Traits::vertex_descriptor> corners;
      for(const std::size_t v : polygon)
        corners.push_back(added[v]);
      const Face f = CGAL::Euler::add_face(corners, mesh);
      BOOST_REQUIRE(f != Traits::null_face());
      put(patch, f, static_cast<int>(below(random, 4)) - 1);
      Halfedge h = halfedge(f, mesh);
      while(target(h, mesh) != corners.front())
        h = next(h, mesh);
      for(const std::size_t v : polygon) {
        put(uv, h, places[v][below(random, 3)]);
        h = next(h, mesh);
      }
    }
  }

  // All bits of each corner's point and texture coordinates; of those of faces without chart, what `none` is
  std::vector<std::vector<std::array<std::uint64_t, 5>>> corners(bool has_patches, std::uint64_t none) const
  {
    std::vector<std::vector<std::array<std::uint64_t, 5>>> result;
    for(const Face f : faces(mesh)) {
      const bool has_uv = !has_patches || get(patch, f) >= 0;
      result.emplace_back();
      for(const Halfedge h : halfedges_around_face(halfedge(f, mesh), mesh)) {
        const Point_3& p = get(get(CGAL::vertex_point, mesh), target(h, mesh));
        const Point& q = get(uv, h);
        result.back().push_back({bits(p.x()), bits(p.y()), bits(p.z()), has_uv ? bits(q.x()) : none,
                                 has_uv ? bits(q.y()) : none});
      }
    }
    return result;
  }
};

template <typename Mesh_>
bool is_valid_without_isolated_vertices(Mesh_& mesh)
{
  CGAL::Polygon_mesh_processing::remove_isolated_vertices(mesh);
  return CGAL::is_valid_polygon_mesh(mesh);
}

template <typename Mesh_, typename Point = Point_2>
void check_round_trip()
{
  std::size_t without = 0;
  for(unsigned seed = 0; seed < 200; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Random random(seed);
    Textured<Mesh_, Point> written, read;
    written.generate(random);
    std::stringstream stream, again;
    const TA::OBJ_report report =
        TA::IO::write_OBJ(stream, written.mesh, written.uv, CGAL::parameters::face_patch_map(written.patch));
    BOOST_TEST_REQUIRE(bool(report));
    const TA::OBJ_report back = TA::IO::read_OBJ(stream, read.mesh, read.uv);
    BOOST_TEST_REQUIRE(bool(back), back.message);
    BOOST_TEST(vertices(read.mesh).size() == vertices(written.mesh).size());
    BOOST_TEST(num_edges(read.mesh) == num_edges(written.mesh));
    BOOST_TEST(back.number_of_faces_without_coordinates == report.number_of_faces_without_coordinates);
    without += back.number_of_faces_without_coordinates;
    auto face = faces(read.mesh).begin(); // of these, none was put
    for(const auto f : faces(written.mesh))
      put(read.patch, *face++, get(written.patch, f));
    BOOST_TEST((read.corners(true, 7) == written.corners(true, 7)));
    TA::IO::write_OBJ(again, read.mesh, read.uv, CGAL::parameters::face_patch_map(read.patch));
    BOOST_TEST((again.str() == stream.str()));
    BOOST_TEST(is_valid_without_isolated_vertices(read.mesh));

    // All are in one chart
    Textured<Mesh_, Point> whole;
    std::stringstream one_chart;
    BOOST_TEST(bool(TA::IO::write_OBJ(one_chart, written.mesh, written.uv)));
    BOOST_TEST(bool(TA::IO::read_OBJ(one_chart, whole.mesh, whole.uv)));
    BOOST_TEST((whole.corners(false, 7) == written.corners(false, 7)));
  }
  BOOST_TEST(without > 100u);
}

// The points and texture coordinates that a text describes, or what is wrong with it
struct Text_mesh : Textured<Mesh>
{
  TA::OBJ_report report;

  explicit Text_mesh(const std::string& text)
  {
    std::istringstream in(text);
    report = TA::IO::read_OBJ(in, mesh, uv);
  }
};

const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 1\n";
const std::string coordinates = "vt 0 0\nvt .5 0\nvt .5 .5\nvt 0 .5\n";

} // namespace

BOOST_AUTO_TEST_CASE(all_bits_are_read_back)
{
  check_round_trip<Mesh>();
  check_round_trip<Polyhedron>();
  check_round_trip<Mesh, CGAL::Simple_cartesian<float>::Point_2>();
}

BOOST_AUTO_TEST_CASE(any_stream)
{
  struct Comma : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  Random random(1);
  Textured<Mesh> written;
  written.generate(random);
  std::ostringstream plain, odd;
  odd.imbue(std::locale(std::locale::classic(), new Comma));
  odd << std::hex << std::showpos << std::fixed;
  odd.precision(1);
  odd.width(3);
  const std::locale before = std::locale::global(odd.getloc());
  BOOST_TEST(bool(TA::IO::write_OBJ(plain, written.mesh, written.uv)));
  BOOST_TEST(bool(TA::IO::write_OBJ(odd, written.mesh, written.uv)));
  BOOST_TEST(plain.str() == odd.str());
  Textured<Mesh> read;
  std::istringstream in(odd.str());
  in.imbue(odd.getloc());
  BOOST_TEST(bool(TA::IO::read_OBJ(in, read.mesh, read.uv)));
  BOOST_TEST((read.corners(false, 0) == written.corners(false, 0)));
  const Text_mesh tiny("v 1e-400 -1e-310 1.5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::locale::global(before);
  BOOST_TEST_REQUIRE(bool(tiny.report));
  BOOST_TEST(tiny.mesh.point(Mesh::Vertex_index(0)) == Point_3(0, -1e-310, 1.5));
}

BOOST_AUTO_TEST_CASE(precision)
{
  const Text_mesh third("v 0.3333333333333333 0 100000\nv 1 0 0\nv 0 1 0\nvt 0.123456 1e-9\nf 1/1 2/1 3/1\n");
  std::ostringstream out;
  BOOST_TEST(bool(TA::IO::write_OBJ(out, third.mesh, third.uv, CGAL::parameters::stream_precision(3))));
  BOOST_TEST(out.str() ==
             "v 0.333 0 1e+05\nv 1 0 0\nv 0 1 0\nvt 0.123 1e-09\nvt 0.123 1e-09\nvt 0.123 1e-09\n"
             "f 1/1 2/2 3/3\n");
  for(const int digits : {0, -1, 18})
    BOOST_TEST(
        (TA::IO::write_OBJ(out, third.mesh, third.uv, CGAL::parameters::stream_precision(digits)).status ==
         SMP::Diagnosis::WRONG_OPTION));
}

BOOST_AUTO_TEST_CASE(all_ways_to_write_a_file)
{
  const Text_mesh plain(points + coordinates + "f 1/1 2/2 3/3 4/4\nf 3/1 5/2 4/3\n");
  BOOST_TEST_REQUIRE(bool(plain.report));
  const auto expected = plain.corners(false, 0);
  BOOST_TEST(expected.size() == 2u);
  std::string windows;
  for(const char c : points + coordinates + "f 1/1 2/2 3/3 4/4\nf 3/1 5/2 4/3")
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::vector<std::string> texts = {
      windows,
      "# a comment\n\nmtllib a.mtl\no box\n" + points + "vn 0 0 1\n" + coordinates +
          "g front\ns 1\nusemtl red\nf 1/1/1 2/2/1 3/3/1 4/4/1 # the front\nl 1 2\np 3\nf 3/1/1 5/2/1 "
          "4/3/1\n",
      "f 1/1 2/2 3/3 4/4\nf 3/1 5/2 4/3\n" + points + coordinates,
      points + coordinates + "f -5/-4 -4/-3 -3/-2 -2/-1\nf -3/-4 -1/-3 -2/-2\n",
      points + coordinates + "f -5/1/-9 2/-3/ 3/-2/4 -2/4/x\nfo 3/1 5/2 4/3\n",
      points + coordinates + "f 1/1 2/2 \\\n 3/3 \\\r\n4/4\n\tf\t3/1   5/2 4/3  \n",
      "v 0 0 0 1\nv 1 0 0 .1 .2 .3\nv 1 1 0\nv +0 1.0 0e0\nv 2 2 1e0\nvt 0\nvt .5\nvt .5 .5 0\nvt 0 5e-1\n"
      "f 1/1 2/2 3/3 4/4\nf 3/1 5/2 4/3\n",
      "vt 9 9\n" + points + "v 7 7 7\n" + coordinates + "f 1/2 2/3 3/4 4/5\nf 3/2 5/3 4/4\n"};
  for(const std::string& text : texts) {
    const Text_mesh read(text);
    BOOST_TEST(bool(read.report), read.report.message << " in\n" << text);
    BOOST_TEST((read.corners(false, 0) == expected), text);
  }

  const Text_mesh mixed(points + coordinates + "f 1 2 3 4\nf 3/1 5/2 4/3\n");
  BOOST_TEST(mixed.report.number_of_faces_without_coordinates == 1u);
  const Text_mesh normals(points + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 3// 5// 4//\n");
  BOOST_TEST(normals.report.number_of_faces_without_coordinates == 2u);
  BOOST_TEST(num_faces(normals.mesh) == 2u);
}

BOOST_AUTO_TEST_CASE(wrong_files)
{
  using SMP::Diagnosis;
  struct Case
  {
    std::string text;
    Diagnosis status;
    std::size_t line;
    std::string message;
  };
  const std::string all = points + coordinates; // nine lines
  const std::vector<Case> cases = {
      {"", Diagnosis::EMPTY_MESH, 0, "no faces"},
      {points, Diagnosis::EMPTY_MESH, 0, "no faces"},
      {std::string("\x89PNG\r\n\x1a\n\0\0v", 11), Diagnosis::EMPTY_MESH, 0, "no faces"},
      {"v 1 2\n", Diagnosis::TOO_FEW_NUMBERS, 1, "line 1: vertex 1: a number is missing"},
      {"v\n", Diagnosis::TOO_FEW_NUMBERS, 1, "vertex 1"},
      {"v 0 0 0\n\nv 1 2 # 3\n", Diagnosis::TOO_FEW_NUMBERS, 3, "vertex 2"},
      {"v 0 0 0\nv 1 2,5 3\n", Diagnosis::NOT_A_NUMBER, 2, "vertex 2: \"2,5\" is not a number"},
      {"v 0 0 1e\n", Diagnosis::NOT_A_NUMBER, 1, "\"1e\""},
      {"v 0 nan 0\n", Diagnosis::NON_FINITE_POINT, 1, "\"nan\" is not finite"},
      {"v 0 0 -1e999\n", Diagnosis::NON_FINITE_POINT, 1, "\"-1e999\""},
      {"vt\n", Diagnosis::TOO_FEW_NUMBERS, 1, "texture coordinates 1"},
      {"vt 0 x\n", Diagnosis::NOT_A_NUMBER, 1, "\"x\""},
      {"vt 0 inf\n", Diagnosis::NON_FINITE_COORDINATE, 1, "texture coordinates 1: \"inf\" is not finite"},
      {all + "f\n", Diagnosis::TOO_FEW_NUMBERS, 10, "face 1 has fewer than three"},
      {all + "f 1 2 3\nf 1 2\n", Diagnosis::TOO_FEW_NUMBERS, 11, "face 2 has fewer than three"},
      {all + "f 1 2 3.5\n", Diagnosis::NOT_A_NUMBER, 10, "\"3.5\" is not the number of a vertex"},
      {all + "f 1 2 3/\n", Diagnosis::NOT_A_NUMBER, 10, "\"\" is not the number of a pair"},
      {all + "f /1 2 3\n", Diagnosis::NOT_A_NUMBER, 10, "\"\" is not the number of a vertex"},
      {all + "f 1/1 2/2 3/x\n", Diagnosis::NOT_A_NUMBER, 10, "\"x\""},
      {all + "f 0 1 2\n", Diagnosis::NUMBER_OUT_OF_RANGE, 10, "face 1 names vertex 0"},
      {all + "f 1 2 -6\n", Diagnosis::NUMBER_OUT_OF_RANGE, 10, "vertex -6, counted backwards, but only 5"},
      {all + "f 1/-5 2/1 3/1\n", Diagnosis::NUMBER_OUT_OF_RANGE, 10, "but only 4 come before"},
      {all + "f 1 2 -9223372036854775808\n", Diagnosis::NUMBER_OUT_OF_RANGE, 10, "but only 5"},
      {all + "f 1 2 9223372036854775807\n", Diagnosis::NUMBER_OUT_OF_RANGE, 10, "the file has only 5"},
      {all + "f 1 2 99999999999999999999\n", Diagnosis::NUMBER_OUT_OF_RANGE, 10,
       "vertex 99999999999999999999"},
      {all + "f 1 2 3\nf 3 4 6\n", Diagnosis::NUMBER_OUT_OF_RANGE, 11,
       "line 11: face 2 names vertex 6, but the file has only 5"},
      {all + "f 1/1 2/2 3/5\n", Diagnosis::NUMBER_OUT_OF_RANGE, 10,
       "face 1 names texture coordinates 5, but the file has only 4"},
      {all + "f 1/1 2/2 3\n", Diagnosis::NO_TEXTURE_COORDINATES, 10,
       "face 1 has texture coordinates at some"},
      {all + "f 1/1 2//1 3/3\n", Diagnosis::NO_TEXTURE_COORDINATES, 10, "at some corners only"},
      {all + "f 1 \\\n2 3\nf 3 4 5 3\n", Diagnosis::REPEATED_VERTEX, 12, "face 2 names vertex 3 twice"},
      {all + "f 1 2 3\nf 2 3 5\n", Diagnosis::NON_MANIFOLD_EDGE, 11,
       "face 2 has the edge from vertex 2 to vertex 3 in the same direction as face 1"},
      {all + "f 1 2 3\n\nf 2 1 4\nf 3 2 4\nf 1 2 5\n", Diagnosis::NON_MANIFOLD_EDGE, 14,
       "face 4 has the edge from vertex 1 to vertex 2 in the same direction as face 1"},
      // a closed fan around vertex 1, and a face more
      {all + "v 3 3 3\nv 4 4 4\nf 1 2 3\nf 1 3 4\nf 1 6 7\nf 1 4 2\n", Diagnosis::NON_MANIFOLD_VERTEX, 14,
       "face 3 has vertex 1, which is surrounded"},
      {all + "v 3 3 3\nv 4 4 4\nf 1 6 7\nf 1 2 3\nf 1 3 4\nf 1 4 2\n", Diagnosis::NON_MANIFOLD_VERTEX, 13,
       "face 2 has vertex 1"}};
  for(const Case& wrong : cases) {
    BOOST_TEST_INFO_SCOPE(wrong.text);
    const Text_mesh read(wrong.text);
    BOOST_TEST(!read.report);
    BOOST_TEST(read.report.status == wrong.status);
    BOOST_TEST(read.report.line == wrong.line);
    BOOST_TEST(read.report.message.find(wrong.message) != std::string::npos, read.report.message);
    BOOST_TEST(vertices(read.mesh).size() == 0u);
  }
  // two fans on borders
  BOOST_TEST(bool(Text_mesh(all + "f 1 2 3\nf 1 4 5\n").report));
}

BOOST_AUTO_TEST_CASE(numbers_of_type_float)
{
  typedef CGAL::Simple_cartesian<float> Float;
  const auto read = [](const std::string& text) {
    CGAL::Surface_mesh<Float::Point_3> mesh;
    const auto uv = get(CGAL::dynamic_halfedge_property_t<Float::Point_2>(), mesh);
    std::istringstream in(text + "v 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n");
    const TA::OBJ_report report = TA::IO::read_OBJ(in, mesh, uv);
    BOOST_TEST(mesh.number_of_vertices() == (report ? 3u : 0u));
    BOOST_TEST((report || report.status == SMP::Diagnosis::PRECISION_EXCEEDED));
    return report.message;
  };
  BOOST_TEST(read("v 3.4e38 1e-300 0\nvt 0 -3.4e38\n") == "");
  BOOST_TEST(read("v 3.5e38 0 0\nvt 0 0\n") ==
             "vertex 1: a number is too large for the type of the coordinates");
  BOOST_TEST(read("v 0 0 0\nvt 0 -3.5e38\n") ==
             "texture coordinates 1: a number is too large for the type of the coordinates");
}

BOOST_AUTO_TEST_CASE(meshes_grow)
{
  Textured<Mesh> both;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
  for(int i = 0; i < 2; ++i) {
    std::istringstream in(triangle);
    BOOST_TEST(bool(TA::IO::read_OBJ(in, both.mesh, both.uv)));
  }
  BOOST_TEST(num_vertices(both.mesh) == 6u);
  BOOST_TEST(num_faces(both.mesh) == 2u);
  std::istringstream wrong(triangle + "f 1 2 3\n");
  BOOST_TEST(!TA::IO::read_OBJ(wrong, both.mesh, both.uv));
  BOOST_TEST(num_vertices(both.mesh) == 6u);

  const auto far = both.mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:far", Point_3(0, 0, 0)).first;
  std::istringstream in("v 9 8 7\nv 0 1 0\nv 1 0 0\nf 1 2 3\n");
  BOOST_TEST(bool(TA::IO::read_OBJ(in, both.mesh, both.uv, CGAL::parameters::vertex_point_map(far))));
  BOOST_TEST(far[Mesh::Vertex_index(6)] == Point_3(9, 8, 7));
}

BOOST_AUTO_TEST_CASE(maps_of_vertices)
{
  Random random(5);
  for(int i = 0; i < 20; ++i) {
    Textured<Mesh> written;
    written.generate(random);
    const auto uv = written.mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
    for(const auto v : written.mesh.vertices())
      uv[v] = Point_2(any_number(random), any_number(random));
    std::stringstream stream;
    BOOST_TEST(bool(TA::IO::write_OBJ(stream, written.mesh, uv)));
    Mesh read;
    const auto read_uv = read.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
    BOOST_TEST(bool(TA::IO::read_OBJ(stream, read, read_uv)));
    for(const auto v : written.mesh.vertices()) {
      if(written.mesh.is_isolated(v))
        continue;
      BOOST_TEST(bits(uv[v].x()) == bits(read_uv[v].x()));
      BOOST_TEST(bits(uv[v].y()) == bits(read_uv[v].y()));
    }
  }

  const auto read = [](const std::string& faces) {
    Mesh mesh;
    const auto uv = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv", Point_2(-1, -1)).first;
    std::istringstream in(points + coordinates + "vt 0 0\n" + faces);
    TA::OBJ_report report = TA::IO::read_OBJ(in, mesh, uv);
    if(report)
      for(const auto v : mesh.vertices())
        report.message += std::to_string(static_cast<int>(2 * uv[v].x())) + " ";
    else
      BOOST_TEST(mesh.number_of_vertices() == 0u);
    return report;
  };
  BOOST_TEST(read("f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n").message == "0 1 1 0 -2 "); // equal, but other numbers
  BOOST_TEST(read("f 1/1 2/2 3/3\nf 1 3 4\n").message == "0 1 1 -2 -2 ");
  const TA::OBJ_report seam = read("f 1/1 2/2 3/3\nf 1/1 3/4 4/4\n");
  BOOST_TEST(seam.status == SMP::Diagnosis::INCONSISTENT_COORDINATES);
  BOOST_TEST(seam.line == 12u);
  BOOST_TEST(seam.message.find("vertex 3 has other coordinates in face 2") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(seam_meshes_are_written_cut_open)
{
  typedef boost::graph_traits<Mesh>::edge_descriptor Edge;
  typedef Mesh::Property_map<Mesh::Edge_index, bool> Edge_map;
  typedef Mesh::Property_map<Mesh::Vertex_index, bool> Vertex_map;
  typedef CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map> Seam_mesh;
  Mesh sphere = seam_surfaces::sphere(1).mesh<Mesh>();
  const Edge_map edges = sphere.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const Vertex_map ends = sphere.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
  Seam_mesh cut(sphere, edges, ends);
  Mesh::Halfedge_index h(0);
  for(int i = 0; i < 4; ++i) { // straight on, at each vertex three edges further
    const Edge e = edge(h, sphere);
    BOOST_REQUIRE(cut.add_seam(source(e, sphere), target(e, sphere)));
    h = sphere.next(sphere.opposite(sphere.next(sphere.opposite(sphere.next(h)))));
  }
  const auto uv = sphere.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  double x = 0;
  for(const auto v : vertices(cut))
    for(const auto around : CGAL::halfedges_around_target(halfedge(v, cut), cut))
      uv[around.tmhd] = Point_2(x, x += 0.1);
  typedef boost::graph_traits<Seam_mesh>::vertex_descriptor Vertex;
  const auto uv_of_vertex = boost::make_function_property_map<Vertex>(
      [&](const Vertex& v) { return get(uv, Mesh::Halfedge_index(v)); });
  std::stringstream stream;
  BOOST_TEST_REQUIRE(bool(TA::IO::write_OBJ(stream, cut, uv_of_vertex)));
  Mesh read;
  const auto read_uv = read.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  BOOST_TEST_REQUIRE(bool(TA::IO::read_OBJ(stream, read, read_uv)));
  BOOST_TEST(read.number_of_vertices() == sphere.number_of_vertices() + 3);
  BOOST_TEST(read.number_of_faces() == sphere.number_of_faces());
  auto v = read.vertices().begin();
  for(const auto written : vertices(cut)) {
    BOOST_TEST(read_uv[*v] == get(uv_of_vertex, written));
    BOOST_TEST(read.point(*v++) == get(get(CGAL::vertex_point, cut), written));
  }
}

// Whatever is in a file, it is read or refused; what is read is a mesh.
BOOST_AUTO_TEST_CASE(changed_files)
{
  std::size_t read = 0, refused = 0;
  for(unsigned seed = 0; seed < 3000; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Random random(seed);
    std::string text =
        points + "vn 0 0 1\n" + coordinates + "f 1/1 2/2/1 3/3 4/4\nf 3/1 5/2 4/3\nf -1 -3 2\n";
    for(std::size_t i = 1 + below(random, 2); i > 0; --i) {
      const std::string characters = "0123456789-/. \\\n\r#vftne";
      const std::size_t place = below(random, text.size());
      const char c = characters[below(random, characters.size())];
      if(below(random, 3) == 0)
        text.erase(place, 1 + below(random, 3));
      else if(below(random, 2) == 0)
        text.insert(place, 1, c);
      else
        text[place] = c;
    }
    Text_mesh changed(text);
    (changed.report ? read : refused) += 1;
    BOOST_TEST(is_valid_without_isolated_vertices(changed.mesh));
    BOOST_TEST(changed.report.message.empty() == bool(changed.report));
    BOOST_TEST((!changed.report || num_faces(changed.mesh) > 0));
  }
  BOOST_TEST(read > 500u);
  BOOST_TEST(refused > 500u);
}

// Any faces on a few vertices: they are read if and only if CGAL can add them one by one.
BOOST_AUTO_TEST_CASE(any_faces)
{
  std::array<std::size_t, 4> outcomes = {}; // read, and the three ways to be refused
  std::size_t pinched = 0;
  for(unsigned seed = 0; seed < 20000; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Random random(seed);
    const std::size_t size = 5 + below(random, 3), number = 1 + below(random, 9);
    std::string text;
    std::vector<Polygon> polygons;
    Mesh mesh;
    for(std::size_t v = 0; v < size; ++v) {
      text += "v " + std::to_string(v) + " 0 0\n";
      mesh.add_vertex(Point_3(0, 0, 0));
    }
    bool is_mesh = true;
    for(std::size_t f = 0; f < number; ++f) {
      // often along an edge of a face before
      Polygon polygon;
      if(!polygons.empty() && below(random, 8) != 0) {
        const Polygon& other = polygons[below(random, polygons.size())];
        const std::size_t i = below(random, other.size());
        polygon = {other[(i + 1) % other.size()], other[i]};
      }
      for(const std::size_t wanted = 3 + below(random, 5) / 4; polygon.size() < wanted;) {
        const std::size_t v = below(random, size);
        if(below(random, 60) == 0 || std::find(polygon.begin(), polygon.end(), v) == polygon.end())
          polygon.push_back(v);
      }
      polygons.push_back(polygon);
      text += "f";
      std::vector<Mesh::Vertex_index> corners;
      for(const std::size_t v : polygon) {
        text += " " + std::to_string(v + 1);
        corners.emplace_back(static_cast<Mesh::size_type>(v));
      }
      text += "\n";
      is_mesh = is_mesh && CGAL::Euler::add_face(corners, mesh) != Mesh::null_face();
    }
    const Text_mesh read(text);
    BOOST_TEST(bool(read.report) == is_mesh);
    if(read.report) {
      BOOST_TEST(num_faces(read.mesh) == number);
      pinched += !CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(polygons);
    } else
      BOOST_TEST(!CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(polygons));
    const auto status = read.report.status;
    outcomes[status == SMP::Diagnosis::NOTHING_WRONG       ? 0
             : status == SMP::Diagnosis::REPEATED_VERTEX   ? 1
             : status == SMP::Diagnosis::NON_MANIFOLD_EDGE ? 2
                                                           : 3] += 1;
    BOOST_TEST((read.report || status == SMP::Diagnosis::REPEATED_VERTEX ||
                status == SMP::Diagnosis::NON_MANIFOLD_EDGE ||
                status == SMP::Diagnosis::NON_MANIFOLD_VERTEX));
  }
  for(const std::size_t count : outcomes)
    BOOST_TEST(count > 100u);
  BOOST_TEST(pinched > 100u);
}

namespace {

std::string content_of(const std::string& file)
{
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

} // namespace

BOOST_AUTO_TEST_CASE(materials)
{
  const Text_mesh square("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt .5 0\nvt .5 .5\nvt 0 .5\n"
                         "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 4/4 5/3\n");
  BOOST_TEST_REQUIRE(bool(square.report));
  TA::OBJ_material material;
  material.name = "stone";
  material.color_image = "stone colours.png";
  BOOST_TEST(bool(TA::IO::write_OBJ("test_OBJ.one.obj", square.mesh, square.uv, material)));
  BOOST_TEST(content_of("test_OBJ.one.mtl") == "newmtl stone\nKd 1 1 1\nmap_Kd stone colours.png\n");
  const std::string text = content_of("test_OBJ.one.obj");
  BOOST_TEST(text.find("mtllib test_OBJ.one.mtl\nv 0 0 0\n") == 0u);
  BOOST_TEST(text.find("usemtl stone\nvt") != std::string::npos);
  BOOST_TEST(text.find("usemtl") == text.rfind("usemtl"));

  std::vector<TA::OBJ_material> several(3, material);
  several[0].name = "plain";
  several[0].color = {0.5, 0.25, 1};
  several[0].color_image.clear();
  several[2].name = "bumps";
  several[2].normal_image = "n.png";
  several[2].displacement_image = "d.png";
  several[2].least_displacement = -0.5;
  several[2].greatest_displacement = 0.25;
  auto kind = get(CGAL::dynamic_face_property_t<std::size_t>(), square.mesh);
  const std::array<std::size_t, 3> kinds = {2, 2, 0};
  for(const auto f : faces(square.mesh))
    put(kind, f, kinds[f.idx()]);
  auto normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), square.mesh);
  for(const auto v : vertices(square.mesh))
    put(normals, v, Kernel::Vector_3(0, 0, v.idx()));
  BOOST_TEST(bool(TA::IO::write_OBJ("test_OBJ.obj", square.mesh, square.uv, kind, several,
                                    CGAL::parameters::vertex_normal_map(normals))));
  BOOST_TEST(content_of("test_OBJ.mtl") ==
             "newmtl plain\nKd 0.5 0.25 1\nnewmtl stone\nKd 1 1 1\nmap_Kd stone colours.png\n"
             "newmtl bumps\nKd 1 1 1\nmap_Kd stone colours.png\nnorm n.png\nmap_Bump n.png\n"
             "disp -mm -0.5 0.75 d.png\n");
  BOOST_TEST(content_of("test_OBJ.obj") ==
             "mtllib test_OBJ.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
             "vn 0 0 0\nvn 0 0 1\nvn 0 0 2\nvn 0 0 3\nvn 0 0 4\n"
             "usemtl bumps\nvt 0 0\nvt 0.5 0\nvt 0.5 0.5\nf 1/1/1 2/2/2 3/3/3\n"
             "vt 0 0.5\nf 1/1/1 3/3/3 4/4/4\nusemtl plain\nvt 0.5 0.5\nf 1/1/1 4/4/4 5/5/5\n");
  Textured<Mesh> read;
  BOOST_TEST(bool(TA::IO::read_OBJ("test_OBJ.obj", read.mesh, read.uv)));
  BOOST_TEST((read.corners(false, 0) == square.corners(false, 0)));

#ifdef ABF_WITH_ASSIMP
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile("test_OBJ.obj", 0);
  BOOST_TEST_REQUIRE(scene != nullptr);
  BOOST_TEST_REQUIRE(scene->mNumMeshes == 2u);
  for(unsigned m = 0; m < 2; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    const aiMaterial& found = *scene->mMaterials[mesh.mMaterialIndex];
    aiString image;
    if(found.GetTexture(aiTextureType_DIFFUSE, 0, &image) == AI_SUCCESS) {
      BOOST_TEST(std::string(found.GetName().C_Str()) == "bumps");
      BOOST_TEST(std::string(image.C_Str()) == "stone colours.png");
      BOOST_TEST(mesh.mNumFaces == 2u);
    } else {
      BOOST_TEST(std::string(found.GetName().C_Str()) == "plain");
      BOOST_TEST(mesh.mNumFaces == 1u);
    }
    BOOST_TEST(mesh.HasTextureCoords(0));
    BOOST_TEST(mesh.HasNormals());
  }
#endif
}

BOOST_AUTO_TEST_CASE(what_cannot_be_written)
{
  Text_mesh square(points + coordinates + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  BOOST_TEST_REQUIRE(bool(square.report));
  const std::string file = "test_OBJ.refused.obj";
  const auto number = get(CGAL::dynamic_face_property_t<int>(), square.mesh);
  for(const auto f : faces(square.mesh))
    put(number, f, static_cast<int>(f.idx()));
  const auto refuse = [&](const std::vector<TA::OBJ_material>& materials, const std::string& message) {
    const auto report = TA::IO::write_OBJ(file, square.mesh, square.uv, number, materials);
    BOOST_TEST(report.status == SMP::Diagnosis::WRONG_OPTION);
    BOOST_TEST(report.message.find(file + ": " + message) == 0u, report.message);
  };
  TA::OBJ_material good, bad;
  good.name = "good";
  refuse({good}, "face 1 has material 1, but there are 1 materials");
  put(number, *faces(square.mesh).begin(), -1);
  refuse({good, bad}, "face 0 has material -1");
  refuse({good, good}, "material 1 has the same name as material 0");
  for(const char* name : {"", "a\nb", "a\r", " a", "a\t", "#a", "a\\"}) {
    bad = good;
    bad.name = name;
    refuse({bad}, "material 0 has an empty name, or one that cannot be written");
    bad = good;
    for(std::string TA::OBJ_material::*image :
        {&TA::OBJ_material::color_image, &TA::OBJ_material::normal_image,
         &TA::OBJ_material::displacement_image})
      if(*name != '\0') {
        bad = good;
        bad.*image = name;
        refuse({bad}, "material 0 names a picture whose name cannot be written");
      }
  }
  for(const double number_out_of_range : {-0.1, 1.1, std::nan("")}) {
    bad = good;
    bad.color[1] = number_out_of_range;
    refuse({bad}, "material 0 has a colour outside of 0 to 1");
  }
  for(double TA::OBJ_material::*displacement :
      {&TA::OBJ_material::least_displacement, &TA::OBJ_material::greatest_displacement}) {
    bad = good;
    bad.*displacement = std::numeric_limits<double>::infinity();
    refuse({bad}, "material 0 has a displacement that is not finite");
  }
  BOOST_TEST(!std::ifstream(file));
  BOOST_TEST(TA::IO::write_OBJ("test_OBJ.refused.mtl", square.mesh, square.uv, good).status ==
             SMP::Diagnosis::WRONG_OPTION);
  BOOST_TEST(!std::ifstream("test_OBJ.refused.mtl"));

  // numbers that are not finite
  const auto check = [&](SMP::Diagnosis status, const std::string& message) {
    std::ostringstream out;
    const auto report = TA::IO::write_OBJ(out, square.mesh, square.uv);
    BOOST_TEST(report.status == status);
    BOOST_TEST(report.message.find(message) == 0u, report.message);
    BOOST_TEST(out.str().empty());
  };
  const auto h = square.mesh.halfedge(Mesh::Face_index(1));
  put(square.uv, h, Point_2(0, std::nan("")));
  check(SMP::Diagnosis::NON_FINITE_COORDINATE, "face 1 has a texture coordinate that is not finite");
  std::ostringstream out;
  put(square.patch, Mesh::Face_index(1), -1); // where nobody looks
  BOOST_TEST(
      bool(TA::IO::write_OBJ(out, square.mesh, square.uv, CGAL::parameters::face_patch_map(square.patch))));
  square.mesh.point(Mesh::Vertex_index(2)) = Point_3(0, std::numeric_limits<double>::infinity(), 0);
  check(SMP::Diagnosis::NON_FINITE_POINT,
        "vertex 2 (0, inf, 0) has coordinates that are not all finite numbers");
  square.mesh.point(Mesh::Vertex_index(2)) = Point_3(1, 1, 0);
  const auto normals = get(CGAL::dynamic_vertex_property_t<Kernel::Vector_3>(), square.mesh);
  for(const auto v : vertices(square.mesh))
    put(normals, v, Kernel::Vector_3(0, 0, v.idx() == 1 ? std::nan("") : 1));
  BOOST_TEST(
      TA::IO::write_OBJ(out, square.mesh, square.uv, CGAL::parameters::vertex_normal_map(normals)).status ==
      SMP::Diagnosis::WRONG_NORMAL);
}

BOOST_AUTO_TEST_CASE(files_that_fail)
{
  Text_mesh square(points + coordinates + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  const auto written = TA::IO::write_OBJ("no such folder/a.obj", square.mesh, square.uv);
  BOOST_TEST(written.status == SMP::Diagnosis::CANNOT_OPEN);
  BOOST_TEST(written.message == "cannot open no such folder/a.obj");
  Textured<Mesh> read;
  const auto missing = TA::IO::read_OBJ("no such folder/a.obj", read.mesh, read.uv);
  BOOST_TEST(missing.status == SMP::Diagnosis::CANNOT_OPEN);
  BOOST_TEST(missing.message == "cannot open no such folder/a.obj");
  std::ofstream("test_OBJ.wrong.obj") << "v 1\n";
  BOOST_TEST(TA::IO::read_OBJ("test_OBJ.wrong.obj", read.mesh, read.uv).message ==
             "test_OBJ.wrong.obj: line 1: vertex 1: a number is missing");

  std::stringstream broken;
  broken.setstate(std::ios::failbit);
  BOOST_TEST(TA::IO::read_OBJ(broken, read.mesh, read.uv).status == SMP::Diagnosis::CANNOT_READ);
  BOOST_TEST(TA::IO::write_OBJ(broken, square.mesh, square.uv).status == SMP::Diagnosis::CANNOT_WRITE);
  struct Lost_buffer : std::streambuf
  {
    int_type underflow() override { throw std::ios_base::failure("lost"); }
  } buffer;
  std::istream lost(&buffer);
  BOOST_TEST(TA::IO::read_OBJ(lost, read.mesh, read.uv).status == SMP::Diagnosis::CANNOT_READ);
  if(std::ofstream("/dev/full")) {
    BOOST_TEST(TA::IO::write_OBJ("/dev/full", square.mesh, square.uv).status == SMP::Diagnosis::CANNOT_WRITE);
  }
}

BOOST_AUTO_TEST_SUITE_END()
