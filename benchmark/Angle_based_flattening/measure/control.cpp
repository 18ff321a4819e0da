// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "subcommands.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/corners_of_map.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>
#include <vector>

namespace ABF_benchmark {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef SMP::Vertex_angles<Mesh> Angles;
typedef SMP::ABF_plus_plus_options Options;

// One way to flatten a surface, and what it gave
struct Way
{
  std::string name;
  Options options;
  std::optional<Angles> angles;
  double predicted = NAN; // L2 stretch
  SMP::ABF_plus_plus_report report = {};
  SMP::Flattening_measures measures = {};
  std::vector<double> seconds = {};
};

template <class Flat_mesh, class Border, class UV_map>
void run(Way& way, Flat_mesh& mesh, Border border, UV_map uv)
{
  SMP::ABF_plus_plus_parameterizer_3<Flat_mesh> parameterizer(way.options);
  if(way.angles)
    parameterizer.set_angle_sums(*way.angles);
  way.seconds.push_back(seconds_of([&] { SMP::parameterize(mesh, parameterizer, border, uv); }));
  way.report = parameterizer.report();
  if(way.report.status == SMP::Diagnosis::NOTHING_WRONG)
    way.measures = SMP::measure_flattening(mesh, border, uv);
}

double median(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  const std::size_t half = numbers.size() / 2;
  return numbers.size() % 2 == 1 ? numbers[half] : (numbers[half - 1] + numbers[half]) / 2;
}

// The ratio of times is the median of those side by side.
void add_to(const Way& way, const Way& first, Measurement& m)
{
  m.add("way", way.name);
  m.add("predicted", way.predicted);
  if(way.report.status != SMP::Diagnosis::NOTHING_WRONG)
    return m.fail(way.report.message);
  std::vector<double> ratios;
  std::transform(way.seconds.begin(), way.seconds.end(), first.seconds.begin(), std::back_inserter(ratios),
                 std::divides<double>());
  int cg_steps = 0, factorizations = 0;
  for(const SMP::ABF_plus_plus_step& step : way.report.steps) {
    cg_steps += step.linear_iterations;
    factorizations += step.factorizations;
  }
  m.add("seconds", median(way.seconds));
  m.add("ratio", median(ratios));
  m.add("read", way.report.seconds.read);
  m.add("angles", way.report.seconds.angles);
  m.add("layout", way.report.seconds.layout);
  m.add("newton_steps", way.report.iterations);
  m.add("cg_steps", cg_steps);
  m.add("factorizations", factorizations);
  m.add("strategy", static_cast<int>(way.report.strategy));
  m.add("energy", way.measures.angular_distortion);
  m.add("relative_energy", way.measures.angular_distortion / first.measures.angular_distortion);
  m.add("stretch", way.measures.l2_stretch);
  m.add("quasi_conformal", way.measures.mean_quasi_conformal_ratio);
  m.add("largest_quasi_conformal", way.measures.max_quasi_conformal_ratio);
  m.add("angle_change", way.measures.mean_angle_change);
  m.add("flips", way.measures.flipped_triangles);
  m.add("border_is_simple", way.measures.border_is_simple);
  m.add("jump", way.report.largest_seam_jump);
  m.add("turn", way.report.largest_seam_turn);
  m.add("angle_error", way.report.largest_angle_error);
  m.add("side_deviation", way.report.side_deviation);
}

// Prints a line for each way, but for the last one, which it leaves in `m`.
void print(const std::vector<Way>& ways, Measurement& m)
{
  const Measurement common = m;
  for(const Way& way : ways) {
    m = common;
    add_to(way, ways.front(), m);
    if(&way != &ways.back())
      std::cout << m;
  }
}

Way with_cones(const std::string& name, const TA::Cone_selection<Mesh>& selection)
{
  if(!selection)
    throw std::runtime_error(selection.message);
  return {name, Options(), selection.angles(), selection.predicted_stretch};
}

bool is_sphere(const Mesh& mesh)
{
  return CGAL::is_closed(mesh) && static_cast<long>(num_vertices(mesh)) - static_cast<long>(num_edges(mesh)) +
                                          static_cast<long>(num_faces(mesh)) ==
                                      2;
}

} // namespace

void cones(const std::string& file, const Control_choice& choice, Measurement& m)
{
  Mesh mesh;
  read_mesh(file, mesh);
  m.add("triangles", mesh.number_of_faces());
  TA::Cone_selection<Mesh> selection;
  m.add("cone_seconds", seconds_of([&] { selection = TA::select_cones(mesh, choice.cones); }));
  Options cut_first;
  cut_first.equal_seam_lengths = false;
  std::vector<Way> ways = {{"cut first", cut_first, {}}, {"equal", Options(), {}}};
  ways.push_back(with_cones("rigid", selection));
  TA::Cone_options least, quarters;
  least.angles = TA::Cone_angles::LEAST_SQUARES;
  quarters.angle_multiple = CGAL_PI / 2;
  const auto least_squares = TA::select_cones(mesh, choice.cones, least);
  if(least_squares.status != SMP::Diagnosis::INFEASIBLE_ANGLE_SUMS) // few cones can need a negative angle
    ways.push_back(with_cones("least squares", least_squares));
  if(is_sphere(mesh))
    ways.push_back(with_cones("quarters", TA::select_cones(mesh, choice.cones, quarters)));
  m.add("cones", selection.cones.size());

  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  TA::Seam_report seam_report;
  const std::set<Mesh::Vertex_index> terminals = selection.vertices();
  m.add("seam_seconds", seconds_of([&] {
          seam_report = TA::cut_to_disks(
              mesh, seams,
              CGAL::parameters::vertex_is_constrained_map(CGAL::make_boolean_property_map(terminals)));
        }));
  if(!seam_report)
    return m.fail(seam_report.message);
  m.add("seam", seam_report.relative_seam_length);
  auto cut = TA::make_seam_mesh(mesh, seams).mesh;
  const auto border = TA::border_halfedge(cut);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, abf::Chart::Point_2>("h:uv", {0, 0}).first;
  for(int i = 0; i < choice.repeat; ++i)
    for(Way& way : ways)
      run(way, cut, border, uv);
  print(ways, m);
}

void rectangle(const std::string& file, const Control_choice& choice, Measurement& m)
{
  Mesh mesh;
  read_mesh(file, mesh);
  m.add("triangles", mesh.number_of_faces());
  const auto border = PMP::longest_border(mesh).first;
  if(border == Mesh::null_halfedge())
    throw std::runtime_error("the mesh has no border");
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, abf::Chart::Point_2>("v:uv", {0, 0}).first;
  std::vector<Way> ways = {{"free", Options(), {}}};
  run(ways.front(), mesh, border, uv);
  if(ways.front().report.status != SMP::Diagnosis::NOTHING_WRONG)
    return m.fail(ways.front().report.message);

  std::vector<Mesh::Vertex_index> vertices;
  for(const auto v : vertices_around_face(border, mesh))
    vertices.push_back(v);
  const auto corners = SMP::internal::ABF::corners_of_map(vertices, uv);
  const Angles angles = SMP::rectangle_angles(mesh, corners).angles;
  m.add("split_edges", SMP::split_flat_chords(mesh, border, angles).edges.size());
  Angles right;
  for(const auto v : corners)
    right.set(v, CGAL_PI / 2);
  ways = {{"free", Options(), {}}, {"four corners", Options(), right}, {"rectangle", Options(), angles}};
  ways.push_back({"rectangle, to 1e-9", Options(), angles});
  ways.back().options.tolerance = 1e-9;
  for(int i = 0; i < choice.repeat; ++i)
    for(Way& way : ways)
      run(way, mesh, border, uv);
  print(ways, m);
}

} // namespace ABF_benchmark
