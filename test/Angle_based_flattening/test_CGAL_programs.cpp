// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs like the examples and the test of CGAL's package of parameterization, on its data. Each is a template of the
// parameterizer, and runs with one of CGAL's and with ours: nothing else of it is changed.

#include <boost/test/unit_test.hpp>
#include <boost/mpl/list.hpp>

#include "test_data.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <list>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_CGAL_programs)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;

// The mesh types of CGAL's programs.
typedef CGAL::Surface_mesh<Point_3> Surface;
typedef Surface::Property_map<Surface::Edge_index, bool> Seam_edges;
typedef Surface::Property_map<Surface::Vertex_index, bool> Seam_vertices;
typedef CGAL::Seam_mesh<Surface, Seam_edges, Seam_vertices> Cut_surface;
typedef CGAL::Face_filtered_graph<Surface> Part;

typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
template <typename Key, typename Value>
using Hash_map = boost::associative_property_map<CGAL::Unique_hash_map<Key, Value>>;
typedef boost::graph_traits<Polyhedron> Polyhedron_traits;
typedef CGAL::Seam_mesh<Polyhedron, Hash_map<Polyhedron_traits::edge_descriptor, bool>,
                        Hash_map<Polyhedron_traits::vertex_descriptor, bool>>
    Cut_polyhedron;

// What is swapped: a type of CGAL's for one of ours.
template <typename Mesh, typename Other>
using Parameterizers = boost::mpl::list<Other, SMP::ABF_plus_plus_parameterizer_3<Mesh>,
                                        SMP::Hierarchical_parameterizer_3<Mesh>>;
typedef Parameterizers<Surface, SMP::Discrete_authalic_parameterizer_3<Surface>> Of_surface;
typedef Parameterizers<Cut_surface, SMP::LSCM_parameterizer_3<Cut_surface>> Of_cut_surface;
typedef Parameterizers<Part, SMP::Mean_value_coordinates_parameterizer_3<Part>> Of_part;
typedef Parameterizers<Polyhedron, SMP::Mean_value_coordinates_parameterizer_3<Polyhedron>> Of_polyhedron;
typedef Parameterizers<Cut_polyhedron, SMP::Mean_value_coordinates_parameterizer_3<Cut_polyhedron>>
    Of_cut_polyhedron;

namespace {

// Only ours promise that no triangle is flipped: CGAL's flip some of the lion.
template <typename Parameterizer>
struct Promises_no_flips : std::false_type
{};

template <typename Mesh>
struct Promises_no_flips<SMP::ABF_plus_plus_parameterizer_3<Mesh>> : std::true_type
{};

template <typename Mesh>
struct Promises_no_flips<SMP::Hierarchical_parameterizer_3<Mesh>> : std::true_type
{};

template <typename Mesh>
Mesh read(const std::string& file)
{
  Mesh mesh;
  BOOST_TEST_REQUIRE(CGAL::IO::read_polygon_mesh(file, mesh), file);
  return mesh;
}

// By the exact predicate of a kernel that the map knows nothing of.
template <typename Mesh, typename UV_map>
std::size_t number_of_unpositive_triangles(const Mesh& mesh, UV_map uv)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 Point;
  std::size_t result = 0;
  for(auto f : faces(mesh)) {
    std::vector<Point> corners;
    for(auto v : vertices_around_face(halfedge(f, mesh), mesh))
      corners.emplace_back(get(uv, v).x(), get(uv, v).y());
    result += CGAL::orientation(corners[0], corners[1], corners[2]) != CGAL::COUNTERCLOCKWISE;
  }
  return result;
}

// The last lines of each program: the map is written to a file, whose header is read back.
template <typename Parameterizer, typename Mesh, typename Halfedge, typename UV_map>
void finish(const Mesh& mesh, Halfedge bhd, UV_map uv, SMP::Error_code status)
{
  BOOST_TEST_REQUIRE(status == SMP::OK, SMP::get_error_message(status));
  if(Promises_no_flips<Parameterizer>::value)
    BOOST_TEST(number_of_unpositive_triangles(mesh, uv) == 0u);

  std::stringstream file;
  SMP::IO::output_uvmap_to_off(mesh, bhd, uv, file);
  std::string format;
  std::ptrdiff_t vertices_in_file, faces_in_file;
  file >> format >> vertices_in_file >> faces_in_file;
  const auto all_vertices = vertices(mesh);
  const auto all_faces = faces(mesh);
  BOOST_TEST(format == "OFF");
  BOOST_TEST(vertices_in_file == std::distance(all_vertices.begin(), all_vertices.end()));
  BOOST_TEST(faces_in_file == std::distance(all_faces.begin(), all_faces.end()));
}

// A map for each vertex as CGAL's test gives it to the member function.
template <typename Mesh, typename Value>
struct Vertex_values
{
  typedef std::unordered_map<typename boost::graph_traits<Mesh>::vertex_descriptor, Value> Table;

  boost::associative_property_map<Table> map() { return boost::associative_property_map<Table>(table); }

  Table table;
};

template <typename Mesh>
Vertex_values<Mesh, int> numbered(const Mesh& mesh)
{
  Vertex_values<Mesh, int> result;
  for(auto v : vertices(mesh))
    result.table.emplace(v, static_cast<int>(result.table.size()));
  return result;
}

// As in CGAL's test: by the member function, and again by the free one with the same object.
template <typename Parameterizer, typename Mesh, typename Halfedge, typename UV_map>
void run_twice(Mesh& mesh, Halfedge bhd, UV_map uv)
{
  Vertex_values<Mesh, int> indices = numbered(mesh);
  Vertex_values<Mesh, bool> parameterized;
  Parameterizer parameterizer;
  const SMP::Error_code status =
      parameterizer.parameterize(mesh, bhd, uv, indices.map(), parameterized.map());
  BOOST_TEST(status == SMP::OK, SMP::get_error_message(status));
  finish<Parameterizer>(mesh, bhd, uv, SMP::parameterize(mesh, parameterizer, bhd, uv));
}

// `discrete_authalic` and `simple_parameterization`: coordinates are a property of the vertices.
template <typename Parameterizer>
void on_surface(Surface mesh)
{
  const auto bhd = PMP::longest_border(mesh).first;
  const auto uv = mesh.add_property_map<Surface::Vertex_index, Point_2>("v:uv").first;
  finish<Parameterizer>(mesh, bhd, uv, SMP::parameterize(mesh, Parameterizer(), bhd, uv));
  run_twice<Parameterizer>(mesh, bhd, uv);
}

// `iterative_authalic_parameterizer`: coordinates are in a hash map.
template <typename Parameterizer>
void on_surface_with_hash_map(Surface mesh)
{
  const auto bhd = PMP::longest_border(mesh).first;
  CGAL::Unique_hash_map<Surface::Vertex_index, Point_2> table;
  const Hash_map<Surface::Vertex_index, Point_2> uv(table);
  Parameterizer parameterizer;
  finish<Parameterizer>(mesh, bhd, uv, SMP::parameterize(mesh, parameterizer, bhd, uv));
}

// `square_border_parameterizer`, and the test with indices that are a dynamic property.
template <typename Parameterizer>
void on_polyhedron(Polyhedron mesh)
{
  typedef Polyhedron_traits::vertex_descriptor Vertex;
  const auto bhd = PMP::longest_border(mesh).first;
  CGAL::Unique_hash_map<Vertex, Point_2> table;
  const Hash_map<Vertex, Point_2> uv(table);
  finish<Parameterizer>(mesh, bhd, uv, SMP::parameterize(mesh, Parameterizer(), bhd, uv));
  run_twice<Parameterizer>(mesh, bhd, uv);

  const auto indices = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  const auto parameterized = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  int number = 0;
  for(Vertex v : vertices(mesh))
    put(indices, v, number++);
  Parameterizer parameterizer;
  finish<Parameterizer>(mesh, bhd, uv, parameterizer.parameterize(mesh, bhd, uv, indices, parameterized));
}

// `lscm`: seams are in a file, coordinates belong to the halfedges of the surface without seams.
template <typename Parameterizer>
void on_cut_surface(Surface surface, const std::string& seams)
{
  const auto edges = surface.add_property_map<Surface::Edge_index, bool>("e:on_seam", false).first;
  const auto vertices = surface.add_property_map<Surface::Vertex_index, bool>("v:on_seam", false).first;
  Cut_surface mesh(surface, edges, vertices);
  BOOST_TEST_REQUIRE((mesh.add_seams(seams.c_str()) != Surface::null_halfedge()));
  const auto uv = surface.add_property_map<Surface::Halfedge_index, Point_2>("h:uv").first;
  const auto bhd = PMP::longest_border(mesh).first;
  finish<Parameterizer>(mesh, bhd, uv, SMP::parameterize(mesh, Parameterizer(), bhd, uv));
  run_twice<Parameterizer>(mesh, bhd, uv);
}

// `orbifold`: seams are shortest paths between the vertices in a file, and the member function is called.
template <typename Parameterizer>
void between_cones(Surface surface, const std::string& file)
{
  std::vector<Surface::Vertex_index> cones;
  BOOST_TEST_REQUIRE(SMP::read_cones<Surface>(surface, file.c_str(), std::back_inserter(cones)) == SMP::OK);
  std::list<Surface::Edge_index> path;
  SMP::compute_shortest_paths_between_cones(surface, cones.begin(), cones.end(), path);

  const auto edges = surface.add_property_map<Surface::Edge_index, bool>("e:on_seam", false).first;
  const auto vertices = surface.add_property_map<Surface::Vertex_index, bool>("v:on_seam", false).first;
  Cut_surface mesh(surface, edges, vertices);
  for(Surface::Edge_index e : path)
    mesh.add_seam(source(e, surface), target(e, surface));
  BOOST_TEST(mesh.number_of_seam_edges() == path.size());

  const auto uv = surface.add_property_map<Surface::Halfedge_index, Point_2>("h:uv").first;
  run_twice<Parameterizer>(mesh, PMP::longest_border(mesh).first, uv);
}

// `seam_Polyhedron_3`: all maps are hash maps.
template <typename Parameterizer>
void on_cut_polyhedron(Polyhedron polyhedron, const std::string& seams)
{
  CGAL::Unique_hash_map<Polyhedron_traits::edge_descriptor, bool> edges(false);
  CGAL::Unique_hash_map<Polyhedron_traits::vertex_descriptor, bool> vertices(false);
  CGAL::Unique_hash_map<Polyhedron_traits::halfedge_descriptor, Point_2> table;
  Cut_polyhedron mesh(polyhedron, Hash_map<Polyhedron_traits::edge_descriptor, bool>(edges),
                      Hash_map<Polyhedron_traits::vertex_descriptor, bool>(vertices));
  BOOST_TEST_REQUIRE((mesh.add_seams(seams.c_str()) != Polyhedron_traits::null_halfedge()));
  const Hash_map<Polyhedron_traits::halfedge_descriptor, Point_2> uv(table);
  const auto bhd = PMP::longest_border(mesh).first;
  finish<Parameterizer>(mesh, bhd, uv, SMP::parameterize(mesh, Parameterizer(), bhd, uv));
  run_twice<Parameterizer>(mesh, bhd, uv);
}

Kernel::Vector_3 unit_normal(const Surface& mesh, Surface::Face_index f)
{
  std::vector<Point_3> p;
  for(Surface::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh))
    p.push_back(mesh.point(v));
  return CGAL::unit_normal(p[0], p[1], p[2]);
}

// A part of a surface: each smooth patch between sharp edges that is a disk.
template <typename Parameterizer>
void on_smooth_patches(Surface surface, std::size_t expected_disks)
{
  const auto sharp = surface.add_property_map<Surface::Edge_index, bool>("e:sharp", false).first;
  for(Surface::Edge_index e : surface.edges())
    if(!surface.is_border(e))
      sharp[e] = unit_normal(surface, surface.face(surface.halfedge(e, 0))) *
                     unit_normal(surface, surface.face(surface.halfedge(e, 1))) <
                 0.8;
  const auto patch_of = surface.add_property_map<Surface::Face_index, std::size_t>("f:patch").first;
  const std::size_t patches =
      PMP::connected_components(surface, patch_of, CGAL::parameters::edge_is_constrained_map(sharp));
  const auto uv = surface.add_property_map<Surface::Vertex_index, Point_2>("v:uv").first;
  std::size_t disks = 0;
  for(std::size_t k = 0; k < patches; ++k) {
    Part mesh(surface, k, patch_of);
    if(mesh.number_of_vertices() + mesh.number_of_faces() != mesh.number_of_halfedges() / 2 + 1)
      continue; // the Euler characteristic of a disk is 1
    ++disks;
    const auto bhd = PMP::longest_border(mesh).first;
    finish<Parameterizer>(mesh, bhd, uv, SMP::parameterize(mesh, Parameterizer(), bhd, uv));
  }
  BOOST_TEST(disks == expected_disks);
}

// Two waves of n times n cells that meet in a ridge.
Surface roof(int n)
{
  Surface mesh;
  CGAL::make_grid(
      2 * n, n, mesh,
      [n](std::size_t i, std::size_t j) {
        const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
        return Point_3(x, y, -std::abs(x - 1) + 0.1 * std::sin(4 * y));
      },
      true);
  return mesh;
}

const std::string dinosaur = test_data::examples / "dinosaur.off", egg = test_data::examples / "egg.off",
                  egg_seams = test_data::examples / "egg.selection.txt";

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(surface, Parameterizer, Of_surface)
{
  on_surface<Parameterizer>(read<Surface>(dinosaur));
  on_surface_with_hash_map<Parameterizer>(read<Surface>(dinosaur));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(polyhedron, Parameterizer, Of_polyhedron)
{
  on_polyhedron<Parameterizer>(read<Polyhedron>(dinosaur));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cut_surface, Parameterizer, Of_cut_surface)
{
  on_cut_surface<Parameterizer>(read<Surface>(egg), egg_seams);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cones, Parameterizer, Of_cut_surface)
{
  const std::string file = "test_CGAL_programs.selection.txt";
  std::ofstream(file) << "0 1000 2000\n\n\n";
  between_cones<Parameterizer>(read<Surface>(egg), file);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cut_polyhedron, Parameterizer, Of_cut_polyhedron)
{
  on_cut_polyhedron<Parameterizer>(read<Polyhedron>(egg), egg_seams);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(smooth_patches, Parameterizer, Of_part)
{
  on_smooth_patches<Parameterizer>(roof(20), 2);
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes,
                      *test_data::needs(test_data::CGAL_meshes) * test_data::needs(test_data::CGAL_examples))

BOOST_AUTO_TEST_CASE_TEMPLATE(surfaces, Parameterizer, Of_surface)
{
  for(const char* file : {"nefertiti.off", "three_peaks.off", "mushroom.off"}) {
    BOOST_TEST_CONTEXT(file) on_surface<Parameterizer>(read<Surface>(test_data::CGAL_meshes / file));
  }
  on_surface_with_hash_map<Parameterizer>(read<Surface>(test_data::CGAL_meshes / "nefertiti.off"));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(polyhedra, Parameterizer, Of_polyhedron)
{
  for(const char* file : {"nefertiti.off", "three_peaks.off", "mushroom.off"}) {
    BOOST_TEST_CONTEXT(file) on_polyhedron<Parameterizer>(read<Polyhedron>(test_data::CGAL_meshes / file));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cut_surfaces, Parameterizer, Of_cut_surface)
{
  for(const char* seams :
      {"lion.selection.txt", "lion2.selection.txt", "lion3.selection.txt", "lion4.selection.txt"}) {
    BOOST_TEST_CONTEXT(seams)
    on_cut_surface<Parameterizer>(read<Surface>(test_data::CGAL_meshes / "lion.off"),
                                  test_data::CGAL_examples / seams);
  }
  on_cut_surface<Parameterizer>(read<Surface>(test_data::CGAL_meshes / "blob.off"),
                                test_data::CGAL_examples / "blob.selection.txt");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cones_of_bear, Parameterizer, Of_cut_surface)
{
  between_cones<Parameterizer>(read<Surface>(test_data::CGAL_meshes / "bear.off"),
                               test_data::CGAL_examples / "bear.selection.txt");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(cut_polyhedra, Parameterizer, Of_cut_polyhedron)
{
  on_cut_polyhedron<Parameterizer>(read<Polyhedron>(test_data::CGAL_meshes / "lion.off"),
                                   test_data::CGAL_examples / "lion.selection.txt");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(smooth_patches_of_fandisk, Parameterizer, Of_part)
{
  on_smooth_patches<Parameterizer>(read<Surface>(test_data::CGAL_meshes / "fandisk.off"), 12);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
