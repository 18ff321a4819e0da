// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One atlas of several meshes is that of one mesh with all faces.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_common_atlas)

namespace {

using atlas_check::Atlas_options;
using atlas_check::Atlas_report;
using atlas_check::Diagnosis;
using atlas_check::Point_2;
using atlas_check::TA::make_common_atlas;
typedef CGAL::Surface_mesh<atlas_check::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Halfedge_index, Point_2> UV_map;
typedef Mesh::Property_map<Mesh::Edge_index, bool> Seam_map;
typedef Mesh::Property_map<Mesh::Face_index, int> Chart_map;

// Meshes, and one with all of their faces. Some edges of each are given seams.
struct Meshes
{
  std::vector<Mesh> meshes;
  std::vector<UV_map> uv;
  std::vector<Seam_map> seams;
  std::vector<Chart_map> charts;
  Mesh joined;

  void add(const Mesh& mesh)
  {
    meshes.push_back(mesh);
    meshes.back()
        .collect_garbage(); // so that indices of the joined mesh are those of the meshes, one after another
    joined += meshes.back();
  }

  static UV_map uv_of(Mesh& mesh)
  {
    return mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", atlas_check::untouched).first;
  }
  static Seam_map seams_of(Mesh& mesh)
  {
    return mesh.add_property_map<Mesh::Edge_index, bool>("e:seam").first;
  }
  static Chart_map charts_of(Mesh& mesh)
  {
    return mesh.add_property_map<Mesh::Face_index, int>("f:chart", atlas_check::no_number).first;
  }

  void add_maps(std::size_t every)
  {
    std::size_t number = 0;
    for(Mesh& mesh : meshes) {
      uv.push_back(uv_of(mesh));
      seams.push_back(seams_of(mesh));
      charts.push_back(charts_of(mesh));
      for(const Mesh::Edge_index e : mesh.edges()) {
        seams.back()[e] = ++number % every == 0;
        seams_of(joined)[Mesh::Edge_index(static_cast<Mesh::size_type>(number - 1))] = seams.back()[e];
      }
    }
  }

  auto make(const Atlas_options& options = few_charts())
  {
    return make_common_atlas(meshes, seams, uv, charts, options);
  }

  void check_same(const Atlas_report& one, const Atlas_report& several)
  {
    BOOST_TEST_REQUIRE((one.status == several.status), one.message << " / " << several.message);
    BOOST_TEST(one.seam_length == several.seam_length);
    BOOST_TEST(one.relative_seam_length == several.relative_seam_length);
    BOOST_TEST(one.covered_share == several.covered_share);
    BOOST_TEST(one.texel_density == several.texel_density);
    BOOST_TEST(one.measures.l2_stretch == several.measures.l2_stretch);
    BOOST_TEST(one.number_of_parts == several.number_of_parts);
    BOOST_TEST_REQUIRE(one.skipped.size() == several.skipped.size());
    BOOST_TEST_REQUIRE(one.charts.size() == several.charts.size());
    std::size_t faces = 0, edges = 0, skipped = 0;
    for(std::size_t i = 0; i < meshes.size(); ++i) {
      const Mesh& mesh = meshes[i];
      for(const Mesh::Halfedge_index h : mesh.halfedges())
        BOOST_REQUIRE(
            (uv[i][h] ==
             uv_of(joined)[Mesh::Halfedge_index(static_cast<Mesh::size_type>(2 * edges + h.idx()))]));
      for(const Mesh::Edge_index e : mesh.edges())
        BOOST_REQUIRE((seams[i][e] ==
                       seams_of(joined)[Mesh::Edge_index(static_cast<Mesh::size_type>(edges + e.idx()))]));
      for(const Mesh::Face_index f : mesh.faces()) {
        BOOST_REQUIRE((charts[i][f] ==
                       charts_of(joined)[Mesh::Face_index(static_cast<Mesh::size_type>(faces + f.idx()))]));
        if(charts[i][f] >= 0)
          BOOST_REQUIRE(several.charts[static_cast<std::size_t>(charts[i][f])].mesh == i);
      }
      for(; skipped < several.skipped.size() && several.skipped[skipped].mesh == i; ++skipped)
        BOOST_TEST(one.skipped[skipped].first_face == several.skipped[skipped].first_face + faces);
      faces += mesh.number_of_faces();
      edges += mesh.number_of_edges();
    }
    BOOST_TEST(skipped == several.skipped.size());
    for(std::size_t i = 0; i < one.charts.size(); ++i) {
      BOOST_TEST(one.charts[i].part == several.charts[i].part);
      BOOST_TEST(one.charts[i].mesh == 0u);
    }
  }
};

Mesh sphere(unsigned seed)
{
  std::mt19937 random(seed);
  atlas_surfaces::Union all;
  all.add(atlas_surfaces::bumpy_sphere(random));
  return all.mesh<Mesh>();
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_as_of_one_mesh)
{
  std::set<Diagnosis> statuses;
  for(unsigned seed = 0; seed < 12; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Meshes all;
    for(unsigned i = 0; i < 3; ++i)
      all.add(atlas_surfaces::random_union(10 * seed + i, 3).mesh<Mesh>());
    all.add_maps(seed % 3 == 0 ? 7 : 1000000);
    Atlas_options options(seed % 2 == 0 ? Atlas_options::TEXTURE : Atlas_options::FEW_CHARTS);
    options.pack_into_square = seed % 4 != 3;
    const auto one =
        atlas_check::TA::make_atlas(all.joined, Meshes::seams_of(all.joined), Meshes::uv_of(all.joined),
                                    Meshes::charts_of(all.joined), options);
    options.threads = static_cast<int>(seed % 3);
    all.check_same(one, all.make(options));
    statuses.insert(one.status);
  }
  BOOST_TEST(statuses.count(Diagnosis::NOTHING_WRONG) + statuses.count(Diagnosis::STRETCH_BOUND_MISSED) > 0u);
  BOOST_TEST(statuses.count(Diagnosis::SOMETHING_SKIPPED) == 1u);
}

// Parts of very different sizes have the scale of the largest one.
BOOST_AUTO_TEST_CASE(sizes_in_proportion)
{
  Meshes all;
  for(const double size : {1e-3, 1e3, 1.}) {
    Mesh mesh = sphere(1);
    for(const Mesh::Vertex_index v : mesh.vertices())
      mesh.point(v) = CGAL::ORIGIN + size * (mesh.point(v) - CGAL::ORIGIN);
    all.add(mesh);
  }
  all.add_maps(1000000);
  const auto one =
      atlas_check::TA::make_atlas(all.joined, Meshes::seams_of(all.joined), Meshes::uv_of(all.joined),
                                  Meshes::charts_of(all.joined), few_charts());
  all.check_same(one, all.make());
}

// Meshes without faces have no part in it.
BOOST_AUTO_TEST_CASE(empty_meshes)
{
  Meshes all;
  all.add(Mesh());
  all.add(sphere(2));
  all.add(Mesh());
  all.add_maps(1000000);
  const auto report = all.make();
  BOOST_TEST(report.has_atlas());
  BOOST_TEST(report.charts.size() > 0u);
  for(const Atlas_report::Chart& chart : report.charts)
    BOOST_TEST(chart.mesh == 1u);

  const std::vector<Mesh> none(2), nothing;
  std::vector<Mesh> meshes(2);
  const std::vector<UV_map> maps = {Meshes::uv_of(meshes[0]), Meshes::uv_of(meshes[1])};
  BOOST_TEST((make_common_atlas(none, maps).status == Diagnosis::EMPTY_MESH));
  BOOST_TEST((make_common_atlas(nothing, std::vector<UV_map>()).status == Diagnosis::EMPTY_MESH));
}

// What is wrong is said of the mesh where it is.
BOOST_AUTO_TEST_CASE(wrong_meshes_are_named)
{
  std::mt19937 random(1);
  atlas_surfaces::Component bad;
  do
    bad = atlas_surfaces::bad_component(random);
  while(bad.status != Diagnosis::NON_FINITE_POINT);
  atlas_surfaces::Union wrong;
  wrong.add(bad);
  Meshes all;
  all.add(sphere(3));
  all.add(wrong.mesh<Mesh>());
  all.add_maps(1000000);
  auto report = all.make();
  BOOST_TEST((report.status == Diagnosis::SOMETHING_SKIPPED));
  BOOST_TEST_REQUIRE(report.skipped.size() == 1u);
  BOOST_TEST(report.skipped[0].mesh == 1u);
  BOOST_TEST(report.skipped[0].first_face == 0u);
  BOOST_TEST(report.message.find("mesh 1: vertex ") != std::string::npos, report.message);

  all.uv.pop_back();
  report = all.make();
  BOOST_TEST((report.status == Diagnosis::WRONG_OPTION));
  BOOST_TEST(report.message.find("2 meshes, but 1 property maps") != std::string::npos, report.message);
}

// Other meshes than `Surface_mesh`, without maps of seams and charts
BOOST_AUTO_TEST_CASE(polyhedra)
{
  typedef CGAL::Polyhedron_3<atlas_check::Kernel> Polyhedron;
  typedef boost::graph_traits<Polyhedron>::halfedge_descriptor Halfedge;
  std::vector<Polyhedron> polyhedra(2);
  Meshes all;
  for(unsigned i = 0; i < 2; ++i) {
    all.add(sphere(4 + i));
    CGAL::copy_face_graph(all.meshes[i], polyhedra[i]);
  }
  std::vector<std::map<Halfedge, Point_2>> uv(2);
  std::vector<boost::associative_property_map<std::map<Halfedge, Point_2>>> maps(uv.begin(), uv.end());
  const auto report = make_common_atlas(polyhedra, maps);
  BOOST_TEST(report.has_atlas());
  for(unsigned i = 0; i < 2; ++i)
    BOOST_TEST(uv[i].size() == 3 * num_faces(polyhedra[i]));
}

BOOST_AUTO_TEST_SUITE_END()
