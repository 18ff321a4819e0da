// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of other meshes, points, number types and solvers than the usual ones.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"
#include "test_options.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_atlas_meshes)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::make_atlas_of;
using atlas_check::Wishes;
using atlas_surfaces::component;
using atlas_surfaces::random_union;
using atlas_surfaces::Union;
using TA::Atlas_options;
using TA::Atlas_report;
using SMP::Diagnosis;
typedef CGAL::Surface_mesh<test_charts::Point_3> Mesh;

namespace {

typedef CGAL::Simple_cartesian<float> Float_kernel;

// Counts the calls of `start()` for each stage.
struct Counting_visitor : TA::Atlas_visitor
{
  std::vector<Stage> stages;

  bool start(Stage stage) override
  {
    stages.push_back(stage);
    return true;
  }
};

// Its triangles become smaller and smaller, by a factor of 4 in each ring around the middle.
Union shrinking_disk(int rings)
{
  const int n = 6;
  std::vector<test_charts::Point_3> points{{0, 0, 0}};
  test_charts::Triangles triangles;
  for(int ring = 0; ring < rings; ++ring)
    for(int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * (i + 0.5 * ring) / n, radius = std::pow(4, ring - rings);
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
      const int v = 1 + n * ring + i, w = 1 + n * ring + (i + 1) % n;
      if(ring == 0)
        triangles.push_back({0, v, w});
      else {
        triangles.push_back({v - n, v, w - n});
        triangles.push_back({v, w, w - n});
      }
    }
  Union all;
  all.add({"shrinking disk", points, triangles});
  return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(coordinates_may_be_floats)
{
  for(unsigned seed = 0; seed < 40; ++seed) {
    const Union all = random_union(seed);
    const Mesh mesh = all.mesh<Mesh>();
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    Wishes wishes;
    wishes.resolution = 256;
    const Atlas_run run =
        make_atlas_of<Float_kernel::Point_2>(mesh, few_charts(&Atlas_options::resolution, 256));
    if(!run.report.has_atlas()) {
      BOOST_TEST((run.report.status == run.report.skipped.front().status));
      BOOST_TEST(run.is_untouched());
      continue;
    }
    check_parts(run);
    check_charts(run);
    check_seams(run);
    const std::vector<int> vertex = chart_vertices(run);
    check_vertices(run, vertex);
    check_overlaps(run, vertex, true);
    check_texels(run, wishes.resolution, wishes.gutter_texels());
  }
}

BOOST_AUTO_TEST_CASE(what_has_more_digits_than_floats_is_skipped)
{
  Union all = shrinking_disk(20);
  all.add(component(seam_surfaces::octahedron()));
  const Mesh mesh = all.mesh<Mesh>();
  BOOST_TEST(bool(make_atlas_of(mesh).report));
  Counting_visitor visitor;
  const Atlas_run run = make_atlas_of<Float_kernel::Point_2>(
      mesh, few_charts(&Atlas_options::resolution, 256, &Atlas_options::visitor, &visitor));
  BOOST_TEST_REQUIRE(run.report.has_atlas());
  check_parts(run);
  BOOST_TEST_REQUIRE(run.report.skipped.size() == 1u);
  BOOST_TEST(run.report.skipped[0].status == Diagnosis::PRECISION_EXCEEDED);
  BOOST_TEST(run.report.skipped[0].part == 0u);
  BOOST_TEST_REQUIRE(run.report.skipped[0].vertices.size() == 1u);
  const std::string name = "vertex " + std::to_string(run.report.skipped[0].vertices[0]) + " (";
  BOOST_TEST(run.report.skipped[0].message.find(name) != std::string::npos, run.report.skipped[0].message);
  BOOST_TEST(run.report.charts.size() == 1u);
  BOOST_TEST(run.report.charts[0].number_of_faces == 8u);
  check_overlaps(run, chart_vertices(run), true);
  check_texels(run, 256, 2);
  // the octahedron gets the whole square
  Union octahedron;
  octahedron.add(all.components[1]);
  const Atlas_run alone = make_atlas_of<Float_kernel::Point_2>(octahedron.mesh<Mesh>(),
                                                               few_charts(&Atlas_options::resolution, 256));
  BOOST_TEST(run.report.covered_share == alone.report.covered_share, boost::test_tools::tolerance(1e-3));
  typedef TA::Atlas_visitor Visitor;
  const std::vector<Visitor::Stage> stages{Visitor::READ,    Visitor::CHARTS,  Visitor::PACK,
                                           Visitor::CERTIFY, Visitor::MEASURE, Visitor::WRITE};
  BOOST_TEST((visitor.stages == stages));
}

// The smallest triangles are far smaller than that, and grow.
BOOST_AUTO_TEST_CASE(coordinates_for_files_are_multiples_of_a_step)
{
  Union all = shrinking_disk(14);
  all.add(component(seam_surfaces::octahedron()));
  const Mesh mesh = all.mesh<Mesh>();
  const Atlas_run run = make_atlas_of(
      mesh, few_charts(&Atlas_options::resolution, 256, &Atlas_options::float_coordinates, true));
  BOOST_TEST(bool(run.report));
  check_parts(run);
  check_charts(run);
  check_overlaps(run, chart_vertices(run), true);
  check_texels(run, 256, 1);
  bool are_multiples = true;
  for(const atlas_check::Point_2& p : run.uv)
    for(double x : {p.x(), p.y()})
      are_multiples = are_multiples && std::rint(std::ldexp(x, 24)) == std::ldexp(x, 24);
  BOOST_TEST(are_multiples);
}

BOOST_AUTO_TEST_CASE(any_mesh_gives_the_same_atlas)
{
  typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> Polyhedron;
  for(unsigned seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    const Union all = random_union(seed);
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    const Mesh mesh = all.mesh<Mesh>();
    Polyhedron polyhedron;
    all.make_mesh(polyhedron);
    const Atlas_run run = make_atlas_of(mesh), other = make_atlas_of(polyhedron);
    BOOST_TEST((run.report.status == other.report.status));
    BOOST_TEST((run.uv == other.uv));
    BOOST_TEST(run.chart == other.chart);
    BOOST_TEST((run.is_seam == other.is_seam));
  }
}

BOOST_AUTO_TEST_CASE(points_may_be_of_another_kernel)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  const Mesh mesh = random_union(12).mesh<Mesh>(), elsewhere = [&] {
    Mesh copy = mesh;
    for(auto v : copy.vertices())
      copy.point(v) = test_charts::Point_3(0, 0, 0);
    return copy;
  }();
  const auto exact = boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) {
    const auto& p = mesh.point(v);
    return Exact::Point_3(p.x(), p.y(), p.z());
  });
  const Atlas_run run = make_atlas_of(mesh);
  const Atlas_run other = make_atlas_of<Exact::Point_2>(
      elsewhere, few_charts(), parameters::vertex_point_map(exact), [](auto) { return false; }, exact);
  BOOST_TEST(run.report.has_atlas());
  check_atlas(other, Wishes());
  BOOST_TEST((run.uv == other.uv));
  BOOST_TEST(run.chart == other.chart);
}

BOOST_AUTO_TEST_CASE(another_solver_gives_nearly_the_same_atlas)
{
  const Mesh mesh = random_union(22, 8).without_bad_components().mesh<Mesh>();
  const Atlas_run run = make_atlas_of(mesh);
  const Atlas_run other = make_atlas_of(
      mesh, few_charts(),
      parameters::sparse_linear_solver(
          CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType>>()));
  check_atlas(run, Wishes());
  check_atlas(other, Wishes());
  BOOST_TEST(run.report.charts.size() == other.report.charts.size());
  BOOST_TEST(run.report.measures.l2_stretch == other.report.measures.l2_stretch,
             boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(maps_may_be_left_out)
{
  const Mesh mesh = random_union(5).mesh<Mesh>();
  const Atlas_run run = make_atlas_of(mesh);
  const auto uv = get(CGAL::dynamic_halfedge_property_t<CGAL::Simple_cartesian<double>::Point_2>(), mesh);
  const auto report = TA::make_atlas(mesh, uv, few_charts());
  BOOST_TEST((report.status == run.report.status));
  BOOST_TEST(report.charts.size() == run.report.charts.size());
  std::size_t corner = 0;
  for(auto f : mesh.faces())
    for(auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      if(run.chart[run.face[corner]] >= 0)
        BOOST_TEST_REQUIRE((get(uv, h).x() == run.uv[corner].x() && get(uv, h).y() == run.uv[corner].y()));
      ++corner;
    }
}

// Quadrangles over a rough terrain, each divided by a diagonal, and the quadrangle of each triangle
struct Quadrangles
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, int> number =
      mesh.add_property_map<Mesh::Face_index, int>("f:number").first;
  std::vector<std::array<Mesh::Halfedge_index, 4>> corners; // in one of both faces

  Quadrangles(int n, unsigned seed)
  {
    std::mt19937 random(seed);
    std::vector<Mesh::Vertex_index> v;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; j <= n; ++j) {
        const double x = i + test_charts::uniform(random, -0.35, 0.35);
        const double y = j + test_charts::uniform(random, -0.35, 0.35);
        v.push_back(mesh.add_vertex({x, y, test_charts::uniform(random, 0., 1.5)}));
      }
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const int k = i * (n + 1) + j;
        const auto f = mesh.add_face(v[k], v[k + n + 1], v[k + n + 2], v[k + 1]);
        const auto h = mesh.halfedge(f);
        corners.push_back({h, mesh.next(h), mesh.next(mesh.next(h)), mesh.prev(h)});
        const auto diagonal = CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
        for(const auto side : {diagonal, mesh.opposite(diagonal)})
          number[mesh.face(side)] = static_cast<int>(corners.size());
      }
  }

  template <typename UVMap>
  int count_concave(const UVMap& uv) const
  {
    int count = 0;
    for(const auto& h : corners) {
      bool is_convex = true;
      for(int k = 0; k < 4; ++k)
        is_convex = is_convex &&
                    CGAL::orientation(uv[h[k]], uv[h[(k + 1) % 4]], uv[h[(k + 2) % 4]]) == CGAL::LEFT_TURN;
      count += !is_convex;
    }
    return count;
  }
};

BOOST_AUTO_TEST_CASE(polygons_become_convex)
{
  typedef CGAL::Simple_cartesian<double>::Point_2 Point;
  int concave = 0, left = 0;
  for(unsigned seed = 0; seed < 20; ++seed) {
    Quadrangles quadrangles(12, seed);
    const auto uv = quadrangles.mesh.add_property_map<Mesh::Halfedge_index, Point>("h:uv").first;
    BOOST_TEST_REQUIRE(TA::make_atlas(quadrangles.mesh, uv, few_charts()).has_atlas());
    const int before = quadrangles.count_concave(uv);
    const auto report =
        TA::make_atlas(quadrangles.mesh, uv, few_charts(), parameters::face_patch_map(quadrangles.number));
    BOOST_TEST_REQUIRE(report.has_atlas());
    const int after = quadrangles.count_concave(uv);
    BOOST_TEST(after <= before);
    BOOST_TEST(report.number_of_mended_polygons == static_cast<std::size_t>(before - after));
    concave += before;
    left += after;
  }
  BOOST_TEST_MESSAGE(concave << " concave quadrangles, of which " << left << " are left");
  BOOST_TEST(concave >= 5);
  BOOST_TEST(left == 0);
}

BOOST_AUTO_TEST_SUITE_END()
