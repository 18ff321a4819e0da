// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts with a given number of texels per unit on pages of any shape, compared with an oracle that asks exact
// predicates for each texel.

#include <boost/test/unit_test.hpp>

#include "planar_charts.h"
#include "test_options.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Texture_atlas/pack_charts.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_pages)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace ABF = SMP::internal::ABF;
namespace parameters = CGAL::parameters;
using TA::internal::Packing;
using TA::internal::Packing_check;
using ABF::Planar_point;
using TA::Atlas_options;
using TA::Atlas_report;
using SMP::Diagnosis;
using TA::Packing_options;
using test_charts::Planar_charts;
using test_charts::Texel_oracle;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace {

// The texels along the length 1 of the surface, so that all charts together would fill that many pages
double texels_for(const Planar_charts& charts, const Packing_options& options, double pages)
{
  double area = 0;
  for(double a : charts.area)
    area += a;
  return std::sqrt(pages * options.resolution * options.number_of_rows() / area);
}

// The triangles of a page, where the width of the page has the length 1
struct Page
{
  std::vector<Planar_point> corners;
  std::vector<int> chart;
};

Page page_of(const Planar_charts& charts, const Packing& packing, const Packing_options& options, int number)
{
  const std::vector<Planar_point> corners = placed_corners(charts, packing);
  Page page;
  for(std::size_t t = 0; t < charts.chart.size(); ++t)
    if(packing.page[charts.chart[t]] == number) {
      for(std::size_t c = 3 * t; c < 3 * t + 3; ++c)
        page.corners.emplace_back(corners[c].x() - number % 10, (corners[c].y() - number / 10) *
                                                                    options.number_of_rows() /
                                                                    options.resolution);
      page.chart.push_back(charts.chart[t]);
    }
  return page;
}

// All in their pages, with half the gutter around, and apart: texels by the gutter, and blocks
void check_page(const Page& page, const Packing_options& options)
{
  const int gutter = options.number_of_gutter_texels();
  BOOST_TEST(!page.chart.empty());
  BOOST_TEST(!Texel_oracle(page.corners, page.chart, options.resolution).are_too_near(gutter));
  BOOST_TEST(!Texel_oracle(page.corners, page.chart, options.resolution / options.block).are_too_near(0));
  const double border = (gutter + 1) / 2;
  for(const Planar_point& p : page.corners) {
    const Planar_point texel = p * options.resolution;
    BOOST_TEST(texel.minCoeff() >= border);
    BOOST_TEST(texel.x() <= options.resolution - border);
    BOOST_TEST(texel.y() <= options.number_of_rows() - border);
  }
}

// Of each chart, in texels
std::vector<double> areas_in_texels(const Planar_charts& charts, const Packing& packing,
                                    const Packing_options& options)
{
  const std::vector<Planar_point> p = placed_corners(charts, packing);
  std::vector<double> areas(static_cast<std::size_t>(charts.number), 0);
  for(std::size_t t = 0; t < charts.chart.size(); ++t)
    areas[charts.chart[t]] += std::abs(ABF::cross(p[3 * t + 1] - p[3 * t], p[3 * t + 2] - p[3 * t])) / 2 *
                              options.resolution * options.number_of_rows();
  return areas;
}

std::vector<double> areas_on_surface(const Planar_charts& charts)
{
  std::vector<double> areas(static_cast<std::size_t>(charts.number), 0);
  for(std::size_t t = 0; t < charts.chart.size(); ++t)
    areas[charts.chart[t]] += charts.area[t];
  return areas;
}

// Charts without needles, which are enlarged
Planar_charts plump_charts(int number, std::mt19937& random)
{
  Planar_charts charts;
  std::uniform_real_distribution<double> unit(0.3, 1);
  while(charts.number < number) {
    const std::size_t first = charts.chart.size();
    if(charts.number % 3 == 0)
      test_charts::add_disc(charts, unit(random), 3 + charts.number % 17);
    else if(charts.number % 3 == 1)
      test_charts::add_L(charts, 2 * unit(random), 0.5 * unit(random));
    else
      charts.add_rectangle(0, 0, unit(random), 2 * unit(random));
    charts.finish_chart(first, random);
  }
  return charts;
}

} // namespace

// Several pages, or one that charts fill
BOOST_AUTO_TEST_CASE(charts_on_any_pages_are_apart)
{
  std::mt19937 random(1);
  std::set<int> numbers_of_pages;
  for(int i = 0; i < 40; ++i) {
    const Planar_charts charts = plump_charts(10 + static_cast<int>(random() % 30), random);
    Packing_options options;
    options.resolution = 64 << random() % 2;
    options.height = 64 << random() % 2;
    options.block = 1 << random() % 3;
    options.gutter = static_cast<int>(random() % 6);
    options.texels_per_unit = i % 4 == 0 ? 0 : texels_for(charts, options, 0.5 + static_cast<double>(i % 7));
    const Packing packing = pack(charts, options);
    BOOST_REQUIRE((packing.status == Packing::DONE || packing.status == Packing::CHART_TOO_LARGE));
    if(packing.status != Packing::DONE)
      continue;
    numbers_of_pages.insert(static_cast<int>(packing.number_of_pages));
    double texels = 0;
    for(double area : areas_in_texels(charts, packing, options))
      texels += area;
    const double page = options.resolution * options.number_of_rows();
    BOOST_TEST(std::abs(texels / page / packing.number_of_pages / packing.covered_share - 1) < 1e-9);
    const std::vector<Planar_point> corners = placed_corners(charts, packing);
    BOOST_TEST((TA::internal::certify_packing(corners, charts.chart, packing.page, options).status ==
                Packing_check::CERTIFIED));
    for(int k = 0; k < packing.number_of_pages; ++k)
      check_page(page_of(charts, packing, options, k), options);
  }
  BOOST_TEST(numbers_of_pages.size() > 5u);
}

BOOST_AUTO_TEST_CASE(each_chart_has_the_given_density)
{
  std::mt19937 random(3);
  for(const double pages : {0.1, 3., 7.}) {
    const Planar_charts charts = plump_charts(100, random);
    Packing_options options;
    options.resolution = 256;
    options.height = 128;
    options.block = 4;
    options.texels_per_unit = texels_for(charts, options, pages);
    const Packing packing = pack(charts, options);
    BOOST_REQUIRE(packing.status == Packing::DONE);
    BOOST_TEST(packing.number_of_pages >= pages);
    BOOST_TEST(packing.number_of_pages <= 1 + 2 * pages);
    BOOST_TEST(std::abs(packing.texels_per_length / options.texels_per_unit - 1) < 1e-12);
    const std::vector<double> texels = areas_in_texels(charts, packing, options),
                              areas = areas_on_surface(charts);
    for(int c = 0; c < charts.number; ++c)
      BOOST_TEST(std::abs(std::sqrt(texels[c] / areas[c]) / options.texels_per_unit - 1) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(pages_do_not_depend_on_threads)
{
  std::mt19937 random(4);
  const Planar_charts charts = plump_charts(120, random);
  Packing_options options;
  options.resolution = 128;
  options.texels_per_unit = texels_for(charts, options, 9);
  std::vector<std::vector<Planar_point>> corners;
  for(int threads : {1, 2})
    ABF::with_threads(threads, [&]() { corners.push_back(placed_corners(charts, pack(charts, options))); });
  BOOST_TEST((corners[0] == corners[1]));
}

// A strip that is longer than the page is wide is turned.
BOOST_AUTO_TEST_CASE(strips_lie_along_the_diagonal_if_they_must)
{
  std::mt19937 random(5);
  Planar_charts charts;
  for(const double length : {1.3, 0.2, 0.2}) {
    charts.add_rectangle(0, 0, length, 0.01);
    charts.finish_chart(charts.chart.size() - 2, random);
  }
  Packing_options options;
  options.resolution = 512;
  options.texels_per_unit = 512;
  const Packing packing = pack(charts, options);
  BOOST_REQUIRE(packing.status == Packing::DONE);
  BOOST_TEST(packing.number_of_pages == 1);
  options.texels_per_unit = 600;
  const Packing too_large = pack(charts, options);
  BOOST_TEST((too_large.status == Packing::CHART_TOO_LARGE));
  BOOST_TEST(too_large.chart == 0);
  BOOST_TEST(std::abs(too_large.texels.maxCoeff() / 780 - 1) < 1e-9);
  options.height = 1024; // twice as many rows hold it
  BOOST_TEST((pack(charts, options).status == Packing::DONE));
}

namespace {

// Squares of side 1, side by side without touching
struct Squares
{
  Mesh mesh;
  Mesh::Property_map<CGAL::SM_Face_index, int> chart;
  Mesh::Property_map<CGAL::SM_Halfedge_index, Kernel::Point_2> uv;

  explicit Squares(int number)
  {
    chart = mesh.add_property_map<CGAL::SM_Face_index, int>("f:chart").first;
    uv = mesh.add_property_map<CGAL::SM_Halfedge_index, Kernel::Point_2>("h:uv").first;
    for(int i = 0; i < number; ++i) {
      const auto at = [&](double x, double y) { return mesh.add_vertex({2 * i + x, y, 0.}); };
      const auto a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
      chart[mesh.add_face(a, b, c)] = i;
      chart[mesh.add_face(a, c, d)] = i;
    }
    for(const auto h : mesh.halfedges())
      uv[h] = {mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y()};
  }

  auto pack(const Packing_options& options) { return TA::pack_charts(mesh, chart, uv, options); }
};

Packing_options with_density(int resolution, double texels)
{
  return with<Packing_options>(&Packing_options::resolution, resolution, &Packing_options::texels_per_unit,
                               texels);
}

void check_failure(const Packing_options& options, Diagnosis diagnosis, const std::vector<std::string>& words)
{
  Squares squares(3);
  const auto report = squares.pack(options);
  BOOST_TEST((report.status == diagnosis));
  for(const std::string& word : words)
    BOOST_TEST(report.message.find(word) != std::string::npos, report.message << " has no " << word);
  for(const auto h : squares.mesh.halfedges())
    BOOST_TEST((squares.uv[h] == Kernel::Point_2(squares.mesh.point(squares.mesh.target(h)).x(),
                                                 squares.mesh.point(squares.mesh.target(h)).y())));
}

} // namespace

// Twelve pages with four squares, the last two of them in the second row of pages
BOOST_AUTO_TEST_CASE(pages_are_numbered_as_in_UDIM)
{
  Squares squares(48);
  const auto report = squares.pack(with_density(128, 50));
  BOOST_REQUIRE_MESSAGE(report, report.message);
  BOOST_TEST(report.number_of_pages == 12u);
  BOOST_REQUIRE_EQUAL(report.page_of_chart.size(), 48u);
  for(const auto f : squares.mesh.faces()) {
    const int page = report.page_of_chart[static_cast<std::size_t>(squares.chart[f])];
    for(const auto h : squares.mesh.halfedges_around_face(squares.mesh.halfedge(f))) {
      BOOST_TEST(std::floor(squares.uv[h].x()) == page % 10);
      BOOST_TEST(std::floor(squares.uv[h].y()) == page / 10);
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_pages)
{
  check_failure(with_density(64, 70), Diagnosis::CHART_TOO_LARGE, {"chart 0", "70 x 70", "64 x 64"});
  check_failure(with_density(64, 1e4), Diagnosis::TOO_MANY_PAGES, {"73243", "10000"});
  check_failure(with_density(64, 1e300), Diagnosis::TOO_MANY_PAGES, {"10000"});
  check_failure(with_density(64, -1), Diagnosis::WRONG_OPTION, {"-1"});
  check_failure(with_density(64, std::nan("")), Diagnosis::WRONG_OPTION, {"nan"});
  check_failure(with_density(64, std::numeric_limits<double>::infinity()), Diagnosis::WRONG_OPTION, {"inf"});
  const auto wrong_height = with<Packing_options>(&Packing_options::height, 0);
  check_failure(wrong_height, Diagnosis::WRONG_OPTION, {"height is 0", "32768"});
  check_failure(with<Packing_options>(&Packing_options::block, 0), Diagnosis::WRONG_OPTION, {"block is 0"});
  check_failure(with<Packing_options>(&Packing_options::block, 4, &Packing_options::height, 62),
                Diagnosis::WRONG_OPTION, {"block of 4", "62"});
}

namespace {

// Hills over a long strip
Mesh strip(int length, int width)
{
  Mesh mesh;
  std::vector<CGAL::SM_Vertex_index> v;
  for(int i = 0; i <= length; ++i)
    for(int j = 0; j <= width; ++j)
      v.push_back(mesh.add_vertex({1. * i, 1. * j, 0.4 * std::sin(0.7 * i) * std::cos(0.9 * j)}));
  const auto at = [&](int i, int j) { return v[static_cast<std::size_t>(i * (width + 1) + j)]; };
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < width; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

struct Strip_atlas
{
  Mesh mesh = strip(60, 12);
  Mesh::Property_map<CGAL::SM_Edge_index, bool> seams =
      mesh.add_property_map<CGAL::SM_Edge_index, bool>("e:seam", false).first;
  Mesh::Property_map<CGAL::SM_Halfedge_index, Kernel::Point_2> uv =
      mesh.add_property_map<CGAL::SM_Halfedge_index, Kernel::Point_2>("h:uv").first;
  Mesh::Property_map<CGAL::SM_Face_index, int> chart =
      mesh.add_property_map<CGAL::SM_Face_index, int>("f:chart", -1).first;
  CGAL::Surface_mesh_parameterization::Mesh_report<Mesh, Atlas_report> report;

  explicit Strip_atlas(const Atlas_options& options) : report(TA::make_atlas(mesh, seams, uv, chart, options))
  {}
};

Atlas_options atlas_options(int width, int height, double texels)
{
  Atlas_options options(Atlas_options::FEW_CHARTS);
  options.resolution = width;
  options.height = height;
  options.texels_per_unit = texels;
  return options;
}

} // namespace

// The strip is 60 by 12 long, and more along its hills; a page holds much less.
BOOST_AUTO_TEST_CASE(charts_are_cut_until_pages_hold_them)
{
  for(const double weight : {1., 0.5}) {
    const Atlas_options options = atlas_options(128, 64, 10 / weight);
    Mesh mesh = strip(60, 12);
    auto uv = mesh.add_property_map<CGAL::SM_Halfedge_index, Kernel::Point_2>("h:uv").first;
    auto chart = mesh.add_property_map<CGAL::SM_Face_index, int>("f:chart", -1).first;
    auto seams = mesh.add_property_map<CGAL::SM_Edge_index, bool>("e:seam", false).first;
    auto weights = mesh.add_property_map<CGAL::SM_Face_index, double>("f:weight", weight).first;
    const auto report = TA::make_atlas(mesh, seams, uv, chart, options, parameters::face_size_map(weights));
    BOOST_REQUIRE_MESSAGE(report, report.message);
    BOOST_TEST(report.number_of_pages > 8u);
    BOOST_TEST(report.charts.size() >= report.number_of_pages);
    std::vector<double> surface(report.charts.size(), 0), texels(report.charts.size(), 0);
    for(const auto f : mesh.faces()) {
      const auto h = mesh.halfedge(f), g = mesh.next(h);
      const auto c = static_cast<std::size_t>(chart[f]);
      surface[c] += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                 mesh.point(mesh.target(g))));
      texels[c] += CGAL::area(uv[h], uv[g], uv[mesh.next(g)]) * 128 * 64;
      BOOST_TEST(std::floor(uv[h].x()) == report.charts[c].page % 10);
      BOOST_TEST(std::floor(uv[h].y()) == report.charts[c].page / 10);
    }
    for(std::size_t c = 0; c < surface.size(); ++c)
      BOOST_TEST(std::abs(std::sqrt(texels[c] / surface[c]) / 10 - 1) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(a_triangle_that_no_page_holds_is_named)
{
  const Strip_atlas atlas(atlas_options(64, 32, 100));
  BOOST_TEST((atlas.report.status == Diagnosis::PACKING_FAILED));
  BOOST_TEST(atlas.report.message.find("chart ") == 0u, atlas.report.message);
  BOOST_TEST(atlas.report.message.find("64 x 32") != std::string::npos, atlas.report.message);
  const Strip_atlas pages(atlas_options(64, 32, 1e5));
  BOOST_TEST((pages.report.status == Diagnosis::PACKING_FAILED));
  BOOST_TEST(pages.report.message.find("10000") != std::string::npos, pages.report.message);
}

// The measures are those of the map in texels, and so is the scale along the width.
BOOST_AUTO_TEST_CASE(measures_are_of_square_texels)
{
  Strip_atlas atlas(atlas_options(512, 128, 0));
  BOOST_REQUIRE_MESSAGE(atlas.report, atlas.report.message);
  for(const auto h : atlas.mesh.halfedges())
    atlas.uv[h] = {atlas.uv[h].x(), atlas.uv[h].y() / 4};
  const auto measured = SMP::measure_flattening(atlas.mesh, atlas.uv);
  BOOST_TEST(std::abs(atlas.report.measures.l2_stretch / measured.l2_stretch - 1) < 1e-6);
  BOOST_TEST(std::abs(atlas.report.measures.mean_angle_change / measured.mean_angle_change - 1) < 1e-6);
  BOOST_TEST(atlas.report.measures.l2_stretch < 1.2);
  double surface = 0, plane = 0;
  for(const auto f : atlas.mesh.faces()) {
    const auto h = atlas.mesh.halfedge(f), g = atlas.mesh.next(h);
    surface += std::sqrt(CGAL::squared_area(atlas.mesh.point(atlas.mesh.source(h)),
                                            atlas.mesh.point(atlas.mesh.target(h)),
                                            atlas.mesh.point(atlas.mesh.target(g))));
    plane += CGAL::area(atlas.uv[h], atlas.uv[g], atlas.uv[atlas.mesh.next(g)]);
  }
  BOOST_TEST(std::abs(std::sqrt(plane / surface) / atlas.report.scale - 1) < 1e-9);
  BOOST_TEST(std::abs(4 * plane / atlas.report.covered_share - 1) < 1e-9);
  BOOST_TEST(atlas.report.low_texel_density <= atlas.report.covered_share);
  BOOST_TEST(atlas.report.low_texel_density > 0.3 * atlas.report.covered_share);
}

BOOST_AUTO_TEST_SUITE_END()
