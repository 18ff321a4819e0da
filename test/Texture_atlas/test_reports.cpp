// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reports name the offending elements of the mesh; points may be those of any property map; and surfaces without area are refused.

#include "test_options.h"

#include <boost/test/unit_test.hpp>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Texture_atlas/seam_selection.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Texture_atlas/split_overlaps.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_reports)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using SMP::Diagnosis;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

// A bumpy square of 5 x 5 vertices with room for everything that functions write
struct Surface
{
  explicit Surface(double height = 0.5)
  {
    CGAL::make_grid(
        4, 4, mesh,
        [=](std::size_t i, std::size_t j) {
          const double x = static_cast<double>(i) / 4, y = static_cast<double>(j) / 4;
          return Point_3(x, y, height * std::sin(3 * x) * std::cos(2 * y));
        },
        true);
    seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
    weights = mesh.add_property_map<Edge, double>("e:weight", 1).first;
    charts = mesh.add_property_map<Face, int>("f:chart", 0).first;
    uv = mesh.add_property_map<Halfedge, Point_2>("h:uv").first;
    vertex_uv = mesh.add_property_map<Vertex, Point_2>("v:uv", untouched).first;
    for(Halfedge h : mesh.halfedges())
      uv[h] = Point_2(mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y());
  }

  const Point_2 untouched{-7, 3};
  Mesh mesh;
  Mesh::Property_map<Edge, bool> seams;
  Mesh::Property_map<Edge, double> weights;
  Mesh::Property_map<Face, int> charts;
  Mesh::Property_map<Halfedge, Point_2> uv;
  Mesh::Property_map<Vertex, Point_2> vertex_uv;
};

typedef std::vector<Vertex> Vertices;
typedef std::vector<Edge> Edges;
typedef std::vector<Face> Faces;

template <typename Report>
void check(const Report& report, Diagnosis status, const Vertices& vertices, const Edges& edges,
           const Faces& faces)
{
  BOOST_TEST(!report);
  BOOST_TEST(report.status == status, report.status << ": " << report.message);
  BOOST_TEST(!report.message.empty());
  BOOST_TEST((report.offending_vertices == vertices));
  BOOST_TEST((report.offending_edges == edges));
  BOOST_TEST((report.offending_faces == faces));
}

} // namespace

BOOST_AUTO_TEST_CASE(of_points_that_are_not_finite)
{
  Surface s;
  const Vertex v(12);
  s.mesh.point(v) = Point_3(0, infinity, 0);
  const Vertices bad{v};
  check(TA::select_seams(s.mesh, s.seams), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(TA::cut_to_disks(s.mesh, s.seams), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(TA::shorten_seams(s.mesh, s.seams), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(TA::split_overlaps(s.mesh, s.uv, s.seams, s.charts), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(TA::select_cones(s.mesh, 3), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(TA::flatten_with_cones(s.mesh, 3, s.seams, s.uv), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(SMP::flatten_surface(s.mesh, s.vertex_uv), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(SMP::measure_flattening(s.mesh, s.uv), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  check(TA::bake_surface(s.mesh, s.uv, Surface().mesh), Diagnosis::NON_FINITE_POINT, bad, {}, {});
  const auto packing = TA::pack_charts(s.mesh, s.charts, s.uv);
  BOOST_TEST(packing.status == Diagnosis::NON_FINITE_POINT);
  BOOST_TEST((packing.offending_vertices == bad));
  BOOST_TEST_REQUIRE(packing.offending_faces.size() == 1u);
  std::set<Vertex> corners;
  for(Vertex w : s.mesh.vertices_around_face(s.mesh.halfedge(packing.offending_faces[0])))
    corners.insert(w);
  BOOST_TEST(corners.count(v) == 1u);

  const Surface simple;
  const auto baked = TA::bake_surface(simple.mesh, simple.uv, s.mesh);
  check(baked, Diagnosis::WRONG_FINE_POINT, {}, {}, {});
  BOOST_TEST((baked.offending_fine_vertices == bad));
}

BOOST_AUTO_TEST_CASE(of_faces_that_are_not_triangles)
{
  Surface s;
  Edge e(0);
  while(s.mesh.is_border(e))
    e = Edge(e.idx() + 1);
  const Halfedge kept = CGAL::Euler::join_face(s.mesh.halfedge(e), s.mesh);
  const Faces bad{s.mesh.face(kept)};
  check(TA::select_seams(s.mesh, s.seams), Diagnosis::NOT_TRIANGULATED, {}, {}, bad);
  check(TA::split_overlaps(s.mesh, s.uv, s.seams, s.charts), Diagnosis::NOT_TRIANGULATED, {}, {}, bad);
  check(TA::flatten_with_cones(s.mesh, 3, s.seams, s.uv), Diagnosis::NOT_TRIANGULATED, {}, {}, bad);
  check(SMP::flatten_surface(s.mesh, s.vertex_uv), Diagnosis::NOT_TRIANGULATED, {}, {}, bad);
  check(SMP::measure_flattening(s.mesh, s.uv), Diagnosis::NOT_TRIANGULATED, {}, {}, bad);
  check(TA::pack_charts(s.mesh, s.charts, s.uv), Diagnosis::NOT_TRIANGULATED, {}, {}, bad);
  check(TA::is_disk_cut(s.mesh, s.seams), Diagnosis::NOT_TRIANGULATED, {}, {}, bad);
  const Surface simple;
  const auto baked = TA::bake_surface(simple.mesh, simple.uv, s.mesh);
  check(baked, Diagnosis::FINE_MESH_NOT_TRIANGULATED, {}, {}, {});
  BOOST_TEST((baked.offending_fine_faces == bad));
  BOOST_TEST(bool(TA::make_atlas(s.mesh, s.uv, few_charts()))); // which divides it
}

BOOST_AUTO_TEST_CASE(of_weights_and_coordinates)
{
  Surface s;
  Edge e(7);
  while(s.mesh.is_border(e))
    e = Edge(e.idx() + 1);
  s.weights[e] = -1;
  const auto np = CGAL::parameters::edge_weight_map(s.weights);
  check(TA::select_seams(s.mesh, s.seams, TA::Seam_options(), np), Diagnosis::WRONG_WEIGHT, {}, {e}, {});
  check(TA::make_atlas(s.mesh, s.uv, few_charts(), np), Diagnosis::WRONG_WEIGHT, {}, {e}, {});

  const Face f(9);
  auto sizes = s.mesh.add_property_map<Face, double>("f:size", 1).first;
  sizes[f] = -2;
  const auto with_sizes = CGAL::parameters::face_size_map(sizes);
  check(TA::make_atlas(s.mesh, s.uv, few_charts(), with_sizes), Diagnosis::WRONG_WEIGHT, {}, {}, {f});
  check(TA::pack_charts(s.mesh, s.charts, s.uv, TA::Packing_options(), with_sizes), Diagnosis::WRONG_WEIGHT,
        {}, {}, {f});

  const Halfedge h = s.mesh.halfedge(f);
  const Point_2 p = s.uv[h];
  s.uv[h] = Point_2(p.x() + 1e-3, p.y());
  check(TA::split_overlaps(s.mesh, s.uv, s.seams, s.charts), Diagnosis::INCONSISTENT_COORDINATES,
        {s.mesh.target(h)}, {}, {});
  s.uv[h] = Point_2(infinity, 0);
  check(TA::split_overlaps(s.mesh, s.uv, s.seams, s.charts), Diagnosis::NON_FINITE_COORDINATE,
        {s.mesh.target(h)}, {}, {});
  check(TA::pack_charts(s.mesh, s.charts, s.uv), Diagnosis::NON_FINITE_COORDINATE, {}, {}, {f});
  check(TA::bake_surface(s.mesh, s.uv, s.mesh), Diagnosis::NO_TEXTURE_COORDINATES, {}, {}, {f});
  s.uv[h] = Point_2(2, 0);
  check(TA::bake_surface(s.mesh, s.uv, s.mesh), Diagnosis::OUTSIDE_SQUARE, {}, {}, {f});

  // Chart 1 has no area in the plane.
  Surface flat;
  for(Face g : {Face(3), Face(4)}) {
    flat.charts[g] = 1;
    for(Halfedge k : CGAL::halfedges_around_face(flat.mesh.halfedge(g), flat.mesh))
      flat.uv[k] = Point_2(0.5, 0.5);
  }
  check(TA::pack_charts(flat.mesh, flat.charts, flat.uv), Diagnosis::DEGENERATE_CHART, {}, {},
        {Face(3), Face(4)});
}

BOOST_AUTO_TEST_CASE(of_seams)
{
  Surface s;
  const auto terminals = boost::make_function_property_map<Vertex>([](Vertex) { return true; });
  const Vertex isolated = s.mesh.add_vertex(Point_3(0, 0, 0));
  check(TA::cut_to_disks(s.mesh, s.seams, CGAL::parameters::vertex_is_constrained_map(terminals)),
        Diagnosis::WRONG_OPTION, {isolated}, {}, {});

  Mesh ball;
  CGAL::make_icosahedron<Mesh, Point_3>(ball);
  const auto seams = ball.add_property_map<Edge, bool>("e:seam", false).first;
  check(TA::is_disk_cut(ball, seams), Diagnosis::NO_BORDER, {}, {}, {Face(0)});
  const auto none = boost::make_function_property_map<Edge>([](Edge) { return true; });
  check(TA::select_seams(ball, seams, TA::Seam_options(), CGAL::parameters::edge_is_constrained_map(none)),
        Diagnosis::NO_CUT_ALLOWED, {}, {}, {Face(0)});
  Vertex far(1);
  while(ball.halfedge(Vertex(0), far) != Mesh::null_halfedge())
    far = Vertex(far.idx() + 1);
  std::istringstream selection("\n\n0 " + std::to_string(far.idx()) + "\n");
  check(TA::read_seam_selection(selection, ball, seams), Diagnosis::NO_SUCH_EDGE, {Vertex(0), far}, {}, {});
}

// The first face, or the wrong one, of each part without charts
BOOST_AUTO_TEST_CASE(of_atlases)
{
  Surface s;
  const Mesh other = s.mesh;
  const auto size = s.mesh.number_of_faces();
  s.mesh += other;
  s.mesh.point(*std::next(s.mesh.vertices().begin(), static_cast<long>(other.number_of_vertices()))) =
      Point_3(0, 0, infinity);
  const auto report = TA::make_atlas(s.mesh, s.uv, few_charts());
  BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
  BOOST_TEST_REQUIRE(report.offending_faces.size() == 1u);
  BOOST_TEST(report.offending_faces[0].idx() >= size);
  BOOST_TEST((report.offending_vertices == Vertices{Vertex(Mesh::size_type(other.number_of_vertices()))}));
  BOOST_TEST(report.has_atlas());
}

BOOST_AUTO_TEST_SUITE(with_points_of_a_property_map)

namespace {

// The mesh has other points than the surface.
struct Moved_surface : Surface
{
  Moved_surface() : Surface(0)
  {
    points = mesh.add_property_map<Vertex, Point_3>("v:other").first;
    for(Vertex v : mesh.vertices())
      points[v] = Surface().mesh.point(v);
  }

  auto np() const { return CGAL::parameters::vertex_point_map(points); }

  Mesh::Property_map<Vertex, Point_3> points;
};

std::vector<Point_2> coordinates(const Surface& s)
{
  std::vector<Point_2> result;
  for(Vertex v : s.mesh.vertices())
    result.push_back(s.vertex_uv[v]);
  return result;
}

template <typename Parameterizer>
void check_parameterizer(const Parameterizer& parameterizer)
{
  Surface expected, flat(0);
  Moved_surface moved;
  BOOST_TEST_REQUIRE(bool(SMP::flatten_surface(expected.mesh, expected.vertex_uv, parameterizer)));
  BOOST_TEST_REQUIRE(bool(SMP::flatten_surface(flat.mesh, flat.vertex_uv, parameterizer)));
  BOOST_TEST_REQUIRE(bool(SMP::flatten_surface(moved.mesh, moved.vertex_uv, parameterizer, moved.np())));
  BOOST_TEST((coordinates(moved) == coordinates(expected)));
  BOOST_TEST((coordinates(flat) != coordinates(expected)));

  Moved_surface other;
  Parameterizer with_points = parameterizer;
  with_points.set_points(other.points);
  BOOST_TEST_REQUIRE(bool(SMP::flatten_surface(other.mesh, other.vertex_uv, with_points)));
  BOOST_TEST((coordinates(other) == coordinates(expected)));
}

} // namespace

BOOST_AUTO_TEST_CASE(are_flattened)
{
  check_parameterizer(SMP::ABF_plus_plus_parameterizer_3<Mesh>());
  check_parameterizer(SMP::Hierarchical_parameterizer_3<Mesh>());
}

// The longest border is that of these points.
BOOST_AUTO_TEST_CASE(have_borders)
{
  Surface s;
  const Mesh other = s.mesh;
  const auto number = static_cast<Mesh::size_type>(other.number_of_vertices());
  s.mesh += other;
  for(Mesh::size_type larger : {0u, 1u}) {
    const auto points = boost::make_function_property_map<Vertex>([&s, number, larger](Vertex v) {
      const double factor = v.idx() / number == larger ? 3 : 1;
      return CGAL::ORIGIN + factor * (s.mesh.point(v) - CGAL::ORIGIN);
    });
    for(Vertex v : s.mesh.vertices())
      s.vertex_uv[v] = s.untouched;
    BOOST_TEST_REQUIRE(
        bool(SMP::flatten_surface(s.mesh, s.vertex_uv, SMP::ABF_plus_plus_parameterizer_3<Mesh>(),
                                  CGAL::parameters::vertex_point_map(points))));
    for(Vertex v : s.mesh.vertices())
      BOOST_TEST((s.vertex_uv[v] == s.untouched) == (v.idx() / number != larger));
    const auto cut = TA::make_seam_mesh(s.mesh, s.seams);
    BOOST_TEST_REQUIRE(bool(cut));
    const auto border = TA::border_halfedge(cut.mesh, CGAL::parameters::vertex_point_map(points));
    BOOST_TEST(target(static_cast<Halfedge>(border), s.mesh).idx() / number == larger);
  }
}

BOOST_AUTO_TEST_CASE(of_seam_meshes_are_flattened)
{
  Surface expected;
  Moved_surface moved;
  const auto flatten = [](Surface& s, const auto& np) {
    auto cut = TA::make_seam_mesh(s.mesh, s.seams);
    typedef TA::Cut_mesh<Mesh> Seam_mesh;
    const auto report =
        SMP::flatten_surface(cut.mesh, s.uv, SMP::ABF_plus_plus_parameterizer_3<Seam_mesh>(), np);
    BOOST_TEST_REQUIRE(bool(report), report.message);
    std::vector<Point_2> result;
    for(Face f : s.mesh.faces())
      for(Halfedge h : CGAL::halfedges_around_face(s.mesh.halfedge(f), s.mesh))
        result.push_back(s.uv[h]);
    return result;
  };
  BOOST_TEST((flatten(moved, moved.np()) == flatten(expected, CGAL::parameters::default_values())));
}

BOOST_AUTO_TEST_CASE(are_measured)
{
  const Surface expected;
  const Moved_surface moved;
  const auto uv = [](const Surface& s) {
    return boost::make_function_property_map<Vertex>([&s](Vertex v) { return s.uv[s.mesh.halfedge(v)]; });
  };
  const auto border = CGAL::Polygon_mesh_processing::longest_border(expected.mesh).first;
  const double energy = SMP::measure_flattening(expected.mesh, border, uv(expected)).angular_distortion;
  BOOST_TEST(energy > 1e-4);
  BOOST_TEST(SMP::measure_flattening(moved.mesh, border, uv(moved), moved.np()).angular_distortion == energy);
  BOOST_TEST(SMP::measure_flattening(moved.mesh, border, uv(moved)).angular_distortion < 1e-12);
  BOOST_TEST(SMP::measure_flattening(moved.mesh, moved.uv, moved.np()).angular_distortion ==
                 SMP::measure_flattening(expected.mesh, expected.uv).angular_distortion,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(are_split)
{
  Moved_surface moved;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(moved.mesh).first;
  SMP::Vertex_angles<Mesh> angles;
  for(Vertex v : CGAL::vertices_around_face(border, moved.mesh))
    angles.set(v, CGAL_PI);
  for(int v : {0, 4, 20, 24}) // of the corners, two have one triangle, which would be flat on a side
    if(moved.mesh.degree(Vertex(static_cast<unsigned>(v))) > 2)
      angles.set(Vertex(static_cast<unsigned>(v)), CGAL_PI / 2);
  for(int v : {10, 14})
    angles.set(Vertex(static_cast<unsigned>(v)), CGAL_PI / 2);
  const auto split = SMP::split_flat_chords(moved.mesh, border, angles, moved.np());
  BOOST_TEST_REQUIRE(bool(split), split.message);
  BOOST_TEST(split.edges.size() == 2u);
  for(const auto& e : split.edges)
    BOOST_TEST((moved.points[e.middle] == CGAL::midpoint(moved.points[e.source], moved.points[e.target])));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(of_surfaces_without_area)

namespace {

template <typename Parameterizer>
void check_no_area(Surface& s, Parameterizer parameterizer)
{
  const auto report = SMP::flatten_surface(s.mesh, s.vertex_uv, parameterizer);
  const auto all = s.mesh.faces();
  BOOST_TEST(report.status == Diagnosis::NO_AREA, report.status << ": " << report.message);
  BOOST_TEST(report.degenerate_triangles == static_cast<int>(all.size()));
  BOOST_TEST((report.message.find("all " + std::to_string(all.size()) + " triangles") != std::string::npos));
  BOOST_TEST(report.offending_faces.size() == all.size());
  BOOST_TEST(SMP::error_code(report.status) == SMP::ERROR_WRONG_PARAMETER);
  for(Vertex v : s.mesh.vertices())
    BOOST_TEST((s.vertex_uv[v] == s.untouched));
}

void check_no_area(Surface& s)
{
  check_no_area(s, SMP::ABF_plus_plus_parameterizer_3<Mesh>());
  check_no_area(s, SMP::Hierarchical_parameterizer_3<Mesh>());
}

void move(Surface& s, double x, double y, double z, double x0)
{
  for(Vertex v : s.mesh.vertices()) {
    const double t = 0.1 * static_cast<double>((7 * v.idx()) % 25);
    s.mesh.point(v) = Point_3(x0 + x * t, y * t, z * t);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(are_refused)
{
  Surface s;
  for(double x0 : {0., 1., -1e6, 1e200})
    for(const auto& [x, y, z] : std::vector<std::array<double, 3>>{
            {0, 0, 0}, {1, 0, 0}, {0, 0, 1e-300}, {0.1, 0.2, 0.3}, {1, -3, 1e-9}, {1e-20, 0.7, 1e20}}) {
      BOOST_TEST_INFO_SCOPE(x0 << " and " << x << ' ' << y << ' ' << z);
      move(s, x, y, z, x0);
      check_no_area(s);
    }
}

// However flat a surface is, it has an area if its coordinates have digits for that.
BOOST_AUTO_TEST_CASE(are_not_flat_ones)
{
  for(double height : {1e-12, 1e-100, 1e-300}) {
    Surface s;
    for(Vertex v : s.mesh.vertices())
      s.mesh.point(v) = Point_3(s.mesh.point(v).x(), height * s.mesh.point(v).y(), 0);
    const auto report = SMP::flatten_surface(s.mesh, s.vertex_uv);
    BOOST_TEST(bool(report), report.message);
    BOOST_TEST(report.degenerate_triangles == 0);
  }
}

BOOST_AUTO_TEST_CASE(have_all_triangles_degenerate)
{
  Surface s;
  const Halfedge h = s.mesh.halfedge(Face(5));
  s.mesh.point(s.mesh.target(h)) =
      CGAL::midpoint(s.mesh.point(s.mesh.source(h)), s.mesh.point(s.mesh.target(s.mesh.next(h))));
  const auto report = SMP::flatten_surface(s.mesh, s.vertex_uv);
  BOOST_TEST(bool(report), report.message);
  BOOST_TEST(report.degenerate_triangles == 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
