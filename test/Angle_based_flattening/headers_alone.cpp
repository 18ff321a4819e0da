// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A program without the compiled library that includes only the direct method: it flattens, and refuses what other
// headers are for.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/generators.h>

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

  explicit Grid(double height)
  {
    const auto bump = [height](std::size_t i, std::size_t j) {
      return Kernel::Point_3(double(i), double(j), height * double((i * i + 3 * j * j * j) % 7));
    };
    CGAL::make_grid(6, 6, mesh, bump, true);
    uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  }

  Report flatten(Parameterizer parameterizer)
  {
    const auto vpmap = mesh.add_property_map<Mesh::Vertex_index, bool>("v:parameterized", false).first;
    parameterizer.parameterize(mesh, border, uv, get(boost::vertex_index, mesh), vpmap);
    return parameterizer.report();
  }
};

int faults = 0;

void expect(bool is_so, const std::string& what)
{
  if(!is_so) {
    std::cerr << "not so: " << what << '\n';
    ++faults;
  }
}

void expect_refusal(const Report& report, const std::string& what)
{
  expect(report.status == SMP::Diagnosis::WRONG_OPTION, what + " are refused");
  expect(report.message.find("#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_strategies.h>") !=
             std::string::npos,
         what + ": the message names the header, but is '" + report.message + "'");
}

// Newton's method without a step leaves nothing but fallbacks.
void expect_named_fallback()
{
  Grid grid(5);
  Options options;
  options.max_iterations = 0;
  options.layout = Options::EXACT_LAYOUT;
  for(const bool fallbacks : {true, false}) {
    options.fallbacks = fallbacks;
    const Report report = grid.flatten(Parameterizer(options));
    expect(report.status != SMP::Diagnosis::NOTHING_WRONG, "steep noise has no map without a step");
    const bool is_named = report.message.find("ABF_plus_plus_strategies.h") != std::string::npos;
    expect(is_named == fallbacks, "the message names the last fallback, but is '" + report.message + "'");
  }
}

int main()
{
  Grid grid(0.1);
  const Report report = grid.flatten(Parameterizer());
  expect(report.status == SMP::Diagnosis::NOTHING_WRONG, "the grid is flattened");

  Options injective, filled;
  injective.injective = true;
  filled.holes = Options::FILL;
  expect_refusal(grid.flatten(Parameterizer(injective)), "injective maps");
  expect_refusal(grid.flatten(Parameterizer(filled)), "filled holes");

  const auto sums = grid.mesh.add_property_map<Mesh::Vertex_index, std::optional<double>>("v:sum").first;
  sums[source(grid.border, grid.mesh)] = 1.5;
  Parameterizer prescribing;
  prescribing.set_angle_sums(sums);
  expect_refusal(grid.flatten(prescribing), "prescribed angles");

  expect_named_fallback();
  return faults;
}
