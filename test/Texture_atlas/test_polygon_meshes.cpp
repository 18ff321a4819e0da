// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of meshes whose faces are polygons

#include <boost/test/unit_test.hpp>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_type_config.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/make_atlas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_polygon_meshes)

namespace {

namespace TA = CGAL::Texture_atlas;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;
using Vertex = Mesh::Vertex_index;

// A torus of quads
template <typename Surface>
Surface torus(const int columns, const int rows)
{
  Surface mesh;
  std::vector<typename boost::graph_traits<Surface>::vertex_descriptor> vertices;
  const auto points = get(CGAL::vertex_point, mesh);
  for(int r = 0; r < rows; ++r)
    for(int c = 0; c < columns; ++c) {
      const double a = r * 2 * CGAL_PI / rows, b = c * 2 * CGAL_PI / columns;
      vertices.push_back(add_vertex(mesh));
      put(points, vertices.back(),
          typename boost::property_traits<std::decay_t<decltype(points)>>::value_type(
              (3 + std::cos(a)) * std::cos(b), (3 + std::cos(a)) * std::sin(b), std::sin(a)));
    }
  const auto vertex = [&](const int r, const int c) { return vertices[r % rows * columns + c % columns]; };
  for(int r = 0; r < rows; ++r)
    for(int c = 0; c < columns; ++c)
      CGAL::Euler::add_face(
          std::array{vertex(r, c), vertex(r, c + 1), vertex(r + 1, c + 1), vertex(r + 1, c)}, mesh);
  return mesh;
}

// Whether all faces with a chart are convex polygons in the square, and joined across edges that are no seams
template <typename Surface, typename Uv, typename Charts, typename Seams>
void check(const Surface& mesh, const Uv& uv, const Charts& charts, const Seams& seams)
{
  for(const auto f : faces(mesh)) {
    if(get(charts, f) < 0)
      continue;
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      const auto p = get(uv, prev(h, mesh)), q = get(uv, h), r = get(uv, next(h, mesh));
      BOOST_TEST((CGAL::orientation(p, q, r) == CGAL::LEFT_TURN));
      BOOST_TEST((q.x() >= 0 && q.x() <= 1 && q.y() >= 0 && q.y() <= 1));
    }
  }
  for(const auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh), o = opposite(h, mesh);
    if(is_border(e, mesh) || get(seams, e))
      continue;
    BOOST_TEST((get(charts, face(h, mesh)) == get(charts, face(o, mesh))));
    if(get(charts, face(h, mesh)) >= 0)
      BOOST_TEST((get(uv, h) == get(uv, prev(o, mesh)) && get(uv, o) == get(uv, prev(h, mesh))));
  }
}

struct Mapped
{
  Mesh mesh;
  Mesh::Property_map<Halfedge, Kernel::Point_2> uv;
  Mesh::Property_map<Edge, bool> seams;
  Mesh::Property_map<Face, int> charts;

  explicit Mapped(const Mesh& given) : mesh(given)
  {
    uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:test", Kernel::Point_2(7, 7)).first;
    seams = mesh.add_property_map<Edge, bool>("e:test", false).first;
    charts = mesh.add_property_map<Face, int>("f:test", 7).first;
  }

  void check_all() const
  {
    check(mesh, uv, charts, seams);
    for(const Face f : mesh.faces())
      BOOST_TEST(charts[f] >= 0);
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(polygons_have_charts)
{
  Mapped torus_of_quads(torus<Mesh>(24, 10));
  const auto report =
      TA::make_atlas(torus_of_quads.mesh, torus_of_quads.seams, torus_of_quads.uv, torus_of_quads.charts);
  BOOST_TEST(bool(report), report.message);
  torus_of_quads.check_all();
  std::size_t triangles = 0;
  double seams = 0;
  for(const auto& chart : report.charts)
    triangles += chart.number_of_faces;
  for(const Edge e : torus_of_quads.mesh.edges())
    seams += torus_of_quads.seams[e] ? CGAL::Polygon_mesh_processing::edge_length(e, torus_of_quads.mesh) : 0;
  BOOST_TEST(triangles == 2 * torus_of_quads.mesh.number_of_faces());
  BOOST_TEST(report.seam_length == seams, boost::test_tools::tolerance(1e-9));
}

// Other kernels and meshes
BOOST_AUTO_TEST_CASE(polygons_of_a_polyhedron_have_charts)
{
  using Cartesian = CGAL::Simple_cartesian<double>;
  using Polyhedron = CGAL::Polyhedron_3<Cartesian>;
  Polyhedron mesh;
  Polyhedron::Halfedge_handle h =
      mesh.make_tetrahedron(Cartesian::Point_3(1, 0, 0), Cartesian::Point_3(0, 1, 0),
                            Cartesian::Point_3(0, 0, 1), Cartesian::Point_3(0, 0, 0));
  Polyhedron::Halfedge_handle g = h->next()->opposite()->next(); // a cube, as in CGAL's manual
  mesh.split_edge(h->next());
  mesh.split_edge(g->next());
  mesh.split_edge(g);
  h->next()->vertex()->point() = Cartesian::Point_3(1, 0, 1);
  g->next()->vertex()->point() = Cartesian::Point_3(0, 1, 1);
  g->opposite()->vertex()->point() = Cartesian::Point_3(1, 1, 0);
  const Polyhedron::Halfedge_handle f = mesh.split_facet(g->next(), g->next()->next()->next());
  const Polyhedron::Halfedge_handle e = mesh.split_edge(f);
  e->vertex()->point() = Cartesian::Point_3(1, 1, 1);
  mesh.split_facet(e, f->next()->next());
  std::map<boost::graph_traits<Polyhedron>::halfedge_descriptor, CGAL::Simple_cartesian<float>::Point_2> uv;
  std::map<boost::graph_traits<Polyhedron>::edge_descriptor, bool> seams;
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, int> charts;
  const auto uv_map = boost::make_assoc_property_map(uv);
  const auto report = TA::make_atlas(mesh, boost::make_assoc_property_map(seams), uv_map,
                                     boost::make_assoc_property_map(charts));
  BOOST_TEST(bool(report), report.message);
  BOOST_TEST(charts.size() == 6u);
  check(mesh, uv_map, boost::make_assoc_property_map(charts), boost::make_assoc_property_map(seams));
}

BOOST_AUTO_TEST_CASE(named_parameters_are_about_polygons)
{
  Mapped mapped(torus<Mesh>(24, 10));
  Mesh& mesh = mapped.mesh;
  auto constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
  auto weight = mesh.add_property_map<Edge, double>("e:weight", 1).first;
  auto size = mesh.add_property_map<Face, double>("f:size", 1).first;
  auto patch = mesh.add_property_map<Face, int>("f:patch", 0).first;
  for(const Face f : mesh.faces()) {
    size[f] = f.idx() < 120 ? 2 : 1;
    patch[f] = static_cast<int>(f.idx()) / 2; // pairs of neighbors are octagons
  }
  for(const Edge e : mesh.edges())
    constrained[e] = patch[mesh.face(mesh.halfedge(e, 0))] == patch[mesh.face(mesh.halfedge(e, 1))];
  const auto report = TA::make_atlas(mesh, mapped.seams, mapped.uv, mapped.charts, TA::Atlas_options(),
                                     CGAL::parameters::edge_weight_map(weight)
                                         .edge_is_constrained_map(constrained)
                                         .face_size_map(size)
                                         .face_patch_map(patch));
  BOOST_TEST(bool(report), report.message);
  mapped.check_all();
  for(const Edge e : mesh.edges())
    BOOST_TEST(!(constrained[e] && mapped.seams[e]));
  weight[Edge(3)] = -1;
  const auto refused = TA::make_atlas(mesh, mapped.seams, mapped.uv, mapped.charts, TA::Atlas_options(),
                                      CGAL::parameters::edge_weight_map(weight));
  BOOST_TEST(refused.status == TA::Diagnosis::WRONG_WEIGHT);
  BOOST_TEST_REQUIRE(refused.offending_edges.size() == 1u);
  BOOST_TEST(refused.offending_edges.front() == Edge(3));
}

BOOST_AUTO_TEST_CASE(a_bad_polygon_condemns_no_others)
{
  Mapped mapped(torus<Mesh>(24, 10));
  Mesh& mesh = mapped.mesh;
  mesh.point(Vertex(30)) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const auto report = TA::make_atlas(mesh, mapped.seams, mapped.uv, mapped.charts);
  BOOST_TEST(report.status == TA::Diagnosis::SOMETHING_SKIPPED);
  BOOST_TEST_REQUIRE(report.skipped.size() == 1u);
  BOOST_TEST(report.skipped.front().status == TA::Diagnosis::NON_FINITE_POINT);
  BOOST_TEST(report.skipped.front().number_of_faces == 4u);
  std::set<Face> bad;
  for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(Vertex(30))))
    bad.insert(mesh.face(h));
  BOOST_TEST(report.skipped.front().first_face == bad.begin()->idx());
  BOOST_TEST(report.skipped.front().message ==
             "vertex 30 (nan, 0, 0) has coordinates that are not all finite numbers, first in face " +
                 std::to_string(bad.begin()->idx()));
  BOOST_TEST((report.offending_faces == std::vector<Face>{*bad.begin()}));
  for(const Face f : mesh.faces())
    BOOST_TEST((mapped.charts[f] < 0) == (bad.count(f) > 0));
  for(const Face f : bad)
    BOOST_TEST((mapped.uv[mesh.halfedge(f)] == Kernel::Point_2(7, 7))); // unchanged
  check(mesh, mapped.uv, mapped.charts, mapped.seams);
}

BOOST_AUTO_TEST_CASE(given_charts_of_polygons_are_kept)
{
  Mapped mapped(torus<Mesh>(24, 10));
  BOOST_TEST(bool(TA::make_atlas(mapped.mesh, mapped.seams, mapped.uv, mapped.charts)));
  Mapped again(mapped.mesh);
  for(const Halfedge h : mapped.mesh.halfedges())
    again.uv[h] = mapped.uv[h];
  TA::Atlas_options options;
  options.given_charts = TA::Atlas_options::KEEP;
  options.stretch_bound = 2;
  const auto report = TA::make_atlas(again.mesh, again.seams, again.uv, again.charts, options);
  BOOST_TEST(bool(report), report.message);
  again.check_all();
  for(const Edge e : mapped.mesh.edges())
    BOOST_TEST(again.seams[e] == mapped.seams[e]);
}

BOOST_AUTO_TEST_CASE(meshes_of_polygons_and_triangles_share_an_atlas)
{
  Mesh tetrahedron;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(4, 0, 0), Kernel::Point_3(0, 4, 0),
                         Kernel::Point_3(0, 0, 4), tetrahedron);
  std::vector<Mesh> meshes = {tetrahedron, torus<Mesh>(24, 10)};
  std::vector<Mesh::Property_map<Halfedge, Kernel::Point_2>> uv;
  std::vector<Mesh::Property_map<Edge, bool>> seams;
  std::vector<Mesh::Property_map<Face, int>> charts;
  for(Mesh& mesh : meshes) {
    uv.push_back(mesh.add_property_map<Halfedge, Kernel::Point_2>("h:test").first);
    seams.push_back(mesh.add_property_map<Edge, bool>("e:test", false).first);
    charts.push_back(mesh.add_property_map<Face, int>("f:test", -1).first);
  }
  const auto report = TA::make_common_atlas(meshes, seams, uv, charts);
  BOOST_TEST(bool(report), report.message);
  int most = -1;
  for(std::size_t i = 0; i < meshes.size(); ++i) {
    check(meshes[i], uv[i], charts[i], seams[i]);
    int least = std::numeric_limits<int>::max(), last = -1;
    for(const Face f : meshes[i].faces()) {
      least = (std::min)(least, charts[i][f]);
      last = (std::max)(last, charts[i][f]);
    }
    BOOST_TEST(least == most + 1);
    most = last;
  }
  BOOST_TEST(report.charts.size() == static_cast<std::size_t>(most + 1));
}

BOOST_AUTO_TEST_SUITE_END()
