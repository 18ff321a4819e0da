// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates that are moved to a grid, read as programs do that store them as integers.

#include <boost/test/unit_test.hpp>

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_atlas_of_soup.h>
#include <CGAL/Texture_atlas/pack_charts.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_quantization)

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using SMP::Diagnosis;
using TA::Packing_options;
using TA::Soup_atlas;
using TA::Soup_options;
using TA::Soup_report;
using TA::Surface_soup;
using Index = Surface_soup::Index;

// A number from 0 to 1 as programs store it: rounded to so many bits, of which the first are repeated in 16
std::int64_t stored(const double x, const int bits)
{
  const auto i = static_cast<std::int64_t>(std::llround(x * ((1 << bits) - 1)));
  return (i << (16 - bits)) | (i >> (2 * bits - 16));
}

template <class Point>
bool is_on_grid(const Point& p, const int bits)
{
  const auto is_stored = [bits](const double x) {
    const float complement = static_cast<float>(1 - x);
    return std::abs(x - static_cast<double>(stored(x, bits)) / 65535) < 4e-8 && static_cast<float>(x) == x &&
           complement == 1 - x;
  };
  return is_stored(p.x()) && is_stored(p.y());
}

// Twice the area, in squares of the finest grid
template <class Point>
std::int64_t stored_area(const std::array<Point, 3>& p, const int bits)
{
  const auto difference = [&](const std::size_t i, const bool is_v) {
    const auto coordinate = [is_v](const Point& q) { return is_v ? q.y() : q.x(); };
    return stored(coordinate(p[i]), bits) - stored(coordinate(p[0]), bits);
  };
  return difference(1, false) * difference(2, true) - difference(1, true) * difference(2, false);
}

// Quads, or triangles
Surface_soup bumpy_sphere(const Index columns, const Index rows, const double bumps, const bool has_quads,
                          const unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Surface_soup soup;
  for(Index r = 1; r < rows; ++r)
    for(Index c = 0; c < columns; ++c) {
      const double a = r * CGAL_PI / rows, b = c * 2 * CGAL_PI / columns, radius = 1 + bumps * unit(random);
      soup.points.emplace_back(radius * std::sin(a) * std::cos(b), radius * std::sin(a) * std::sin(b),
                               radius * std::cos(a));
    }
  for(Index r = 0; r + 2 < rows; ++r)
    for(Index c = 0; c < columns; ++c) {
      const Index d = (c + 1) % columns, lower = r * columns, upper = lower + columns;
      if(has_quads) {
        soup.add_polygon({lower + c, upper + c, upper + d, lower + d});
      } else {
        soup.add_polygon({lower + c, upper + c, upper + d});
        soup.add_polygon({lower + c, upper + d, lower + d});
      }
    }
  return soup;
}

// Each polygon that is not named has its corners on the grid, and all its fans of triangles keep their orientation in
// integers. Returns the number of those that are named.
std::size_t check_soup(const Surface_soup& soup, const Soup_options& options)
{
  const int bits = *options.quantization_bits;
  Soup_atlas atlas;
  const Soup_report report = make_atlas(soup, atlas, options);
  BOOST_TEST_REQUIRE(report.has_atlas(), report.message); // a coarse grid stretches small triangles
  const std::set<std::size_t> named(report.faces_off_grid.begin(), report.faces_off_grid.end());
  BOOST_TEST(named.size() == report.faces_off_grid.size());
  std::size_t wrong = 0, misnamed = 0;
  for(Index p = 0; p < soup.number_of_polygons(); ++p) {
    const auto begin = atlas.uv.begin() + soup.first_corners[p],
               end = atlas.uv.begin() + soup.first_corners[p + 1];
    const bool is_off = !std::all_of(begin, end, [&](const auto& q) { return is_on_grid(q, bits); });
    misnamed += is_off != (named.count(p) > 0);
    const auto size = end - begin;
    for(int i = 0; i < size && !is_off; ++i) {
      const std::int64_t area = stored_area<Surface_soup::Kernel::Point_2>(
          {begin[i], begin[(i + 1) % size], begin[(i + 2) % size]}, bits);
      wrong += atlas.is_turned[p] ? area >= 0 : area <= 0;
    }
  }
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(misnamed == 0u);
  const std::string note = "found no place on the grid of " + std::to_string(bits) +
                           " bits, the first is face " +
                           (named.empty() ? "" : std::to_string(*named.begin() + 1) + ":");
  BOOST_TEST(std::any_of(report.notes.begin(), report.notes.end(), [&note](const std::string& text) {
               return text.find(note) != std::string::npos;
             }) == !named.empty());
  return named.size();
}

Soup_options with_bits(const int bits)
{
  Soup_options options;
  options.quantization_bits = bits;
  return options;
}

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// One chart in the plane, with triangles between given points
struct Planar_chart
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, int> chart =
      mesh.add_property_map<Mesh::Face_index, int>("f:c", 0).first;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv =
      mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:u").first;

  Planar_chart(const std::vector<Point_2>& points, const std::vector<std::array<unsigned, 3>>& triangles)
  {
    for(const Point_2& p : points)
      mesh.add_vertex({p.x(), p.y(), 0});
    for(const auto& [i, j, k] : triangles)
      mesh.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(j), Mesh::Vertex_index(k));
    for(const auto h : mesh.halfedges())
      uv[h] = points[mesh.target(h)];
  }

  std::array<Point_2, 3> corners(const Mesh::Face_index f) const
  {
    const auto h = mesh.halfedge(f);
    return {uv[h], uv[mesh.next(h)], uv[mesh.next(mesh.next(h))]};
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(triangles_of_noisy_surfaces_keep_their_orientation)
{
  for(const auto& [bits, bumps] : {std::pair(10, 0.02), {12, 0.05}, {14, 0.1}, {16, 0.1}}) {
    const Surface_soup soup = bumpy_sphere(60, 30, bumps, false, 3);
    const std::size_t off = check_soup(soup, with_bits(bits));
    BOOST_TEST(off <= soup.number_of_polygons() / 200,
               off << " faces are off the grid of " << bits << " bits");
  }
}

BOOST_AUTO_TEST_CASE(quads_stay_convex)
{
  for(const int bits : {12, 16})
    BOOST_TEST(check_soup(bumpy_sphere(40, 20, 0.001, true, 4), with_bits(bits)) == 0u);
}

// Far more triangles than the grid has points for
BOOST_AUTO_TEST_CASE(faces_that_no_grid_holds_are_named)
{
  const Surface_soup soup = bumpy_sphere(200, 100, 0.01, false, 5);
  Soup_options options = with_bits(8);
  options.resolution = 32;
  options.gutter = 1;
  const std::size_t off = check_soup(soup, options);
  BOOST_TEST(off > 100u);
  BOOST_TEST(off < soup.number_of_polygons());
}

// A component, whose faces have other numbers in the soup, and charts that are given
BOOST_AUTO_TEST_CASE(parts_and_given_charts)
{
  Surface_soup soup = bumpy_sphere(10, 6, 0, false, 6);
  const Surface_soup large = bumpy_sphere(120, 60, 0.01, false, 7);
  const auto first = static_cast<Index>(soup.points.size());
  soup.points.insert(soup.points.end(), large.points.begin(), large.points.end());
  for(Index p = 0; p < large.number_of_polygons(); ++p)
    soup.add_polygon({first + large.vertices[3 * p], first + large.vertices[3 * p + 1],
                      first + large.vertices[3 * p + 2]});
  Soup_options options = with_bits(8);
  options.resolution = 64;
  options.component = 0;
  Soup_atlas atlas;
  const Soup_report report = make_atlas(soup, atlas, options);
  BOOST_TEST_REQUIRE(report.has_atlas(), report.message);
  BOOST_TEST_REQUIRE(!report.faces_off_grid.empty());
  for(const std::size_t p : report.faces_off_grid) {
    const auto* const corners = &atlas.uv[soup.first_corners[p]];
    BOOST_TEST(!std::all_of(corners, corners + 3, [](const auto& q) { return is_on_grid(q, 8); }));
  }

  const Surface_soup smooth = bumpy_sphere(40, 20, 0.01, false, 8);
  Soup_atlas before, after;
  BOOST_TEST_REQUIRE(bool(make_atlas(smooth, before)));
  Surface_soup given = smooth;
  given.texture = before.uv;
  for(Index c = 0; c < smooth.number_of_corners(); ++c)
    given.corner_texture.push_back(c);
  Soup_options keeps = with_bits(12);
  keeps.given_charts = Soup_options::KEEP;
  const Soup_report kept = make_atlas(given, after, keeps);
  BOOST_TEST_REQUIRE(bool(kept), kept.message);
  BOOST_TEST(kept.faces_off_grid.empty());
  BOOST_TEST(std::all_of(after.uv.begin(), after.uv.end(), [](const auto& q) { return is_on_grid(q, 12); }));
}

// Charts may be mirrored, and have triangles without area. Both stay as they are.
BOOST_AUTO_TEST_CASE(packed_charts_keep_their_orientation)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(0, 1);
  for(const double mirror : {1., -1.}) {
    const unsigned n = 40;
    std::vector<Point_2> points;
    std::vector<std::array<unsigned, 3>> triangles;
    for(unsigned i = 0; i <= n; ++i)
      for(unsigned j = 0; j <= n; ++j) {
        const bool is_flat = i < 2 && j < 2; // one triangle has no area
        points.emplace_back(mirror * (i + (is_flat ? 0 : 0.4 * unit(random))),
                            is_flat ? i : j + 0.4 * unit(random));
      }
    for(unsigned i = 0; i < n; ++i)
      for(unsigned j = 0; j < n; ++j) {
        const unsigned p = i * (n + 1) + j, q = p + n + 1;
        triangles.push_back({p, q, q + 1});
        triangles.push_back({p, q + 1, p + 1});
      }
    Planar_chart chart(points, triangles);
    std::vector<int> before;
    const auto sign_of = [](const std::array<Point_2, 3>& p) {
      return static_cast<int>(CGAL::orientation(p[0], p[1], p[2]));
    };
    for(const auto f : chart.mesh.faces())
      before.push_back(sign_of(chart.corners(f)));
    Packing_options options;
    options.resolution = 256;
    options.quantization_bits = 10;
    const auto report = TA::pack_charts(chart.mesh, chart.chart, chart.uv, options);
    BOOST_TEST_REQUIRE(bool(report), report.message);
    std::set<std::size_t> named(report.faces_off_grid.begin(), report.faces_off_grid.end());
    BOOST_TEST(named.size() < 20u);
    std::size_t wrong = 0, flat = 0;
    for(const auto f : chart.mesh.faces()) {
      const int sign = before[f.idx()];
      flat += sign == 0;
      if(sign != 0 && named.count(f.idx()) == 0)
        wrong += stored_area(chart.corners(f), 10) * sign <= 0;
    }
    BOOST_TEST(flat > 0u);
    BOOST_TEST(wrong == 0u);
  }
}

// Combs whose teeth are much nearer to each other than points of the grid are; the last one has several in each step.
BOOST_AUTO_TEST_CASE(narrow_gaps_stay_open)
{
  for(const auto& [teeth, width, gap] : {std::tuple(12u, 0.8, 0.2), {12u, 1., 1e-4}, {40u, 0.005, 0.005}}) {
    std::vector<Point_2> points;
    std::vector<std::array<unsigned, 3>> triangles;
    for(unsigned i = 0; i < teeth; ++i) {
      const double left = i * (width + gap), right = left + width;
      const unsigned p = 6 * i;
      for(const double y : {0., 1., 8.})
        points.insert(points.end(), {{left, y}, {right, y}});
      for(unsigned q = p; q < p + 4; q += 2)
        triangles.insert(triangles.end(), {{q, q + 1, q + 3}, {q, q + 3, q + 2}});
      if(i + 1 < teeth)
        triangles.insert(triangles.end(), {{p + 1, p + 6, p + 8}, {p + 1, p + 8, p + 3}});
    }
    Planar_chart chart(points, triangles);
    BOOST_TEST_REQUIRE(SMP::is_injective(chart.mesh, chart.uv));
    Packing_options options;
    options.resolution = 64;
    options.quantization_bits = 8;
    const auto report = TA::pack_charts(chart.mesh, chart.chart, chart.uv, options);
    BOOST_TEST_REQUIRE(bool(report), report.message);
    BOOST_TEST(report.faces_off_grid.empty() == (teeth == 12));
    BOOST_TEST(SMP::is_injective(chart.mesh, chart.uv));
  }
}

BOOST_AUTO_TEST_CASE(grids_that_are_too_coarse)
{
  Planar_chart chart({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  const auto message_of = [&](const int bits, const int resolution, const int gutter, const double texels) {
    Packing_options options;
    options.quantization_bits = bits;
    options.resolution = resolution;
    options.gutter = gutter;
    options.texels_per_unit = texels;
    const auto report = TA::pack_charts(chart.mesh, chart.chart, chart.uv, options);
    BOOST_TEST((report.status == Diagnosis::WRONG_OPTION) == !report.message.empty());
    return report.message;
  };
  const auto says = [](const std::string& message, const std::string& words) {
    return message.find(words) != std::string::npos;
  };
  BOOST_TEST(says(message_of(10, 1024, 1, 0), "; 12 bits suffice"));
  BOOST_TEST(message_of(12, 1024, 1, 0).empty());
  BOOST_TEST(says(message_of(11, 1024, 1, 0), "; 12 bits suffice"));
  BOOST_TEST(message_of(8, 64, 1, 0).empty());
  BOOST_TEST(says(message_of(16, 32768, 1, 0), "no grid of up to 16 bits suffices"));
  BOOST_TEST(message_of(16, 32768, 2, 0).empty());
  for(const int bits : {0, 7, 17})
    BOOST_TEST(says(message_of(bits, 64, 1, 0), "quantization_bits"));
  BOOST_TEST(says(message_of(12, 64, 1, 10), "quantization_bits and texels_per_unit"));
}

BOOST_AUTO_TEST_SUITE_END()
