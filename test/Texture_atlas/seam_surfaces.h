// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_SEAM_SURFACES_H
#define ANGLE_BASED_FLATTENING_SEAM_SURFACES_H

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Closed surfaces, and surfaces with handles and borders, for tests of seams: all triangulated, with normals outward.
namespace seam_surfaces {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef std::vector<std::size_t> Polygon;

struct Surface
{
  std::string name;
  std::vector<Point_3> points;
  std::vector<Polygon> faces;
  std::size_t handles = 0, borders = 0;

  template <typename Mesh = Surface_mesh>
  Mesh mesh() const
  {
    Mesh result;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, result);
    return result;
  }
};

// Splits polygons into triangles that share their first vertex.
inline void triangulate(Surface& surface)
{
  std::vector<Polygon> triangles;
  for(const Polygon& face : surface.faces)
    for(std::size_t i = 1; i + 1 < face.size(); ++i)
      triangles.push_back({face[0], face[i], face[i + 1]});
  surface.faces = std::move(triangles);
}

inline Surface tetrahedron()
{
  return {"tetrahedron",
          {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

inline Surface octahedron()
{
  return {"octahedron",
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

inline Surface icosahedron()
{
  const double p = (1 + std::sqrt(5.)) / 2;
  return {"icosahedron",
          {{-1, p, 0},
           {1, p, 0},
           {-1, -p, 0},
           {1, -p, 0},
           {0, -1, p},
           {0, 1, p},
           {0, -1, -p},
           {0, 1, -p},
           {p, 0, -1},
           {p, 0, 1},
           {-p, 0, -1},
           {-p, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

// Its vertices are the middles of the faces, its faces go around the vertices.
inline Surface dual(const Surface& surface, const std::string& name)
{
  Surface result;
  result.name = name;
  for(const Polygon& face : surface.faces) {
    Vector_3 sum = CGAL::NULL_VECTOR;
    for(std::size_t v : face)
      sum = sum + (surface.points[v] - CGAL::ORIGIN);
    result.points.push_back(CGAL::ORIGIN + sum / static_cast<double>(face.size()));
  }
  for(std::size_t v = 0; v < surface.points.size(); ++v) {
    std::map<std::size_t, std::size_t> face_from, target_of; // by the neighbour at which a face begins
    for(std::size_t f = 0; f < surface.faces.size(); ++f)
      for(std::size_t i = 0; i < 3; ++i)
        if(surface.faces[f][i] == v) {
          face_from[surface.faces[f][(i + 1) % 3]] = f;
          target_of[surface.faces[f][(i + 1) % 3]] = surface.faces[f][(i + 2) % 3];
        }
    Polygon polygon;
    std::size_t w = face_from.begin()->first;
    do {
      polygon.push_back(face_from[w]);
      w = target_of[w];
    } while(w != face_from.begin()->first);
    result.faces.push_back(polygon);
  }
  triangulate(result);
  return result;
}

inline std::vector<Surface> platonic_solids()
{
  return {tetrahedron(), dual(octahedron(), "cube"), octahedron(), dual(icosahedron(), "dodecahedron"),
          icosahedron()};
}

// All triangles are split in four, `levels` times.
inline void subdivide(Surface& surface, int levels)
{
  for(int level = 0; level < levels; ++level) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t v, std::size_t w) {
      const auto [it, is_new] = middles.insert({std::minmax({v, w}), surface.points.size()});
      if(is_new)
        surface.points.push_back(CGAL::midpoint(surface.points[v], surface.points[w]));
      return it->second;
    };
    std::vector<Polygon> faces;
    for(const Polygon& f : surface.faces) {
      const std::size_t a = middle(f[1], f[2]), b = middle(f[2], f[0]), c = middle(f[0], f[1]);
      faces.insert(faces.end(), {{f[0], c, b}, {f[1], a, c}, {f[2], b, a}, {a, b, c}});
    }
    surface.faces = std::move(faces);
  }
}

// A subdivided icosahedron
inline Surface sphere(int levels)
{
  Surface result = icosahedron();
  result.name = "sphere of level " + std::to_string(levels);
  subdivide(result, levels);
  for(Point_3& p : result.points) {
    const Vector_3 v = p - CGAL::ORIGIN;
    p = CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  }
  return result;
}

// Without some of its faces, which are far enough apart that each leaves a border of its own
inline Surface sphere_with_holes(std::size_t holes, unsigned seed)
{
  Surface result = sphere(3);
  result.name = "sphere with " + std::to_string(holes) + " holes";
  std::mt19937 random(seed);
  std::shuffle(result.faces.begin(), result.faces.end(), random);
  std::set<std::size_t> used;
  std::vector<Polygon> faces;
  for(const Polygon& f : result.faces) {
    const bool is_free = std::none_of(f.begin(), f.end(), [&](std::size_t v) { return used.count(v) != 0; });
    if(result.borders < holes && is_free) {
      used.insert(f.begin(), f.end());
      ++result.borders;
    } else
      faces.push_back(f);
  }
  result.faces = std::move(faces);
  return result;
}

inline Surface torus(std::size_t m, std::size_t n)
{
  Surface result;
  result.name = "torus";
  result.handles = 1;
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double a = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(m);
      const double b = 2 * CGAL_PI * static_cast<double>(j) / static_cast<double>(n);
      const double r = 3 + std::cos(b);
      result.points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
      const std::size_t k = (i + 1) % m, l = (j + 1) % n;
      result.faces.push_back({i * n + j, k * n + j, k * n + l, i * n + l});
    }
  triangulate(result);
  return result;
}

// A cylinder without its ends
inline Surface tube(std::size_t m, std::size_t n)
{
  Surface result;
  result.name = "tube";
  result.borders = 2;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j < m; ++j) {
      const double a = 2 * CGAL_PI * static_cast<double>(j) / static_cast<double>(m);
      result.points.emplace_back(std::cos(a), std::sin(a), static_cast<double>(i) / 2);
      if(i < n)
        result.faces.push_back({i * m + j, i * m + (j + 1) % m, (i + 1) * m + (j + 1) % m, (i + 1) * m + j});
    }
  triangulate(result);
  return result;
}

// A slab of 3 x (2 holes + 1) cubes, without the cubes of the holes: its genus is the number of holes.
inline Surface slab(int holes)
{
  Surface result;
  result.name = "slab of genus " + std::to_string(holes);
  result.handles = static_cast<std::size_t>(holes);
  const auto is_solid = [&](int x, int y, int z) {
    return x >= 0 && x <= 2 * holes && y >= 0 && y < 3 && z == 0 && !(y == 1 && x % 2 == 1);
  };
  std::map<std::array<int, 3>, std::size_t> number;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = number.insert({p, result.points.size()});
    if(is_new)
      result.points.emplace_back(p[0], p[1], p[2]);
    return it->second;
  };
  for(int x = 0; x <= 2 * holes; ++x)
    for(int y = 0; y < 3; ++y)
      for(int axis = 0; axis < 3; ++axis)
        for(int side : {0, 1}) {
          const std::array<int, 3> cell{x, y, 0};
          std::array<int, 3> across = cell;
          across[axis] += 2 * side - 1;
          if(!is_solid(x, y, 0) || is_solid(across[0], across[1], across[2]))
            continue;
          Polygon face;
          for(const auto& [u, v] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            std::array<int, 3> p = cell;
            p[axis] += side;
            p[(axis + 1) % 3] += u;
            p[(axis + 2) % 3] += v;
            face.push_back(vertex(p));
          }
          if(side == 0)
            std::reverse(face.begin(), face.end());
          result.faces.push_back(face);
        }
  triangulate(result);
  return result;
}

// Any of these, by chance
inline Surface random_surface(unsigned seed)
{
  std::mt19937 random(seed);
  const auto number = [&](int least, int largest) {
    return std::uniform_int_distribution<int>(least, largest)(random);
  };
  switch(number(0, 6)) {
  case 0:
    return platonic_solids()[static_cast<std::size_t>(number(0, 4))];
  case 1:
    return sphere(number(1, 2));
  case 2: {
    const int m = number(3, 12), n = number(3, 9);
    return torus(static_cast<std::size_t>(m), static_cast<std::size_t>(n));
  }
  case 3: {
    const int m = number(3, 12), n = number(1, 9);
    return tube(static_cast<std::size_t>(m), static_cast<std::size_t>(n));
  }
  case 4:
    return slab(number(0, 5));
  default:
    return sphere_with_holes(static_cast<std::size_t>(number(1, 50)), seed);
  }
}

} // namespace seam_surfaces

#endif // ANGLE_BASED_FLATTENING_SEAM_SURFACES_H
