// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"

#include "run.h"

#include "../common/use_cores.h"

#include <CGAL/Aff_transformation_2.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include <cmath>
#include <exception>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hierarchical {

namespace {

typedef SMP::Hierarchical_report::Seconds Seconds;
typedef SMP::ABF_plus_plus_report::Seconds Direct_seconds;

const std::vector<std::pair<std::string, double Seconds::*>>& seconds_of_stages()
{
  static const std::vector<std::pair<std::string, double Seconds::*>> stages = {
      {"read", &Seconds::read},     {"coarsen", &Seconds::coarsen}, {"solve", &Seconds::coarse_chart},
      {"refine", &Seconds::refine}, {"polish", &Seconds::polish},   {"certify", &Seconds::certify},
      {"write", &Seconds::write}};
  return stages;
}

// Sets the number of threads, where the options have one.
const std::vector<std::pair<std::string, double Direct_seconds::*>>& seconds_of_direct_stages()
{
  static const std::vector<std::pair<std::string, double Direct_seconds::*>> stages = {
      {"read", &Direct_seconds::read},       {"targets", &Direct_seconds::targets},
      {"angles", &Direct_seconds::angles},   {"layout", &Direct_seconds::layout},
      {"certify", &Direct_seconds::certify}, {"write", &Direct_seconds::write}};
  return stages;
}

template <class Stages>
std::vector<std::string> names_of(const Stages& stages)
{
  std::vector<std::string> names;
  for(const auto& stage : stages) {
    names.push_back(stage.first);
  }
  return names;
}

template <class Options>
auto set_threads(Options& options, const int threads, int) -> decltype(void(options.threads = threads))
{
  options.threads = threads;
}

template <class Options>
void set_threads(Options&, int, long)
{}

Measurement run_method(const Task& task, Mesh& mesh)
{
  if(task.method == habf || task.method == polished) {
    return run(mesh, SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>(options_of(task)));
  } else if(task.method == direct) {
    return run(mesh, SMP::ABF_plus_plus_parameterizer_3<Mesh>());
  } else if(task.method == hlscm || task.method == lscm) {
    return run_lscm(task, mesh);
  } else if(task.method == sequential) {
    return run_sequential(task, mesh);
  }
  throw std::runtime_error("unknown method '" + task.method + "'");
}

} // namespace

SMP::Hierarchical_options options_of(const Task& task)
{
  SMP::Hierarchical_options options;
  options.simplification_rate = task.rate;
  options.sweeps = task.sweeps;
  options.polish = task.method == polished;
  set_threads(options, task.threads, 0);
  return options;
}

void take_report(const SMP::Hierarchical_report& report, Measurement& measurement)
{
  std::map<std::string, double>& numbers = measurement.numbers;
  for(const auto& [name, member] : seconds_of_stages()) {
    numbers[name] = report.seconds.*member;
  }
  numbers["levels"] = report.levels;
  numbers["coarse_triangles"] = report.coarse_triangles;
  numbers["retries"] = report.retries;
  numbers["without_solver"] = report.start == SMP::Hierarchical_report::PROGRESSIVE_EMBEDDING;
  numbers["kernel_insertions"] = report.kernel_insertions;
  numbers["polished"] = report.polished;
  numbers["newton_steps"] = report.polish_iterations;
}

void take_report(const SMP::ABF_plus_plus_report& report, Measurement& measurement)
{
  std::map<std::string, double>& numbers = measurement.numbers;
  for(const auto& [name, member] : seconds_of_direct_stages()) {
    numbers[name] = report.seconds.*member;
  }
  numbers["newton_steps"] = report.iterations;
  numbers["cg_steps"] = numbers["factorizations"] = 0;
  for(const SMP::ABF_plus_plus_step& step : report.steps) {
    numbers["cg_steps"] += step.linear_iterations;
    numbers["factorizations"] += step.factorizations;
  }
}

// The shear depends on the axes. For small distortions the root mean square over two pairs of axes at 45 degrees is
// the one over all pairs.
void measure_map(const Mesh& mesh, const Halfedge border, UV_map uv, Measurement& measurement)
{
  std::map<std::string, double>& numbers = measurement.numbers;
  const SMP::Flattening_measures measures = SMP::measure_flattening(mesh, border, uv);
  const CGAL::Aff_transformation_2<CGAL::Epick> turn(CGAL::ROTATION, std::sqrt(0.5), std::sqrt(0.5));
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    uv[v] = turn(uv[v]);
  }
  const double turned = SMP::measure_flattening(mesh, border, uv).l2_shear;
  numbers["shear_as_returned"] = measures.l2_shear;
  numbers["shear"] = std::sqrt((CGAL::square(measures.l2_shear) + CGAL::square(turned)) / 2);
  numbers["stretch"] = measures.l2_stretch;
  numbers["flips"] = measures.flipped_triangles;
}

const std::vector<std::string>& stages()
{
  static const std::vector<std::string> names = names_of(seconds_of_stages());
  return names;
}

const std::vector<std::string>& direct_stages()
{
  static const std::vector<std::string> names = names_of(seconds_of_direct_stages());
  return names;
}

Measurement measure(const Task& task)
{
  try {
    use_cores(task.threads);
    Mesh mesh = read_mesh(task.file);
    return run_method(task, mesh);
  } catch(const std::bad_alloc&) {
    return failed_measurement("out of memory");
  } catch(const std::exception& error) {
    return failed_measurement(error.what());
  }
}

} // namespace hierarchical
