// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Packed charts, compared with an oracle that asks exact predicates for each texel.

#include <boost/test/unit_test.hpp>

#include "planar_charts.h"
#include "test_options.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/pack_charts.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_packing)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace ABF = SMP::internal::ABF;
namespace parameters = CGAL::parameters;
using TA::internal::Packing;
using TA::internal::Packing_check;
using ABF::Planar_point;
using TA::Packing_report;
using SMP::Diagnosis;
using TA::Packing_options;
using test_charts::Planar_charts;
using test_charts::Texel_oracle;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

Packing_options options(int resolution, int gutter)
{
  Packing_options result;
  result.resolution = resolution;
  result.gutter = gutter;
  return result;
}

double sum_of_areas(const std::vector<Planar_point>& corners)
{
  double sum = 0;
  for(std::size_t c = 0; c < corners.size(); c += 3)
    sum += std::abs(ABF::cross(corners[c + 1] - corners[c], corners[c + 2] - corners[c])) / 2;
  return sum;
}

// Charts have the gutter between them, the square, and the same density up to those that are enlarged or reduced.
void check_packing(const Planar_charts& charts, const Packing& packing, const Packing_options& options)
{
  BOOST_REQUIRE(packing.status == Packing::DONE);
  BOOST_REQUIRE_EQUAL(packing.placement.size(), charts.number);
  const std::vector<Planar_point> corners = placed_corners(charts, packing);
  const Texel_oracle oracle(corners, charts.chart, options.resolution);
  BOOST_TEST(!oracle.are_too_near(options.number_of_gutter_texels()));
  BOOST_TEST(oracle.border() >= (options.number_of_gutter_texels() + 1) / 2);
  BOOST_TEST((TA::internal::certify_packing(corners, charts.chart, packing.page, options).status ==
              Packing_check::CERTIFIED));
  BOOST_TEST(std::abs(sum_of_areas(corners) / packing.covered_share - 1) < 1e-6);

  std::vector<double> area(charts.number, 0), should(charts.number, 0);
  for(std::size_t t = 0; t < charts.chart.size(); ++t) {
    const Planar_point p = corners[3 * t], q = corners[3 * t + 1], r = corners[3 * t + 2];
    area[charts.chart[t]] += std::abs(ABF::cross(q - p, r - p)) / 2;
    should[charts.chart[t]] += charts.area[t];
  }
  int denser = 0;
  for(int c = 0; c < charts.number; ++c) {
    const double texels = std::sqrt(area[c] / should[c]) * options.resolution;
    BOOST_TEST(texels > packing.scale[c] * packing.texels_per_length * (1 - 1e-6));
    if(packing.scale[c] < 1)
      BOOST_TEST(texels < packing.scale[c] * packing.texels_per_length * (1 + 1e-6));
    denser += texels > packing.texels_per_length * (1 + 1e-6);
  }
  BOOST_TEST(denser == packing.number_of_enlarged);
}

// Turned counterclockwise by a similarity, charts keep their orientation.
void check_orientation(const Planar_charts& charts, const Packing& packing)
{
  const std::vector<Planar_point> corners = placed_corners(charts, packing);
  const auto turn = [](const std::vector<Planar_point>& p, std::size_t c) {
    return ABF::cross(p[c + 1] - p[c], p[c + 2] - p[c]);
  };
  for(std::size_t c = 0; c < corners.size(); c += 3)
    BOOST_TEST((turn(corners, c) > 0) == (turn(charts.corners, c) > 0));
}

const bool is_quick = std::getenv("ABF_TEST_QUICK") != nullptr;

} // namespace

BOOST_AUTO_TEST_CASE(random_charts_are_apart)
{
  std::mt19937 random(1);
  for(int i = 0; i < (is_quick ? 10 : 40); ++i) {
    const Planar_charts charts = test_charts::random_charts(1 + static_cast<int>(random() % 30), random);
    const Packing_options o = options(64 << random() % 3, static_cast<int>(random() % 6));
    const Packing packing = pack(charts, o);
    check_packing(charts, packing, o);
    check_orientation(charts, packing);
    if(charts.number > 8)
      BOOST_TEST(packing.covered_share > 0.15);
  }
}

BOOST_AUTO_TEST_CASE(thousands_of_charts)
{
  std::mt19937 random(2);
  const Planar_charts charts = test_charts::random_charts(2000, random);
  const Packing_options o = options(512, 1);
  const Packing packing = pack(charts, o);
  check_packing(charts, packing, o);
  BOOST_TEST(packing.number_of_small > 1500);
  BOOST_TEST(packing.covered_share > 0.4);
}

// Where several texels are one cell
BOOST_AUTO_TEST_CASE(high_resolutions)
{
  std::mt19937 random(3);
  for(int resolution : {2048, 4096}) {
    const Planar_charts charts = test_charts::random_charts(12, random);
    const Packing_options o = options(resolution, resolution / 512 + 1);
    const Packing packing = pack(charts, o);
    BOOST_REQUIRE(packing.status == Packing::DONE);
    const std::vector<Planar_point> corners = placed_corners(charts, packing);
    BOOST_TEST((TA::internal::certify_packing(corners, charts.chart, packing.page, o).status ==
                Packing_check::CERTIFIED));
  }
}

// In a copy of the texture whose texels are 2^n times as long, no texel belongs to two charts.
BOOST_AUTO_TEST_CASE(reduced_textures_keep_charts_apart)
{
  std::mt19937 random(31);
  for(int levels : {0, 1, 2, 3}) {
    const Planar_charts charts = test_charts::random_charts(12, random);
    const Packing_options o = options(256, 1 << levels);
    const Packing packing = pack(charts, o);
    check_packing(charts, packing, o);
    const std::vector<Planar_point> corners = placed_corners(charts, packing);
    for(int level = 0; level <= levels; ++level)
      BOOST_TEST(!Texel_oracle(corners, charts.chart, 256 >> level).are_too_near(0));
  }
}

BOOST_AUTO_TEST_CASE(gutter_grows_with_the_resolution)
{
  for(const auto& [resolution, gutter] :
      {std::pair(1, 1), {64, 1}, {512, 2}, {1024, 4}, {2048, 8}, {32768, 128}})
    BOOST_TEST(with<Packing_options>(&Packing_options::resolution, resolution).number_of_gutter_texels() ==
               gutter);
}

BOOST_AUTO_TEST_CASE(any_resolution_and_gutter)
{
  std::mt19937 random(4);
  for(int resolution : {1, 2, 3, 7, 63, 64, 65, 100, 129})
    for(int gutter : {0, 1, 2, 5, 40, 70}) {
      const Planar_charts charts = test_charts::random_charts(2, random);
      const Packing packing = pack(charts, options(resolution, gutter));
      BOOST_REQUIRE((packing.status == Packing::DONE || packing.status == Packing::TOO_MANY_CHARTS));
      if(packing.status == Packing::DONE) {
        const std::vector<Planar_point> corners = placed_corners(charts, packing);
        BOOST_TEST(
            (TA::internal::certify_packing(corners, charts.chart, packing.page, options(resolution, gutter))
                 .status == Packing_check::CERTIFIED));
      }
      // Two texels with the gutter between them, and half of it around
      BOOST_TEST((packing.status == Packing::DONE) == (resolution >= 2 + gutter + (gutter + 1) / 2 * 2));
    }
}

BOOST_AUTO_TEST_CASE(certificate_equals_the_oracle)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int wrong = 0, cases = 0;
  for(int i = 0; i < (is_quick ? 5 : 20); ++i) {
    const Planar_charts charts = test_charts::random_charts(6, random);
    const Packing_options o = options(64, static_cast<int>(random() % 4));
    const std::vector<Planar_point> packed = placed_corners(charts, pack(charts, o));
    for(int j = 0; j < 30; ++j, ++cases) {
      std::vector<Planar_point> corners = packed;
      const int moved = static_cast<int>(random() % 6);
      const Planar_point shift = Planar_point(unit(random) - 0.5, unit(random) - 0.5) * 2 / 64;
      for(std::size_t c = 0; c < corners.size(); ++c)
        if(charts.chart[c / 3] == moved)
          corners[c] += shift;
      const Texel_oracle oracle(corners, charts.chart, 64);
      const Packing_check check =
          TA::internal::certify_packing(corners, charts.chart, std::vector<int>(6, 0), o);
      if(oracle.border() < (o.number_of_gutter_texels() + 1) / 2) {
        BOOST_TEST((check.status == Packing_check::OUTSIDE));
        BOOST_TEST(charts.chart[check.triangle] == moved);
      } else
        BOOST_TEST((check.status == Packing_check::SHARED_TEXEL) ==
                   oracle.are_too_near(o.number_of_gutter_texels()));
      BOOST_TEST((check.status == Packing_check::CERTIFIED) == (check.triangle < 0));
      wrong += check.status != Packing_check::CERTIFIED;
    }
  }
  BOOST_TEST(wrong > cases / 10);
  BOOST_TEST(wrong < cases - cases / 10);
}

BOOST_AUTO_TEST_CASE(charts_find_places_in_holes)
{
  std::mt19937 random(6);
  Planar_charts charts;
  test_charts::add_ring(charts, 0.9, 1, 64);
  charts.finish_chart(0, random);
  std::size_t first = charts.chart.size();
  test_charts::add_disc(charts, 0.8, 64);
  charts.finish_chart(first, random);
  const Packing_options o = options(256, 2);
  const Packing packing = pack(charts, o);
  check_packing(charts, packing, o);
  BOOST_TEST(packing.covered_share > 0.6); // the disc beside the ring covers less than 0.3
}

BOOST_AUTO_TEST_CASE(a_square_fills_the_square)
{
  std::mt19937 random(7);
  Planar_charts charts;
  charts.add_rectangle(0, 0, 1, 1);
  charts.finish_chart(0, random);
  for(int gutter : {0, 2, 9}) {
    const Packing packing = pack(charts, options(128, gutter));
    check_packing(charts, packing, options(128, gutter));
    BOOST_TEST(packing.covered_share > 0.985 * std::pow(1 - (gutter + 1) / 2 * 2 / 128., 2));
  }
}

BOOST_AUTO_TEST_CASE(same_bits_on_any_number_of_threads)
{
  std::mt19937 random(8);
  for(int number : {3, 40, 500}) {
    const Planar_charts charts = test_charts::random_charts(number, random);
    std::vector<Packing> packings;
    for(int threads : {1, 2, 0})
      ABF::with_threads(threads, [&] { packings.push_back(pack(charts, options(256, 1))); });
    for(const Packing& packing : packings) {
      BOOST_REQUIRE(packing.status == Packing::DONE);
      BOOST_TEST(packing.covered_share == packings[0].covered_share);
      BOOST_TEST((placed_corners(charts, packing) == placed_corners(charts, packings[0])));
    }
  }
}

BOOST_AUTO_TEST_CASE(charts_of_very_different_size)
{
  Planar_charts charts;
  for(double size : {1., 1e-3, 1e-6, 1e-12, 1e-40}) {
    test_charts::add_disc(charts, size, 10);
    ++charts.number;
  }
  const Packing_options o = options(128, 2);
  const Packing packing = pack(charts, o);
  check_packing(charts, packing, o);
  BOOST_TEST(packing.number_of_enlarged == 3);
}

BOOST_AUTO_TEST_CASE(areas_that_are_zero)
{
  std::mt19937 random(10);
  Planar_charts charts = test_charts::random_charts(3, random);
  for(std::size_t t = 0; t < charts.chart.size(); ++t)
    if(charts.chart[t] == 1)
      charts.area[t] = 0;
  const Packing packing = pack(charts, options(128, 2));
  BOOST_REQUIRE(packing.status == Packing::DONE);
  BOOST_TEST(packing.number_of_enlarged == 1);
  const std::vector<Planar_point> corners = placed_corners(charts, packing);
  BOOST_TEST(!Texel_oracle(corners, charts.chart, 128).are_too_near(2));
  charts.area.assign(charts.area.size(), 0);
  BOOST_TEST((pack(charts, options(128, 2)).status == Packing::NO_AREA));
}

BOOST_AUTO_TEST_CASE(needles_far_longer_than_the_square)
{
  std::mt19937 random(11);
  Planar_charts charts = test_charts::random_charts(3, random);
  const std::size_t first = charts.chart.size();
  charts.add({0, 0}, {1, 0}, {0.3, 1e-10});
  charts.area.back() = 100;
  charts.finish_chart(first, random);
  const Packing_options o = options(128, 2);
  check_packing(charts, pack(charts, o), o);
}

// The others are as large as without them.
BOOST_AUTO_TEST_CASE(long_needles_do_not_determine_the_scale)
{
  std::mt19937 random(14);
  Planar_charts charts = test_charts::random_charts(20, random);
  const Packing_options o = options(256, 2);
  const Packing alone = pack(charts, o);
  const std::size_t first = charts.chart.size();
  const double length = 10 * std::sqrt(std::accumulate(charts.area.begin(), charts.area.end(), 0.));
  charts.add({0, 0}, {length, 0}, {length / 3, 1e-5 * length});
  charts.finish_chart(first, random);
  const Packing packing = pack(charts, o);
  check_packing(charts, packing, o);
  BOOST_TEST(packing.texels_per_length > 0.97 * alone.texels_per_length);
  for(int c = 0; c < 20; ++c)
    BOOST_TEST((packing.scale[c] < 1) == (alone.scale[c] < 1)); // some are less than a texel wide
  BOOST_TEST(packing.scale[20] < 0.1);
}

// Nor where it is a texel wide, or with a given scale
BOOST_AUTO_TEST_CASE(only_charts_with_hardly_any_area_are_reduced)
{
  Planar_charts charts;
  charts.add_rectangle(0, 0, 10, 0.01);
  ++charts.number;
  test_charts::add_disc(charts, 1, 30);
  ++charts.number;
  Packing_options o = options(256, 2);
  const Packing packing = pack(charts, o);
  check_packing(charts, packing, o);
  BOOST_TEST(packing.scale[0] == 1);
  charts.area[0] *= 0.01; // the rectangle is to be a tenth as long
  charts.area[1] *= 0.01;
  check_packing(charts, pack(charts, o), o);
  BOOST_TEST(pack(charts, o).scale[0] < 1);
  BOOST_TEST(pack(charts, options(4096, 2)).scale[0] == 1);
  o.texels_per_unit = 100;
  const Packing given = pack(charts, o);
  BOOST_REQUIRE(given.status == Packing::DONE);
  BOOST_TEST(given.scale[0] == 1);
}

BOOST_AUTO_TEST_CASE(charts_that_overlap_themselves)
{
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0, 1);
  Planar_charts charts;
  for(int c = 0; c < 6; ++c) {
    const std::size_t first = charts.chart.size();
    const auto point = [&] { return Planar_point(unit(random), unit(random)); };
    for(int t = 0; t < 5; ++t)
      charts.add(point(), point(), point());
    const Planar_point p = point(), q = point();
    charts.add(p, q, p); // no area, and not within the others
    charts.finish_chart(first, random);
  }
  const Packing_options o = options(128, 2);
  check_packing(charts, pack(charts, o), o);
}

BOOST_AUTO_TEST_CASE(wrong_arrays)
{
  std::mt19937 random(13);
  const Planar_charts good = test_charts::random_charts(4, random);
  Planar_charts charts = good;
  charts.corners.back().x() = infinity;
  Packing packing = pack(charts, options(64, 1));
  BOOST_TEST((packing.status == Packing::NON_FINITE));
  BOOST_TEST(packing.chart == 3);
  charts = good;
  charts.area.back() = -1;
  BOOST_TEST((pack(charts, options(64, 1)).status == Packing::NON_FINITE));
  charts = good;
  for(std::size_t c = 0; c < charts.corners.size(); ++c)
    if(charts.chart[c / 3] == 2)
      charts.corners[c] = Planar_point(c % 7, 3);
  packing = pack(charts, options(64, 1));
  BOOST_TEST((packing.status == Packing::DEGENERATE_CHART));
  BOOST_TEST(packing.chart == 2);
  for(const Packing_options& o : {options(0, 1), options(64, -1), options(1 << 16, 1), options(64, 1 << 11)})
    BOOST_TEST((pack(good, o).status == Packing::WRONG_OPTION));
}

BOOST_AUTO_TEST_CASE(too_many_charts)
{
  std::mt19937 random(14);
  const int side = is_quick ? 64 : 128; // 4096 or 16384 texels
  const Planar_charts charts = test_charts::random_charts(side * side * 9 / 10, random);
  BOOST_TEST((pack(charts, options(side, 2)).status == Packing::TOO_MANY_CHARTS));
  BOOST_TEST((pack(charts, options(side, 0)).status == Packing::DONE));
}

// ---- meshes

namespace {

// Charts as parts of a mesh in the plane, with coordinates that are turned and scaled
template <typename Point_3, typename Point_2>
struct Charts_of_mesh
{
  typedef CGAL::Surface_mesh<Point_3> Mesh;
  typedef typename Mesh::Face_index Face;
  typedef typename Mesh::Halfedge_index Halfedge;

  Mesh mesh;
  typename Mesh::template Property_map<Halfedge, Point_2> uv;
  typename Mesh::template Property_map<Face, int> chart;
  typename Mesh::template Property_map<Face, double> weight;

  Charts_of_mesh(int number, unsigned seed)
  {
    std::mt19937 random(seed);
    uv = mesh.template add_property_map<Halfedge, Point_2>("h:uv", Point_2(7, 7)).first;
    chart = mesh.template add_property_map<Face, int>("f:chart", -1).first;
    weight = mesh.template add_property_map<Face, double>("f:weight", 1).first;
    for(int c = 0; c < number; ++c) {
      Planar_charts planar;
      std::uniform_real_distribution<double> unit(0, 1);
      planar.add({0, 0}, {1 + unit(random), 0}, {unit(random), 2});
      const std::vector<Planar_point> in_space = planar.corners;
      planar.finish_chart(0, random);
      typename Mesh::Vertex_index v[3];
      for(int k = 0; k < 3; ++k)
        v[k] = mesh.add_vertex(Point_3(in_space[k].x(), in_space[k].y(), c));
      const Face f = mesh.add_face(v[0], v[1], v[2]);
      chart[f] = 10 * c + 5; // any numbers
      for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
        for(int k = 0; k < 3; ++k)
          if(mesh.target(h) == v[k])
            uv[h] = Point_2(planar.corners[k].x(), planar.corners[k].y());
    }
  }
  Charts_of_mesh(const Charts_of_mesh&) = delete; // the maps belong to the mesh

  std::vector<Point_2> coordinates() const
  {
    std::vector<Point_2> result;
    for(const Halfedge h : mesh.halfedges())
      result.push_back(uv[h]);
    return result;
  }

  // Those of faces with a chart
  void placed(std::vector<Planar_point>& corners, std::vector<int>& charts) const
  {
    for(const Face f : mesh.faces())
      if(chart[f] >= 0) {
        charts.push_back(chart[f]);
        for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
          corners.emplace_back(CGAL::to_double(uv[h].x()), CGAL::to_double(uv[h].y()));
      }
  }

  double density(Face f) const
  {
    const Halfedge h = mesh.halfedge(f), g = mesh.next(h), i = mesh.next(g);
    const auto point = [&](Halfedge e) { return mesh.point(mesh.target(e)); };
    const auto plane = [&](Halfedge e) {
      return Planar_point(CGAL::to_double(uv[e].x()), CGAL::to_double(uv[e].y()));
    };
    const double in_space = std::sqrt(
        CGAL::to_double(CGAL::cross_product(point(g) - point(h), point(i) - point(h)).squared_length()));
    return std::sqrt(std::abs(ABF::cross(plane(g) - plane(h), plane(i) - plane(h))) / in_space);
  }
};

typedef CGAL::Simple_cartesian<double> Doubles;
typedef CGAL::Simple_cartesian<float> Floats;
typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;

template <typename Charts>
void check_mesh(const Charts& charts, int resolution, int gutter)
{
  std::vector<Planar_point> corners;
  std::vector<int> numbers;
  charts.placed(corners, numbers);
  const Texel_oracle oracle(corners, numbers, resolution);
  BOOST_TEST(!oracle.are_too_near(gutter));
  BOOST_TEST(oracle.border() >= (gutter + 1) / 2);
}

// Fails as it should, and leaves the coordinates alone.
template <typename Charts, typename NamedParameters = parameters::Default_named_parameters>
std::string check_failure(Charts& charts, Diagnosis diagnosis,
                          const Packing_options& options = Packing_options(),
                          const NamedParameters& np = parameters::default_values())
{
  const auto before = charts.coordinates();
  const auto report = TA::pack_charts(charts.mesh, charts.chart, charts.uv, options, np);
  BOOST_TEST(!report);
  BOOST_TEST(report.status == diagnosis);
  BOOST_TEST(!report.message.empty());
  const auto after = charts.coordinates();
  for(std::size_t i = 0; i < before.size(); ++i) {
    const double x = CGAL::to_double(before[i].x());
    BOOST_TEST((std::isnan(x) || before[i] == after[i]));
  }
  return report.message;
}

} // namespace

BOOST_AUTO_TEST_CASE(surface_mesh)
{
  Charts_of_mesh<Doubles::Point_3, Doubles::Point_2> charts(30, 21);
  const auto report =
      TA::pack_charts(charts.mesh, charts.chart, charts.uv,
                      with<Packing_options>(&Packing_options::resolution, 128, &Packing_options::gutter, 3));
  BOOST_REQUIRE_MESSAGE(report, report.message);
  BOOST_TEST(report.number_of_charts == 30u);
  BOOST_TEST(report.number_of_faces == 30u);
  BOOST_TEST(report.covered_share > 0.2);
  check_mesh(charts, 128, 3);
  for(const auto f : charts.mesh.faces())
    BOOST_TEST(std::abs(128 * charts.density(f) / report.texels_per_length - 1) < 1e-9);
  for(const auto h : charts.mesh.halfedges())
    if(charts.mesh.is_border(h))
      BOOST_TEST((charts.uv[h] == Doubles::Point_2(7, 7)));
}

BOOST_AUTO_TEST_CASE(weights)
{
  Charts_of_mesh<Doubles::Point_3, Doubles::Point_2> charts(12, 22);
  for(const auto f : charts.mesh.faces())
    charts.weight[f] = f.idx() % 3 == 0 ? 3 : 1;
  const auto report = TA::pack_charts(charts.mesh, charts.chart, charts.uv,
                                      with<Packing_options>(&Packing_options::resolution, 512),
                                      parameters::face_size_map(charts.weight));
  BOOST_REQUIRE_MESSAGE(report, report.message);
  check_mesh(charts, 512, 2);
  for(const auto f : charts.mesh.faces())
    BOOST_TEST(std::abs(512 * charts.density(f) / report.texels_per_length / charts.weight[f] - 1) < 1e-9);
}

BOOST_AUTO_TEST_CASE(coordinates_of_floats_and_of_exact_numbers)
{
  Charts_of_mesh<Floats::Point_3, Floats::Point_2> floats(25, 23);
  const auto report =
      TA::pack_charts(floats.mesh, floats.chart, floats.uv,
                      with<Packing_options>(&Packing_options::resolution, 256, &Packing_options::gutter, 2));
  BOOST_REQUIRE_MESSAGE(report, report.message);
  check_mesh(floats, 256, 2);

  Charts_of_mesh<Exact::Point_3, Exact::Point_2> exact(8, 24);
  const auto exact_report =
      TA::pack_charts(exact.mesh, exact.chart, exact.uv,
                      with<Packing_options>(&Packing_options::resolution, 64, &Packing_options::gutter, 2));
  BOOST_REQUIRE_MESSAGE(exact_report, exact_report.message);
  check_mesh(exact, 64, 2);
}

BOOST_AUTO_TEST_CASE(polyhedron)
{
  typedef CGAL::Polyhedron_3<Doubles> Polyhedron;
  const Charts_of_mesh<Doubles::Point_3, Doubles::Point_2> charts(10, 25);
  Polyhedron mesh;
  CGAL::copy_face_graph(charts.mesh, mesh);
  const auto uv = get(CGAL::dynamic_halfedge_property_t<Doubles::Point_2>(), mesh);
  const auto chart = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  std::size_t number = 0;
  for(const auto f : faces(mesh)) {
    put(chart, f, number++);
    for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      put(uv, h, Doubles::Point_2(target(h, mesh)->point().x(), target(h, mesh)->point().y()));
  }
  const auto report = TA::pack_charts(
      mesh, chart, uv, with<Packing_options>(&Packing_options::resolution, 128, &Packing_options::gutter, 2));
  BOOST_REQUIRE_MESSAGE(report, report.message);
  std::vector<Planar_point> corners;
  std::vector<int> numbers;
  for(const auto f : faces(mesh)) {
    numbers.push_back(static_cast<int>(get(chart, f)));
    for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      corners.emplace_back(get(uv, h).x(), get(uv, h).y());
  }
  BOOST_TEST(!Texel_oracle(corners, numbers, 128).are_too_near(2));
}

BOOST_AUTO_TEST_CASE(faces_without_chart_stay)
{
  Charts_of_mesh<Doubles::Point_3, Doubles::Point_2> charts(9, 26);
  const CGAL::SM_Face_index f(4);
  charts.chart[f] = -3;
  for(const auto h : charts.mesh.halfedges_around_face(charts.mesh.halfedge(f)))
    charts.uv[h] = Doubles::Point_2(infinity, h.idx());
  const auto report =
      TA::pack_charts(charts.mesh, charts.chart, charts.uv,
                      with<Packing_options>(&Packing_options::resolution, 64, &Packing_options::gutter, 2));
  BOOST_REQUIRE_MESSAGE(report, report.message);
  BOOST_TEST(report.number_of_charts == 8u);
  check_mesh(charts, 64, 2);
  for(const auto h : charts.mesh.halfedges_around_face(charts.mesh.halfedge(f)))
    BOOST_TEST((charts.uv[h] == Doubles::Point_2(infinity, h.idx())));
}

BOOST_AUTO_TEST_CASE(wrong_meshes)
{
  typedef Charts_of_mesh<Doubles::Point_3, Doubles::Point_2> Charts;
  {
    Charts charts(3, 27);
    for(const auto f : charts.mesh.faces())
      charts.chart[f] = -1;
    check_failure(charts, Diagnosis::EMPTY_MESH);
  }
  {
    Charts charts(3, 28);
    const auto h = charts.mesh.halfedge(CGAL::SM_Face_index(1));
    charts.uv[h] = Doubles::Point_2(std::nan(""), 0);
    const std::string message = check_failure(charts, Diagnosis::NON_FINITE_COORDINATE);
    BOOST_TEST(message.find(", 1)") != std::string::npos);
    charts.uv[h] = Doubles::Point_2(0, 0);
    charts.mesh.point(charts.mesh.target(h)) = Doubles::Point_3(0, infinity, 1);
    check_failure(charts, Diagnosis::NON_FINITE_POINT);
  }
  {
    Charts charts(3, 29);
    charts.weight[CGAL::SM_Face_index(2)] = -1;
    const auto np = parameters::face_size_map(charts.weight);
    check_failure(charts, Diagnosis::WRONG_WEIGHT, Packing_options(), np);
    for(const auto f : charts.mesh.faces())
      charts.weight[f] = 0;
    check_failure(charts, Diagnosis::NO_AREA, Packing_options(), np);
    check_failure(charts, Diagnosis::WRONG_OPTION, with<Packing_options>(&Packing_options::resolution, 0));
    check_failure(charts, Diagnosis::WRONG_OPTION, with<Packing_options>(&Packing_options::gutter, -1));
    check_failure(charts, Diagnosis::WRONG_OPTION,
                  with<Packing_options>(&Packing_options::number_of_rotations, 0));
    check_failure(charts, Diagnosis::TOO_MANY_CHARTS,
                  with<Packing_options>(&Packing_options::resolution, 5, &Packing_options::gutter, 2));
  }
  {
    Charts charts(3, 30);
    for(const auto h : charts.mesh.halfedges_around_face(charts.mesh.halfedge(CGAL::SM_Face_index(1))))
      charts.uv[h] = Doubles::Point_2(h.idx(), 0);
    const std::string message = check_failure(charts, Diagnosis::DEGENERATE_CHART);
    BOOST_TEST(message.find("chart 15 ") != std::string::npos);
  }
  {
    Charts charts(3, 31);
    auto& mesh = charts.mesh;
    const auto v = [&](double x, double y) { return mesh.add_vertex(Doubles::Point_3(x, y, 9)); };
    charts.chart[mesh.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1))] = 0;
    check_failure(charts, Diagnosis::NOT_TRIANGULATED);
  }
}

BOOST_AUTO_TEST_SUITE_END()
