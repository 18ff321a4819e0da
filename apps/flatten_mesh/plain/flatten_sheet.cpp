// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/flatten_sheet.h"

#include "flatten_mesh/plain/Chosen_solver.h"

#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/squared_distance_2.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace {

// The numbers of the first few of many vertices, as in "vertices 3, 17, ...".
std::string vertices_text(const Sheet& sheet, const std::vector<Vertex>& vertices)
{
  std::vector<std::size_t> numbers; // a vertex on a seam has several copies
  for(const Vertex v : vertices) {
    const std::size_t number = sheet.input_vertex(v).idx() + 1;
    if(numbers.size() < 7 && std::find(numbers.begin(), numbers.end(), number) == numbers.end()) {
      numbers.push_back(number);
    }
  }
  const std::size_t shown = (std::min)(numbers.size(), std::size_t(6));
  std::string text = numbers.size() == 1 ? "vertex " : "vertices ";
  for(std::size_t i = 0; i < shown; ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  }
  return text + (shown < numbers.size() ? ", ..." : "");
}

// Where the fault is, in the numbers that the user knows. Of faces these are the vertices: larger polygons
// were divided.
template <class Parameterizer>
std::string place_text(const Sheet& sheet, const Parameterizer& parameterizer)
{
  if(!parameterizer.report().offending_vertices.empty()) {
    return " (" + vertices_text(sheet, parameterizer.report().offending_vertices) + ")";
  }
  if(!parameterizer.report().offending_faces.empty()) {
    const Mesh& mesh = sheet.mesh();
    const Halfedge h = mesh.halfedge(parameterizer.report().offending_faces.front());
    const auto vertices = mesh.vertices_around_face(h);
    return " (the triangle of " +
           vertices_text(sheet, std::vector<Vertex>(vertices.begin(), vertices.end())) +
           (parameterizer.report().offending_faces.size() > 1 ? ", and others)" : ")");
  }
  return "";
}

void take_report(const SMP::ABF_plus_plus_report& report, Flattening& flattening)
{
  const SMP::ABF_plus_plus_report::Seconds& seconds = report.seconds;
  flattening.report = report;
  flattening.stages = {{"chart", seconds.read},    {"targets", seconds.targets}, {"angles", seconds.angles},
                       {"layout", seconds.layout}, {"certify", seconds.certify}, {"uv", seconds.write}};
  if(report.strategy == SMP::ABF_plus_plus_report::INJECTIVE_DESCENT) {
    flattening.stages.insert(flattening.stages.end() - 2, {{"coarsen", seconds.coarsen},
                                                           {"solve", seconds.coarse_chart},
                                                           {"refine", seconds.refine},
                                                           {"polish", seconds.polish}});
  }
}

void take_report(const SMP::Hierarchical_report& report, Flattening& flattening)
{
  const SMP::Hierarchical_report::Seconds& seconds = report.seconds;
  static_cast<SMP::Flattening_report&>(flattening.report) = report;
  flattening.report.iterations = report.polish_iterations;
  flattening.report.energy = report.energy;
  flattening.report.constraint_residual = report.constraint_residual;
  flattening.levels = report.levels;
  flattening.coarse_triangles = report.coarse_triangles;
  flattening.has_relaxed_angles = report.relaxed_angles;
  flattening.is_polished = report.polished;
  flattening.stages = {
      {"chart", seconds.read},    {"coarsen", seconds.coarsen}, {"solve", seconds.coarse_chart},
      {"refine", seconds.refine}, {"polish", seconds.polish},   {"certify", seconds.certify},
      {"uv", seconds.write}};
}

template <class Parameterizer>
void run_parameterizer(const Sheet& sheet, Parameterizer& parameterizer, const UV_map& uv,
                       Flattening& flattening)
{
  Mesh& mesh = sheet.mesh();
  const auto is_parameterized = mesh.add_property_map<Vertex, bool>("v:flatten_mesh_done", false).first;
  CGAL::Real_timer timer;
  timer.start();
  parameterizer.parameterize(mesh, sheet.border, uv, get(boost::vertex_index, mesh), is_parameterized);
  timer.stop();
  flattening.parameterize_seconds += timer.time();
  take_report(parameterizer.report(), flattening);
  flattening.place = place_text(sheet, parameterizer);
}

void flatten_directly(const Sheet& sheet, const Chosen_solver& solver,
                      const SMP::ABF_plus_plus_options& options, const UV_map& uv, Flattening& flattening)
{
  flattening.method = "direct";
  flattening.has_equal_seams = options.equal_seam_lengths.value_or(false);
  SMP::ABF_plus_plus_parameterizer_3<Mesh, Chosen_solver> direct(options, solver);
  if(sheet.angles) {
    direct.set_angle_sums(*sheet.angles);
  }
  if(!sheet.seam_sides.empty()) {
    direct.set_seam_sides(boost::make_function_property_map<Halfedge>(
        [&sheet](const Halfedge h) { return sheet.seam_sides[h.idx()]; }));
  }
  run_parameterizer(sheet, direct, uv, flattening);
}

// Both sides of seams get equal lengths, unless something else is asked for, or that fails.
void flatten_with_equal_seams(const Sheet& sheet, const Chosen_solver& solver,
                              SMP::ABF_plus_plus_options options, const UV_map& uv, Flattening& flattening)
{
  const bool is_default = !options.equal_seam_lengths && !sheet.seam_sides.empty();
  if(is_default) {
    options.equal_seam_lengths = true;
  }
  flatten_directly(sheet, solver, options, uv, flattening);
  if(!is_default || flattening.succeeded() || !is_failure_of_computation(flattening.report)) {
    return;
  }
  const std::string message = flattening.report.message;
  const double seconds = flattening.parameterize_seconds;
  options.equal_seam_lengths = false;
  flatten_directly(sheet, solver, options, uv, flattening);
  flattening.stages.insert(flattening.stages.begin(), {"attempt", seconds});
  flattening.note +=
      std::string(flattening.note.empty() ? "" : "; ") +
      "the two sides of a seam have different lengths, because the map with equal lengths failed: " + message;
}

// Whether the energy of a hierarchical map is at most about 20 % above that of the direct method, by an estimate:
// sweeps until they gain little leave up to 15 %, and errors on the scale of the coarse chart were at most 1.6 % of its
// energy (per triangle) on all terrains that were measured.
bool is_close_to_direct(const SMP::Hierarchical_report& report, const SMP::ABF_plus_plus_report& coarse,
                        const SMP::Hierarchical_options& options)
{
  const double energy = report.energy / report.triangles;
  return report.start == SMP::Hierarchical_report::COARSE_PARAMETERIZER &&
         report.angle_sweeps < options.angle_sweeps && coarse.energy / coarse.triangles <= 9 * energy;
}

// Returns whether `auto` takes the result: if it comes close to the direct one, or if the direct method would fail too.
bool flatten_hierarchically(const Sheet& sheet, const Chosen_solver& solver,
                            SMP::Hierarchical_options hierarchical, const SMP::ABF_plus_plus_options& options,
                            const UV_map& uv, Flattening& flattening)
{
  using Coarse = SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh, Chosen_solver>;
  flattening.method = "hierarchical";
  static_cast<SMP::Flattening_options&>(hierarchical) = options;
  hierarchical.visitor = nullptr; // the coarse parameterizer tells its steps
  hierarchical.polish_options = options;
  SMP::Hierarchical_parameterizer_3<Mesh, Coarse> parameterizer(hierarchical, Coarse(options, solver));
  run_parameterizer(sheet, parameterizer, uv, flattening);
  if(!flattening.succeeded()) {
    return !is_failure_of_computation(flattening.report);
  }
  return options.injective || parameterizer.report().polished ||
         is_close_to_direct(parameterizer.report(), parameterizer.coarse_parameterizer().report(),
                            hierarchical);
}

// From more triangles on, the direct method takes several seconds, and the other one a third to a half of that.
constexpr std::size_t direct_is_slow = 200000;

void choose_method(const Sheet& sheet, const Command_line& command, const SMP::ABF_plus_plus_options& options,
                   const UV_map& uv, Flattening& flattening)
{
  const Chosen_solver solver(command.solver);
  const bool is_direct_fast = sheet.faces.size() <= direct_is_slow && !options.injective;
  if(command.method == "direct" || (command.method == "auto" && is_direct_fast) || sheet.angles ||
     options.equal_seam_lengths.value_or(false)) {
    flatten_with_equal_seams(sheet, solver, options, uv, flattening);
    return;
  }
  const bool is_taken = flatten_hierarchically(sheet, solver, command.hierarchical, options, uv, flattening);
  if(is_taken || command.method != "auto") {
    return;
  }
  flattening.note =
      flattening.succeeded()
          ? "the direct method replaced the hierarchical one, whose result was not close enough"
          : "the direct method replaced the hierarchical one, which failed: " + flattening.report.message;
  const double seconds = flattening.parameterize_seconds;
  flatten_with_equal_seams(sheet, solver, options, uv, flattening);
  flattening.stages.insert(flattening.stages.begin(), {"attempt", seconds});
}

// The largest difference between the logarithms of the lengths of both sides of an edge on a seam
double seam_jump(const Sheet& sheet, const UV_map& uv)
{
  const Mesh& mesh = sheet.mesh();
  const auto squared_length = [&](const Halfedge h) {
    return CGAL::squared_distance(uv[mesh.source(h)], uv[mesh.target(h)]);
  };
  const auto is_in_sheet = [&](const Halfedge h) {
    return std::binary_search(sheet.vertices.begin(), sheet.vertices.end(), mesh.target(h));
  };
  double jump = 0;
  for(std::size_t i = 0; i < sheet.seam_sides.size(); ++i) {
    const Halfedge h(static_cast<Mesh::size_type>(i)), other = sheet.seam_sides[i];
    if(other != Mesh::null_halfedge() && is_in_sheet(h) && is_in_sheet(other)) {
      jump = (std::max)(jump, std::abs(std::log(squared_length(h) / squared_length(other))) / 2);
    }
  }
  return jump;
}

} // namespace

void measure(const Sheet& sheet, Flattening& flattening)
{
  Mesh& mesh = sheet.mesh();
  CGAL::Real_timer timer;
  timer.start();
  flattening.distortion = mesh.add_property_map<Face, double>("f:flatten_mesh_distortion", 0.).first;
  double area = 0, stretched = 0;
  const auto add = [&](const Face f, const SMP::Flattening_face_measures& measures) {
    flattening.distortion[f] = measures.rms_angle_change * 180. / CGAL_PI;
    area += measures.area;
    stretched += measures.area > 0 ? measures.area / (measures.scale * measures.scale) : 0;
  };
  flattening.measures =
      SMP::measure_flattening(mesh, sheet.border, flattening.uv, CGAL::parameters::visitor(add));
  flattening.scale_stretch = std::sqrt(stretched / area);
  if(flattening.method == "hierarchical") {
    flattening.report.largest_seam_jump = seam_jump(sheet, flattening.uv);
  }
  flattening.measure_seconds += timer.time();
}

Flattening flatten_sheet(const Sheet& sheet, const Command_line& command, Progress& progress)
{
  Flattening flattening;
  flattening.uv = sheet.mesh().add_property_map<Vertex, Kernel::Point_2>("v:flatten_mesh_uv").first;
  SMP::ABF_plus_plus_options options = command.options;
  options.visitor = &progress;
  choose_method(sheet, command, options, flattening.uv, flattening);
  if(flattening.succeeded()) {
    measure(sheet, flattening);
  }
  return flattening;
}

} // namespace flatten_mesh
