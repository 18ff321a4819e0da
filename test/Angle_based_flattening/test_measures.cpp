// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures of a map, compared with closed forms where they exist, and otherwise with other formulas in 50 digits.

#include <boost/test/unit_test.hpp>
#include <boost/test/data/test_case.hpp>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include "reference_measures.h"
#include "test_charts.h"
#include "test_meshes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <set>
#include <thread>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_measures)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Measured measure(const Chart& chart, const std::vector<Point_2>& uv)
{
  Measured measured;
  measured.map = abf::measure_chart(chart, uv, [&](int t, const Face_measures& face) {
    BOOST_TEST(t == static_cast<int>(measured.faces.size()));
    measured.faces.push_back(face);
  });
  BOOST_TEST(static_cast<int>(measured.faces.size()) == chart.number_of_triangles());
  return measured;
}

void check(double value, double expected)
{
  const bool is_close = value == expected || // infinities
                        std::abs(value - expected) <= 1e-12 * (std::max)(1., std::abs(expected));
  BOOST_TEST(is_close, value << " is not " << expected);
}

// The measures that do not depend on the direction of the axes.
const std::vector<double Measures::*> invariants{&Measures::angular_distortion,
                                                 &Measures::l2_stretch,
                                                 &Measures::linf_stretch,
                                                 &Measures::l2_principal_shear,
                                                 &Measures::mean_quasi_conformal_ratio,
                                                 &Measures::max_quasi_conformal_ratio,
                                                 &Measures::l2_area_distortion,
                                                 &Measures::symmetric_dirichlet_energy,
                                                 &Measures::smallest_angle};

// (u, v) = (a x + b y, c x + d y)
struct Linear_map
{
  const char* name;
  double a, b, c, d;
  double quasi_conformal_ratio, shear, equal_stretch_error; // expected

  std::vector<Point_2> of(const std::vector<Point_2>& points) const
  {
    std::vector<Point_2> image;
    for(const Point_2& p : points)
      image.emplace_back(a * p.x() + b * p.y(), c * p.x() + d * p.y());
    return image;
  }
};

std::ostream& operator<<(std::ostream& out, const Linear_map& map)
{
  return out << map.name;
}

// The derivatives of the inverses are: of the shear (1, 0) and (-1, 1), of the scaling by 2 and 1/2 (1/2, 0) and
// (0, 2); turned by 45 degrees, this stretches both axes alike.
const std::vector<Linear_map> linear_maps{
    {"identity", 1, 0, 0, 1, 1, 0, 0},
    {"isometry", 0.6, -0.8, 0.8, 0.6, 1, 0, 0},
    {"similarity", 3, -4, 4, 3, 1, 0, 0},
    {"mirror", 0.6, 0.8, 0.8, -0.6, 1, 0, 0},
    {"shear", 1, 1, 0, 1, (3 + std::sqrt(5.)) / 2, std::sqrt(0.5), 1. / 3},
    {"scaling", 2, 0, 0, 0.5, 4, 0, 15. / 17},
    {"mirrored scaling", -2, 0, 0, 0.5, 4, 0, 15. / 17},
    {"scaling along diagonals", 1.25, 0.75, 0.75, 1.25, 4, 15. / 17, 0},
    {"strong scaling", 1e6, 0, 0, 1, 1e6, 0, (1 - 1e-12) / (1 + 1e-12)},
};

} // namespace

BOOST_DATA_TEST_CASE(of_linear_maps, boost::unit_test::data::make(linear_maps), map)
{
  const Chart chart = flat_grid(6, 8);
  const Measured measured = measure(chart, map.of(projected(chart)));
  const bool flips = map.a * map.d < map.b * map.c;
  // With equal areas, the singular values are the root of their ratio and its inverse.
  const double ratio = map.quasi_conformal_ratio;
  const double l2_stretch = std::sqrt((ratio + 1 / ratio) / 2);
  const double linf_stretch = std::sqrt(ratio);
  const double principal_shear = (ratio * ratio - 1) / (ratio * ratio + 1);
  const double dirichlet = 2 * (ratio + 1 / ratio);

  for(const Face_measures& face : measured.faces) {
    check(face.l2_stretch, l2_stretch);
    check(face.linf_stretch, linf_stretch);
    check(face.shear, map.shear);
    check(face.principal_shear, principal_shear);
    check(face.equal_stretch_error, map.equal_stretch_error);
    check(face.quasi_conformal_ratio, ratio);
    check(face.area_distortion, 0);
    check(face.symmetric_dirichlet_energy, dirichlet);
    BOOST_TEST(face.flipped == flips);
  }
  check(measured.map.l2_stretch, l2_stretch);
  check(measured.map.linf_stretch, linf_stretch);
  check(measured.map.l2_shear, map.shear);
  check(measured.map.l2_principal_shear, principal_shear);
  check(measured.map.l2_equal_stretch_error, map.equal_stretch_error);
  check(measured.map.mean_quasi_conformal_ratio, ratio);
  check(measured.map.max_quasi_conformal_ratio, ratio);
  check(measured.map.l2_area_distortion, 0);
  check(measured.map.symmetric_dirichlet_energy, dirichlet);
  BOOST_TEST(measured.map.flipped_triangles == (flips ? chart.number_of_triangles() : 0));
  BOOST_TEST(measured.map.border_is_simple);
  if(ratio == 1)
    BOOST_TEST(measured.map.angular_distortion < 1e-24);
}

// Equilateral in space, right-angled and isosceles in the plane: 45, 45 and 90 degrees instead of 60.
BOOST_AUTO_TEST_CASE(angles_of_one_triangle)
{
  const Chart chart = make_chart({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}, {{0, 1, 2}});
  const Measured measured = measure(chart, {{2, 1}, {5, 1}, {2, 4}});
  check(measured.map.angular_distortion, (2. / 16 + 1. / 4) / 3);
  check(measured.faces[0].angular_distortion, (2. / 16 + 1. / 4) / 3);
  check(measured.map.smallest_angle, CGAL_PI / 4);
  check(measured.faces[0].smallest_angle, CGAL_PI / 4);
}

BOOST_AUTO_TEST_SUITE(of_surfaces)

namespace {

// A cone over a regular polygon, cut open along a ray from its apex, with vertices anywhere on the rays; it is
// developable, and `unrolled` is isometric.
struct Cone
{
  Cone(int rays, int rings, double height)
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-0.3, 0.3);
    const double slant = std::hypot(1, height), between = 2 * CGAL_PI / rays;
    const double angle = std::acos((std::cos(between) + height * height) / (slant * slant));
    std::vector<Point_3> points{Point_3(0, 0, 0)};
    unrolled.emplace_back(0, 0);
    for(int i = 0; i <= rays; ++i)
      for(int j = 1; j <= rings; ++j) {
        const double r = i < rays ? j + jitter(random) : j;
        points.emplace_back(r * std::cos(i * between), r * std::sin(i * between), -r * height);
        unrolled.emplace_back(r * slant * std::cos(i * angle), r * slant * std::sin(i * angle));
      }
    Triangles triangles;
    for(int i = 0; i < rays; ++i)
      for(int j = 0; j < rings; ++j) {
        const int a = j == 0 ? 0 : i * rings + j, b = i * rings + j + 1, c = b + rings, d = a + rings;
        triangles.push_back({a, b, c});
        if(j > 0)
          triangles.push_back({a, c, d});
      }
    chart = make_chart(points, triangles);
  }

  Chart chart;
  std::vector<Point_2> unrolled;
};

// The part of the unit sphere whose stereographic projection from the north pole is a disk.
struct Cap
{
  Cap(int rings, double radius)
  {
    const int sectors = 8 * rings;
    std::vector<Point_3> points;
    const auto add = [&](double u, double v) {
      const double w = 1 + u * u + v * v;
      projected.emplace_back(u, v);
      points.emplace_back(2 * u / w, 2 * v / w, 1 - 2 / w);
    };
    add(0, 0);
    for(int j = 1; j <= rings; ++j)
      for(int i = 0; i < sectors; ++i) {
        const double r = radius * j / rings, angle = 2 * CGAL_PI * i / sectors;
        add(r * std::cos(angle), r * std::sin(angle));
      }
    Triangles triangles;
    for(int i = 0; i < sectors; ++i)
      for(int j = 0; j < rings; ++j) {
        const int next = (i + 1) % sectors, ring = 1 + sectors * j, inner = ring - sectors;
        if(j == 0)
          triangles.push_back({0, ring + i, ring + next});
        else {
          triangles.push_back({inner + i, ring + i, ring + next});
          triangles.push_back({inner + i, ring + next, inner + next});
        }
      }
    chart = make_chart(points, triangles);
  }

  Chart chart;
  std::vector<Point_2> projected;
};

void check_against_reference(const Chart& chart, const std::vector<Point_2>& uv)
{
  const Measured measured = measure(chart, uv), expected = Reference_measures(chart, uv).measured();
  for(std::size_t t = 0; t < measured.faces.size(); ++t)
    for(double Face_measures::*value :
        {&Face_measures::area, &Face_measures::angular_distortion, &Face_measures::l2_stretch,
         &Face_measures::linf_stretch, &Face_measures::shear, &Face_measures::principal_shear,
         &Face_measures::equal_stretch_error, &Face_measures::quasi_conformal_ratio,
         &Face_measures::area_distortion, &Face_measures::symmetric_dirichlet_energy,
         &Face_measures::smallest_angle})
      check(measured.faces[t].*value, expected.faces[t].*value);
  for(double Measures::*value : invariants)
    check(measured.map.*value, expected.map.*value);
  check(measured.map.l2_shear, expected.map.l2_shear);
  check(measured.map.l2_equal_stretch_error, expected.map.l2_equal_stretch_error);
  BOOST_TEST(measured.map.flipped_triangles == 0);
}

} // namespace

BOOST_AUTO_TEST_CASE(unrolled_cone)
{
  const Cone cone(7, 5, 0.8);
  const Measures measures = measure(cone.chart, cone.unrolled).map;
  check(measures.l2_stretch, 1);
  check(measures.linf_stretch, 1);
  check(measures.l2_shear, 0);
  check(measures.l2_principal_shear, 0);
  check(measures.l2_equal_stretch_error, 0);
  check(measures.mean_quasi_conformal_ratio, 1);
  check(measures.max_quasi_conformal_ratio, 1);
  check(measures.l2_area_distortion, 0);
  check(measures.symmetric_dirichlet_energy, 4);
  BOOST_TEST(measures.angular_distortion < 1e-24);
  BOOST_TEST(measures.flipped_triangles == 0);
}

BOOST_AUTO_TEST_CASE(stereographic_cap_triangle_by_triangle)
{
  const Cap cap(6, 1.5);
  check_against_reference(cap.chart, cap.projected);
}

BOOST_AUTO_TEST_CASE(projected_bump_triangle_by_triangle)
{
  const Chart chart = bump(8, 3, 1);
  check_against_reference(chart, projected(chart));
}

// To the smooth cap, whose projection stretches by 2 / (1 + r^2) and whose area is 4 pi (1 - 1/w) with w = 1 + R^2,
// the measures converge with the square of the edges' length.
BOOST_AUTO_TEST_CASE(stereographic_cap_converges)
{
  const double radius = 1.5, w = 1 + radius * radius, l = std::log(w);
  const double squared_stretch = (w + 1 + 1 / w) / 3;
  Measures expected;
  expected.l2_stretch = std::sqrt(squared_stretch);
  expected.linf_stretch = std::sqrt(w); // at the pole
  expected.l2_area_distortion = std::sqrt(((l * l - 4 * l + 8) - (l * l + 4 * l + 8) / w) / (1 - 1 / w));
  expected.symmetric_dirichlet_energy = 2 * (squared_stretch + 1);
  const Cap coarse(10, radius), fine(20, radius);
  const Measures of_coarse = measure(coarse.chart, coarse.projected).map,
                 of_fine = measure(fine.chart, fine.projected).map;
  for(double Measures::*value : {&Measures::l2_stretch, &Measures::linf_stretch,
                                 &Measures::l2_area_distortion, &Measures::symmetric_dirichlet_energy}) {
    const double limit = expected.*value, at_fine = of_fine.*value;
    const double quotient = (of_coarse.*value - limit) / (at_fine - limit);
    BOOST_TEST(quotient > 3.7);
    BOOST_TEST(quotient < 4.3);
    BOOST_TEST(at_fine == limit, boost::test_tools::tolerance(1e-2));
  }
  BOOST_TEST(of_coarse.l2_principal_shear / of_fine.l2_principal_shear > 1.9); // conformal
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(invariance)

BOOST_AUTO_TEST_CASE(under_similarities)
{
  const Chart chart = bump(10, 4, 1);
  const std::vector<Point_2> uv = projected(chart);
  const Measures before = measure(chart, uv).map;
  const auto after = [&](double a, double b) { // of the plane
    std::vector<Point_2> image;
    for(const Point_2& p : uv)
      image.emplace_back(a * p.x() - b * p.y() + 3, b * p.x() + a * p.y() - 2);
    return measure(chart, image).map;
  };
  const Measures turned = after(17 * std::cos(0.7), 17 * std::sin(0.7));
  for(double Measures::*value : invariants)
    check(turned.*value, before.*value);
  BOOST_TEST(std::abs(turned.l2_shear - before.l2_shear) > 1e-3);
  BOOST_TEST(std::abs(turned.l2_equal_stretch_error - before.l2_equal_stretch_error) > 1e-3);
  for(const Measures& same : {after(0.01, 0), after(0, 3)}) { // a scaling and a quarter turn
    check(same.l2_shear, before.l2_shear);
    check(same.l2_equal_stretch_error, before.l2_equal_stretch_error);
  }
}

BOOST_AUTO_TEST_CASE(principal_shear_is_the_largest)
{
  const Chart chart = make_chart({{0, 0, 0}, {1, 0, 0.3}, {0.2, 1.5, 0}}, {{0, 1, 2}});
  const std::vector<Point_2> uv{{0, 0}, {2, 0.5}, {-0.3, 1}};
  double largest = 0;
  for(int i = 0; i < 3600; ++i) {
    const double angle = CGAL_PI * i / 3600;
    const Linear_map turn{"", std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 0, 0, 0};
    const Measures measures = measure(chart, turn.of(uv)).map;
    largest = (std::max)(largest, measures.l2_shear);
    check(measures.l2_principal_shear, measure(chart, uv).map.l2_principal_shear);
  }
  BOOST_TEST(largest == measure(chart, uv).map.l2_principal_shear, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_SUITE_END()

// Enough triangles for several batches, and a last block that is not full. Without TBB there is one thread only.
BOOST_AUTO_TEST_CASE(same_bits_whatever_the_number_of_threads)
{
  const Chart chart = bump(190, 7);
  std::vector<Point_2> uv = projected(chart);
  uv[1000] = uv[5000]; // flips some
  std::vector<Measured> measured;
  for(int threads : {1, 2, 3, 0})
    abf::with_threads(threads, [&]() { measured.push_back(measure(chart, uv)); });
  BOOST_TEST(chart.number_of_triangles() > 64 * abf::block_size);
  BOOST_TEST(measured[0].map.flipped_triangles > 0);
  for(const Measured& other : measured) {
    for(double Measures::*total : {&Measures::l2_shear, &Measures::l2_equal_stretch_error})
      BOOST_TEST((other.map.*total) == (measured[0].map.*total));
    for(double Measures::*total : invariants)
      BOOST_TEST((other.map.*total) == (measured[0].map.*total));
    BOOST_TEST(other.map.flipped_triangles == measured[0].map.flipped_triangles);
    BOOST_TEST((std::equal(other.faces.begin(), other.faces.end(), measured[0].faces.begin(),
                           [](const Face_measures& a, const Face_measures& b) {
                             return a.area == b.area && a.angular_distortion == b.angular_distortion &&
                                    a.l2_stretch == b.l2_stretch && a.flipped == b.flipped;
                           })));
  }
}

// The visitor is called by the caller's thread, because property maps need not be thread-safe.
BOOST_AUTO_TEST_CASE(faces_are_visited_by_one_thread)
{
  const Chart chart = bump(190, 7);
  std::set<std::thread::id> threads;
  abf::measure_chart(chart, projected(chart),
                     [&](int, const Face_measures&) { threads.insert(std::this_thread::get_id()); });
  BOOST_TEST((threads == std::set<std::thread::id>{std::this_thread::get_id()}));
}

BOOST_AUTO_TEST_SUITE(borders)

namespace {

// A strip of a spiral staircase of radii 1 and 2, `turns` times around.
Chart staircase(double turns)
{
  const int steps = 40;
  std::vector<Point_3> points;
  Triangles triangles;
  for(int i = 0; i <= steps; ++i) {
    const double angle = 2 * CGAL_PI * turns * i / steps;
    for(const double radius : {1., 2.})
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), angle);
    if(i > 0) {
      triangles.push_back({2 * i - 2, 2 * i - 1, 2 * i + 1});
      triangles.push_back({2 * i - 2, 2 * i + 1, 2 * i});
    }
  }
  return make_chart(points, triangles);
}

Chart square_with_hole()
{
  std::vector<Point_3> points;
  for(const double r : {4., 2.})
    for(const auto& [x, y] : {std::make_pair(-r, -r), {r, -r}, {r, r}, {-r, r}})
      points.emplace_back(x, y, 0);
  Triangles triangles;
  for(int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    triangles.push_back({i, next, next + 4});
    triangles.push_back({i, next + 4, i + 4});
  }
  const Chart chart = make_chart(points, triangles);
  BOOST_TEST(chart.borders.size() == 2u);
  return chart;
}

// The lower left corner of the hole is `corner` in the plane.
Measures with_hole(const Point_2& corner)
{
  const Chart chart = square_with_hole();
  std::vector<Point_2> uv = projected(chart);
  uv[4] = corner;
  return measure(chart, uv).map;
}

// The border and the hole may be mirrored.
Measures with_mirrored_borders(bool outer, bool inner)
{
  const Chart chart = square_with_hole();
  std::vector<Point_2> uv = projected(chart);
  for(int v = 0; v < 8; ++v)
    if(v < 4 ? outer : inner)
      uv[v] = Point_2(-uv[v].x(), uv[v].y());
  return measure(chart, uv).map;
}

} // namespace

BOOST_AUTO_TEST_CASE(overlaps_without_flips)
{
  for(const double turns : {0.9, 1.1}) {
    const Chart chart = staircase(turns);
    const Measures measures = measure(chart, projected(chart)).map;
    BOOST_TEST(measures.flipped_triangles == 0);
    BOOST_TEST(measures.border_is_simple == (turns < 1));
  }
}

BOOST_AUTO_TEST_CASE(of_holes)
{
  const double ulp = 4 * std::numeric_limits<double>::epsilon();
  BOOST_TEST(with_hole({-2, -2}).border_is_simple);
  BOOST_TEST(with_hole({-2, -4 + ulp}).border_is_simple);
  BOOST_TEST(!with_hole({-2, -4}).border_is_simple); // touches the other border
  BOOST_TEST(!with_hole({-2, -5}).border_is_simple);
  BOOST_TEST(!with_hole({3, -2}).border_is_simple); // crosses itself
  for(const bool outer : {false, true})
    for(const bool inner : {false, true})
      BOOST_TEST(with_mirrored_borders(outer, inner).border_is_simple == (outer == inner));
}

BOOST_AUTO_TEST_CASE(of_collapsed_and_infinite_points)
{
  const Chart one = make_chart({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  BOOST_TEST(!measure(one, {{0, 0}, {1, 0}, {0, 0}}).map.border_is_simple);
  BOOST_TEST(!measure(one, {{0, 0}, {1, 0}, {2, 0}}).map.border_is_simple);
  const Measures measures = measure(one, {{0, 0}, {1, 0}, {0, infinity}}).map;
  BOOST_TEST(!measures.border_is_simple);
  BOOST_TEST(measures.flipped_triangles == 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(own_angles)

namespace {

// Two right triangles with legs of 1, and of `size`, side by side; only one of them becomes equilateral in the plane.
Measures one_becomes_equilateral(double size, bool small_one)
{
  const Chart chart =
      make_chart({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -size, 0}, {size, -size, 0}}, {{0, 1, 2}, {3, 4, 0}});
  const double height = std::sqrt(0.75);
  const Point_2 tip = small_one ? Point_2(0.5, height) : Point_2(0, 1),
                end = small_one ? Point_2(0, 0) : Point_2(size / 2, size * height - size);
  std::vector<Point_2> uv{{0, 0}, {1, 0}, tip, {0, -size}, {size, -size}};
  if(!small_one)
    for(int v : {0, 1, 2})
      uv[v] = Point_2(uv[v].x() + end.x(), uv[v].y() + end.y());
  return measure(chart, uv).map;
}

} // namespace

BOOST_AUTO_TEST_CASE(by_area_and_by_corner)
{
  const double degree = std::acos(-1.) / 180;
  const double mean = (30 + 15 + 15) * degree / 3, rms = std::sqrt((900 + 225 + 225) / 3.) * degree;
  for(bool small_one : {true, false}) {
    const double size = 7, weight = small_one ? 1 / 50. : 49 / 50.;
    const Measures measures = one_becomes_equilateral(size, small_one);
    check(measures.mean_angle_change, weight * mean);
    check(measures.rms_angle_change, std::sqrt(weight) * rms);
    check(measures.mean_corner_angle_change, mean / 2);
    check(measures.rms_corner_angle_change, rms / std::sqrt(2.));
    const double ratio = std::sqrt(3.); // of the shear that makes a right triangle equilateral
    check(measures.max_quasi_conformal_ratio, ratio);
    check(measures.quasi_conformal_ratio_95, small_one ? 1 : ratio);
    check(measures.max_scale / measures.min_scale, 1 / std::pow(0.75, 0.25));
  }
}

// The energy compares with angles that sum to 2 pi: on a steep cone it can be small although the angles change a lot.
BOOST_AUTO_TEST_CASE(energy_does_not_tell_of_a_steep_cone)
{
  const int n = 12;
  std::vector<Point_3> points{Point_3(0, 0, 10)};
  std::vector<Point_2> uv{{0, 0}};
  Triangles triangles;
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.) * i / n;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    uv.emplace_back(std::cos(angle), std::sin(angle));
    triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  const Measures measures = measure(make_chart(points, triangles), uv).map;
  BOOST_TEST(measures.mean_quasi_conformal_ratio > 9);
  BOOST_TEST(measures.mean_angle_change > 17 * std::acos(-1.) / 180);
  BOOST_TEST(measures.angular_distortion < 0.02);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(degenerate)

namespace {

// Half a unit square and the other half.
Chart square(const Point_3& last = Point_3(0, 1, 0))
{
  return make_chart({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, last}, {{0, 1, 2}, {0, 2, 3}});
}

void check_worst(const Face_measures& face)
{
  for(double value : {face.l2_stretch, face.linf_stretch, face.quasi_conformal_ratio, face.area_distortion,
                      face.symmetric_dirichlet_energy})
    BOOST_TEST(value == infinity);
  for(double value : {face.shear, face.principal_shear, face.equal_stretch_error})
    BOOST_TEST(value == 1);
}

// One triangle is unchanged. The other one has the same area on the surface, but none in the plane.
void check_half_collapsed(const Measured& measured)
{
  check(measured.faces[0].principal_shear, 0);
  check(measured.faces[0].linf_stretch, std::sqrt(0.5)); // the plane has half of the area
  check_worst(measured.faces[1]);
  BOOST_TEST(measured.faces[1].flipped);
  BOOST_TEST(measured.map.flipped_triangles == 1);
  for(double value : {measured.map.l2_stretch, measured.map.linf_stretch,
                      measured.map.mean_quasi_conformal_ratio, measured.map.max_quasi_conformal_ratio,
                      measured.map.l2_area_distortion, measured.map.symmetric_dirichlet_energy})
    BOOST_TEST(value == infinity);
  for(double value :
      {measured.map.l2_shear, measured.map.l2_principal_shear, measured.map.l2_equal_stretch_error})
    check(value, std::sqrt(0.5));
}

} // namespace

BOOST_AUTO_TEST_CASE(collapsed_in_the_plane)
{
  const Measured to_a_line = measure(square(), {{0, 0}, {1, 0}, {1, 1}, {0.5, 0.5}});
  check_half_collapsed(to_a_line);
  check(to_a_line.faces[1].angular_distortion, (1 + 1 + 1) / 3.); // 0, 180 and 0 degrees for 45, 90 and 45
  BOOST_TEST(to_a_line.map.smallest_angle == 0);
  check_worst(measure(square(), {{0, 0}, {1, 0}, {0, 0}, {0, 0}}).faces[1]);
}

BOOST_AUTO_TEST_CASE(not_finite_in_the_plane)
{
  for(double bad : {not_a_number, infinity, -infinity}) {
    const Measured measured = measure(square(), {{0, 0}, {1, 0}, {1, 1}, {bad, 1}});
    check(measured.faces[0].principal_shear, 0);
    BOOST_TEST(measured.map.flipped_triangles == 1);
    for(double value :
        {measured.faces[1].angular_distortion, measured.faces[1].mean_angle_change, measured.faces[1].shear,
         measured.faces[1].smallest_angle, measured.map.rms_angle_change,
         measured.map.mean_corner_angle_change, measured.map.angular_distortion, measured.map.l2_stretch,
         measured.map.linf_stretch, measured.map.l2_shear, measured.map.mean_quasi_conformal_ratio,
         measured.map.quasi_conformal_ratio_95, measured.map.max_quasi_conformal_ratio,
         measured.map.min_scale, measured.map.max_scale, measured.map.smallest_angle})
      BOOST_TEST(std::isnan(value));
  }
}

BOOST_AUTO_TEST_CASE(flipped)
{
  const Measured measured = measure(square(), {{0, 0}, {1, 0}, {1, 1}, {1, 0}}); // folded
  BOOST_TEST(!measured.faces[0].flipped);
  BOOST_TEST(measured.faces[1].flipped);
  for(double value : {measured.faces[0].l2_stretch, measured.faces[1].l2_stretch,
                      measured.faces[1].linf_stretch, measured.map.l2_stretch, measured.map.linf_stretch})
    check(value, 1);
  check(measured.map.symmetric_dirichlet_energy, 4);
  check(measured.map.l2_principal_shear, 0);
  check(measured.map.max_quasi_conformal_ratio, 1);
  check(measured.map.l2_area_distortion, 0);
}

// The sign depends on the last bit of a coordinate, which the determinant in doubles loses.
BOOST_AUTO_TEST_CASE(flips_are_exact)
{
  const Chart one = make_chart({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const double ulp = std::numeric_limits<double>::epsilon() / 2;
  BOOST_TEST(measure(one, {{0.5, 0.5 + ulp}, {12, 12}, {24, 24}}).map.flipped_triangles == 0);
  BOOST_TEST(measure(one, {{0.5, 0.5 - ulp}, {12, 12}, {24, 24}}).map.flipped_triangles == 1);
}

BOOST_AUTO_TEST_CASE(without_area_in_space)
{
  const std::vector<Point_2> uv{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Measured half = measure(square(Point_3(0.5, 0.5, 0)), uv);
  BOOST_TEST(half.faces[1].area == 0);
  check_worst(half.faces[1]);
  check(half.map.l2_stretch, std::sqrt(2.)); // the plane has twice the area
  check(half.map.linf_stretch, std::sqrt(2.));
  check(half.map.l2_shear, 0);
  check(half.map.l2_principal_shear, 0);
  check(half.map.max_quasi_conformal_ratio, 1);
  check(half.map.symmetric_dirichlet_energy, 2 * (2 + 0.5));
  check(half.map.l2_area_distortion, std::log(2.));

  const Measures none =
      measure(make_chart({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), {{0, 0}, {1, 0}, {1, 1}}).map;
  BOOST_TEST(none.l2_stretch == infinity);
  BOOST_TEST(none.l2_principal_shear == 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(of_meshes)

namespace {

typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;

} // namespace

// A constant mesh with several components, and a map that is computed on the fly.
BOOST_AUTO_TEST_CASE(totals_are_those_of_the_faces)
{
  Mesh with_triangle = test_meshes::bump<Mesh>(8);
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(with_triangle).first;
  const Face other = with_triangle.add_face(with_triangle.add_vertex(Point_3(0.5, 0.5, 0)), // over the border
                                            with_triangle.add_vertex(Point_3(6, 0, 0)),
                                            with_triangle.add_vertex(Point_3(5, 1, 0)));
  const Mesh& mesh = with_triangle;
  const auto uvmap = boost::make_function_property_map<Vertex>([&mesh](Vertex v) {
    const Point_3& p = mesh.point(v);
    return CGAL::Simple_cartesian<float>::Point_2(static_cast<float>(p.x()), static_cast<float>(p.y()));
  });
  std::set<Face> visited;
  double area = 0, angular_distortion = 0, l2_stretch = 0, linf_stretch = 0, ratio = 0;
  const auto add = [&](Face f, const Face_measures& face) {
    BOOST_TEST(visited.insert(f).second);
    check(face.area, CGAL::Polygon_mesh_processing::face_area(f, mesh));
    area += face.area;
    angular_distortion += face.angular_distortion;
    l2_stretch += face.area * face.l2_stretch * face.l2_stretch;
    linf_stretch = (std::max)(linf_stretch, face.linf_stretch);
    ratio += face.area * face.quasi_conformal_ratio;
  };
  const Measures measures = SMP::measure_flattening(mesh, bhd, uvmap, CGAL::parameters::visitor(add));
  BOOST_TEST(visited.size() == num_faces(mesh) - 1);
  BOOST_TEST(visited.count(other) == 0u);
  check(measures.angular_distortion, angular_distortion / static_cast<double>(visited.size()));
  check(measures.l2_stretch, std::sqrt(l2_stretch / area));
  check(measures.linf_stretch, linf_stretch);
  check(measures.mean_quasi_conformal_ratio, ratio / area);
  BOOST_TEST(measures.border_is_simple);
  BOOST_TEST(measures.l2_stretch == SMP::measure_flattening(mesh, bhd, uvmap).l2_stretch);
}

BOOST_AUTO_TEST_CASE(refusals)
{
  Mesh mesh = test_meshes::bump<Mesh>(3);
  const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const auto uv = mesh.add_property_map<Vertex, Point_2>("v:uv").first;
  BOOST_TEST(bool(SMP::measure_flattening(mesh, bhd, uv)));
  BOOST_TEST(SMP::measure_flattening(mesh, opposite(bhd, mesh), uv).status == SMP::Diagnosis::NOT_ON_BORDER);
  mesh.point(target(bhd, mesh)) = Point_3(0, not_a_number, 0);
  const auto report = SMP::measure_flattening(mesh, bhd, uv);
  BOOST_TEST(report.status == SMP::Diagnosis::NON_FINITE_POINT);
  BOOST_TEST((report.offending_vertices == std::vector<Vertex>{target(bhd, mesh)}));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
