// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Seams of surfaces of any topology: they leave disks, which can be flattened, with the stretch that was predicted.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"
#include "test_options.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seams)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using seam_surfaces::Surface;
using TA::Seam_report;
using TA::Seam_options;
typedef seam_surfaces::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Edge, bool> Seam_map;
typedef CGAL::Simple_cartesian<double>::Point_2 Point_2;

namespace {

Seam_map add_seams(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:seam", false).first;
}

std::vector<bool> marks(const Mesh& mesh, Seam_map seams)
{
  std::vector<bool> result;
  for(Edge e : mesh.edges())
    result.push_back(seams[e]);
  return result;
}

double length(const Mesh& mesh, Edge e)
{
  const Halfedge h = mesh.halfedge(e);
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

double seam_length(const Mesh& mesh, Seam_map seams)
{
  double sum = 0;
  for(Edge e : mesh.edges())
    if(seams[e])
      sum += length(mesh, e);
  return sum;
}

void check_report(const Mesh& mesh, Seam_map seams, const Seam_report& report)
{
  BOOST_TEST_REQUIRE(report.message == "");
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  const auto check = TA::is_disk_cut(mesh, seams);
  BOOST_TEST(bool(check), check.message);
  BOOST_TEST(report.number_of_disks == report.number_of_components);
  BOOST_TEST(report.seam_length == seam_length(mesh, seams), boost::test_tools::tolerance(1e-9));
}

std::vector<Surface> surfaces()
{
  std::vector<Surface> result = seam_surfaces::platonic_solids();
  for(int levels : {0, 1, 2, 3})
    result.push_back(seam_surfaces::sphere(levels));
  for(std::size_t holes : {1, 2, 5, 20, 50})
    result.push_back(seam_surfaces::sphere_with_holes(holes, 7));
  for(int handles = 0; handles < 8; ++handles)
    result.push_back(seam_surfaces::slab(handles));
  result.push_back(seam_surfaces::torus(3, 3));
  result.push_back(seam_surfaces::torus(24, 12));
  result.push_back(seam_surfaces::tube(12, 30));
  for(unsigned seed = 0; seed < 40; ++seed)
    result.push_back(seam_surfaces::random_surface(seed));
  return result;
}

// The L2 stretch of the flattened disk; infinity if it cannot be flattened
double flattened_stretch(const Mesh& mesh, Seam_map seams)
{
  auto seam_mesh = TA::make_seam_mesh(mesh, seams).mesh;
  typedef decltype(seam_mesh) Seam_mesh;
  typedef boost::graph_traits<Seam_mesh>::halfedge_descriptor Seam_halfedge;
  typedef boost::graph_traits<Seam_mesh>::vertex_descriptor Seam_vertex;
  std::map<Seam_vertex, Point_2> uv;
  const Seam_halfedge border = TA::border_halfedge(seam_mesh);
  SMP::ABF_plus_plus_parameterizer_3<Seam_mesh> parameterizer;
  const auto code = SMP::parameterize(seam_mesh, parameterizer, border, boost::make_assoc_property_map(uv));
  if(code != SMP::OK)
    return (std::numeric_limits<double>::infinity)();
  double surface_area = 0, plane_area = 0, sum = 0;
  for(auto f : faces(seam_mesh)) {
    const Seam_halfedge h = halfedge(f, seam_mesh), g = next(h, seam_mesh);
    const std::array<Seam_vertex, 3> v{source(h, seam_mesh), target(h, seam_mesh), target(g, seam_mesh)};
    const auto point = [&](int k) { return get(get(CGAL::vertex_point, seam_mesh), v[k]); };
    const double in_space = std::sqrt(CGAL::squared_area(point(0), point(1), point(2)));
    // squared singular values of the map from the plane: its Dirichlet energy
    const auto a = uv[v[1]] - uv[v[0]], b = uv[v[2]] - uv[v[0]];
    const auto p = point(1) - point(0), q = point(2) - point(0);
    const double det = CGAL::determinant(a, b);
    const double trace = (p * p) * (b * b) - 2 * (p * q) * (a * b) + (q * q) * (a * a);
    sum += in_space * trace / (2 * det * det);
    surface_area += in_space;
    plane_area += det / 2;
  }
  return std::sqrt(sum / surface_area * plane_area / surface_area);
}

} // namespace

BOOST_AUTO_TEST_CASE(cuts_leave_disks_that_can_be_flattened)
{
  for(const Surface& surface : surfaces()) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    BOOST_TEST_INFO_SCOPE(surface.name);
    const auto report = TA::cut_to_disks(mesh, seams);
    check_report(mesh, seams, report);
    BOOST_TEST(report.number_of_components == 1u);
    BOOST_TEST(std::isfinite(flattened_stretch(mesh, seams)));
  }
}

// A disk needs no seam, and a cut that is there no other one.
BOOST_AUTO_TEST_CASE(disks_are_left_as_they_are)
{
  for(const Surface& surface : {seam_surfaces::sphere_with_holes(1, 3), seam_surfaces::slab(3)}) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    TA::cut_to_disks(mesh, seams);
    const std::vector<bool> before = marks(mesh, seams);
    BOOST_TEST((std::count(before.begin(), before.end(), true) == 0) == (surface.handles == 0));
    TA::cut_to_disks(mesh, seams);
    BOOST_TEST((marks(mesh, seams) == before));
  }
}

// Around the tube and along the inner equator: nothing that cuts a torus is shorter.
BOOST_AUTO_TEST_CASE(cuts_of_a_torus_are_short)
{
  Mesh mesh = seam_surfaces::torus(60, 20).mesh();
  const Seam_map seams = add_seams(mesh);
  const double shortest = 2 * CGAL_PI * (1 + 2);
  const double found = TA::cut_to_disks(mesh, seams).seam_length;
  BOOST_TEST(found < 1.02 * shortest);
  BOOST_TEST(found > 0.98 * shortest);
}

BOOST_AUTO_TEST_CASE(selected_seams_keep_the_bound)
{
  for(const Surface& surface : surfaces()) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    BOOST_TEST_INFO_SCOPE(surface.name);
    const auto report = TA::select_seams(mesh, seams, with<Seam_options>(&Seam_options::stretch_bound, 1.2));
    check_report(mesh, seams, report);
    BOOST_TEST(report.bound_reached);
    BOOST_TEST(report.predicted_stretch <= 1.2);
    BOOST_TEST(std::isfinite(flattened_stretch(mesh, seams)));
  }
}

BOOST_AUTO_TEST_CASE(the_prediction_is_that_of_the_map)
{
  for(const Surface& surface : {seam_surfaces::sphere(4), seam_surfaces::torus(60, 20)})
    for(double bound : {1.3, 1.1, 1.05}) {
      Mesh mesh = surface.mesh();
      const Seam_map seams = add_seams(mesh);
      const auto report =
          TA::select_seams(mesh, seams, with<Seam_options>(&Seam_options::stretch_bound, bound));
      BOOST_TEST(report.predicted_stretch <= bound);
      BOOST_TEST(flattened_stretch(mesh, seams) == report.predicted_stretch,
                 boost::test_tools::tolerance(0.03));
    }
}

// The seams of a large surface come from a coarser copy.
BOOST_AUTO_TEST_CASE(large_surfaces)
{
  Mesh mesh = seam_surfaces::sphere(6).mesh();
  const Seam_map seams = add_seams(mesh);
  const auto report = TA::select_seams(mesh, seams);
  check_report(mesh, seams, report);
  BOOST_TEST(report.bound_reached);
  BOOST_TEST(flattened_stretch(mesh, seams) == report.predicted_stretch, boost::test_tools::tolerance(0.05));
}

// On the copy there are loops, and paths across forbidden edges. The prediction is that of the seams as they are in the
// end.
BOOST_AUTO_TEST_CASE(large_surfaces_with_handles_and_forbidden_edges)
{
  enum
  {
    NOTHING,
    EVERY_OTHER_EDGE,
    WALL_WITH_A_GAP,
    CAP
  };
  std::vector<Surface> all = {seam_surfaces::slab(1), seam_surfaces::slab(3), seam_surfaces::torus(240, 80)};
  seam_surfaces::subdivide(all[0], 5);
  seam_surfaces::subdivide(all[1], 4);
  std::vector<int> kinds = {EVERY_OTHER_EDGE, WALL_WITH_A_GAP, NOTHING, CAP};
  if(std::getenv("ABF_TEST_QUICK") != nullptr) {
    all.resize(1);
    kinds.resize(2);
  }
  for(const Surface& surface : all)
    for(int kind : kinds) {
      Mesh mesh = surface.mesh();
      BOOST_TEST_REQUIRE(mesh.number_of_vertices() > 12000u);
      const Seam_map seams = add_seams(mesh);
      const auto weights = mesh.add_property_map<Edge, double>("e:weight", 0.).first;
      const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
      std::mt19937 random(1);
      for(Edge e : mesh.edges()) {
        const Mesh::Point p = mesh.point(mesh.source(mesh.halfedge(e)));
        const double x = (p.x() - box.xmin()) / box.x_span(), y = (p.y() - box.ymin()) / box.y_span(),
                     z = (p.z() - box.zmin()) / box.z_span();
        const bool is_forbidden = kind == EVERY_OTHER_EDGE ? random() % 2 == 0
                                  : kind == WALL_WITH_A_GAP
                                      ? std::abs(x - 0.55) < 0.04 && std::abs(2 * y - 1) < 0.8
                                  : kind == CAP ? x < 0.1 && z > 0.5
                                                : false;
        weights[e] = is_forbidden ? std::numeric_limits<double>::infinity() : length(mesh, e);
      }
      BOOST_TEST_INFO_SCOPE(surface.name << ", kind " << kind);
      const auto report = TA::select_seams(mesh, seams, Seam_options(), parameters::edge_weight_map(weights));
      check_report(mesh, seams, report);
      for(Edge e : mesh.edges())
        BOOST_TEST_REQUIRE(!(seams[e] && std::isinf(weights[e])));
      BOOST_TEST(report.bound_reached == (report.predicted_stretch <= 1.1));
      BOOST_TEST(flattened_stretch(mesh, seams) == report.predicted_stretch,
                 boost::test_tools::tolerance(0.05));
    }
}

BOOST_AUTO_TEST_CASE(fewer_terminals_than_the_bound_needs)
{
  Mesh mesh = seam_surfaces::sphere(3).mesh();
  const Seam_map seams = add_seams(mesh);
  const auto report = TA::select_seams(
      mesh, seams,
      with<Seam_options>(&Seam_options::stretch_bound, 1.01, &Seam_options::maximum_number_of_terminals, 4));
  check_report(mesh, seams, report);
  BOOST_TEST(report.number_of_terminals == 4u);
  BOOST_TEST(!report.bound_reached);
  BOOST_TEST(report.predicted_stretch > 1.01);
}

// Whatever part of a cut a user gives, it stays, and is completed.
BOOST_AUTO_TEST_CASE(given_seams_are_kept)
{
  for(unsigned seed = 0; seed < 40; ++seed) {
    const Surface surface = seam_surfaces::random_surface(seed);
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    std::mt19937 random(seed);
    for(Edge e : mesh.edges())
      seams[e] = !mesh.is_border(e) && random() % 30 == 0;
    const std::vector<bool> given = marks(mesh, seams);
    BOOST_TEST_INFO_SCOPE("seed " << seed << ", " << surface.name);
    const auto report = seed % 2 == 0 ? TA::cut_to_disks(mesh, seams) : TA::select_seams(mesh, seams);
    BOOST_TEST(report.message == "");
    const auto check = TA::is_disk_cut(mesh, seams);
    BOOST_TEST(bool(check), check.message);
    for(Edge e : mesh.edges())
      if(given[e.idx()])
        BOOST_TEST(seams[e]);
  }
}

// Along one edge, a sphere is a disk with a border of two edges, and no polygon has two edges.
BOOST_AUTO_TEST_CASE(a_seam_of_one_edge_becomes_longer)
{
  std::vector<Surface> spheres = seam_surfaces::platonic_solids();
  spheres.push_back(seam_surfaces::sphere(2));
  spheres.push_back(seam_surfaces::sphere(6)); // with a coarse copy
  for(const Surface& surface : spheres)
    for(int kind = 0; kind < 3; ++kind) {
      Mesh mesh = surface.mesh();
      const Seam_map seams = add_seams(mesh);
      const Edge given(static_cast<Mesh::size_type>(mesh.number_of_edges() / 2));
      seams[given] = true;
      BOOST_TEST_INFO_SCOPE(surface.name << ", kind " << kind);
      BOOST_TEST(!TA::is_disk_cut(mesh, seams));
      check_report(mesh, seams,
                   kind == 0   ? TA::cut_to_disks(mesh, seams)
                   : kind == 1 ? TA::select_seams(mesh, seams)
                               : TA::select_seams(mesh, seams,
                                                  with<Seam_options>(&Seam_options::stretch_bound, 1000)));
      BOOST_TEST(seams[given]);
    }
}

// Where no other edge may become a seam, a sphere remains without a cut.
BOOST_AUTO_TEST_CASE(a_seam_of_one_edge_cannot_become_longer)
{
  Mesh mesh = seam_surfaces::sphere(2).mesh();
  const Seam_map seams = add_seams(mesh);
  auto is_forbidden = mesh.add_property_map<Edge, bool>("e:forbidden", true).first;
  seams[Edge(7)] = true;
  for(bool selects : {false, true}) {
    const auto np = parameters::edge_is_constrained_map(is_forbidden);
    const auto report =
        selects ? TA::select_seams(mesh, seams, Seam_options(), np) : TA::cut_to_disks(mesh, seams, np);
    BOOST_TEST(report.status == SMP::Diagnosis::NO_CUT_ALLOWED);
  }
}

BOOST_AUTO_TEST_CASE(some_edges_must_not_become_seams)
{
  for(const Surface& surface : {seam_surfaces::torus(24, 12), seam_surfaces::sphere(3)}) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    auto is_forbidden = mesh.add_property_map<Edge, bool>("e:forbidden", false).first;
    for(Edge e : mesh.edges())
      is_forbidden[e] = mesh.point(mesh.source(mesh.halfedge(e))).x() > (surface.handles == 1 ? 3.2 : 0.1);
    check_report(mesh, seams,
                 TA::cut_to_disks(mesh, seams, parameters::edge_is_constrained_map(is_forbidden)));
    for(Edge e : mesh.edges())
      BOOST_TEST(!(seams[e] && is_forbidden[e]));
  }
}

BOOST_AUTO_TEST_CASE(no_way_is_left)
{
  Mesh mesh = seam_surfaces::torus(24, 12).mesh();
  const Seam_map seams = add_seams(mesh);
  auto is_forbidden = mesh.add_property_map<Edge, bool>("e:forbidden", false).first;
  for(Edge e : mesh.edges()) // all around the tube, in one place
    for(Halfedge h : {mesh.halfedge(e), mesh.opposite(mesh.halfedge(e))})
      if(mesh.point(mesh.source(h)).x() > 0 && std::abs(mesh.point(mesh.source(h)).y()) < 1)
        is_forbidden[e] = true;
  for(bool selects : {false, true}) {
    const auto np = parameters::edge_is_constrained_map(is_forbidden);
    const auto report =
        selects ? TA::select_seams(mesh, seams, Seam_options(), np) : TA::cut_to_disks(mesh, seams, np);
    BOOST_TEST(report.status == SMP::Diagnosis::NO_CUT_ALLOWED);
    BOOST_TEST(report.message.find("with vertex ") != std::string::npos);
    BOOST_TEST(seam_length(mesh, seams) == 0);
  }
}

// Seams follow cheap edges.
BOOST_AUTO_TEST_CASE(weights_count_instead_of_lengths)
{
  Mesh mesh = seam_surfaces::torus(24, 12).mesh();
  const Seam_map seams = add_seams(mesh);
  auto weights = mesh.add_property_map<Edge, double>("e:weight", 1.).first;
  for(Edge e : mesh.edges()) {
    const auto p = mesh.point(mesh.source(mesh.halfedge(e))), q = mesh.point(mesh.target(mesh.halfedge(e)));
    weights[e] =
        std::hypot(p.x(), p.y()) > 3.9 && std::hypot(q.x(), q.y()) > 3.9 ? 0.01 : 1; // the outer equator
  }
  check_report(mesh, seams, TA::cut_to_disks(mesh, seams, parameters::edge_weight_map(weights)));
  int cheap = 0;
  for(Edge e : mesh.edges())
    cheap += seams[e] && weights[e] < 1;
  BOOST_TEST(cheap >= 23);
  for(double wrong : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    weights[Edge(17)] = wrong;
    const auto report = TA::select_seams(mesh, seams, Seam_options(), parameters::edge_weight_map(weights));
    BOOST_TEST(report.status == SMP::Diagnosis::WRONG_WEIGHT);
    BOOST_TEST(report.message.find("the edge from vertex ") != std::string::npos);
  }
}

// A weight may be computed when it is asked for, by ray casting for instance.
BOOST_AUTO_TEST_CASE(each_weight_is_read_once)
{
  Mesh mesh = seam_surfaces::slab(2).mesh();
  CGAL::copy_face_graph(seam_surfaces::tube(8, 4).mesh(), mesh);
  const Seam_map seams = add_seams(mesh);
  std::vector<int> reads(mesh.number_of_edges(), 0);
  const auto weights = boost::make_function_property_map<Edge>([&](Edge e) {
    ++reads[e.idx()];
    return length(mesh, e);
  });
  check_report(mesh, seams, TA::cut_to_disks(mesh, seams, parameters::edge_weight_map(weights)));
  BOOST_TEST((reads == std::vector<int>(mesh.number_of_edges(), 1)));
}

// From a cut with detours; ends inside the surface stay where they are.
BOOST_AUTO_TEST_CASE(seams_become_shorter)
{
  for(const Surface& surface :
      {seam_surfaces::torus(40, 16), seam_surfaces::slab(4), seam_surfaces::sphere(3)}) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    auto weights = mesh.add_property_map<Edge, double>("e:weight").first;
    std::mt19937 random(5);
    for(Edge e : mesh.edges())
      weights[e] = 1 + static_cast<double>(random() % 100);
    TA::select_seams(mesh, seams, Seam_options(), parameters::edge_weight_map(weights));
    std::vector<Vertex> ends;
    const auto is_end = [&](Vertex v) {
      int degree = 0;
      for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
        degree += seams[mesh.edge(h)];
      return degree == 1;
    };
    for(Vertex v : mesh.vertices())
      if(is_end(v))
        ends.push_back(v);
    const double before = seam_length(mesh, seams);
    const auto report = TA::shorten_seams(mesh, seams);
    BOOST_TEST(report.seam_length < 0.95 * before);
    BOOST_TEST(bool(TA::is_disk_cut(mesh, seams)));
    for(Vertex v : ends) {
      bool is_on_seam = false;
      for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
        is_on_seam = is_on_seam || seams[mesh.edge(h)];
      BOOST_TEST(is_on_seam);
    }
  }
}

// A closed seam cuts a sphere in two, whichever function looks at it.
BOOST_AUTO_TEST_CASE(disks_are_counted)
{
  for(int kind = 0; kind < 3; ++kind) {
    Mesh mesh = seam_surfaces::sphere(3).mesh();
    CGAL::copy_face_graph(seam_surfaces::torus(12, 8).mesh(), mesh);
    const Seam_map seams = add_seams(mesh);
    const auto first = *mesh.faces().begin();
    for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(first)))
      seams[mesh.edge(h)] = true;
    if(kind == 0)
      TA::cut_to_disks(mesh, seams);
    const auto report = kind == 0   ? TA::shorten_seams(mesh, seams)
                        : kind == 1 ? TA::cut_to_disks(mesh, seams)
                                    : TA::select_seams(mesh, seams);
    BOOST_TEST_INFO_SCOPE("kind " << kind);
    BOOST_TEST(report.message == "");
    BOOST_TEST(report.number_of_components == 2u);
    BOOST_TEST(report.number_of_disks == 3u);
    const auto check = TA::is_disk_cut(mesh, seams);
    BOOST_TEST(bool(check), check.message);
    BOOST_TEST(check.parts.size() == report.number_of_disks);
  }
}

BOOST_AUTO_TEST_CASE(all_components_are_cut)
{
  Mesh mesh = seam_surfaces::torus(12, 8).mesh();
  CGAL::copy_face_graph(seam_surfaces::sphere(2).mesh(), mesh);
  CGAL::copy_face_graph(seam_surfaces::tube(8, 4).mesh(), mesh);
  mesh.add_face(mesh.add_vertex(Mesh::Point(0, 0, 9)), mesh.add_vertex(Mesh::Point(1, 0, 9)),
                mesh.add_vertex(Mesh::Point(0, 1, 9)));
  const Seam_map seams = add_seams(mesh);
  const auto report = TA::select_seams(mesh, seams);
  check_report(mesh, seams, report);
  BOOST_TEST(report.number_of_components == 4u);
}

BOOST_AUTO_TEST_CASE(nothing_depends_on_threads_or_on_the_kind_of_mesh)
{
  const Surface surface = seam_surfaces::slab(4);
  std::vector<std::vector<bool>> results;
  for(int threads : {1, 4}) {
    Mesh mesh = surface.mesh();
    const Seam_map seams = add_seams(mesh);
    SMP::internal::ABF::with_threads(threads, [&]() { TA::select_seams(mesh, seams); });
    results.push_back(marks(mesh, seams));
  }
  BOOST_TEST((results[0] == results[1]));

  typedef CGAL::Polyhedron_3<seam_surfaces::Kernel> Polyhedron;
  const Polyhedron polyhedron = surface.mesh<Polyhedron>();
  const auto seams = get(CGAL::dynamic_edge_property_t<bool>(), polyhedron);
  for(auto e : edges(polyhedron))
    put(seams, e, false);
  const auto report = TA::select_seams(polyhedron, seams);
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(bool(TA::is_disk_cut(polyhedron, seams)));
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named)
{
  const auto diagnosis_of = [](Mesh mesh) {
    const Seam_map seams = add_seams(mesh);
    const auto report = TA::select_seams(mesh, seams);
    BOOST_TEST(report.message != "");
    BOOST_TEST(seam_length(mesh, seams) == 0);
    return report.status;
  };
  BOOST_TEST(diagnosis_of(Mesh()) == SMP::Diagnosis::EMPTY_MESH);
  Mesh quad;
  quad.add_face(quad.add_vertex(Mesh::Point(0, 0, 0)), quad.add_vertex(Mesh::Point(1, 0, 0)),
                quad.add_vertex(Mesh::Point(1, 1, 0)), quad.add_vertex(Mesh::Point(0, 1, 0)));
  BOOST_TEST(diagnosis_of(quad) == SMP::Diagnosis::NOT_TRIANGULATED);
  Mesh infinite = seam_surfaces::sphere(1).mesh();
  infinite.point(Vertex(3)) = Mesh::Point(0, (std::numeric_limits<double>::infinity)(), 0);
  Seam_map seams = add_seams(infinite);
  BOOST_TEST(TA::cut_to_disks(infinite, seams).status == SMP::Diagnosis::NON_FINITE_POINT);

  Mesh sphere = seam_surfaces::sphere(1).mesh();
  seams = add_seams(sphere);
  BOOST_TEST(TA::select_seams(sphere, seams, with<Seam_options>(&Seam_options::stretch_bound, 0.9)).status ==
             SMP::Diagnosis::WRONG_OPTION);
  BOOST_TEST(TA::select_seams(sphere, seams, with<Seam_options>(&Seam_options::stretch_bound, std::nan("")))
                 .status == SMP::Diagnosis::WRONG_OPTION);
  BOOST_TEST(
      TA::select_seams(sphere, seams, with<Seam_options>(&Seam_options::maximum_number_of_terminals, -1))
          .status == SMP::Diagnosis::WRONG_OPTION);
}

// Triangles without area, and all of a surface at one point
BOOST_AUTO_TEST_CASE(degenerate_surfaces_are_cut)
{
  for(const Surface& surface : {seam_surfaces::torus(12, 8), seam_surfaces::sphere(2)})
    for(int kind = 0; kind < 6; ++kind) {
      Mesh mesh = surface.mesh();
      for(Vertex v : mesh.vertices()) {
        const auto p = mesh.point(v);
        mesh.point(v) = kind % 3 == 0 ? Mesh::Point(p.x(), 0, 0) : kind % 3 == 1 ? Mesh::Point(1, 2, 3) : p;
      }
      if(kind % 3 == 2)
        for(int i = 0; i < 20; ++i)
          mesh.point(Vertex(4 * i)) = mesh.point(Vertex(4 * i + 1));
      const Seam_map seams = add_seams(mesh);
      BOOST_TEST_INFO_SCOPE(surface.name << ", kind " << kind);
      const auto report = kind < 3 ? TA::select_seams(mesh, seams) : TA::cut_to_disks(mesh, seams);
      BOOST_TEST(report.message == "");
      const auto check = TA::is_disk_cut(mesh, seams);
      BOOST_TEST(bool(check), check.message);
    }
}

BOOST_AUTO_TEST_SUITE_END()
