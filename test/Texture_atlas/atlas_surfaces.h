// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_ATLAS_SURFACES_H
#define ANGLE_BASED_FLATTENING_ATLAS_SURFACES_H

#include "cut_spheres.h"
#include "mesh_of_chart.h"
#include "overlapping_charts.h"
#include "random_charts.h"
#include "seam_surfaces.h"

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Surfaces of several components, good and bad ones, for tests of atlases.
namespace atlas_surfaces {

using CGAL::Surface_mesh_parameterization::Diagnosis;
using test_charts::Chart;
using test_charts::Point_3;
using test_charts::Triangles;
using test_charts::uniform;
using test_charts::uniform_int;

struct Component
{
  std::string name;
  std::vector<Point_3> points;
  Triangles triangles;
  Diagnosis status = Diagnosis::NOTHING_WRONG; // or why it cannot have a chart

  bool is_good() const { return status == Diagnosis::NOTHING_WRONG; }
};

inline Component component(const std::string& name, const Chart& chart)
{
  Component result{name, chart.points, {}};
  for(int c = 0; c < chart.number_of_corners(); c += 3)
    result.triangles.push_back({chart.vertex[c], chart.vertex[c + 1], chart.vertex[c + 2]});
  return result;
}

inline Component component(const seam_surfaces::Surface& surface)
{
  Component result{surface.name, {}, {}};
  for(const auto& p : surface.points)
    result.points.emplace_back(p.x(), p.y(), p.z());
  for(const seam_surfaces::Polygon& f : surface.faces)
    result.triangles.push_back({static_cast<int>(f[0]), static_cast<int>(f[1]), static_cast<int>(f[2])});
  return result;
}

// Two triangles with the same three edges
inline Component pillow()
{
  return {"pillow", {{0, 0, 0}, {3, 0, 0}, {1, 2, 0}}, {{0, 1, 2}, {0, 2, 1}}};
}

inline Component single_triangle(std::mt19937& random)
{
  return {"triangle",
          {test_charts::random_point(random), test_charts::random_point(random),
           test_charts::random_point(random)},
          {{0, 1, 2}}};
}

// Hills without some of the squares, none of which is next to another or to the border
inline Component disk_with_holes(int n, std::mt19937& random)
{
  const Chart hills = test_charts::bump(n, static_cast<unsigned>(n), uniform(random, 0, 1));
  Component result = component("disk with holes", hills);
  Triangles triangles;
  for(std::size_t t = 0; t < result.triangles.size(); ++t) {
    const int square = static_cast<int>(t / 2), i = square / n, j = square % n;
    if(!(i % 3 == 1 && j % 3 == 1 && i + 1 < n && j + 1 < n))
      triangles.push_back(result.triangles[t]);
  }
  result.triangles = std::move(triangles);
  return result;
}

// With bumps that are so high that their maps overlap
inline Component bumpy_sphere(std::mt19937& random)
{
  const auto [points, triangles] = test_charts::sphere(uniform_int(random, 2, 3));
  return {"sphere with bumps",
          test_charts::with_bumps(points, uniform_int(random, 1, 6), uniform(random, 0.5, 3), 9, random),
          triangles};
}

// A ribbon that winds around an axis by more than a turn: ABF++ maps it onto itself.
inline Component staircase(int columns, double turns)
{
  return component("staircase", test_charts::staircase(columns, 3, turns, 0.1));
}

inline Component good_component(std::mt19937& random)
{
  const auto size = [&](int least, int largest) {
    return static_cast<std::size_t>(uniform_int(random, least, largest));
  };
  switch(uniform_int(random, 0, 14)) {
  case 0:
    return component(seam_surfaces::sphere(uniform_int(random, 1, 2)));
  case 1: {
    const std::size_t m = size(3, 16), n = size(3, 9);
    return component(seam_surfaces::torus(m, n));
  }
  case 2:
    return component(seam_surfaces::slab(uniform_int(random, 0, 4)));
  case 3:
    return component(seam_surfaces::sphere_with_holes(size(1, 12), static_cast<unsigned>(random())));
  case 4: {
    const std::size_t m = size(3, 12), n = size(1, 12);
    return component(seam_surfaces::tube(m, n));
  }
  case 5:
  case 6:
    return single_triangle(random);
  case 7:
    return component(seam_surfaces::platonic_solids()[size(0, 4)]);
  case 8:
    return pillow();
  case 9:
    return disk_with_holes(uniform_int(random, 3, 12), random);
  case 10:
    return bumpy_sphere(random);
  case 11:
    return staircase(uniform_int(random, 20, 60), uniform(random, 1.1, 2.5));
  case 12: {
    const int operations = uniform_int(random, 1, 100);
    return component("random chart", test_charts::random_chart(operations, random));
  }
  default: {
    const Chart hills = test_charts::bump(uniform_int(random, 2, 6), 7);
    const int number = uniform_int(random, 1, 10);
    return component("slivers",
                     test_charts::slivers(hills, number, std::pow(10, -uniform(random, 1, 14)), random));
  }
  }
}

inline Component bad_component(std::mt19937& random)
{
  // A wrong face condemns no others, so all faces are wrong.
  Component result;
  switch(uniform_int(random, 0, 2)) {
  case 0: {
    const double bad = uniform_int(random, 0, 1) == 0 ? std::numeric_limits<double>::infinity()
                                                      : std::numeric_limits<double>::quiet_NaN();
    result = {"fan", {{1, bad, 0}, {0, 0, 0}}, {}};
    for(int i = uniform_int(random, 1, 8); i > 0; --i) {
      result.points.emplace_back(i, i * i, 0);
      const int last = static_cast<int>(result.points.size()) - 1;
      result.triangles.push_back({0, last - 1, last});
    }
    result.status = Diagnosis::NON_FINITE_POINT;
    break;
  }
  case 1:
    result = {"square",
              {{std::numeric_limits<double>::quiet_NaN(), 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
              {{0, 1, 2}, {0, 2, 3}}};
    result.status = Diagnosis::NON_FINITE_POINT;
    break;
  default: {
    const bool is_point = uniform_int(random, 0, 1) == 0;
    result = good_component(random);
    for(std::size_t w = 0; w < result.points.size(); ++w)
      result.points[w] =
          is_point ? Point_3(0, 0, 0) : Point_3(static_cast<double>(w % 7), 0, 0); // a point or a line
    result.status = Diagnosis::NO_AREA;
  }
  }
  result.name += ", " + to_string(result.status);
  return result;
}

// Much larger or smaller, and elsewhere
inline void move(Component& component, std::mt19937& random, double magnitude)
{
  const double factor = std::pow(10, uniform(random, -magnitude, magnitude));
  const Point_3 center = test_charts::random_point(random);
  for(Point_3& p : component.points)
    p = Point_3(factor * (p.x() + center.x()), factor * (p.y() + center.y()), factor * (p.z() + center.z()));
}

// Components in one mesh. The order of triangles within a component is always the same.
struct Union
{
  std::vector<Component> components;
  std::vector<int> order; // the component of each triangle

  void add(const Component& component)
  {
    order.insert(order.end(), component.triangles.size(), static_cast<int>(components.size()));
    components.push_back(component);
  }

  std::string names() const
  {
    std::string text;
    for(const Component& c : components)
      text += (text.empty() ? "" : " + ") + c.name;
    return text;
  }

  bool is_good() const
  {
    return std::all_of(components.begin(), components.end(), [](const Component& c) { return c.is_good(); });
  }

  Union without_bad_components() const
  {
    Union result;
    std::vector<int> number;
    for(const Component& c : components) {
      number.push_back(c.is_good() ? static_cast<int>(result.components.size()) : -1);
      if(c.is_good())
        result.components.push_back(c);
    }
    for(int c : order)
      if(number[c] >= 0)
        result.order.push_back(number[c]);
    return result;
  }

  // Where a component should have a quadrangle, its first triangle is merged with another one.
  template <typename Mesh>
  void make_mesh(Mesh& mesh) const
  {
    std::vector<Point_3> points;
    Triangles triangles;
    std::vector<int> first_point, next(components.size(), 0);
    for(const Component& c : components) {
      first_point.push_back(static_cast<int>(points.size()));
      points.insert(points.end(), c.points.begin(), c.points.end());
    }
    for(int c : order) {
      triangles.push_back(components[c].triangles[next[c]++]);
      for(int& v : triangles.back())
        v += first_point[c];
    }
    test_charts::make_mesh(test_charts::make_chart(points, triangles), mesh);
  }

  template <typename Mesh>
  Mesh mesh() const
  {
    Mesh result;
    make_mesh(result);
    return result;
  }

  // Of each vertex of the mesh
  std::vector<int> component_of_vertex() const
  {
    std::vector<int> result;
    for(std::size_t c = 0; c < components.size(); ++c)
      result.insert(result.end(), components[c].points.size(), static_cast<int>(c));
    return result;
  }
};

// With the triangles of all components one after another, or mixed
inline Union random_union(unsigned seed, int most_components = 5, double magnitude = 3)
{
  std::mt19937 random(seed);
  Union result;
  const int number = uniform_int(random, 1, most_components);
  for(int i = 0; i < number; ++i) {
    Component c = uniform_int(random, 0, 4) == 0 ? bad_component(random) : good_component(random);
    move(c, random, magnitude);
    result.add(c);
  }
  if(uniform_int(random, 0, 1) == 0)
    std::shuffle(result.order.begin(), result.order.end(), random);
  return result;
}

} // namespace atlas_surfaces

#endif // ANGLE_BASED_FLATTENING_ATLAS_SURFACES_H
