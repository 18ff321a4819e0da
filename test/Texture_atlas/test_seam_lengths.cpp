// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Seams whose two sides have the same lengths in the plane.

#include <boost/test/unit_test.hpp>

#include "seam_surfaces.h"
#include "test_data.h"
#include "test_options.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seam_lengths)

using namespace seam_surfaces;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef Surface_mesh Mesh;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Seams;
typedef Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> UV_map;
typedef TA::Cut_mesh<Mesh> Seam_mesh;
typedef SMP::ABF_plus_plus_report Report;
using TA::Seam_options;
typedef SMP::ABF_plus_plus_options Options;

namespace {

struct Map
{
  Report report;
  SMP::Flattening_measures measures;
  std::vector<double> lengths; // of each halfedge
  double jump = 0;             // largest difference of the logarithms of lengths on both sides of a seam

  double length(Mesh::Halfedge_index h) const { return lengths[h.idx()]; }
};

std::vector<double> planar_lengths(const Mesh& mesh, const Seam_mesh& cut, const UV_map& uv)
{
  std::vector<double> lengths;
  for(Mesh::Halfedge_index h : mesh.halfedges()) {
    const boost::graph_traits<Seam_mesh>::halfedge_descriptor g(h);
    lengths.push_back(std::sqrt(CGAL::squared_distance(get(uv, source(g, cut)), get(uv, target(g, cut)))));
  }
  return lengths;
}

double largest_jump(const Mesh& mesh, const Seams& seams, const Map& map)
{
  double jump = 0;
  for(Mesh::Edge_index e : mesh.edges())
    if(seams[e] && !mesh.is_border(e))
      jump = (std::max)(
          jump, std::abs(std::log(map.length(mesh.halfedge(e, 0)) / map.length(mesh.halfedge(e, 1)))));
  return jump;
}

Map flatten(Mesh& mesh, const Seams& seams, const Options& options)
{
  Seam_mesh cut = TA::make_seam_mesh(mesh, seams).mesh;
  const auto border = TA::border_halfedge(cut);
  const UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  SMP::ABF_plus_plus_parameterizer_3<Seam_mesh> parameterizer(options);
  Map map;
  BOOST_TEST(SMP::parameterize(cut, parameterizer, border, uv) == SMP::OK);
  map.report = parameterizer.report();
  BOOST_TEST(map.report.status == SMP::Diagnosis::NOTHING_WRONG, map.report.message);
  if(map.report.status == SMP::Diagnosis::NOTHING_WRONG) {
    map.measures = SMP::measure_flattening(cut, border, uv);
    map.lengths = planar_lengths(mesh, cut, uv);
    map.jump = largest_jump(mesh, seams, map);
    BOOST_TEST(map.measures.flipped_triangles == 0);
    BOOST_TEST(std::abs(map.jump - map.report.largest_seam_jump) < 1e-12);
  }
  return map;
}

Options with_equal_lengths(bool equal, Options::Holes holes = Options::REFUSE)
{
  Options options;
  options.holes = holes;
  options.equal_seam_lengths = equal;
  return options;
}

void check_equal(Mesh& mesh, const Seams& seams, double bound, Options::Holes holes = Options::REFUSE)
{
  const Map free = flatten(mesh, seams, with_equal_lengths(false, holes)),
            equal = flatten(mesh, seams, with_equal_lengths(true, holes));
  BOOST_TEST(equal.report.converged);
  BOOST_TEST(equal.report.failed_strategies.empty());
  BOOST_TEST(equal.jump < 1e-5);
  BOOST_TEST(equal.measures.angular_distortion <= bound * free.measures.angular_distortion + 1e-6);
  BOOST_TEST_MESSAGE("jump " << free.jump << " -> " << equal.jump << ", energy "
                             << free.measures.angular_distortion << " -> "
                             << equal.measures.angular_distortion << ", steps " << free.report.iterations
                             << " -> " << equal.report.iterations);
}

// A sphere with bumps
Mesh bumpy_sphere(int levels, unsigned seed)
{
  Mesh mesh = sphere(levels).mesh();
  std::mt19937 random(seed);
  std::vector<double> factor(mesh.number_of_vertices(), 1.);
  for(int i = 0; i < 5; ++i) {
    const Point_3 middle = mesh.point(Mesh::Vertex_index(random() % mesh.number_of_vertices()));
    for(auto v : mesh.vertices())
      factor[v] += 0.7 * std::exp(-4 * CGAL::squared_distance(mesh.point(v), middle));
  }
  for(auto v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + factor[v] * (mesh.point(v) - CGAL::ORIGIN);
  return mesh;
}

} // namespace

BOOST_AUTO_TEST_CASE(of_spheres_are_equal)
{
  for(unsigned seed = 0; seed < 8; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Mesh mesh = bumpy_sphere(3, seed);
    const Seams seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    BOOST_REQUIRE(
        TA::select_seams(mesh, seams, with<Seam_options>(&Seam_options::stretch_bound, 1.02 + 0.05 * seed))
            .status == SMP::Diagnosis::NOTHING_WRONG);
    check_equal(mesh, seams, 1.5);
  }
}

// What vertices are off by adds up along seams: then the last step is not yet the last.
BOOST_AUTO_TEST_CASE(are_equal_to_the_tolerance)
{
  for(double tolerance : {1e-2, 1e-3, 1e-4, 1e-7})
    for(unsigned seed = 0; seed < 8; ++seed) {
      BOOST_TEST_INFO_SCOPE("tolerance " << tolerance << ", seed " << seed);
      Mesh mesh = bumpy_sphere(3, seed);
      const Seams seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
      TA::select_seams(mesh, seams, with<Seam_options>(&Seam_options::stretch_bound, 1.02));
      Options options = with_equal_lengths(true);
      options.tolerance = tolerance;
      const Map map = flatten(mesh, seams, options);
      BOOST_TEST(map.report.converged);
      BOOST_TEST(map.report.constraint_residual <= tolerance);
      BOOST_TEST(map.jump <= 1.1 * tolerance);
    }
}

// Seams from one vertex to all corners of a fan around it: a vertex with a hundred places, and ends with one place
BOOST_AUTO_TEST_CASE(at_vertices_of_many_seams)
{
  const int n = 100;
  Surface surface;
  surface.points = {Point_3(0, 0, 1), Point_3(0, 0, -1)};
  for(int ring = 1; ring <= 3; ++ring)
    for(int i = 0; i < n; ++i) {
      const double a = 2 * CGAL_PI * i / n, b = CGAL_PI * ring / 4;
      surface.points.emplace_back(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
    }
  const auto vertex = [&](int ring, int i) { return static_cast<std::size_t>(2 + (ring - 1) * n + i % n); };
  for(int i = 0; i < n; ++i) {
    surface.faces.push_back({0, vertex(1, i), vertex(1, i + 1)});
    for(int ring = 1; ring < 3; ++ring) {
      surface.faces.push_back({vertex(ring, i), vertex(ring + 1, i), vertex(ring + 1, i + 1)});
      surface.faces.push_back({vertex(ring, i), vertex(ring + 1, i + 1), vertex(ring, i + 1)});
    }
    surface.faces.push_back({1, vertex(3, i + 1), vertex(3, i)});
  }
  Mesh mesh = surface.mesh();
  const Seams seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  Mesh::Vertex_index hub(0);
  for(auto v : mesh.vertices())
    if(mesh.point(v) == surface.points.front())
      hub = v;
  for(auto h : mesh.halfedges_around_target(mesh.halfedge(hub)))
    seams[mesh.edge(h)] = true;
  BOOST_TEST(mesh.degree(hub) == 100u);
  const Map equal = flatten(mesh, seams, with_equal_lengths(true));
  BOOST_TEST(equal.jump < 1e-5);
}

// Around handles and borders, too
BOOST_AUTO_TEST_CASE(of_other_surfaces_are_equal)
{
  for(const Surface& surface :
      {torus(12, 8), slab(2), slab(3), sphere_with_holes(2, 1), sphere_with_holes(8, 2), tube(12, 9)})
    BOOST_TEST_CONTEXT(surface.name)
    {
      Mesh mesh = surface.mesh();
      const Seams seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
      TA::cut_to_disks(mesh, seams);
      check_equal(mesh, seams, 2);
    }
}

// Equations of loops and of holes at once
BOOST_AUTO_TEST_CASE(beside_holes_are_equal)
{
  for(const Surface& surface : {torus(16, 10), slab(2), sphere(2)}) {
    BOOST_TEST_INFO_SCOPE(surface.name);
    Mesh mesh = surface.mesh();
    if(surface.handles == 2)
      CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
    const Seams seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    TA::cut_to_disks(mesh, seams);
    int holes = 0;
    for(Mesh::Face_index f : mesh.faces()) {
      bool is_inside = true;
      for(auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
        for(auto g : mesh.halfedges_around_target(h))
          is_inside = is_inside && !seams[mesh.edge(g)] && !mesh.is_border(mesh.edge(g));
      if(is_inside && holes < 3) {
        CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
        ++holes;
      }
    }
    BOOST_TEST(holes == 3);
    mesh.collect_garbage();
    for(Options::Holes treatment : {Options::SOLVE, Options::FILL})
      check_equal(mesh, seams, 2, treatment);
  }
}

// Sides that are not those of each other
BOOST_AUTO_TEST_CASE(of_wrong_sides_are_refused)
{
  Mesh disk;
  const auto v = [&](double x, double y) { return disk.add_vertex(Point_3(x, y, 0)); };
  const auto a = v(0, 0), b = v(1, 0), c = v(1, 1), d = v(0, 1);
  disk.add_face(a, b, c);
  disk.add_face(a, c, d);
  const auto border = disk.halfedge(b, a);
  typedef boost::graph_traits<Mesh>::halfedge_descriptor Halfedge;
  const auto run = [&](Halfedge of_first, Halfedge of_second) {
    SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(with_equal_lengths(true));
    parameterizer.set_seam_sides(boost::make_function_property_map<Halfedge>([=](Halfedge h) {
      return h == border ? of_first : h == of_first ? of_second : boost::graph_traits<Mesh>::null_halfedge();
    }));
    const auto uv = disk.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    SMP::parameterize(disk, parameterizer, border, uv);
    return parameterizer.report();
  };
  const Halfedge next = disk.next(border), third = disk.next(next);
  BOOST_TEST(run(next, third).status == SMP::Diagnosis::WRONG_OPTION);
  BOOST_TEST(run(border, border).status == SMP::Diagnosis::WRONG_OPTION);
  const auto glued = run(next, border); // a cone of both sides of one of the corners
  BOOST_TEST(glued.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(glued.largest_seam_jump < 1e-5);
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

BOOST_AUTO_TEST_CASE(are_equal)
{
  std::vector<std::string> names{"cow.off"};
  if(std::getenv("ABF_TEST_QUICK") == nullptr)
    names.insert(names.end(), {"camel.off", "bunny00.off"});
  for(const std::string& name : names) {
    Mesh mesh;
    BOOST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::CGAL_meshes / name, mesh));
    const Seams seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
    BOOST_REQUIRE(
        TA::select_seams(mesh, seams, with<Seam_options>(&Seam_options::stretch_bound, 1.2)).status ==
        SMP::Diagnosis::NOTHING_WRONG);
    BOOST_TEST_CONTEXT(name)
    check_equal(mesh, seams, 1.02);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
