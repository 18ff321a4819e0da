// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Polygons with more than three corners: how they are divided into triangles, whatever they are like, and that all
// programs can draw those that the output keeps.

#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/read_model.h"

#include "random_polygons.h"
#include "run_flatten_mesh.h"

#include <CGAL/Texture_atlas/internal/prepare/triangulate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <regex>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_polygons)

using namespace flatten_mesh;
using random_polygons::Kind;

namespace {

constexpr auto none_taken = [](Index, Index) { return false; };

std::vector<Kernel::Point_3> points_of(const std::vector<random_polygons::Point>& polygon)
{
  std::vector<Kernel::Point_3> points;
  for(const random_polygons::Point& p : polygon)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

// Two triangles less than corners, on both sides of each diagonal and one of each side, and they know what is beside.
bool is_triangulation(const Polygon_triangles& triangles, const Index size)
{
  std::set<std::array<Index, 2>> edges;
  bool is_good = triangles.size() + 2 == size;
  for(Index c = 0; c < triangles.corners.size(); ++c) {
    const auto corner = [&triangles](const Index d, const Index step) {
      return triangles.corners[d / 3 * 3 + (d + step) % 3];
    };
    const Index from = corner(c, 1), to = corner(c, 2), across = triangles.opposites[c];
    is_good = is_good && from < size && to < size && edges.insert({from, to}).second;
    is_good = is_good && (across == no_index ? (from + 1) % size == to
                                             : triangles.opposites[across] == c && corner(across, 1) == to &&
                                                   corner(across, 2) == from);
  }
  return is_good;
}

double area(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c)
{
  return CGAL::cross_product(b - a, c - a).z() / 2;
}

// The model of one polygon after the other
Model model_of(const std::vector<std::vector<Kernel::Point_3>>& polygons)
{
  Model model;
  for(const std::vector<Kernel::Point_3>& polygon : polygons) {
    for(const Kernel::Point_3& p : polygon) {
      model.vertices.push_back(static_cast<Index>(model.points.size()));
      model.points.push_back(p);
    }
    model.end_polygon();
  }
  return model;
}

// What other programs make of a file: fans from any corner
struct Fans
{
  explicit Fans(const Model& model)
  {
    for(Index p = 0; p < model.number_of_polygons(); ++p) {
      std::vector<Kernel::Point_2> polygon;
      for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c)
        if(model.texture_point(c) != no_index)
          polygon.push_back(model.texture[model.texture_point(c)]);
      without += polygon.size() != model.size(p);
      if(polygon.size() == model.size(p)) {
        kept += polygon.size() > 3;
        add(polygon);
      }
    }
  }

  void add(const std::vector<Kernel::Point_2>& polygon)
  {
    const std::size_t size = polygon.size();
    for(std::size_t first = 0; first < size; ++first) {
      for(std::size_t i = 1; i + 1 < size; ++i) {
        const std::array<Kernel::Point_2, 3> triangle = {polygon[first], polygon[(first + i) % size],
                                                         polygon[(first + i + 1) % size]};
        flips += CGAL::orientation(triangle[0], triangle[1], triangle[2]) != CGAL::LEFT_TURN;
        if(first == 0)
          triangles.push_back(triangle);
      }
    }
  }

  using Triangle = std::array<Kernel::Point_2, 3>;

  // Whether a side of the first triangle has the second on its other side
  static bool is_beside(const Triangle& s, const Triangle& t)
  {
    for(std::size_t i = 0; i < 3; ++i)
      if(std::none_of(t.begin(), t.end(), [&](const Kernel::Point_2& p) {
           return CGAL::orientation(s[i], s[(i + 1) % 3], p) == CGAL::LEFT_TURN;
         }))
        return true;
    return false;
  }

  std::size_t overlaps() const
  {
    std::size_t count = 0;
    for(auto s = triangles.begin(); s != triangles.end(); ++s)
      for(auto t = triangles.begin(); t != s; ++t)
        count += !is_beside(*s, *t) && !is_beside(*t, *s);
    return count;
  }

  std::size_t flips = 0, kept = 0, without = 0; // kept: larger polygons. Without coordinates
  std::vector<Triangle> triangles;
};

struct Program : public Folder
{
  Model read(const std::string& name) { return read_model(file(name), Degenerate_faces::KEPT, notes); }

  // Returns how many larger polygons are kept.
  std::size_t check(const std::string& input, const std::string& output, const std::string& options)
  {
    run(quoted(input) + " --output " + quoted(file(output)) + " " + options);
    BOOST_TEST_REQUIRE(status == 0, standard_error);
    const Fans fans(read(output));
    BOOST_TEST(fans.without == 0);
    BOOST_TEST(fans.flips == 0);
    BOOST_TEST(fans.overlaps() == 0);
    return fans.kept;
  }

  Command_line command;
  Notes notes = notes_of(command);
};

// The number that a note names, as in "3 polygons divided" and "3 divided"
std::size_t number_before(const std::string& text, const std::string& word)
{
  std::smatch match;
  return std::regex_search(text, match, std::regex("(\\d+)( polygons?)? " + word)) ? std::stoul(match[1]) : 0;
}

} // namespace

BOOST_AUTO_TEST_CASE(any_polygon_becomes_triangles_at_all_corners)
{
  random_polygons::Random random(1);
  for(int i = 0; i < 10000; ++i) {
    const auto points = points_of(random_polygons::polygon(static_cast<Kind>(i % 4), random));
    BOOST_TEST_REQUIRE(
        is_triangulation(triangulate_polygon(points, none_taken), static_cast<Index>(points.size())),
        "polygon " << i);
  }
}

// And those of Delaunay: the angles opposite to a diagonal that can be flipped are at most 180 degrees together.
BOOST_AUTO_TEST_CASE(triangles_are_inside_of_simple_polygons)
{
  random_polygons::Random random(2);
  for(int i = 0; i < 1000; ++i) {
    const auto points = points_of(random_polygons::polygon(Kind::STAR, random));
    const auto size = static_cast<Index>(points.size());
    const Polygon_triangles triangles = triangulate_polygon(points, none_taken);
    double sum = 0, expected = 0;
    for(Index t = 0; t < triangles.size(); ++t) {
      const auto corner = [&](const Index k) { return points[triangles.corners[3 * t + k]]; };
      const double a = area(corner(0), corner(1), corner(2));
      BOOST_TEST(a > 0);
      sum += a;
    }
    for(Index k = 0; k < size; ++k)
      expected += area(Kernel::Point_3(0, 0, 5), points[k], points[(k + 1) % size]);
    BOOST_TEST(std::abs(sum - expected) < 1e-12);
    for(Index c = 0; c < triangles.corners.size() && size > 4; ++c) {
      const Index o = triangles.opposites[c];
      if(o == no_index)
        continue;
      const auto corner = [&](const Index d, const Index step) {
        const Kernel::Point_3& p = points[triangles.corners[d / 3 * 3 + (d + step) % 3]];
        return Kernel::Point_2(p.x(), p.y());
      };
      const Kernel::Point_2 p = corner(c, 0), q = corner(c, 1), r = corner(c, 2), s = corner(o, 0);
      const bool can_be_flipped = CGAL::left_turn(p, q, s) && CGAL::left_turn(s, r, p);
      const double angles =
          std::abs(CGAL::to_double(CGAL::approximate_angle(Kernel::Point_3(q.x(), q.y(), 0),
                                                           Kernel::Point_3(p.x(), p.y(), 0),
                                                           Kernel::Point_3(r.x(), r.y(), 0)))) +
          std::abs(CGAL::to_double(CGAL::approximate_angle(Kernel::Point_3(r.x(), r.y(), 0),
                                                           Kernel::Point_3(s.x(), s.y(), 0),
                                                           Kernel::Point_3(q.x(), q.y(), 0))));
      BOOST_TEST((!can_be_flipped || angles < 180 + 1e-5));
    }
  }
}

// Sides with corners on them and a hole that is joined by a bridge, in a plane that is no coordinate plane
BOOST_AUTO_TEST_CASE(straight_runs_and_bridges_take_no_flat_triangles)
{
  std::vector<Kernel::Point_3> points;
  const auto add = [&points](const double x, const double y) { points.emplace_back(x, y, 3 * x - 5 * y); };
  for(const auto& [x, y] : std::vector<std::array<double, 2>>{
          {0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 1}, {4, 3}, {4, 4}, {1, 4}, {0, 4}, {0, 3}, {0, 2}})
    add(x, y);
  for(const auto& [x, y] : std::vector<std::array<double, 2>>{
          {1, 1}, {1, 2}, {1, 3}, {3, 3}, {3, 2}, {3, 1}, {2, 1}, {1, 1}, {0, 2}})
    add(x, y); // the hole runs the other way
  const auto size = static_cast<Index>(points.size());
  const Polygon_triangles triangles = triangulate_polygon(points, none_taken);
  BOOST_TEST(is_triangulation(triangles, size));
  double sum = 0;
  for(Index t = 0; t < triangles.size(); ++t) {
    const auto corner = [&](const Index k) { return points[triangles.corners[3 * t + k]]; };
    const double a = area(corner(0), corner(1), corner(2));
    BOOST_TEST(a > 0);
    sum += a;
  }
  BOOST_TEST(sum == 12); // of 16, less 4
}

BOOST_AUTO_TEST_CASE(polygons_may_have_very_many_corners)
{
  std::vector<Kernel::Point_3> circle, knot;
  const Index size = 100000;
  for(Index i = 0; i < size; ++i) {
    const double turn = 2 * CGAL_PI * i / size;
    circle.emplace_back(std::cos(turn), std::sin(turn), std::cos(turn));
    knot.emplace_back(std::cos(7 * turn), std::sin(3 * turn), std::cos(2 * turn));
  }
  for(const auto& points : {circle, knot})
    BOOST_TEST(is_triangulation(triangulate_polygon(points, none_taken), size));
}

BOOST_AUTO_TEST_CASE(coordinates_may_be_very_large_or_small)
{
  random_polygons::Random random(3);
  for(const double factor : {1e300, 1e-300, 5e-324}) {
    for(int i = 0; i < 100; ++i) {
      std::vector<Kernel::Point_3> points;
      for(const random_polygons::Point& p : random_polygons::polygon(static_cast<Kind>(i % 4), random))
        points.emplace_back(factor * p[0], factor * p[1], factor * p[2]);
      BOOST_TEST(
          is_triangulation(triangulate_polygon(points, none_taken), static_cast<Index>(points.size())));
    }
  }
}

// All triangulations of pentagons are fans.
BOOST_AUTO_TEST_CASE(taken_diagonals_are_avoided)
{
  random_polygons::Random random(4);
  for(int i = 0; i < 3000; ++i) {
    const auto points = points_of(random_polygons::polygon(static_cast<Kind>(i % 4), random));
    const auto size = static_cast<Index>(points.size());
    std::set<std::array<Index, 2>> taken;
    for(int k = random.below(6); k > 0; --k) {
      const auto v = static_cast<Index>(random.below(static_cast<int>(size))),
                 w = static_cast<Index>(random.below(static_cast<int>(size)));
      taken.insert({v, w});
      taken.insert({w, v});
    }
    const auto is_taken = [&taken](const Index v, const Index w) { return taken.count({v, w}) > 0; };
    const Polygon_triangles triangles = triangulate_polygon(points, is_taken);
    bool has_free_fan = false;
    for(Index v = 0; v < size; ++v) {
      bool is_free = true;
      for(Index step = 2; step + 1 < size; ++step)
        is_free = is_free && !is_taken(v, (v + step) % size);
      has_free_fan = has_free_fan || is_free;
    }
    if(triangles.corners.empty()) {
      BOOST_TEST(!has_free_fan);
      continue;
    }
    BOOST_TEST(is_triangulation(triangles, size));
    for(Index c = 0; c < triangles.corners.size(); ++c) {
      if(triangles.opposites[c] != no_index) {
        const Index t = c / 3 * 3;
        BOOST_TEST(!is_taken(triangles.corners[t + (c + 1) % 3], triangles.corners[t + (c + 2) % 3]));
      }
    }
  }
}

// As surfaces, all together
BOOST_AUTO_TEST_CASE(all_polygons_of_a_model_have_their_triangles)
{
  random_polygons::Random random(5);
  std::vector<std::vector<Kernel::Point_3>> polygons;
  for(int i = 0; i < 10000; ++i)
    polygons.push_back(points_of(random_polygons::polygon(static_cast<Kind>(i % 4), random)));
  Command_line command;
  command.quiet = true;
  Notes notes = notes_of(command);
  const Model model = model_of(polygons);
  const Atlas_input input = atlas_input_of(model, false, notes);
  BOOST_TEST(input.set_aside.empty());
  std::vector<Index> triangles(polygons.size(), 0);
  for(const Index p : polygons_of_faces(input.model, input.mesh, input.origins))
    ++triangles[p];
  std::set<Index> corners;
  for(const Halfedge h : input.mesh.halfedges()) {
    const Index corner = input.origins.corners[h.idx()];
    BOOST_TEST_REQUIRE((corner == no_index) == input.mesh.is_border(h));
    if(corner != no_index) {
      corners.insert(corner);
      BOOST_TEST_REQUIRE(input.mesh.point(input.mesh.target(h)) == model.points[model.vertices[corner]]);
    }
  }
  std::size_t expected = 0;
  for(std::size_t p = 0; p < polygons.size(); ++p) {
    const bool has_no_area = !input.origins.has_no_area.empty() && input.origins.has_no_area[p];
    BOOST_TEST_REQUIRE(triangles[p] == (has_no_area ? 0 : polygons[p].size() - 2));
    expected += has_no_area ? 0 : polygons[p].size();
  }
  BOOST_TEST(corners.size() == expected);
}

namespace {

// A quadrangle both of whose diagonals are edges of triangles
const char* const surrounded = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 -1 1\nv 2 0 2\nv 1 2 -1\n"
                               "f 1 2 3 4\nf 2 1 5\nf 5 1 3\nf 3 2 6\nf 5 3 6\nf 6 2 4\nf 4 3 7\nf 6 4 7\n";

} // namespace

BOOST_FIXTURE_TEST_CASE(a_polygon_whose_diagonals_are_taken_is_named, Program)
{
  const std::string input = write("surrounded.obj", surrounded);
  run(quoted(input) + " --output " + quoted(file("flat.obj")) + " --json " + quoted(file("flat.json")));
  BOOST_TEST(status == 2);
  asks_for_json = true;
  const auto skipped = json().get_child("skipped");
  BOOST_TEST_REQUIRE(skipped.size() == 1u);
  BOOST_TEST(skipped.front().second.get<int>("first_face") == 1);
  BOOST_TEST(skipped.front().second.get<std::string>("diagnosis") == "UNDIVIDED_FACE");
  const Fans fans(read("flat.obj"));
  BOOST_TEST(fans.without == 1);
  BOOST_TEST(fans.flips == 0);
  run(quoted(input) + " --plain --output " + quoted(file("plain.obj")));
  BOOST_TEST(status == 2);
  BOOST_TEST(standard_error.find("face 1 cannot be divided") != std::string::npos, standard_error);
}

BOOST_FIXTURE_TEST_CASE(polygons_that_were_lost_are_kept, Program)
{
  const std::vector<std::string> models = {
      "v 21 0 1\nv 22 0 1\nv 20 0 1\nv 22 2 1\nv 21 1 0\nv 21 2 1\nf 1 2 3 4 5 6\n",
      "v 140 1 1\nv 142 1 0\nv 140 2 0\nv 142 1 1\nv 140 2 1\nf 1 2 3 4 5\n",
      "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\nv .5 .5 -1\nf 1 2 3 4 5\n"};
  for(const std::string& model : models) {
    const std::string input = write("polygon.obj", model);
    for(const std::string options : {"", "--plain", "--for few-charts"})
      for(const std::string output : {"flat.obj", "flat.ply"})
        check(input, output, options);
  }
}

BOOST_FIXTURE_TEST_CASE(all_readers_draw_the_same, Program)
{
  std::size_t divided = 0, mended = 0;
  for(const double noise : {0.05, 0.15, 0.3}) {
    const random_polygons::Animal animal(noise > 0.1 ? 2 : 1, noise);
    const std::string input = write("animal.obj", animal.text());
    for(const std::string options : {"", "--for few-charts", "--plain --injective"}) {
      for(const std::string output : {"flat.obj", "flat.ply"}) {
        const std::size_t kept = check(input, output, options),
                          told = number_before(standard_error, "divided into triangles");
        BOOST_TEST(kept + told == animal.polygons.size());
        divided += told;
        mended += number_before(standard_error, "made convex");
      }
    }
  }
  BOOST_TEST(divided > 0u);
  BOOST_TEST(mended > 0u);
}

// A prism with caps
BOOST_FIXTURE_TEST_CASE(caps_with_720_corners_are_drawn_alike, Program)
{
  std::ostringstream text;
  text.precision(17);
  const int size = 720;
  for(int i = 0; i < size; ++i) {
    for(const int z : {0, 1}) {
      text << "v " << std::cos(2 * CGAL_PI * i / size) << ' ' << std::sin(2 * CGAL_PI * i / size) << ' ' << z
           << '\n';
    }
  }
  for(int i = 0; i < size; ++i) {
    const int next = (i + 1) % size;
    text << "f " << 2 * i + 1 << ' ' << 2 * next + 1 << ' ' << 2 * next + 2 << ' ' << 2 * i + 2 << '\n';
  }
  for(const int z : {0, 1}) {
    text << 'f';
    for(int i = 0; i < size; ++i)
      text << ' ' << 2 * (z == 1 ? i : size - 1 - i) + 1 + z;
    text << '\n';
  }
  const std::string input = write("prism.obj", text.str());
  for(const std::string output : {"flat.obj", "flat.ply"})
    check(input, output, "--for conformal");
}

BOOST_AUTO_TEST_SUITE_END()
