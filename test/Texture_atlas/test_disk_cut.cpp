// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which seams leave disks, compared with a slow count; and that such disks can be flattened.

#include <boost/test/unit_test.hpp>

#include "infeasible_charts.h"
#include "mesh_of_chart.h"
#include "seam_surfaces.h"
#include "test_charts.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_disk_cut)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace abf = SMP::internal::ABF;
using seam_surfaces::Surface;
using SMP::Diagnosis;
typedef seam_surfaces::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;
typedef CGAL::Polyhedron_3<seam_surfaces::Kernel> Polyhedron;

namespace {

// Seams of a mesh, as pairs of vertices
template <typename TriangleMesh>
struct Seams
{
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<bool>>::const_type Map;

  explicit Seams(const TriangleMesh& mesh) : map(get(CGAL::dynamic_edge_property_t<bool>(), mesh))
  {
    for(auto e : edges(mesh))
      put(map, e, false);
  }

  Map map;
};

Seams<Mesh> seams_along(const Mesh& mesh, const std::vector<Vertex>& path)
{
  Seams<Mesh> seams(mesh);
  for(std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Halfedge h = mesh.halfedge(path[i], path[i + 1]);
    BOOST_REQUIRE(h != Mesh::null_halfedge());
    put(seams.map, mesh.edge(h), true);
  }
  return seams;
}

template <typename TriangleMesh>
TA::Disk_cut_report<TriangleMesh> check(const TriangleMesh& mesh, const Seams<TriangleMesh>& seams)
{
  return TA::is_disk_cut(mesh, seams.map);
}

TA::Disk_cut_report<Mesh> check_along(const Mesh& mesh, const std::vector<Vertex>& path)
{
  return check(mesh, seams_along(mesh, path));
}

std::string name(Diagnosis defect)
{
  return SMP::to_string(defect);
}

// Disjoint sets of numbers (Boost's do not compile behind some headers of CGAL 6.)
class Classes
{
public:
  explicit Classes(std::size_t n) : m_parents(n) { std::iota(m_parents.begin(), m_parents.end(), 0); }
  void join(std::size_t a, std::size_t b) { m_parents[find(a)] = find(b); }
  std::size_t find(std::size_t a)
  {
    while(m_parents[a] != a)
      a = m_parents[a] = m_parents[m_parents[a]];
    return a;
  }

private:
  std::vector<std::size_t> m_parents;
};

// A part of a surface, counted
struct Count
{
  std::size_t faces = 0, vertices = 0, edges = 0, borders = 0;
  bool short_border = false, parallel_edges = false;
};

// Glues triangles where there is no seam, corner by corner, and counts what each part has: by vertices and edges of the
// opened surface, without a walk around a vertex or along a border. For each part, ordered by its first face.
std::vector<Count> count_parts(const Mesh& mesh, const Seams<Mesh>& seams)
{
  const std::size_t n = mesh.number_of_faces();
  Classes faces(n), corners(3 * n);
  std::map<Halfedge, std::size_t> corner; // at the target of each halfedge
  for(Face f : mesh.faces())
    for(Halfedge h : halfedges_around_face(mesh.halfedge(f), mesh)) {
      const std::size_t next = corner.size();
      corner[h] = next;
    }
  const auto is_open = [&](Halfedge h) {
    return mesh.is_border(mesh.opposite(h)) || get(seams.map, mesh.edge(h));
  };
  for(const auto& [h, c] : corner)
    if(!is_open(h)) {
      const Halfedge g = mesh.opposite(h);
      faces.join(c / 3, corner[g] / 3);
      corners.join(c, corner[mesh.prev(g)]);
      corners.join(corner[mesh.prev(h)], corner[g]);
    }

  std::map<std::size_t, std::size_t> rank; // of each part
  std::vector<Count> counts;
  for(std::size_t f = 0; f < n; ++f) {
    if(rank.insert({faces.find(f), counts.size()}).second)
      counts.emplace_back();
    ++counts[rank[faces.find(f)]].faces;
  }
  const auto count_of = [&](std::size_t c) -> Count& { return counts[rank[faces.find(c / 3)]]; };
  Classes borders(3 * n); // joined by border edges: a vertex of the opened surface is on one border
  std::set<std::size_t> on_border;
  std::map<std::pair<std::size_t, std::size_t>, int> edges_between;
  for(std::size_t c = 0; c < 3 * n; ++c)
    count_of(c).vertices += corners.find(c) == c;
  for(const auto& [h, c] : corner) {
    const std::size_t a = corners.find(corner[mesh.prev(h)]), b = corners.find(c);
    if(!is_open(h) && mesh.opposite(h) < h)
      continue;
    ++count_of(c).edges;
    count_of(c).parallel_edges |= a == b || ++edges_between[std::minmax({a, b})] > 1;
    if(is_open(h)) {
      borders.join(a, b);
      on_border.insert({a, b});
    }
  }
  std::map<std::size_t, int> border_size;
  for(std::size_t v : on_border)
    ++border_size[borders.find(v)];
  for(const auto& [v, size] : border_size) {
    ++count_of(v).borders;
    count_of(v).short_border |= size < 3;
  }
  return counts;
}

Diagnosis expected_defect(const Count& count)
{
  const long twice_handles =
      2 - static_cast<long>(count.borders + count.vertices + count.faces) + static_cast<long>(count.edges);
  return count.borders == 0     ? Diagnosis::NO_BORDER
         : twice_handles > 0    ? Diagnosis::NONZERO_GENUS
         : count.borders > 1    ? Diagnosis::SEVERAL_BORDERS
         : count.short_border   ? Diagnosis::SHORT_BORDER
         : count.parallel_edges ? Diagnosis::PARALLEL_EDGES
                                : Diagnosis::NOTHING_WRONG;
}

// Each edge with some probability; or a single one; or a tree that spans all vertices, and some edges more
Seams<Mesh> random_seams(const Mesh& mesh, std::mt19937& random)
{
  Seams<Mesh> seams(mesh);
  std::vector<Edge> edges(mesh.edges().begin(), mesh.edges().end());
  std::shuffle(edges.begin(), edges.end(), random);
  const double probability[] = {0, 0.02, 0.1, 0.3, 0.6, 1};
  std::bernoulli_distribution is_seam(probability[random() % 6]);
  for(Edge e : edges)
    put(seams.map, e, is_seam(random));
  const auto kind = random() % 8;
  if(kind < 3)
    return seams;
  if(kind == 3) {
    for(Edge e : edges)
      put(seams.map, e, e == edges.front());
    return seams;
  }
  Classes joined(mesh.number_of_vertices());
  std::size_t extra = random() % 4;
  for(Edge e : edges) {
    const std::size_t a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
    const bool in_tree = joined.find(a) != joined.find(b);
    joined.join(a, b);
    const bool is_extra = !in_tree && extra > 0;
    extra -= is_extra;
    put(seams.map, e, in_tree || is_extra);
  }
  return seams;
}

// Whether the parameterizers take a part, and how many vertices they see
template <typename Seam_mesh>
std::pair<bool, int> read_part(const Seam_mesh& mesh, typename Seam_mesh::halfedge_descriptor border)
{
  abf::Chart_reader<Seam_mesh> reader(mesh);
  BOOST_REQUIRE(!reader.read(border));
  return {!abf::diagnose(reader.chart, false), reader.chart.number_of_vertices()};
}

} // namespace

BOOST_AUTO_TEST_CASE(random_seams_on_random_surfaces)
{
  std::mt19937 random(1);
  std::map<Diagnosis, int> tally;
  const unsigned int seeds = std::getenv("ABF_TEST_QUICK") ? 150 : 400;
  for(unsigned int seed = 0; seed < seeds; ++seed) {
    const Surface surface = seam_surfaces::random_surface(seed);
    BOOST_TEST_INFO_SCOPE(surface.name << ", seed " << seed);
    const Mesh mesh = surface.mesh();
    const Seams<Mesh> seams = random_seams(mesh, random);
    const auto result = check(mesh, seams);
    const std::vector<Count> counts = count_parts(mesh, seams);
    BOOST_REQUIRE(result.parts.size() == counts.size());
    const auto seam_mesh = TA::make_seam_mesh(mesh, seams.map).mesh;
    std::size_t disks = 0, vertices = 0;
    for(std::size_t p = 0; p < counts.size(); ++p) {
      const auto& part = result.parts[p];
      BOOST_TEST(part.number_of_faces == counts[p].faces);
      BOOST_TEST(part.borders.size() == counts[p].borders);
      BOOST_TEST(part.euler_characteristic ==
                 static_cast<std::ptrdiff_t>(counts[p].vertices + counts[p].faces) -
                     static_cast<std::ptrdiff_t>(counts[p].edges));
      BOOST_TEST(name(part.status) == name(expected_defect(counts[p])));
      ++tally[part.status];
      disks += part.status == Diagnosis::NOTHING_WRONG;
      vertices += counts[p].vertices;
      const auto border = TA::border_halfedge(seam_mesh, part.face);
      if(part.status == Diagnosis::NO_BORDER)
        BOOST_TEST((border == Mesh::null_halfedge()));
      else {
        const auto [is_taken, vertices_read] = read_part(seam_mesh, border);
        BOOST_TEST(is_taken == (part.status == Diagnosis::NOTHING_WRONG));
        BOOST_TEST(static_cast<std::size_t>(vertices_read) == counts[p].vertices);
      }
    }
    BOOST_TEST(result.number_of_disks == disks);
    BOOST_TEST(static_cast<bool>(result) == (disks == counts.size()));
    BOOST_TEST(result.message.empty() == static_cast<bool>(result));
    BOOST_TEST(num_vertices(seam_mesh) == vertices);
  }
  for(Diagnosis defect : {Diagnosis::NOTHING_WRONG, Diagnosis::NO_BORDER, Diagnosis::NONZERO_GENUS,
                          Diagnosis::SEVERAL_BORDERS, Diagnosis::SHORT_BORDER})
    BOOST_TEST(tally[defect] > 3, name(defect) << " occurs only " << tally[defect] << " times");
}

BOOST_AUTO_TEST_CASE(surfaces_without_seams)
{
  std::vector<Surface> surfaces = seam_surfaces::platonic_solids();
  surfaces.insert(surfaces.end(),
                  {seam_surfaces::sphere(2), seam_surfaces::torus(7, 5), seam_surfaces::tube(5, 3),
                   seam_surfaces::slab(0), seam_surfaces::slab(3), seam_surfaces::slab(11),
                   seam_surfaces::sphere_with_holes(1, 1), seam_surfaces::sphere_with_holes(50, 2)});
  for(const Surface& surface : surfaces) {
    BOOST_TEST_INFO_SCOPE(surface.name);
    const Mesh mesh = surface.mesh();
    BOOST_TEST(CGAL::is_triangle_mesh(mesh));
    const auto result = check(mesh, Seams<Mesh>(mesh));
    BOOST_REQUIRE(result.parts.size() == 1u);
    BOOST_TEST(result.parts[0].number_of_handles == surface.handles);
    BOOST_TEST(result.parts[0].borders.size() == surface.borders);
    BOOST_TEST(static_cast<bool>(result) == (surface.handles == 0 && surface.borders == 1));
  }
}

BOOST_AUTO_TEST_CASE(no_faces)
{
  Mesh mesh;
  mesh.add_vertex({0, 0, 0});
  const auto result = check(mesh, Seams<Mesh>(mesh));
  BOOST_TEST(name(result.status) == "EMPTY_MESH");
  BOOST_TEST(result.parts.empty());
  BOOST_TEST(!result.message.empty());
}

BOOST_AUTO_TEST_CASE(polygons)
{
  Mesh mesh = seam_surfaces::tetrahedron().mesh();
  std::vector<Vertex> square;
  for(const auto& p : {seam_surfaces::Point_3(0, 0, 0), seam_surfaces::Point_3(1, 0, 0),
                       seam_surfaces::Point_3(1, 1, 0), seam_surfaces::Point_3(0, 1, 0)})
    square.push_back(mesh.add_vertex(p));
  const Face face = mesh.add_face(square);
  auto seams = seams_along(mesh, {Vertex(0), Vertex(1), Vertex(2)});
  const auto result = check(mesh, seams);
  BOOST_TEST(name(result.status) == "NOT_TRIANGULATED");
  BOOST_TEST(result.defective_part == 1u);
  BOOST_TEST(result.number_of_disks == 1u);
  BOOST_TEST(mesh.face(result.parts[1].where) == face);
  BOOST_TEST(result.message == "face 4 is not a triangle");
}

BOOST_AUTO_TEST_CASE(seams_on_a_sphere)
{
  const Mesh mesh = seam_surfaces::octahedron().mesh(); // with the poles 4 and 5
  const auto one = check_along(mesh, {Vertex(0), Vertex(2)});
  BOOST_TEST(name(one.status) == "SHORT_BORDER");
  BOOST_TEST(mesh.edge(one.parts[0].where) == mesh.edge(mesh.halfedge(Vertex(0), Vertex(2))));
  BOOST_TEST(one.message ==
             "the part of face 0 (8 faces) has a border of 2 edges, between vertex 0 (1, 0, 0) and "
             "vertex 2 (0, 1, 0): no planar triangulation has fewer than three");
  BOOST_TEST(static_cast<bool>(check_along(mesh, {Vertex(0), Vertex(2), Vertex(1)})));

  const auto equator = check_along(mesh, {Vertex(0), Vertex(2), Vertex(1), Vertex(3), Vertex(0)});
  BOOST_TEST(static_cast<bool>(equator));
  BOOST_TEST(equator.number_of_disks == 2u);

  auto apart = seams_along(mesh, {Vertex(0), Vertex(2), Vertex(4)});
  put(apart.map, mesh.edge(mesh.halfedge(Vertex(1), Vertex(5))), true);
  const auto two = check(mesh, apart);
  BOOST_TEST(name(two.status) == "SEVERAL_BORDERS");
  BOOST_TEST(two.parts[0].borders.size() == 2u);
  BOOST_TEST(
      two.message ==
      "the part of face 0 (8 faces) has 2 borders: with the edges between vertex 0 (1, 0, 0) and vertex 2 "
      "(0, 1, 0) and between vertex 1 (-1, 0, 0) and vertex 5 (0, 0, -1)");
}

// A seam that ends within the surface, on the border, or that touches the border in its middle
BOOST_AUTO_TEST_CASE(seams_and_borders)
{
  const Mesh mesh = test_charts::mesh_of_chart<Mesh>(test_charts::flat_grid(6, 5));
  std::vector<Vertex> row;
  for(Halfedge h : mesh.halfedges())
    if(mesh.is_border(h)) {
      for(Halfedge g = h; row.size() < 4; g = mesh.next(g))
        row.push_back(mesh.target(g));
      break;
    }
  BOOST_TEST(static_cast<bool>(check_along(mesh, row))); // border edges are no seams
  Vertex inner, deeper;
  for(Halfedge h : mesh.halfedges())
    if(!CGAL::is_border(mesh.target(h), mesh) && !CGAL::is_border(mesh.source(h), mesh)) {
      inner = mesh.target(h), deeper = mesh.source(h);
      break;
    }
  const auto slit = check_along(mesh, {inner, deeper});
  BOOST_TEST(name(slit.status) == "SEVERAL_BORDERS");
  for(Halfedge h : halfedges_around_target(inner, mesh))
    if(CGAL::is_border(mesh.source(h), mesh)) {
      const auto ends_on_border = check_along(mesh, {mesh.source(h), inner, deeper});
      BOOST_TEST(static_cast<bool>(ends_on_border));
      BOOST_TEST(ends_on_border.parts.size() == 1u);
    }
}

// Two tetrahedra, each without a face, that have a vertex in common: two disks, although there is one vertex.
BOOST_AUTO_TEST_CASE(pinched_vertices)
{
  const std::vector<test_charts::Point_3> points{{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                                                 {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const auto mesh_of = [&](const std::vector<std::array<int, 3>>& triangles) {
    return test_charts::mesh_of_chart<Mesh>(test_charts::make_chart(points, triangles));
  };
  const Mesh open = mesh_of({{0, 1, 2}, {0, 2, 3}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {4, 6, 5}});
  BOOST_TEST(open.number_of_vertices() == 7u);
  const auto result = check(open, Seams<Mesh>(open));
  BOOST_TEST(static_cast<bool>(result));
  BOOST_TEST(result.number_of_disks == 2u);
  const auto opened = TA::make_seam_mesh(open, Seams<Mesh>(open).map).mesh;
  BOOST_TEST(num_vertices(opened) == 8u);
  for(Face f : open.faces())
    BOOST_TEST(read_part(opened, TA::border_halfedge(opened, f)).first);

  // One of them is closed, and so the seam mesh could not tell them apart.
  const Mesh half = mesh_of({{0, 1, 2}, {0, 2, 3}, {1, 3, 2}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {4, 6, 5}});
  Seams<Mesh> slit = seams_along(half, {Vertex(1), Vertex(2), Vertex(3)});
  const auto refused = check(half, slit);
  const auto& pinched = half.point(Vertex(0));
  std::ostringstream pinched_name;
  pinched_name << "vertex 0 (" << pinched.x() << ", " << pinched.y() << ", " << pinched.z() << ")";
  BOOST_TEST(name(refused.status) == "NON_MANIFOLD_VERTEX");
  BOOST_TEST(half.target(refused.parts[0].where) == Vertex(0));
  BOOST_TEST(refused.message ==
             pinched_name.str() + " is surrounded by faces, and also belongs to other faces");
  BOOST_TEST((refused.offending_vertices == std::vector<Vertex>{Vertex(0)}));
  put(slit.map, half.edge(half.halfedge(Vertex(4), Vertex(5))), true);
  put(slit.map,
      *std::find_if(half.edges().begin(), half.edges().end(),
                    [&](Edge e) {
                      const std::set<Vertex> ends{half.vertex(e, 0), half.vertex(e, 1)};
                      return ends == std::set<Vertex>{Vertex(0), Vertex(5)};
                    }),
      true);
  const auto cut = TA::make_seam_mesh(half, slit.map);
  BOOST_TEST(name(cut.status) == "NON_MANIFOLD_VERTEX");
  BOOST_TEST((cut.offending_vertices == std::vector<Vertex>{Vertex(0)}));
  BOOST_TEST(cut.message ==
             pinched_name.str() + " is surrounded by faces, and is on a seam or border of other faces");
  BOOST_TEST(cut.mesh.number_of_seam_edges() == 0u);
  BOOST_TEST(num_vertices(cut.mesh) == num_vertices(half));
}

// Parallel edges and loops within a disk, which cannot be drawn in the plane; a seam may take them apart.
BOOST_AUTO_TEST_CASE(parallel_edges)
{
  std::mt19937 random(3);
  const auto grid = test_charts::flat_grid(4, 5);
  for(const auto& infeasible :
      {test_charts::parallel_edges(grid, random), test_charts::interior_degree_2(grid, random),
       test_charts::interior_degree_1(grid, random)}) {
    const Mesh mesh = test_charts::mesh_of_chart<Mesh>(infeasible.chart);
    const auto result = check(mesh, Seams<Mesh>(mesh));
    BOOST_TEST(name(result.status) == "PARALLEL_EDGES");
    const std::set<int> ends{static_cast<int>(mesh.source(result.parts[0].where).idx()),
                             static_cast<int>(mesh.target(result.parts[0].where).idx())};
    const auto& offenders = infeasible.offenders;
    BOOST_TEST((std::find(offenders.begin(), offenders.end(), ends) != offenders.end()));
    const auto seam_mesh = TA::make_seam_mesh(mesh, Seams<Mesh>(mesh).map).mesh;
    BOOST_TEST(!read_part(seam_mesh, TA::border_halfedge(seam_mesh)).first);
  }

  // Where the surface meets itself in one vertex, it is a disk nevertheless.
  const Mesh bow_tie = test_charts::mesh_of_chart<Mesh>(test_charts::bow_tie(5, random).chart);
  BOOST_TEST(static_cast<bool>(check(bow_tie, Seams<Mesh>(bow_tie))));
  const auto opened = TA::make_seam_mesh(bow_tie, Seams<Mesh>(bow_tie).map).mesh;
  BOOST_TEST(read_part(opened, TA::border_halfedge(opened)).first);
  BOOST_TEST(num_vertices(opened) == num_vertices(bow_tie) + 1);
}

BOOST_AUTO_TEST_CASE(any_mesh_type)
{
  for(const Surface& surface :
      {seam_surfaces::slab(2), seam_surfaces::tube(6, 4), seam_surfaces::octahedron()})
    BOOST_TEST_CONTEXT(surface.name)
    {
      const Polyhedron polyhedron = surface.mesh<Polyhedron>();
      const Mesh mesh = surface.mesh();
      for(std::size_t every : {2, 3, 5, 1000}) {
        Seams<Polyhedron> a(polyhedron);
        Seams<Mesh> b(mesh);
        std::size_t i = 0, marked = 0;
        for(auto e : edges(polyhedron))
          put(a.map, e, i++ % every == 0);
        for(auto e : edges(polyhedron))
          marked += get(a.map, e) && !CGAL::is_border(e, polyhedron);
        // the same edges, by their points
        for(auto e : edges(polyhedron))
          for(Edge f : mesh.edges()) {
            const auto &p = source(e, polyhedron)->point(), &q = target(e, polyhedron)->point();
            const auto &r = mesh.point(mesh.vertex(f, 0)), &s = mesh.point(mesh.vertex(f, 1));
            if((p == r && q == s) || (p == s && q == r))
              put(b.map, f, get(a.map, e));
          }
        const auto x = check(polyhedron, a);
        const auto y = check(mesh, b);
        BOOST_TEST(name(x.status) == name(y.status));
        BOOST_TEST(x.parts.size() == y.parts.size());
        BOOST_TEST(x.number_of_disks == y.number_of_disks);
        const auto p = TA::make_seam_mesh(polyhedron, a.map).mesh;
        const auto m = TA::make_seam_mesh(mesh, b.map).mesh;
        BOOST_TEST(p.number_of_seam_edges() == marked);
        BOOST_TEST(num_vertices(p) == num_vertices(m));
        BOOST_TEST(num_halfedges(p) == num_halfedges(m));
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
