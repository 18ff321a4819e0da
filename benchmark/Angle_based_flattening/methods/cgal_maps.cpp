// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's maps of charts, for peers.py, which compiles this: cgal_maps lscm|arap < CHARTS > COORDINATES. Each chart is
// its numbers of points and of triangles, and both. The output has the processor time of all maps, and for each chart
// whether it was mapped and the coordinates of its points.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <vector>

namespace SMP = CGAL::Surface_mesh_parameterization;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Parameterizer, class Coordinates>
bool map(Mesh& mesh, Coordinates uv)
{
  try {
    const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
    return border != Mesh::null_halfedge() && SMP::parameterize(mesh, Parameterizer(), border, uv) == SMP::OK;
  } catch(const std::exception&) {
    return false;
  }
}

int main(int, char* argv[])
{
  const bool lscm = std::strcmp(argv[1], "lscm") == 0;
  std::vector<double> output;
  std::clock_t ticks = 0;
  std::size_t points, triangles;
  while(std::scanf("%zu %zu", &points, &triangles) == 2) {
    Mesh mesh;
    for(std::size_t i = 0; i < points; ++i) {
      double x, y, z;
      if(std::scanf("%lf %lf %lf", &x, &y, &z) != 3)
        return 2;
      mesh.add_vertex({x, y, z});
    }
    bool valid = true;
    for(std::size_t i = 0; i < triangles; ++i) {
      unsigned a, b, c;
      if(std::scanf("%u %u %u", &a, &b, &c) != 3)
        return 2;
      valid &= mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c)) !=
               Mesh::null_face();
    }
    const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    const std::clock_t begin = std::clock();
    valid = valid && (lscm ? map<SMP::LSCM_parameterizer_3<Mesh>>(mesh, uv)
                           : map<SMP::ARAP_parameterizer_3<Mesh>>(mesh, uv));
    ticks += std::clock() - begin;
    output.push_back(valid);
    for(const Mesh::Vertex_index v : mesh.vertices()) {
      output.push_back(valid ? uv[v].x() : 0);
      output.push_back(valid ? uv[v].y() : 0);
    }
  }
  std::printf("%.17g\n", static_cast<double>(ticks) / CLOCKS_PER_SEC);
  for(const double number : output)
    std::printf("%.17g\n", number);
}
