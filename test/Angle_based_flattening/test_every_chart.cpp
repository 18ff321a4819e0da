// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every chart is either flattened, and its map passes the public certificate, or refused with an error that says what
// is wrong and where, and the caller's map is unchanged. Every chart that can be flattened is flattened.

#include <boost/test/unit_test.hpp>

#include "infeasible_charts.h"
#include "mesh_of_chart.h"
#include "random_charts.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
#define EVERY_CHART_IS_SANITIZED 1
#else
#define EVERY_CHART_IS_SANITIZED 0
#endif

BOOST_AUTO_TEST_SUITE(test_every_chart)

namespace SMP = CGAL::Surface_mesh_parameterization;
using namespace test_charts;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex;
typedef SMP::ABF_plus_plus_parameterizer_3<Surface_mesh> Parameterizer;

namespace {

const int seeds = EVERY_CHART_IS_SANITIZED ? 3 : 75; // of each generator

struct Run
{
  explicit Run(const Chart& chart) : mesh(mesh_of_chart<Surface_mesh>(chart))
  {
    uv = mesh.add_property_map<Vertex, Point_2>("v:uv", untouched).first;
    const int c = chart.borders[0][0]; // vertices and triangles have the numbers that they have in the chart
    Surface_mesh::Halfedge_index h = mesh.halfedge(Surface_mesh::Face_index(static_cast<unsigned>(c / 3)));
    while(!is_border(opposite(h, mesh), mesh) || target(h, mesh) != vertex(chart.edge_target(c)))
      h = next(h, mesh);
    // SMP::parameterize() refuses some of these meshes in debug mode
    const auto done = mesh.add_property_map<Vertex, bool>("v:done", false).first;
    code = parameterizer.parameterize(mesh, opposite(h, mesh), uv, get(boost::vertex_index, mesh), done);
    for(Vertex v : parameterizer.report().offending_vertices)
      offenders.insert(static_cast<int>(v));
  }

  static SMP::ABF_plus_plus_options refusing_holes()
  {
    SMP::ABF_plus_plus_options options;
    options.holes = SMP::ABF_plus_plus_options::REFUSE;
    return options;
  }

  static Vertex vertex(int v) { return Vertex(static_cast<unsigned>(v)); }

  std::string fault_of_map() const
  {
    if(SMP::is_locally_injective(mesh, uv))
      return "";
    const SMP::internal::ABF::Planar_map<Surface_mesh, decltype(uv)> map(mesh, mesh.faces(), uv);
    if(!SMP::internal::ABF::flipped_triangles(map.vertex, map.points).empty())
      return "OK with flipped triangles";
    std::vector<char> on_border(map.points.size(), false);
    for(const auto& edge : map.border)
      on_border[edge.source] = true;
    const std::vector<int> sweeps = SMP::internal::ABF::winding_numbers(map.vertex, map.points);
    for(std::size_t v = 0; v < sweeps.size(); ++v)
      if(!on_border[v] && sweeps[v] != 1)
        return "OK with triangles that wind around an interior vertex more than once";
    // The angle at a border vertex may be so large that triangles overlap there. Then the border is not simple.
    return parameterizer.report().border_is_simple ? "OK with a border that is said to be simple and is not"
                                                   : "";
  }

  // Errors in the report and the result of the parameterizer; empty if there are none.
  std::string contradiction() const
  {
    const SMP::ABF_plus_plus_report& report = parameterizer.report();
    if(error_code(report.status) != code ||
       (report.status == SMP::Diagnosis::NOTHING_WRONG) != (code == SMP::OK) ||
       report.message.empty() != (code == SMP::OK))
      return "the report contradicts the error code";
    if(code == SMP::OK)
      return fault_of_map();
    for(Vertex v : mesh.vertices())
      if(uv[v] != untouched)
        return "the map was changed in spite of an error";
    const std::set<SMP::Error_code> documented{SMP::ERROR_NO_TOPOLOGICAL_DISC, SMP::ERROR_NO_1_TO_1_MAPPING,
                                               SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM,
                                               SMP::ERROR_WRONG_PARAMETER};
    return documented.count(code) ? "" : "an error code that is not documented for this";
  }

  const Point_2 untouched{-17, 42};
  Surface_mesh mesh;
  Surface_mesh::Property_map<Vertex, Point_2> uv;
  Parameterizer parameterizer{refusing_holes()};
  SMP::Error_code code;
  std::set<int> offenders;
};

// Runs a generator with all seeds; the seeds that fail are reported in one line.
template <typename Generator, typename Judge>
void check_all(const std::string& name, int runs, const Generator& generate, const Judge& judge)
{
  std::ostringstream failures;
  int failed = 0;
  for(int seed = 1; seed <= runs; ++seed) {
    BOOST_TEST_CHECKPOINT(name << ", seed " << seed); // reported if a run crashes
    std::mt19937 random(static_cast<unsigned>(seed));
    const std::string failure = judge(generate(random));
    if(!failure.empty() && ++failed <= 5)
      failures << "\n  seed " << seed << ": " << failure;
  }
  BOOST_TEST(failed == 0, name << ": " << failed << " of " << runs << " fail, among them" << failures.str());
}

void check_feasible(const std::string& name, const std::function<Chart(std::mt19937&)>& generate,
                    int runs = seeds, bool may_exceed_precision = false)
{
  check_all(name, runs, generate, [=](const Chart& chart) -> std::string {
    const Run run(chart);
    const std::string contradiction = run.contradiction();
    if(!contradiction.empty() || run.code == SMP::OK)
      return contradiction;
    if(may_exceed_precision && run.parameterizer.report().status == SMP::Diagnosis::PRECISION_EXCEEDED)
      return "";
    std::ostringstream text;
    text << "error " << run.code << " with " << chart.number_of_triangles() << " triangles, "
         << chart.number_of_interior_vertices << " interior vertices: " << run.parameterizer.report().message;
    return text.str();
  });
}

void check_without_area(const std::string& name, const std::function<Chart(std::mt19937&)>& generate)
{
  check_all(name, 10, generate, [=](const Chart& chart) -> std::string {
    const Run run(chart);
    const auto& report = run.parameterizer.report();
    return report.status == SMP::Diagnosis::NO_AREA &&
                   report.degenerate_triangles == chart.number_of_triangles() &&
                   report.offending_faces.size() == static_cast<std::size_t>(chart.number_of_triangles())
               ? run.contradiction()
               : "not without area: " + report.message;
  });
}

void check_infeasible(const std::string& name, const std::function<Infeasible_chart(std::mt19937&)>& generate)
{
  check_all(name, seeds, generate, [](const Infeasible_chart& infeasible) -> std::string {
    const Run run(infeasible.chart);
    const std::string contradiction = run.contradiction();
    if(!contradiction.empty())
      return contradiction;
    const std::vector<std::set<int>>& expected = infeasible.offenders;
    if(run.parameterizer.report().status != infeasible.status ||
       std::find(expected.begin(), expected.end(), run.offenders) == expected.end())
      return "another diagnosis: " + run.parameterizer.report().message;
    return "";
  });
}

double any_height(std::mt19937& random)
{
  return std::exp(uniform(random, 0, std::log(100.)));
}

Chart any_smooth_chart(std::mt19937& random)
{
  return round_bump(uniform_int(random, 2, 6), uniform(random, 0, 2));
}

} // namespace

BOOST_AUTO_TEST_CASE(steep)
{
  check_feasible("cone", [](auto& random) { return cone(uniform_int(random, 1, 9), any_height(random)); });
  check_feasible("bump",
                 [](auto& random) { return round_bump(uniform_int(random, 1, 9), any_height(random)); });
  check_feasible("saddle",
                 [](auto& random) { return saddle(uniform_int(random, 1, 9), any_height(random)); });
  check_feasible(
      "fine cone", [](auto& random) { return cone(30, any_height(random)); }, 3);
  check_feasible(
      "fine bump", [](auto& random) { return round_bump(30, any_height(random)); }, 3);
  check_feasible(
      "fine saddle", [](auto& random) { return saddle(30, any_height(random)); }, 3);
  check_feasible("pyramid",
                 [](auto& random) { return pyramid(uniform_int(random, 3, 40), any_height(random)); });
}

BOOST_AUTO_TEST_CASE(noise)
{
  check_feasible("terrain", [](auto& random) {
    return noisy_terrain(uniform_int(random, 2, 12), uniform(random, 0, 1), random);
  });
  check_feasible("rough terrain", [](auto& random) {
    return noisy_terrain(uniform_int(random, 2, 12), uniform(random, 1, 10), random);
  });
}

BOOST_AUTO_TEST_CASE(nested)
{
  auto corner = [](int v) { return Point_3(v == 1, v == 2, 0); };
  check_feasible("nested at random", [](auto& random) {
    return nested_insertions(uniform_int(random, 1, 40), random() % 2,
                             [&](int) { return random_point(random); });
  });
  check_feasible(
      "nested deeply at random",
      [](auto& random) {
        return nested_insertions(400, random() % 2, [&](int) { return random_point(random); });
      },
      4);
  for(int depth : {10, 100, 400, 1000})
    check_feasible(
        "nested slivers, " + std::to_string(depth),
        [&](auto&) {
          return nested_insertions(depth, false,
                                   [&](int v) { return v < 3 ? corner(v) : Point_3(0.4, 1 / double(v), 0); });
        },
        1);
  for(int depth : {5, 10, 20, 40, 100, 400})
    check_feasible(
        "nested and shrinking, " + std::to_string(depth),
        [&](auto&) {
          std::vector<Point_3> last{corner(0), corner(1), corner(2)};
          return nested_insertions(depth, true, [&](int v) {
            if(v < 3)
              return corner(v);
            return last[v % 3] = CGAL::centroid(last[0], last[1], last[2]);
          });
        },
        1, depth > 100); // triangles of 1e-48 and less
}

BOOST_AUTO_TEST_CASE(elongated)
{
  check_feasible("spiral", [](auto& random) { return spiral(uniform_int(random, 1, 300)); });
  check_feasible("strip", [](auto& random) { return strip(2 * uniform_int(random, 1, 100)); });
  check_feasible("comb", [](auto& random) {
    return comb(uniform_int(random, 1, 20), uniform_int(random, 1, 20), uniform(random, 0, 1));
  });
  if(!EVERY_CHART_IS_SANITIZED)
    check_feasible(
        "long strip", [](auto&) { return strip(100000); }, 1);
}

BOOST_AUTO_TEST_CASE(stars)
{
  check_feasible("star", [](auto& random) { return star(uniform_int(random, 3, 60), false, random); });
  check_feasible("star with two rings",
                 [](auto& random) { return star(uniform_int(random, 3, 60), true, random); });
  check_feasible(
      "large star", [](auto& random) { return star(1000, random() % 2, random); }, 4);
}

BOOST_AUTO_TEST_CASE(cut_open)
{
  check_feasible("annulus", [](auto& random) {
    return cut_annulus(uniform_int(random, 3, 30), uniform_int(random, 1, 6), 0);
  });
  check_feasible("cylinder", [](auto& random) {
    return cut_annulus(uniform_int(random, 3, 30), uniform_int(random, 1, 6), any_height(random));
  });
  check_feasible("sphere", [](auto& random) { return cut_sphere(uniform_int(random, 0, 3), random); });
}

BOOST_AUTO_TEST_CASE(random_charts)
{
  check_feasible("random charts",
                 [](auto& random) { return random_chart(uniform_int(random, 1, 100), random); });
  check_feasible("larger random charts",
                 [](auto& random) { return random_chart(uniform_int(random, 100, 500), random); });
  check_feasible(
      "large random charts", [](auto& random) { return random_chart(5000, random); }, 3);
}

BOOST_AUTO_TEST_CASE(degenerate)
{
  check_feasible("slivers", [](auto& random) {
    return slivers(any_smooth_chart(random), uniform_int(random, 1, 5), 1e-12, random);
  });
  check_feasible("collinear triangles", [](auto& random) {
    return slivers(any_smooth_chart(random), uniform_int(random, 1, 5), 0, random);
  });
  check_feasible("duplicated points", [](auto& random) {
    return duplicated_points(any_smooth_chart(random), uniform_int(random, 1, 5), random);
  });
  check_without_area("in a line", [](auto& random) { return in_a_line(any_smooth_chart(random)); });
  check_without_area("in a point", [](auto& random) { return in_a_point(any_smooth_chart(random)); });
  for(double factor : {1e-300, 1e-160, 1e-30, 1e30, 1e160, 1e300})
    check_feasible(
        "scaled by " + std::to_string(std::log10(factor)),
        [=](auto& random) { return scaled(any_smooth_chart(random), factor); }, 5);
}

BOOST_AUTO_TEST_CASE(infeasible)
{
  check_infeasible("parallel edges",
                   [](auto& random) { return parallel_edges(any_smooth_chart(random), random); });
  check_infeasible("interior degree 2",
                   [](auto& random) { return interior_degree_2(any_smooth_chart(random), random); });
  check_infeasible("interior degree 1",
                   [](auto& random) { return interior_degree_1(any_smooth_chart(random), random); });
  check_infeasible("slit edge", [](auto& random) { return slit_edge(uniform_int(random, 0, 3), random); });
  check_infeasible("bow-tie", [](auto& random) { return bow_tie(uniform_int(random, 5, 20), random); });
  check_infeasible("non-finite point",
                   [](auto& random) { return non_finite_point(any_smooth_chart(random), random); });
  check_infeasible("two borders", [](auto& random) { return two_borders(uniform_int(random, 3, 30)); });
  check_infeasible("handle", [](auto& random) { return handle(uniform_int(random, 3, 9)); });
}

BOOST_AUTO_TEST_SUITE_END()

#undef EVERY_CHART_IS_SANITIZED
