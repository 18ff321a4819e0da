// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes the meshes in `data/`: a sea shell cut open along its inner side, and an egg with the seam of an
// orange peel. The same program makes the same meshes everywhere: `generate_shell [FOLDER]`, by default
// `data`.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point_3>;

// Random numbers between -1 and 1. The distributions of the standard library differ between its makers.
class Jitter
{
public:
  double operator()() { return 2. * m_random() / static_cast<double>(std::mt19937::max()) - 1.; }

private:
  std::mt19937 m_random;
};

// A tube that winds around the z axis and grows by the same factor with each turn, with ribs across and
// ridges along. `turn` is the angle around the axis, `around` that around the tube, zero on its inner side.
Point_3 shell_point(const double turn, const double around)
{
  const double size = std::exp(0.1 * turn);
  const double ribs = 1. + 0.08 * std::cos(9. * turn) * (1. - std::cos(around)) / 2.;
  const double ridges = 1. + 0.03 * std::cos(6. * around);
  const double radius = 0.64 * size * ribs * ridges;
  const double from_axis = 0.72 * size - radius * std::cos(around);
  const double height = -1.9 * size + 1.15 * radius * std::sin(around);
  return Point_3(from_axis * std::cos(turn), from_axis * std::sin(turn), height);
}

// Points of the rectangle of `turn` and `around`, in rows with jitter; on the rectangle's sides only along
// them.
std::vector<Point_2> shell_parameters(const double first_turn, const double last_turn)
{
  const int rows = 42;
  const double step = 2. * CGAL_PI / rows;
  const double stretch = 1.05; // of the rectangle along the turns, to have triangles of a good shape
  const int columns = static_cast<int>(std::lround((last_turn - first_turn) * stretch / step));
  std::vector<Point_2> points;
  Jitter jitter;
  for(int i = 0; i <= columns; ++i) {
    for(int j = 0; j <= rows; ++j) {
      const double x = i + (i == 0 || i == columns ? 0. : 0.42 * jitter());
      const double y = j + (j == 0 || j == rows ? 0. : 0.42 * jitter());
      points.emplace_back(first_turn + (last_turn - first_turn) * x / columns, step * y);
    }
  }
  return points;
}

Mesh make_shell()
{
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Triangulation =
      CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base>>;
  const std::vector<Point_2> parameters = shell_parameters(0., 6.25 * CGAL_PI);
  std::vector<std::pair<Point_2, std::size_t>> numbered;
  Mesh mesh;
  for(std::size_t i = 0; i < parameters.size(); ++i) {
    numbered.emplace_back(parameters[i], i);
    mesh.add_vertex(shell_point(parameters[i].x(), parameters[i].y()));
  }
  const Triangulation triangulation(numbered.begin(), numbered.end());
  for(const auto f : triangulation.finite_face_handles()) {
    mesh.add_face(Mesh::Vertex_index(f->vertex(0)->info()), Mesh::Vertex_index(f->vertex(2)->info()),
                  Mesh::Vertex_index(f->vertex(1)->info())); // seen from outside
  }
  return mesh;
}

// The egg: a sphere, longer and more pointed upwards. `part` goes from 0 at the lower pole to 1 at the upper.
Point_3 egg_point(const double part, const double turn)
{
  const double z = 2. * part - 1.;
  const double radius = std::sqrt((std::max)(0., 1. - z * z)) * (1. - 0.18 * z);
  return Point_3(radius * std::cos(turn), radius * std::sin(turn), 1.3 * z);
}

// Points at even distances on the spiral from near one pole to near the other.
std::vector<Point_3> peel_seam(const double turns, const double distance)
{
  const auto on_spiral = [turns](const double t) {
    return egg_point((1. - std::cos(t)) / 2., 2. * turns * t);
  };
  std::vector<Point_3> seam;
  const double last = CGAL_PI - 0.12;
  for(double t = 0.12; t < last; t += 1e-5) {
    const Point_3 p = on_spiral(t);
    if(seam.empty() || CGAL::squared_distance(seam.back(), p) >= distance * distance) {
      seam.push_back(p);
    }
  }
  return seam;
}

// The seam, then random points that keep their distance from it and from one another.
std::vector<Point_3> egg_points(std::vector<Point_3> points, const double distance)
{
  Jitter jitter;
  for(int trial = 0; trial < 60000; ++trial) {
    const double part = (jitter() + 1.) / 2.;
    const Point_3 p = egg_point(part, CGAL_PI * jitter());
    bool is_free = true;
    for(std::size_t i = 0; i < points.size() && is_free; ++i) {
      is_free = CGAL::squared_distance(points[i], p) >= distance * distance;
    }
    if(is_free) {
      points.push_back(p);
    }
  }
  return points;
}

void write_off(const std::string& name, const std::string& remark, const Mesh& mesh)
{
  std::ofstream file(name);
  file << "OFF\n# " << remark
       << "\n# Made by generate_shell.cpp of Angle_based_flattening; GPL-3.0-or-later.\n"
       << mesh.number_of_vertices() << ' ' << mesh.number_of_faces() << " 0\n"
       << std::setprecision(6);
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    file << mesh.point(v).x() << ' ' << mesh.point(v).y() << ' ' << mesh.point(v).z() << '\n';
  }
  for(const Mesh::Face_index f : mesh.faces()) {
    file << 3;
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      file << ' ' << v.idx();
    }
    file << '\n';
  }
}

// A selection file as CGAL's Seam_mesh reads it: the third line holds the edges.
void write_seam(const std::string& name, const std::size_t length)
{
  std::ofstream file(name);
  file << "\n\n";
  for(std::size_t i = 1; i < length; ++i) {
    file << (i == 1 ? "" : " ") << i - 1 << ' ' << i;
  }
  file << '\n';
}

// The points lie on a convex surface, so that their hull is a triangulation of all of them. In the result
// they have the order that they have here.
Mesh convex_surface(const std::vector<Point_3>& points)
{
  Mesh hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  std::map<Point_3, Mesh::Vertex_index> vertex;
  Mesh mesh;
  for(const Point_3& p : points) {
    vertex[p] = mesh.add_vertex(p);
  }
  for(const Mesh::Face_index f : hull.faces()) {
    std::vector<Mesh::Vertex_index> corners;
    for(const Mesh::Vertex_index v : hull.vertices_around_face(hull.halfedge(f))) {
      corners.push_back(vertex.at(hull.point(v)));
    }
    mesh.add_face(corners);
  }
  return mesh;
}

// Whether every edge of the seam, the vertices from 0 to `length - 1`, is an edge of the mesh.
bool has_seam(const Mesh& mesh, const std::size_t length)
{
  for(std::size_t i = 1; i < length; ++i) {
    if(mesh.halfedge(Mesh::Vertex_index(i - 1), Mesh::Vertex_index(i)) == Mesh::null_halfedge()) {
      return false;
    }
  }
  return true;
}

bool is_disk(const Mesh& mesh)
{
  const auto euler = static_cast<long>(mesh.number_of_vertices()) -
                     static_cast<long>(mesh.number_of_edges()) + static_cast<long>(mesh.number_of_faces());
  return CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh) && euler == 1 &&
         !CGAL::is_closed(mesh);
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? argv[1] : "data";

  const Mesh shell = make_shell();
  if(!is_disk(shell)) {
    std::cerr << "The shell is not a disk.\n";
    return 1;
  }
  write_off(folder + "/shell.off",
            "A sea shell, a growing spiral tube with ribs, cut open on its inner side.", shell);

  const double distance = 0.065;
  const std::vector<Point_3> seam = peel_seam(4., distance);
  const Mesh egg = convex_surface(egg_points(seam, distance));
  if(!CGAL::is_valid_polygon_mesh(egg) || !CGAL::is_closed(egg) || !has_seam(egg, seam.size())) {
    std::cerr << "The egg is not closed, or lacks its seam.\n";
    return 1;
  }
  write_off(folder + "/egg.off",
            "An egg. Vertices from 0 on are a spiral from pole to pole: egg.selection.txt.", egg);
  write_seam(folder + "/egg.selection.txt", seam.size());

  std::cout << "shell: " << shell.number_of_faces() << " triangles; egg: " << egg.number_of_faces()
            << " triangles, a seam of " << seam.size() - 1 << " edges\n";
}
