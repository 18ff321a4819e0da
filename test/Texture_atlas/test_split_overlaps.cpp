// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps that overlap themselves: the faces that overlap, and the pieces without overlap, compared with searches through
// all pairs.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/overlapping_faces.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/split_overlaps.h>

#include "hard_charts.h"
#include "immersed_charts.h"
#include "mesh_of_chart.h"
#include "test_data.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_split_overlaps)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using TA::Overlap_split_report;
using test_charts::Chart;
using test_charts::Point_2;
using test_charts::Point_3;
using test_charts::Triangles;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

// A mesh with the map that forgets z, and room for seams and pieces
struct Flat_mesh
{
  Mesh mesh;
  Mesh::Property_map<Halfedge, Point_2> uv;
  Mesh::Property_map<Edge, bool> seams;
  Mesh::Property_map<Face, int> piece;

  Flat_mesh() { add_maps(); }
  Flat_mesh(const Flat_mesh&) = delete; // the maps belong to the mesh

  explicit Flat_mesh(const Chart& chart)
  {
    test_charts::make_mesh(chart, mesh);
    add_maps();
  }

  Flat_mesh(const std::vector<Point_3>& points, const Triangles& triangles)
      : Flat_mesh(test_charts::make_chart(points, triangles))
  {}

  void add_maps()
  {
    uv = mesh.add_property_map<Halfedge, Point_2>("h:map").first;
    seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
    piece = mesh.add_property_map<Face, int>("f:piece", -1).first;
    for(Halfedge h : mesh.halfedges())
      uv[h] = Point_2(mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y());
  }

  template <typename NamedParameters = parameters::Default_named_parameters>
  auto split(const NamedParameters& np = parameters::default_values())
  {
    return TA::split_overlaps(mesh, uv, seams, piece, np);
  }

  std::vector<bool> seam_marks() const
  {
    std::vector<bool> marks;
    for(Edge e : mesh.edges())
      marks.push_back(seams[e]);
    return marks;
  }

  std::vector<int> pieces() const
  {
    std::vector<int> result;
    for(Face f : mesh.faces())
      result.push_back(piece[f]);
    return result;
  }

  auto vertex_uv() const
  {
    const Mesh& m = mesh;
    return boost::make_function_property_map<Vertex>(
        [&m](Vertex v) { return Point_2(m.point(v).x(), m.point(v).y()); });
  }

  std::vector<int> overlapping() const
  {
    std::vector<Face> faces;
    TA::overlapping_faces(mesh, vertex_uv(), std::back_inserter(faces));
    return std::vector<int>(faces.begin(), faces.end());
  }
};

// The triangles that overlap others, pair by pair; flipped ones are turned over, and those without area left out.
std::vector<int> slowly_overlapping(const std::vector<Point_3>& points, Triangles triangles)
{
  std::vector<char> has_area;
  for(auto& t : triangles) {
    const std::array<int, 3> flipped = {t[0], t[2], t[1]};
    const bool is_flipped = test_charts::Overlaps(points, {flipped}).are_positive();
    has_area.push_back(is_flipped || test_charts::Overlaps(points, {t}).are_positive());
    t = is_flipped ? flipped : t;
  }
  std::vector<char> overlaps(triangles.size(), false);
  for(std::size_t s = 0; s < triangles.size(); ++s)
    for(std::size_t t = 0; t < s; ++t)
      if(has_area[s] && has_area[t]) {
        std::vector<Point_3> six;
        Triangles two(2);
        std::map<int, int> number;
        for(int i : {0, 1})
          for(int k = 0; k < 3; ++k) {
            const int v = triangles[i == 0 ? s : t][k];
            if(number.emplace(v, static_cast<int>(six.size())).second)
              six.push_back(points[v]);
            two[i][k] = number[v];
          }
        if(!test_charts::Overlaps(six, two).is_injective())
          overlaps[s] = overlaps[t] = true;
      }
  std::vector<int> result;
  for(std::size_t t = 0; t < overlaps.size(); ++t)
    if(overlaps[t])
      result.push_back(static_cast<int>(t));
  return result;
}

// Whether a piece is injective, pair by pair of its triangles
template <typename SeamMesh>
bool is_slowly_injective(const Flat_mesh& flat, const SeamMesh& seam_mesh, int piece)
{
  std::map<Halfedge, int> number;
  std::vector<Point_3> points;
  Triangles triangles;
  for(Face f : flat.mesh.faces())
    if(flat.piece[f] == piece) {
      triangles.emplace_back();
      int k = 0;
      for(Halfedge h : flat.mesh.halfedges_around_face(flat.mesh.halfedge(f))) {
        const Halfedge v = target(typename SeamMesh::halfedge_descriptor(h), seam_mesh);
        if(number.emplace(v, static_cast<int>(points.size())).second)
          points.emplace_back(flat.uv[h].x(), flat.uv[h].y(), 0);
        triangles.back()[k++] = number[v];
      }
    }
  return test_charts::Overlaps(points, triangles).is_injective();
}

// Pieces are what the seams leave, in the order of their first faces; their maps are injective.
void check_pieces(const Flat_mesh& flat, const Overlap_split_report& report, bool are_disks = true)
{
  BOOST_TEST_REQUIRE(report.message == "");
  BOOST_TEST(bool(report));
  const auto check = TA::is_disk_cut(flat.mesh, flat.seams);
  BOOST_TEST_REQUIRE(check.parts.size() == report.number_of_pieces);
  const auto seam_mesh = TA::make_seam_mesh(flat.mesh, flat.seams).mesh;
  typedef decltype(seam_mesh) Seam_mesh;
  typedef std::decay_t<Seam_mesh> Plain_seam_mesh;
  const auto uv =
      boost::make_function_property_map<typename boost::graph_traits<Plain_seam_mesh>::vertex_descriptor>(
          [&](const auto& v) { return flat.uv[static_cast<Halfedge>(v)]; });
  for(std::size_t p = 0; p < check.parts.size(); ++p) {
    BOOST_TEST(flat.piece[check.parts[p].face] == static_cast<int>(p));
    BOOST_TEST(static_cast<std::size_t>(std::count(flat.piece.begin(), flat.piece.end(),
                                                   static_cast<int>(p))) == check.parts[p].number_of_faces);
    if(are_disks)
      BOOST_TEST(check.parts[p].euler_characteristic == 1);
    const typename Plain_seam_mesh::halfedge_descriptor h(flat.mesh.halfedge(check.parts[p].face));
    BOOST_TEST(SMP::is_injective(seam_mesh, h, uv));
    std::vector<Face> overlapping;
    TA::overlapping_faces(seam_mesh, h, uv, std::back_inserter(overlapping));
    BOOST_TEST(overlapping.empty());
    if(check.parts[p].number_of_faces < 150)
      BOOST_TEST(is_slowly_injective(flat, seam_mesh, static_cast<int>(p)));
  }
}

double edge_length(const Mesh& mesh, Edge e)
{
  const Halfedge h = mesh.halfedge(e);
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

// A ribbon around the origin that rises, by `turns` of 24 columns each; its rows have the radii from 1 to 2.
Chart helicoid(double turns, int rows = 3)
{
  return test_charts::patch(static_cast<int>(24 * turns), rows, [rows](int i, int j) {
    const double angle = -CGAL_PI / 12 * i, radius = 1 + double(j) / rows;
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), 0.02 * i);
  });
}

// A ribbon of 4 rows along a curve, `curve(t)` for t from 0 to 1
template <typename Curve>
Chart ribbon_along(const Curve& curve, int columns, double width)
{
  return test_charts::patch(columns, 4, [&](int i, int j) {
    const double t = double(i) / columns;
    const Point_2 p = curve(t);
    const auto d = curve(t + 1e-4) - curve(t - 1e-4);
    const double s = width * (j - 2) / 4 / std::sqrt(d.squared_length());
    return Point_3(p.x() - s * d.y(), p.y() + s * d.x(), 0.01 * i);
  });
}

Chart lissajous_ribbon()
{
  return ribbon_along(
      [](double t) {
        const double a = (0.02 + 0.96 * t) * 2 * CGAL_PI;
        return Point_2(3 * std::sin(3 * a), 3 * std::sin(2 * a));
      },
      200, 0.3);
}

// Its three straight parts meet in the origin.
Chart rose_ribbon()
{
  return ribbon_along(
      [](double t) {
        const double a = 0.05 + 0.95 * CGAL_PI * t;
        return Point_2(10 * std::cos(3 * a) * std::cos(a), 10 * std::cos(3 * a) * std::sin(a));
      },
      240, 0.6);
}

// A fan of triangles that goes around a vertex by some turns, closed if they are whole turns
Flat_mesh fan(double turns)
{
  const int n = static_cast<int>(8 * turns);
  const bool is_closed = turns == std::floor(turns);
  std::vector<Point_3> points{{0, 0, 0}};
  Triangles triangles;
  for(int i = 0; i < (is_closed ? n : n + 1); ++i)
    points.emplace_back((1 + 0.01 * i) * std::cos(CGAL_PI / 4 * i),
                        (1 + 0.01 * i) * std::sin(CGAL_PI / 4 * i), 0);
  for(int i = 0; i < n; ++i)
    triangles.push_back({0, i + 1, (i + 1) % (is_closed ? n : n + 1) + 1});
  return Flat_mesh(points, triangles);
}

// A grid, some of whose vertices are moved to a few places
Chart crumpled_grid(unsigned seed)
{
  Chart chart = test_charts::flat_grid(5, seed);
  std::mt19937 random(seed);
  const unsigned moves = 1 + random() % 8;
  for(unsigned i = 0; i < moves; ++i) {
    const double x = random() % 6, y = random() % 6;
    chart.points[random() % chart.points.size()] = Point_3(x / 5, y / 5, 0);
  }
  return chart;
}

Triangles triangles_of(const Chart& chart)
{
  Triangles triangles;
  for(int c = 0; c < chart.number_of_corners(); c += 3)
    triangles.push_back({chart.vertex[c], chart.vertex[c + 1], chart.vertex[c + 2]});
  return triangles;
}

} // namespace

BOOST_AUTO_TEST_CASE(overlapping_faces_are_those_of_all_pairs)
{
  int overlapping = 0;
  for(unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::vector<Point_3> points;
    Triangles triangles;
    if(seed % 3 == 0) {
      const Chart chart = crumpled_grid(seed);
      points = chart.points;
      triangles = triangles_of(chart);
    } else if(seed % 3 == 1) {
      const test_charts::Random_disk disk(40, 7, random);
      points = disk.points();
      triangles = disk.triangles();
    } else {
      const test_charts::Random_surface surface(5, 8, 8, random);
      points = surface.points();
      triangles = surface.triangles();
    }
    const Flat_mesh flat(points, triangles);
    const std::vector<int> expected = slowly_overlapping(points, triangles);
    BOOST_TEST_CONTEXT("seed " << seed) BOOST_TEST(flat.overlapping() == expected);
    overlapping += !expected.empty();
  }
  BOOST_TEST(overlapping > 100);
  BOOST_TEST(overlapping < 300);
}

BOOST_AUTO_TEST_CASE(a_map_is_injective_without_flipped_and_overlapping_faces)
{
  std::map<bool, int> tally;
  for(unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    const test_charts::Punched_grid grid(4, seed % 4 == 0 ? 0 : 1, random);
    const test_charts::Random_surface surface(6, 6, 2, random);
    const Flat_mesh flat(seed % 2 == 0 ? grid.points() : surface.points(),
                         seed % 2 == 0 ? grid.triangles() : surface.triangles());
    std::vector<Face> flipped;
    SMP::flipped_faces(flat.mesh, flat.vertex_uv(), std::back_inserter(flipped));
    const bool is_injective = SMP::is_injective(flat.mesh, flat.vertex_uv());
    BOOST_TEST_CONTEXT("seed " << seed)
    BOOST_TEST(is_injective == (flipped.empty() && flat.overlapping().empty()));
    ++tally[is_injective];
  }
  BOOST_TEST(tally[true] > 50);
  BOOST_TEST(tally[false] > 50);
}

BOOST_AUTO_TEST_CASE(common_vertices_and_edges_are_no_overlap_and_other_contacts_are)
{
  const Triangles one_by_one{{0, 1, 2}, {3, 4, 5}};
  // two triangles with a common edge, a common vertex, and of a pinched surface
  BOOST_TEST(
      Flat_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}).overlapping().empty());
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}})
                 .overlapping()
                 .empty());
  // the same with points instead of vertices, and a vertex on an edge
  const std::vector<int> both{0, 1};
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, one_by_one)
                 .overlapping() == both);
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}, one_by_one)
                 .overlapping() == both);
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}}, one_by_one)
                 .overlapping() == both);
  // one within the other, and a hair's breadth apart
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, one_by_one)
                 .overlapping() == both);
  const double hair = std::nextafter(0., -1.);
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, hair, 0}, {0, -1, 0}, {2, -1, 0}}, one_by_one)
                 .overlapping()
                 .empty());
}

BOOST_AUTO_TEST_CASE(flipped_and_degenerate_faces_are_told_apart)
{
  const std::vector<int> both{0, 1};
  const Triangles folded{{0, 1, 2}, {1, 3, 2}};
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.1, 0}}, folded).overlapping() == both);
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, folded).overlapping() == both);
  // both flipped, beside each other
  BOOST_TEST(Flat_mesh({{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {-1, 1, 0}}, folded).overlapping().empty());
  for(const Point_3& p : {Point_3(0.5, 0.5, 0), Point_3(0.25, infinity, 0), Point_3(std::nan(""), 0, 0)})
    BOOST_TEST(Flat_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, p}, folded).overlapping().empty());
}

BOOST_AUTO_TEST_CASE(components_are_looked_at_together_or_one_by_one)
{
  Flat_mesh flat({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {3, 0, 0}, {1, 2, 0}}, {{0, 1, 2}, {3, 4, 5}});
  BOOST_TEST(flat.overlapping().size() == 2u);
  for(Halfedge h : flat.mesh.halfedges()) {
    std::vector<Face> faces;
    TA::overlapping_faces(flat.mesh, h, flat.vertex_uv(), std::back_inserter(faces));
    BOOST_TEST(faces.empty());
  }
  Mesh quad;
  quad.add_face(quad.add_vertex(Point_3(0, 0, 0)), quad.add_vertex(Point_3(1, 0, 0)),
                quad.add_vertex(Point_3(1, 1, 0)), quad.add_vertex(Point_3(0, 1, 0)));
  const auto uv = boost::make_function_property_map<Vertex>([](Vertex) { return Point_2(0, 0); });
  std::vector<Face> faces;
  TA::overlapping_faces(quad, uv, std::back_inserter(faces));
  BOOST_TEST(faces.empty());
}

BOOST_AUTO_TEST_CASE(charts_without_overlap_stay_as_they_are)
{
  for(const Chart& chart :
      {test_charts::flat_grid(8, 3), test_charts::annulus(12), test_charts::spiral(200), helicoid(0.9)}) {
    Flat_mesh flat(chart);
    const auto report = flat.split();
    check_pieces(flat, report, false);
    BOOST_TEST(report.number_of_charts == 1u);
    BOOST_TEST(report.number_of_pieces == 1u);
    BOOST_TEST(report.number_of_overlapping_charts == 0u);
    BOOST_TEST(report.number_of_overlapping_faces == 0u);
    BOOST_TEST(report.added_seam_length == 0);
    BOOST_TEST(report.extra_seam == 0);
    const std::vector<bool> marks = flat.seam_marks();
    BOOST_TEST(std::count(marks.begin(), marks.end(), true) == 0);
  }
}

// Each cut crosses the ribbon, whose width is 1, and no piece can have more than one turn.
BOOST_AUTO_TEST_CASE(spirals_over_themselves_are_cut_across)
{
  for(double turns : {1.125, 1.5, 1.875, 2.5, 3.25, 5.5, 9.75}) {
    Flat_mesh flat(helicoid(turns));
    const auto report = flat.split();
    BOOST_TEST_INFO_SCOPE(turns << " turns");
    check_pieces(flat, report);
    BOOST_TEST(report.number_of_pieces >= std::ceil(turns));
    BOOST_TEST(report.number_of_pieces <= 2 * std::ceil(turns));
    BOOST_TEST(report.added_seam_length < 1.1 * (report.number_of_pieces - 1));
    BOOST_TEST(report.number_of_overlapping_faces == flat.overlapping().size());
    double added = 0;
    for(Edge e : flat.mesh.edges())
      added += flat.seams[e] ? edge_length(flat.mesh, e) : 0;
    BOOST_TEST(report.added_seam_length == added, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(report.extra_seam == 2 * added / report.border_length, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(more_than_two_sheets_and_several_overlaps_are_separated)
{
  for(const Chart& chart : {lissajous_ribbon(), rose_ribbon()}) {
    Flat_mesh flat(chart);
    const auto report = flat.split();
    check_pieces(flat, report);
    BOOST_TEST(report.number_of_pieces >= 3u);
    BOOST_TEST(report.number_of_pieces <= 8u);
  }
}

// More pairs than are stored at once
BOOST_AUTO_TEST_CASE(many_sheets_are_separated)
{
  Flat_mesh flat(helicoid(60.5, 1));
  const auto report = flat.split();
  check_pieces(flat, report);
  BOOST_TEST(report.number_of_pieces >= 61u);
  BOOST_TEST(report.number_of_pieces <= 122u);
}

// Around a vertex inside the chart, or on its border
BOOST_AUTO_TEST_CASE(vertices_are_gone_around_once)
{
  for(double turns : {1.25, 1.5, 2., 2.75, 3., 5.}) {
    Flat_mesh flat = fan(turns);
    const auto report = flat.split();
    BOOST_TEST_INFO_SCOPE(turns << " turns");
    check_pieces(flat, report);
    BOOST_TEST(report.number_of_pieces >= 2u);
  }
}

BOOST_AUTO_TEST_CASE(pieces_of_random_disks_are_injective_disks)
{
  int split = 0;
  std::size_t most = 0;
  for(unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    const test_charts::Random_disk disk(20 + static_cast<int>(seed % 80), 5 + static_cast<int>(seed % 20),
                                        random);
    Flat_mesh flat(disk.points(), disk.triangles());
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const auto report = flat.split();
    check_pieces(flat, report);
    BOOST_TEST(report.number_of_overlapping_faces == flat.overlapping().size());
    BOOST_TEST((report.number_of_pieces > 1) == (report.number_of_overlapping_faces > 0));
    split += report.number_of_pieces > 1;
    most = (std::max)(most, report.number_of_pieces);
  }
  BOOST_TEST(split > 200);
  BOOST_TEST(most > 5u);
}

// Holes and handles may stay, or not; pieces are in one part.
BOOST_AUTO_TEST_CASE(charts_with_holes_and_several_components_are_split)
{
  int split = 0;
  for(unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    const test_charts::Random_surface surface(8, 5, 25, random);
    Flat_mesh flat(surface.points(), surface.triangles());
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    std::size_t faces = 0;
    const auto report = flat.split();
    BOOST_TEST(report.message == "");
    const auto check = TA::is_disk_cut(flat.mesh, flat.seams);
    for(const auto& part : check.parts)
      faces += part.number_of_faces;
    BOOST_TEST(check.parts.size() == report.number_of_pieces);
    BOOST_TEST(faces == flat.mesh.number_of_faces());
    split += report.number_of_pieces > report.number_of_charts;
  }
  BOOST_TEST(split > 50);
  for(const auto& [left, right] :
      {std::make_pair(false, false), {true, false}, {false, true}, {true, true}}) {
    const test_charts::Crosswise_sheets sheets(left, right);
    Flat_mesh flat(sheets.points(), sheets.triangles());
    const auto report = flat.split();
    check_pieces(flat, report, false);
    BOOST_TEST(report.number_of_pieces >= 2u);
  }
}

BOOST_AUTO_TEST_CASE(seams_are_kept_and_bound_charts)
{
  Flat_mesh flat(helicoid(3.5));
  const auto is_given = [&](Edge e) { // across the ribbon, after one and a half turns
    const Halfedge h = flat.mesh.halfedge(e);
    const double column = 36 * 0.02;
    return std::abs(flat.mesh.point(flat.mesh.source(h)).z() - column) < 1e-9 &&
           std::abs(flat.mesh.point(flat.mesh.target(h)).z() - column) < 1e-9;
  };
  for(Edge e : flat.mesh.edges())
    flat.seams[e] = is_given(e);
  // The two charts overlap each other as well, which does not matter.
  const auto report = flat.split();
  check_pieces(flat, report);
  BOOST_TEST(report.number_of_charts == 2u);
  BOOST_TEST(report.number_of_overlapping_charts == 2u);
  for(Edge e : flat.mesh.edges())
    if(is_given(e))
      BOOST_TEST(flat.seams[e]);

  const std::vector<bool> marks = flat.seam_marks();
  const std::vector<int> pieces = flat.pieces();
  const auto again = flat.split();
  BOOST_TEST(again.number_of_charts == report.number_of_pieces);
  BOOST_TEST(again.added_seam_length == 0);
  BOOST_TEST((flat.seam_marks() == marks));
  BOOST_TEST(flat.pieces() == pieces);
}

// Both sides of a seam that opens a ring have the same place in the plane.
BOOST_AUTO_TEST_CASE(a_closed_ring_with_a_seam_becomes_two_disks)
{
  for(int n : {6, 12, 30}) {
    Flat_mesh flat(test_charts::annulus(n));
    TA::cut_to_disks(flat.mesh, flat.seams);
    const auto report = flat.split();
    check_pieces(flat, report);
    BOOST_TEST(report.number_of_charts == 1u);
    BOOST_TEST(report.number_of_pieces == 2u);
  }
}

BOOST_AUTO_TEST_CASE(some_edges_must_not_become_seams)
{
  Flat_mesh flat(helicoid(1.5));
  auto is_forbidden = flat.mesh.add_property_map<Edge, bool>("e:forbidden", false).first;
  const auto z = [&](Edge e) { return flat.mesh.point(flat.mesh.source(flat.mesh.halfedge(e))).z() / 0.02; };
  for(Edge e : flat.mesh.edges())
    is_forbidden[e] = z(e) < 18 || z(e) > 21;
  const auto np = parameters::edge_is_constrained_map(is_forbidden);
  check_pieces(flat, flat.split(np));
  for(Edge e : flat.mesh.edges())
    BOOST_TEST(!(flat.seams[e] && is_forbidden[e]));

  for(Edge e : flat.mesh.edges()) {
    flat.seams[e] = false;
    is_forbidden[e] = true;
  }
  const std::vector<int> before = flat.pieces();
  const auto report = flat.split(np);
  BOOST_TEST(report.status == SMP::Diagnosis::NO_CUT_ALLOWED);
  BOOST_TEST(report.message.find("the face of vertex ") == 0u);
  const std::vector<bool> marks = flat.seam_marks();
  BOOST_TEST(std::count(marks.begin(), marks.end(), true) == 0);
  BOOST_TEST(flat.pieces() == before);
}

BOOST_AUTO_TEST_CASE(weights_count_instead_of_lengths)
{
  Flat_mesh flat(helicoid(1.5));
  auto weights = flat.mesh.add_property_map<Edge, double>("e:weight", 1.).first;
  const auto is_cheap = [&](Edge e) { // across the ribbon, after 20 of 36 columns
    const Halfedge h = flat.mesh.halfedge(e);
    return std::abs(flat.mesh.point(flat.mesh.source(h)).z() - 0.4) < 1e-9 &&
           std::abs(flat.mesh.point(flat.mesh.target(h)).z() - 0.4) < 1e-9;
  };
  for(Edge e : flat.mesh.edges())
    weights[e] = is_cheap(e) ? 0.01 : 1;
  const auto np = parameters::edge_weight_map(weights);
  check_pieces(flat, flat.split(np));
  for(Edge e : flat.mesh.edges())
    BOOST_TEST(flat.seams[e] == (is_cheap(e) && !flat.mesh.is_border(e)));

  Flat_mesh weightless(helicoid(2.5));
  const auto zero = weightless.mesh.add_property_map<Edge, double>("e:weight", 0.).first;
  check_pieces(weightless, weightless.split(parameters::edge_weight_map(zero)));

  for(double wrong : {-1., std::nan("")}) {
    weights[Edge(17)] = wrong;
    const auto report = flat.split(np);
    BOOST_TEST(report.status == SMP::Diagnosis::WRONG_WEIGHT);
    BOOST_TEST(report.message.find("the edge from vertex ") == 0u);
  }
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named)
{
  const auto diagnosis_of = [](Flat_mesh& flat, const std::string& place) {
    const auto report = flat.split();
    BOOST_TEST(!report);
    BOOST_TEST(report.message.find(place) != std::string::npos, report.message);
    const std::vector<bool> marks = flat.seam_marks();
    BOOST_TEST(std::count(marks.begin(), marks.end(), true) == 0);
    for(int piece : flat.pieces())
      BOOST_TEST(piece == -1);
    return to_string(report.status);
  };
  Flat_mesh empty;
  BOOST_TEST(diagnosis_of(empty, "no faces") == "EMPTY_MESH");
  Flat_mesh quad;
  quad.mesh.add_face(quad.mesh.add_vertex(Point_3(0, 0, 0)), quad.mesh.add_vertex(Point_3(1, 0, 0)),
                     quad.mesh.add_vertex(Point_3(1, 1, 0)), quad.mesh.add_vertex(Point_3(0, 1, 0)));
  quad.add_maps();
  quad.piece[Face(0)] = -1;
  BOOST_TEST(diagnosis_of(quad, "is not a triangle") == "NOT_TRIANGULATED");

  Flat_mesh flat(helicoid(1.5));
  const Point_3 point = flat.mesh.point(Vertex(40));
  flat.mesh.point(Vertex(40)) = Point_3(point.x(), infinity, 0);
  BOOST_TEST(diagnosis_of(flat, "inf") == "NON_FINITE_POINT");
  flat.mesh.point(Vertex(40)) = point;

  const Halfedge h = flat.mesh.halfedge(Vertex(41));
  const Point_2 uv = flat.uv[h];
  flat.uv[h] = Point_2(std::nan(""), 0);
  BOOST_TEST(diagnosis_of(flat, "vertex 41 (") == "NON_FINITE_COORDINATE");
  flat.uv[h] = Point_2(uv.x(), std::nextafter(uv.y(), 9.));
  BOOST_TEST(diagnosis_of(flat, "vertex 41 (") == "INCONSISTENT_COORDINATES");
  flat.uv[h] = uv;

  for(Halfedge other : flat.mesh.halfedges_around_target(h))
    flat.uv[other] = Point_2(-uv.x(), -uv.y());
  BOOST_TEST(diagnosis_of(flat, "the face of vertex ") == "FLIPPED_TRIANGLES");
}

BOOST_AUTO_TEST_CASE(coordinates_may_belong_to_vertices_and_have_exact_numbers)
{
  Flat_mesh flat(lissajous_ribbon());
  flat.split();
  const std::vector<int> pieces = flat.pieces();
  const std::vector<bool> marks = flat.seam_marks();
  for(Edge e : flat.mesh.edges())
    flat.seams[e] = false;
  TA::split_overlaps(flat.mesh, flat.vertex_uv(), flat.seams, flat.piece);
  BOOST_TEST(flat.pieces() == pieces);
  BOOST_TEST((flat.seam_marks() == marks));

  typedef CGAL::Exact_predicates_exact_constructions_kernel::Point_2 Exact_point;
  for(Edge e : flat.mesh.edges())
    flat.seams[e] = false;
  const auto exact_uv = boost::make_function_property_map<Halfedge>(
      [&](Halfedge h) { return Exact_point(flat.uv[h].x(), flat.uv[h].y()); });
  TA::split_overlaps(flat.mesh, exact_uv, flat.seams, flat.piece);
  BOOST_TEST(flat.pieces() == pieces);
  BOOST_TEST((flat.seam_marks() == marks));
}

BOOST_AUTO_TEST_CASE(nothing_depends_on_threads_or_on_the_kind_of_mesh)
{
  const Chart chart = rose_ribbon();
  std::vector<std::vector<int>> pieces;
  for(int threads : {1, 4, 4}) {
    Flat_mesh flat(chart);
    SMP::internal::ABF::with_threads(threads, [&]() { flat.split(); });
    pieces.push_back(flat.pieces());
  }
  typedef CGAL::Polyhedron_3<Chart::Kernel> Polyhedron;
  Polyhedron polyhedron;
  test_charts::make_mesh(chart, polyhedron);
  const auto seams = get(CGAL::dynamic_edge_property_t<bool>(), polyhedron);
  for(auto e : edges(polyhedron))
    put(seams, e, false);
  const auto piece = get(CGAL::dynamic_face_property_t<std::size_t>(), polyhedron);
  const auto uv = boost::make_function_property_map<boost::graph_traits<Polyhedron>::vertex_descriptor>(
      [](auto v) { return Point_2(v->point().x(), v->point().y()); });
  std::vector<boost::graph_traits<Polyhedron>::face_descriptor> overlapping;
  TA::overlapping_faces(polyhedron, uv, std::back_inserter(overlapping));
  const auto report = TA::split_overlaps(polyhedron, uv, seams, piece);
  BOOST_TEST(report.number_of_overlapping_faces == overlapping.size());
  pieces.emplace_back();
  for(auto f : faces(polyhedron))
    pieces.back().push_back(static_cast<int>(get(piece, f)));
  for(const std::vector<int>& other : pieces)
    BOOST_TEST(other == pieces.front());
}

BOOST_AUTO_TEST_SUITE(of_reference_disks, *test_data::needs(test_data::reference_disks))

// Most maps of real surfaces overlap themselves. Nothing is measured but how much longer borders become.
BOOST_AUTO_TEST_CASE(maps_of_real_surfaces_need_short_seams)
{
  std::vector<std::string> files{"cow_disk.ply", "dino_disk.ply"};
  if(std::getenv("ABF_TEST_QUICK") == nullptr)
    files.insert(files.end(), {"lionhead_disk.ply", "camel_disk.ply", "armadillo_disk.ply"});
  double sum = 0;
  for(const std::string& file : files) {
    Flat_mesh flat;
    BOOST_TEST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::reference_disks / file, flat.mesh));
    flat.add_maps();
    const auto map = flat.mesh.add_property_map<Vertex, Point_2>("v:map").first;
    SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
    const Halfedge border = CGAL::Polygon_mesh_processing::longest_border(flat.mesh).first;
    BOOST_TEST_REQUIRE(SMP::parameterize(flat.mesh, parameterizer, border, map) == SMP::OK);
    for(Halfedge h : flat.mesh.halfedges())
      flat.uv[h] = map[flat.mesh.target(h)];
    BOOST_TEST_INFO_SCOPE(file);
    const auto report = flat.split();
    check_pieces(flat, report);
    BOOST_TEST(report.number_of_pieces > 1u);
    sum += report.extra_seam;
  }
  BOOST_TEST(sum / static_cast<double>(files.size()) < 0.15);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
