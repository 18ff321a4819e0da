// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Each option of both parameterizers has an effect, or is refused by name (see `option_effects.h`). A new option needs
// another value in `changed_values()`, and perhaps a situation.

#include <boost/test/unit_test.hpp>

#include "hard_charts.h"
#include "mesh_of_chart.h"
#include "option_effects.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_options_have_effects)

using namespace test_charts;
using option_effects::add_values;
using option_effects::Changes;
using option_effects::Outcome;
using option_effects::set;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::ABF_plus_plus_options Direct_options;
typedef SMP::Hierarchical_options Hierarchical_options;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Simple_cartesian<double>::Point_2 UV;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Halfedge_index Halfedge;

namespace {

// A surface and what is asked for it
struct Task
{
  Mesh mesh;
  std::map<int, UV> pins;                  // positions of vertices
  std::map<Halfedge, Halfedge> seam_sides; // of border halfedges

  explicit Task(const Chart& chart) { make_mesh(chart, mesh); }

  Halfedge border_between(int v, int w) const
  {
    const Halfedge h = mesh.halfedge(Vertex(v), Vertex(w));
    return mesh.is_border(h) ? h : mesh.opposite(h);
  }

  void add_seam(Halfedge h, Halfedge g)
  {
    seam_sides[h] = g;
    seam_sides[g] = h;
  }
};

// A bump with a hole
Task holed_bump()
{
  const Chart chart = bump(16, 3, 1);
  Triangles triangles;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    if(t != 250)
      triangles.push_back({chart.vertex[3 * t], chart.vertex[3 * t + 1], chart.vertex[3 * t + 2]});
  return Task(make_chart(chart.points, triangles));
}

// A ramp that winds up by more than a full turn: in the plane, it overlaps itself.
Task winding_ramp()
{
  const int rows = 6, sectors = 40;
  return Task(patch(sectors, rows, [](int i, int j) {
    const double angle = 2.5 * CGAL_PI * i / sectors, radius = 2 + 1. * j / rows;
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), 0.05 * angle * radius);
  }));
}

// Terrain on which Newton's method fails
Task steep_noise()
{
  std::mt19937 random(4);
  return Task(noisy_terrain(12, 60, random));
}

// One side of a sheet is a seam, folded in its middle.
Task sheet_with_seam()
{
  const int n = 12;
  Task task(bump(n, 5));
  for(int i = 0; i < n / 2; ++i)
    task.add_seam(task.border_between(i * (n + 1), (i + 1) * (n + 1)),
                  task.border_between((n - i - 1) * (n + 1), (n - i) * (n + 1)));
  return task;
}

// With more vertices than the coarse chart of injective maps has
Task sheet_with_pins()
{
  Task task(bump(20, 6, 1));
  task.pins = {{0, {0, 0}}, {20, {0.1, 1.2}}, {220, {0.4, 0.6}}, {420, {1, 0.1}}};
  return task;
}

const std::vector<Task>& all_tasks()
{
  static const std::vector<Task> tasks{holed_bump(), winding_ramp(), steep_noise(), sheet_with_seam(),
                                       sheet_with_pins()};
  return tasks;
}

void write_report(std::ostream& out, const SMP::ABF_plus_plus_report& report)
{
  out << report.strategy << report.layout << ' ' << report.iterations << ' ' << report.energy << ' '
      << report.constraint_residual;
  for(const SMP::ABF_plus_plus_step& step : report.steps)
    out << ' ' << step.linear_iterations << ' ' << step.energy;
}

void write_report(std::ostream& out, const SMP::Hierarchical_report& report)
{
  out << report.start << report.coarse_triangles << ' ' << report.angle_sweeps << ' ' << report.energy << ' '
      << report.polished << report.polish_iterations << report.polishing_timed_out << report.note
      << report.failed_coarse_charts.size();
}

// What a caller sees of a run, and of another one after a vertex has moved
template <typename Parameterizer, typename Options>
Outcome run(const Task& task, const Options& options)
{
  Mesh mesh = task.mesh;
  Parameterizer parameterizer(options);
  if(!task.pins.empty()) {
    const auto pins = mesh.add_property_map<Vertex, std::optional<UV>>("v:pin").first;
    for(const auto& [v, position] : task.pins)
      pins[Vertex(v)] = position;
    parameterizer.set_pins(pins);
  }
  if constexpr(std::is_same_v<Options, Direct_options>)
    if(!task.seam_sides.empty())
      parameterizer.set_seam_sides(boost::make_function_property_map<Halfedge>([&](Halfedge h) {
        const auto side = task.seam_sides.find(h);
        return side == task.seam_sides.end() ? Mesh::null_halfedge() : side->second;
      }));
  const auto uv = mesh.add_property_map<Vertex, UV>("v:uv", UV(-1, -1)).first;
  const auto done = mesh.add_property_map<Vertex, bool>("v:done", false).first;
  Outcome outcome{SMP::Diagnosis::NOTHING_WRONG, {}, {}};
  std::ostringstream text;
  text.precision(17);
  for(int repetition = 0; repetition < (std::is_same_v<Options, Direct_options> ? 2 : 1); ++repetition) {
    parameterizer.parameterize(mesh, CGAL::Polygon_mesh_processing::longest_border(mesh).first, uv,
                               get(boost::vertex_index, mesh), done);
    const auto& report = parameterizer.report();
    text << report << ' ';
    write_report(text, report);
    for(const Vertex v : mesh.vertices())
      text << ' ' << uv[v];
    if(repetition == 0) {
      outcome.status = report.status;
      outcome.message = report.message;
    }
    Mesh::Point& p = mesh.point(Vertex(40));
    p = Mesh::Point(p.x(), p.y(), p.z() + 1e-3);
  }
  outcome.text = text.str();
  return outcome;
}

template <typename Options>
struct Method;

template <>
struct Method<Direct_options>
{
  typedef SMP::ABF_plus_plus_parameterizer_3<Mesh> type;
};

template <>
struct Method<Hierarchical_options>
{
  typedef SMP::Hierarchical_parameterizer_3<Mesh> type;
};

template <typename Options>
std::vector<Outcome> outcomes(const Options& options)
{
  std::vector<Outcome> result;
  for(const Task& task : all_tasks())
    result.push_back(run<typename Method<Options>::type>(task, options));
  return result;
}

template <typename Options>
Changes<Options> changes_of_both()
{
  typedef SMP::Flattening_options Both;
  return {{"barrier", set<Options>(&Both::barrier, 3.)},
          {"threads", set<Options>(&Both::threads, -1)}, // other numbers never change anything
          {"holes", set<Options>(&Both::holes, Both::REFUSE)},
          {"fallbacks", set<Options>(&Both::fallbacks, false)},
          {"injective", set<Options>(&Both::injective, true)},
          {"area_weight", set<Options>(&Both::area_weight, 0.05)},
          {"area_weight", set<Options>(&Both::area_weight, 0.9)},
          {"clearance", set<Options>(&Both::clearance, 0.9)},
          {"pin_weight", set<Options>(&Both::pin_weight, 0.1)},
          {"time_limit", set<Options>(&Both::time_limit, 0.)}};
}

Changes<Direct_options> changed_values(const Direct_options&)
{
  typedef Direct_options O;
  Changes<O> changes = changes_of_both<O>();
  changes.insert({{"tolerance", set<O>(&O::tolerance, 1e-12)},
                  {"energy_tolerance", set<O>(&O::energy_tolerance, 1e-13)},
                  {"max_iterations", set<O>(&O::max_iterations, 1)},
                  {"step", set<O>(&O::step, O::SEQUENTIAL_LINEARLY_CONSTRAINED)},
                  {"linear_solver", set<O>(&O::linear_solver, O::DIRECT)},
                  {"layout", set<O>(&O::layout, O::LEAST_SQUARES_LAYOUT)},
                  {"equal_seam_lengths", set<O>(&O::equal_seam_lengths, std::optional<bool>(true))},
                  {"warm_start", set<O>(&O::warm_start, true)}});
  return changes;
}

Changes<Hierarchical_options> changed_values(const Hierarchical_options&)
{
  typedef Hierarchical_options O;
  Changes<O> changes = changes_of_both<O>();
  changes.insert({{"simplification_rate", set<O>(&O::simplification_rate, 0.3)},
                  {"coarse_triangles", set<O>(&O::coarse_triangles, 500)},
                  {"extreme_angle", set<O>(&O::extreme_angle, 0.5)},
                  {"sweeps", set<O>(&O::sweeps, 0)},
                  {"angle_sweeps", set<O>(&O::angle_sweeps, 9)},
                  {"energy_tolerance", set<O>(&O::energy_tolerance, 0.5)},
                  {"max_retries", set<O>(&O::max_retries, 0)},
                  {"polish", set<O>(&O::polish, true)}});
  for(const auto& [name, change] : changed_values(Direct_options()))
    changes.emplace("polish_options." + name,
                    [change = change](O& options) { change(options.polish_options); });
  return changes;
}

std::map<std::string, std::string> values_of(const Direct_options& options)
{
  std::map<std::string, std::string> values;
  add_values(options, "", values);
  return values;
}

std::map<std::string, std::string> values_of(const Hierarchical_options& options)
{
  std::map<std::string, std::string> values;
  add_values(options, "", values);
  add_values(options.polish_options, "polish_options.", values);
  return values;
}

// What happens if something fails does not matter in each situation. Without a Newton step, how steps are taken does not
// matter.
bool may_have_no_effect(const std::string& option, const std::string& situation)
{
  return option == "fallbacks" || option == "max_retries" || situation == "no step" ||
         (option == "barrier" && situation == "isometric"); // which only mends crushed triangles
}

// `test_coarse_parameterizers.cpp` has coarse charts that fail, for `max_retries`.
template <typename Options>
void check(const std::map<std::string, std::function<void(Options&)>>& situations)
{
  option_effects::Checks<Options> checks{changed_values(Options()),
                                         situations,
                                         [](const Options& options) { return outcomes(options); },
                                         [](const Options& options) { return values_of(options); },
                                         may_have_no_effect,
                                         {"polish_options.threads", "max_retries"},
                                         {"threads"}}; // of which no number changes anything
  for(const char* other : {"holes", "fallbacks", "injective", "area_weight", "clearance", "pin_weight",
                           "equal_seam_lengths", "warm_start"})
    checks.only_refused.insert(std::string("polish_options.") + other);
  checks.check();
}

} // namespace

BOOST_AUTO_TEST_CASE(of_the_direct_method)
{
  typedef Direct_options O;
  check<O>({{"default", [](O&) {}},
            {"no barrier", [](O& o) { o.barrier = 0; }},
            {"no step", [](O& o) { o.max_iterations = 0; }},
            {"filled holes", [](O& o) { o.holes = O::FILL; }},
            {"steps of the paper", [](O& o) { o.step = O::SEQUENTIAL_LINEARLY_CONSTRAINED; }},
            {"least squares", [](O& o) { o.layout = O::LEAST_SQUARES_LAYOUT; }},
            {"injective", [](O& o) { o.injective = true; }},
            {"isometric", [](O& o) {
               o.injective = true;
               o.area_weight = 0.5;
             }}});
}

BOOST_AUTO_TEST_CASE(of_the_hierarchical_method)
{
  typedef Hierarchical_options O;
  check<O>({{"default", [](O&) {}},
            {"without fallbacks", [](O& o) { o.fallbacks = false; }},
            {"few triangles", [](O& o) { o.coarse_triangles = 300; }},
            {"angle sweeps", [](O& o) { o.angle_sweeps = 4; }},
            {"polish", [](O& o) { o.polish = true; }},
            {"injective", [](O& o) { o.injective = true; }},
            {"injective and polished",
             [](O& o) {
               o.injective = true;
               o.polish = true;
             }},
            {"isometric", [](O& o) {
               o.injective = true;
               o.area_weight = 0.5;
             }}});
}

BOOST_AUTO_TEST_SUITE_END()
