// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `make_atlas()` cuts charts where they then cover more of the square, along short seams, and only there.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/make_atlas.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_necks)

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace TA = CGAL::Texture_atlas;

// A flat surface of unit squares: those that are marked by `#` in a picture, each divided into triangles.
Mesh flat_surface(const std::vector<std::string>& picture)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Mesh::Vertex_index> vertices;
  const auto vertex = [&](int x, int y) {
    const auto [found, is_new] = vertices.insert({{x, y}, Mesh::Vertex_index()});
    if(is_new)
      found->second = mesh.add_vertex(Kernel::Point_3(x, y, 0));
    return found->second;
  };
  for(int y = 0; y < static_cast<int>(picture.size()); ++y)
    for(int x = 0; x < static_cast<int>(picture[y].size()); ++x)
      if(picture[y][x] == '#') {
        mesh.add_face(vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1));
        mesh.add_face(vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1));
      }
  return mesh;
}

const double infinity = std::numeric_limits<double>::infinity();

const std::vector<std::string> dumbbell = {"######  ######", //
                                           "######  ######", //
                                           "##############", //
                                           "######  ######", //
                                           "######  ######", //
                                           "######  ######"};

struct Result
{
  TA::Atlas_report report;
  std::vector<Mesh::Edge_index> seams;
};

// The edges in `forbidden` must not become seams.
Result atlas_of(Mesh& mesh, double seam_price, const std::vector<Mesh::Edge_index>& forbidden = {})
{
  namespace np = CGAL::parameters;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  const auto constrained = mesh.add_property_map<Mesh::Edge_index, bool>("e:constrained", false).first;
  for(const Mesh::Edge_index e : mesh.edges())
    seams[e] = constrained[e] = false;
  for(const Mesh::Edge_index e : forbidden)
    constrained[e] = true;
  Result result;
  const auto charts = mesh.add_property_map<Mesh::Face_index, int>("f:chart").first;
  TA::Atlas_options options(TA::Atlas_options::FEW_CHARTS);
  options.seam_price = seam_price;
  result.report = TA::make_atlas(mesh, seams, uv, charts, options, np::edge_is_constrained_map(constrained));
  for(const Mesh::Edge_index e : mesh.edges())
    if(seams[e])
      result.seams.push_back(e);
  return result;
}

std::vector<Mesh::Edge_index> across_the_bar(const Mesh& mesh)
{
  std::vector<Mesh::Edge_index> edges;
  for(const Mesh::Edge_index e : mesh.edges()) {
    const Kernel::Point_3 p = mesh.point(mesh.vertex(e, 0)), q = mesh.point(mesh.vertex(e, 1));
    if((std::min)(p.x(), q.x()) >= 6 && (std::max)(p.x(), q.x()) <= 8)
      edges.push_back(e);
  }
  return edges;
}

} // namespace

BOOST_AUTO_TEST_CASE(bar_is_cut)
{
  Mesh mesh = flat_surface(dumbbell);
  const Result whole = atlas_of(mesh, infinity), cut = atlas_of(mesh, 1);
  BOOST_TEST(bool(whole.report));
  BOOST_TEST(whole.report.charts.size() == 1);
  BOOST_TEST(whole.seams.empty());
  BOOST_TEST(bool(cut.report));
  BOOST_TEST(cut.report.charts.size() == 2);
  BOOST_TEST(cut.report.covered_share > 1.2 * whole.report.covered_share);
  BOOST_REQUIRE(cut.seams.size() == 1); // across the bar
  BOOST_TEST(cut.report.seam_length == 1.);
  const std::vector<Mesh::Edge_index> bar = across_the_bar(mesh);
  BOOST_TEST((std::find(bar.begin(), bar.end(), cut.seams.front()) != bar.end()));
}

BOOST_AUTO_TEST_CASE(seams_stay_where_they_are_allowed)
{
  Mesh mesh = flat_surface(dumbbell);
  const std::vector<Mesh::Edge_index> bar = across_the_bar(mesh);
  const Result result = atlas_of(mesh, 0.1, bar);
  BOOST_TEST(bool(result.report));
  for(const Mesh::Edge_index e : result.seams)
    BOOST_TEST((std::find(bar.begin(), bar.end(), e) == bar.end()));
}

// A square fills the page anyway, and two halves of an oblong do so only if seams are cheap.
BOOST_AUTO_TEST_CASE(charts_are_cut_if_that_is_worth_the_price)
{
  Mesh square = flat_surface(std::vector<std::string>(12, std::string(12, '#')));
  Mesh oblong = flat_surface(std::vector<std::string>(8, std::string(16, '#')));
  for(const auto& [mesh, price, is_cut] :
      {std::tuple(&square, 0.01, false), {&oblong, 2., false}, {&oblong, 0.1, true}}) {
    const Result result = atlas_of(*mesh, price);
    BOOST_TEST(bool(result.report));
    BOOST_TEST((result.report.charts.size() > 1) == is_cut);
    BOOST_TEST(result.seams.empty() == !is_cut);
  }
}

// A frame without and with vertices inside: two halves lie beside each other.
BOOST_AUTO_TEST_CASE(rings_are_cut_in_two)
{
  for(const std::size_t width : {1, 2, 3}) {
    std::vector<std::string> frame(30, std::string(30, '#'));
    for(std::size_t y = width; y + width < frame.size(); ++y)
      std::fill(frame[y].begin() + width, frame[y].end() - width, ' ');
    Mesh mesh = flat_surface(frame);
    const Result whole = atlas_of(mesh, infinity), expensive = atlas_of(mesh, 10), cut = atlas_of(mesh, 0.04);
    BOOST_TEST(bool(cut.report), cut.report.message);
    BOOST_TEST(whole.report.charts.size() == 1);
    BOOST_TEST(expensive.report.charts.size() == 1);
    BOOST_TEST(expensive.seams.empty());
    BOOST_TEST(cut.report.charts.size() >= 2);
    BOOST_TEST(cut.report.covered_share > 1.5 * whole.report.covered_share);
    BOOST_TEST(cut.report.measures.l2_stretch < 1 + 1e-6);
  }
}

// Its halves have less than a hundredth of the area.
BOOST_AUTO_TEST_CASE(small_strips_are_cut_if_they_are_long)
{
  std::vector<std::string> picture(72, std::string(72, '#') + std::string(28, ' '));
  picture.push_back(std::string(100, ' '));
  picture.push_back(std::string(100, '#'));
  Mesh mesh = flat_surface(picture);
  const Result whole = atlas_of(mesh, infinity), cut = atlas_of(mesh, 0.04);
  BOOST_TEST(bool(cut.report), cut.report.message);
  BOOST_TEST(cut.report.charts.size() >= 3);
  BOOST_TEST(cut.report.covered_share > 1.2 * whole.report.covered_share);
}

// What is cut off would have too little area, or the hole is too small to be worth it.
BOOST_AUTO_TEST_CASE(small_holes_stay)
{
  std::vector<std::string> plate(24, std::string(24, '#'));
  plate[3][3] = plate[20][12] = ' ';
  Mesh mesh = flat_surface(plate);
  BOOST_TEST(atlas_of(mesh, 0.04).report.charts.size() == 1);
  BOOST_TEST(atlas_of(mesh, 0.04).seams.empty());
}

BOOST_AUTO_TEST_SUITE_END()
