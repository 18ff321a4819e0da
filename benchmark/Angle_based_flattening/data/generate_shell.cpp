// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes the mesh that the benchmarks resize, a sea shell cut open along its inner side:
// `generate_shell FILE.off`. The same program makes the same mesh everywhere. `shell.off` has
// a remark at its top as well.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
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

int main(int argc, char* argv[])
{
  if(argc != 2) {
    std::cerr << "usage: generate_shell FILE.off\n";
    return 2;
  }
  const Mesh shell = make_shell();
  if(!CGAL::IO::write_OFF(argv[1], shell, CGAL::parameters::stream_precision(6))) {
    std::cerr << "cannot write " << argv[1] << '\n';
    return 1;
  }
  std::cout << shell.number_of_faces() << " triangles\n";
}
