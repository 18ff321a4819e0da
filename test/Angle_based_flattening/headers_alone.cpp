// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A program without the compiled library that includes only the direct method: every option works.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>

#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#error "This is about the headers alone."
#endif

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::ABF_plus_plus_options Options;
typedef SMP::ABF_plus_plus_parameterizer_3<Mesh> Parameterizer;
typedef SMP::ABF_plus_plus_report Report;

struct Grid
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv;
  Mesh::Halfedge_index border;

  // Of `columns` x 6 squares with vertices at `point(i, j)`, with a hole if that is wanted
  template <typename Point>
  Grid(std::size_t columns, const Point& point, bool has_hole = false)
  {
    CGAL::make_grid(columns, 6, mesh, point, true);
    uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
    if(has_hole)
      for(Mesh::Halfedge_index h : halfedges(mesh))
        if(!is_border(h, mesh) && is_far_from_border(h)) {
          CGAL::Euler::remove_face(h, mesh);
          break;
        }
  }

  bool is_far_from_border(Mesh::Halfedge_index h) const
  {
    for(Mesh::Vertex_index v : vertices_around_face(h, mesh))
      if(mesh.is_border(v))
        return false;
    return true;
  }

  auto flatten(Parameterizer parameterizer)
  {
    const auto vpmap = mesh.add_property_map<Mesh::Vertex_index, bool>("v:parameterized", false).first;
    for(const Mesh::Vertex_index v : mesh.vertices())
      vpmap[v] = false; // a mesh may be flattened twice
    parameterizer.parameterize(mesh, border, uv, get(boost::vertex_index, mesh), vpmap);
    return parameterizer.report();
  }
};

Grid bumpy_grid(double height, bool has_hole = false)
{
  const auto bump = [height](std::size_t i, std::size_t j) {
    return Kernel::Point_3(double(i), double(j), height * double((i * i + 3 * j * j * j) % 7));
  };
  return Grid(6, bump, has_hole);
}

// One and a half turns of a spiral staircase, whose map overlaps itself
Grid staircase()
{
  return Grid(40, [](std::size_t i, std::size_t j) {
    const double angle = 0.24 * double(i), radius = 1 + 0.1 * double(j);
    return Kernel::Point_3(radius * std::cos(angle), radius * std::sin(angle), 0.02 * angle);
  });
}

int faults = 0;

void expect(bool is_so, const std::string& what)
{
  if(!is_so) {
    std::cerr << "not so: " << what << '\n';
    ++faults;
  }
}

void expect_map(const Report& report, Report::Strategy strategy, const std::string& what)
{
  expect(report.status == SMP::Diagnosis::NOTHING_WRONG,
         what + " has a map, but says '" + report.message + "'");
  expect(report.strategy == strategy, what + ": the strategy has the number " + std::to_string(strategy) +
                                          ", but is " + std::to_string(report.strategy));
}

void expect_injective_map()
{
  Options options;
  expect(!staircase().flatten(Parameterizer(options)).border_is_simple, "the staircase overlaps itself");
  options.injective = true;
  const auto report = staircase().flatten(Parameterizer(options));
  expect_map(report, Report::INJECTIVE_DESCENT, "the staircase without overlap");
  expect(report.injective, "the staircase does not overlap itself any more");
}

void expect_holes()
{
  Options options;
  expect_map(bumpy_grid(0.1, true).flatten(Parameterizer(options)), Report::FROM_TARGET_ANGLES,
             "the grid with a hole");
  options.holes = Options::FILL;
  expect_map(bumpy_grid(0.1, true).flatten(Parameterizer(options)), Report::SOFT_PATCHES,
             "the grid with a filled hole");
}

// Newton's method without a step leaves nothing but the last fallback.
void expect_fallbacks()
{
  Options options;
  options.max_iterations = 0;
  options.layout = Options::EXACT_LAYOUT;
  expect_map(bumpy_grid(5).flatten(Parameterizer(options)), Report::PROGRESSIVE_EMBEDDING, "steep noise");
  options.fallbacks = false;
  expect(bumpy_grid(5).flatten(Parameterizer(options)).status == SMP::Diagnosis::NO_CONVERGENCE,
         "steep noise has no map without a step and without fallbacks");
}

void expect_prescribed_angles()
{
  Grid grid = bumpy_grid(0.1);
  const auto sums = grid.mesh.add_property_map<Mesh::Vertex_index, std::optional<double>>("v:sum").first;
  Parameterizer parameterizer;
  parameterizer.set_angle_sums(sums);
  std::optional<double>& sum = sums[source(grid.border, grid.mesh)];
  sum = 1.5;
  expect_map(grid.flatten(parameterizer), Report::FROM_TARGET_ANGLES, "the grid with an angle");
  sum = 20;
  expect(grid.flatten(parameterizer).status == SMP::Diagnosis::WRONG_ANGLE_SUM,
         "no angles of the triangles at a vertex of this grid add up to 20");
}

void expect_pins()
{
  Grid grid = bumpy_grid(0.1);
  const auto pins =
      grid.mesh.add_property_map<Mesh::Vertex_index, std::optional<Kernel::Point_2>>("v:pin").first;
  const Mesh::Vertex_index a = source(grid.border, grid.mesh), b = target(grid.border, grid.mesh);
  pins[a] = Kernel::Point_2(3, 4);
  pins[b] = Kernel::Point_2(5, 4);
  Parameterizer parameterizer;
  parameterizer.set_pins(pins);
  expect_map(grid.flatten(parameterizer), Report::FROM_TARGET_ANGLES, "the grid with pins");
  expect(grid.uv[a] == *pins[a] && grid.uv[b] == *pins[b], "pins are where they were set");
}

int main()
{
  expect_map(bumpy_grid(0.1).flatten(Parameterizer()), Report::FROM_TARGET_ANGLES, "the grid");
  expect_injective_map();
  expect_holes();
  expect_fallbacks();
  expect_prescribed_angles();
  expect_pins();
  return faults;
}
