// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Limits of time. Nothing here depends on how long anything takes: where a limit has to pass, something waits for it.

#include <boost/test/unit_test.hpp>

#include "scenes.h"
#include "seam_surfaces.h"
#include "test_meshes.h"
#include "test_options.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/select_cones.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_time_limits)

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using scenes::Mesh;
using scenes::Scene;

constexpr double infinity = std::numeric_limits<double>::infinity(), short_time = 0.03;

void wait_until_it_has_passed()
{
  std::this_thread::sleep_for(std::chrono::duration<double>(1.2 * short_time));
}

// Waits at the start of a stage, and notes the last one that it heard of.
template <typename Visitor>
struct Waiting_visitor : Visitor
{
  typedef typename Visitor::Stage Stage;

  explicit Waiting_visitor(Stage at) : stage(at) {}

  bool start(Stage s) override
  {
    last = s;
    if(s == stage && !has_waited) {
      has_waited = true;
      wait_until_it_has_passed();
    }
    return true;
  }

  Stage stage, last = Visitor::READ;
  bool has_waited = false;
};

std::string last_stage(SMP::Flattening_visitor::Stage stage)
{
  static const char* const names[] = {"READ",         "TARGET_ANGLES", "ANGLES", "LAYOUT",  "COARSEN",
                                      "COARSE_CHART", "REFINE",        "POLISH", "CERTIFY", "WRITE"};
  return std::string("not done after 0.03 s; the last stage was ") + names[stage];
}

std::string last_stage(TA::Atlas_visitor::Stage stage)
{
  static const char* const names[] = {"READ", "CHARTS", "PACK", "CERTIFY", "MEASURE", "WRITE"};
  return std::string("not done after 0.03 s; the last stage was ") + names[stage];
}

struct Slow_traits : CGAL::SuperLU_solver_traits<>
{
  bool factor(const Matrix& A, NT& D)
  {
    wait_until_it_has_passed();
    return CGAL::SuperLU_solver_traits<>::factor(A, D);
  }
};

// Options with a limit
template <typename Options>
Options limited(double limit)
{
  Options options;
  options.time_limit = limit;
  return options;
}

SMP::Hierarchical_options injective(double limit)
{
  SMP::Hierarchical_options options = limited<SMP::Hierarchical_options>(limit);
  options.injective = true;
  return options;
}

TA::Cone_options cones(double limit)
{
  TA::Cone_options options;
  options.parameterizer.time_limit = limit;
  return options;
}

typedef SMP::ABF_plus_plus_parameterizer_3<Mesh> Direct;
typedef SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh> Hierarchical;

// What all reports have in common
SMP::Report without_elements(const SMP::Report& report)
{
  return report;
}

typedef std::function<SMP::Report(Scene&, double)> Limited_call;

// All functions with a limit, for a disk
std::vector<Limited_call> calls_for_disks()
{
  return {[](Scene& s, double limit) -> SMP::Report {
            return without_elements(
                SMP::flatten_surface(s.mesh, s.uv, Direct(limited<SMP::ABF_plus_plus_options>(limit))));
          },
          [](Scene& s, double limit) -> SMP::Report {
            return without_elements(
                SMP::flatten_surface(s.mesh, s.uv, Hierarchical(limited<SMP::Hierarchical_options>(limit))));
          },
          [](Scene& s, double limit) -> SMP::Report {
            return without_elements(SMP::flatten_surface(s.mesh, s.uv, Hierarchical(injective(limit))));
          },
          [](Scene& s, double limit) -> SMP::Report {
            return without_elements(
                TA::make_atlas(s.mesh, s.seams, s.corner_uv, s.charts, limited<Few_charts>(limit)));
          },
          [](Scene& s, double limit) -> SMP::Report {
            return without_elements(TA::select_seams(s.mesh, s.seams, limited<TA::Seam_options>(limit)));
          },
          [](Scene& s, double limit) -> SMP::Report {
            return without_elements(TA::select_cones(s.mesh, 3, cones(limit)));
          },
          [](Scene& s, double limit) -> SMP::Report {
            return without_elements(TA::flatten_with_cones(s.mesh, 3, s.seams, s.corner_uv, cones(limit)));
          }};
}

} // namespace

BOOST_AUTO_TEST_CASE(limits_that_are_wrong)
{
  Scene scene(test_meshes::bump<Mesh>(4));
  for(const Limited_call& call : calls_for_disks())
    for(double limit : {-1., -infinity, std::numeric_limits<double>::quiet_NaN()}) {
      const SMP::Report& report = call(scene, limit);
      BOOST_TEST(report.status == SMP::Diagnosis::WRONG_OPTION);
      BOOST_TEST(report.message.find("time_limit is ") == 0);
      BOOST_TEST(report.message.find(", and must be at least 0") != std::string::npos);
      BOOST_TEST((scene.state() == scene.before));
    }
}

BOOST_AUTO_TEST_CASE(no_time_at_all)
{
  Scene scene(test_meshes::bump<Mesh>(4));
  for(const Limited_call& call : calls_for_disks()) {
    const SMP::Report& report = call(scene, 0);
    BOOST_TEST(report.status == SMP::Diagnosis::TIMED_OUT);
    BOOST_TEST(to_string(report.status) == "TIMED_OUT");
    BOOST_TEST(report.message.find("not done after 0 s") == 0);
    BOOST_TEST((scene.state() == scene.before));
  }
  BOOST_TEST(SMP::error_code(SMP::Diagnosis::TIMED_OUT) == SMP::ERROR_NO_1_TO_1_MAPPING);
}

BOOST_AUTO_TEST_CASE(time_enough_changes_nothing)
{
  for(const Limited_call& call : calls_for_disks()) {
    Scene unlimited(test_meshes::bump<Mesh>(8));
    BOOST_TEST(bool(call(unlimited, infinity)));
    for(double limit : {1e8, 1e300}) {
      Scene scene(test_meshes::bump<Mesh>(8));
      BOOST_TEST(bool(call(scene, limit)));
      BOOST_TEST((scene.output() == unlimited.output()));
    }
  }
}

namespace {

// The time is over when a visitor has waited at a stage, or before, if the machine is slow.
template <typename Visitor, typename Options, typename Call>
void check_end_at_stage(typename Visitor::Stage stage, Options options, Scene& scene, const Call& call)
{
  Waiting_visitor<Visitor> visitor(stage);
  options.visitor = &visitor;
  options.time_limit = short_time;
  const SMP::Report& report = call(options);
  BOOST_TEST(report.status == SMP::Diagnosis::TIMED_OUT);
  BOOST_TEST(report.message == last_stage(visitor.last));
  BOOST_TEST((scene.state() == scene.before));
  scene.clear();
}

template <typename Parameterizer, typename Options>
void check_stages(const Options& options, const std::vector<SMP::Flattening_visitor::Stage>& stages)
{
  Scene scene(test_meshes::bump<Mesh>(14));
  for(SMP::Flattening_visitor::Stage stage : stages)
    check_end_at_stage<SMP::Flattening_visitor>(stage, options, scene, [&](const Options& visited) {
      return without_elements(SMP::flatten_surface(scene.mesh, scene.uv, Parameterizer(visited)));
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(stages_of_maps)
{
  typedef SMP::Flattening_visitor V;
  check_stages<Direct>(SMP::ABF_plus_plus_options(),
                       {V::READ, V::TARGET_ANGLES, V::ANGLES, V::LAYOUT, V::CERTIFY, V::WRITE});
  SMP::Hierarchical_options options;
  options.polish = true;
  check_stages<Hierarchical>(
      options, {V::READ, V::COARSEN, V::COARSE_CHART, V::REFINE, V::POLISH, V::CERTIFY, V::WRITE});
  options.injective = true; // and polished while it is refined, as it is small
  check_stages<Hierarchical>(options,
                             {V::READ, V::COARSEN, V::COARSE_CHART, V::REFINE, V::CERTIFY, V::WRITE});
}

BOOST_AUTO_TEST_CASE(stages_of_atlases)
{
  typedef TA::Atlas_visitor V;
  Scene scene(scenes::sphere_and_torus());
  for(int threads : {1, 2})
    for(V::Stage stage : {V::READ, V::CHARTS, V::PACK, V::CERTIFY, V::MEASURE, V::WRITE}) {
      TA::Atlas_options options(TA::Atlas_options::FEW_CHARTS);
      options.threads = threads;
      options.resolution = 64;
      check_end_at_stage<V>(stage, options, scene, [&](const TA::Atlas_options& visited) {
        return without_elements(
            TA::make_atlas(scene.mesh, scene.seams, scene.corner_uv, scene.charts, visited));
      });
    }
}

// No visitor, but a factorization that takes too long
BOOST_AUTO_TEST_CASE(slow_solvers)
{
  Scene scene(seam_surfaces::sphere(1).mesh<Mesh>());
  const auto slow = CGAL::parameters::sparse_linear_solver(Slow_traits());
  for(const SMP::Report& report :
      {without_elements(
           TA::select_seams(scene.mesh, scene.seams, limited<TA::Seam_options>(short_time), slow)),
       without_elements(TA::select_cones(scene.mesh, 4, cones(short_time), slow)),
       without_elements(
           TA::flatten_with_cones(scene.mesh, 4, scene.seams, scene.corner_uv, cones(short_time), slow)),
       without_elements(TA::make_atlas(scene.mesh, scene.seams, scene.corner_uv, scene.charts,
                                       limited<Few_charts>(short_time), slow))}) {
    BOOST_TEST(report.status == SMP::Diagnosis::TIMED_OUT);
    BOOST_TEST((scene.state() == scene.before));
  }
}

// The limit of a coarse parameterizer ends that alone. The other way round, a coarse parameterizer without a limit ends
// when the whole run does.
BOOST_AUTO_TEST_CASE(limits_within_limits)
{
  Scene scene(test_meshes::bump<Mesh>(14));
  const Direct in_no_time(limited<SMP::ABF_plus_plus_options>(0));
  const auto report = SMP::flatten_surface(scene.mesh, scene.uv,
                                           Hierarchical(limited<SMP::Hierarchical_options>(1e8), in_no_time));
  BOOST_TEST(bool(report));
  BOOST_TEST(report.start == SMP::Hierarchical_report::PROGRESSIVE_EMBEDDING);
  scene.clear();

  Waiting_visitor<SMP::Flattening_visitor> visitor(SMP::Flattening_visitor::ANGLES);
  SMP::ABF_plus_plus_options unlimited;
  unlimited.visitor = &visitor;
  const auto ended = SMP::flatten_surface(
      scene.mesh, scene.uv, Hierarchical(limited<SMP::Hierarchical_options>(short_time), Direct(unlimited)));
  BOOST_TEST(ended.status == SMP::Diagnosis::TIMED_OUT);
  BOOST_TEST((scene.state() == scene.before));
}

// Without time to polish, the map is the one before.
BOOST_AUTO_TEST_CASE(limits_of_polishing)
{
  SMP::Hierarchical_options options;
  Scene scene(test_meshes::bump<Mesh>(14)), other(test_meshes::bump<Mesh>(14));
  BOOST_TEST(bool(SMP::flatten_surface(other.mesh, other.uv, Hierarchical(options))));
  options.polish = true;
  const auto polished = SMP::flatten_surface(scene.mesh, scene.uv, Hierarchical(options));
  BOOST_TEST(polished.polished);
  BOOST_TEST(!polished.polishing_timed_out);
  BOOST_TEST((scene.output() != other.output()));
  options.polish_options.time_limit = 0;
  const auto report = SMP::flatten_surface(scene.mesh, scene.uv, Hierarchical(options));
  BOOST_TEST(bool(report));
  BOOST_TEST(report.polishing_timed_out);
  BOOST_TEST(!report.polished);
  BOOST_TEST((scene.output() == other.output()));
}

// Smaller ones are polished while they are refined.
BOOST_AUTO_TEST_CASE(limit_of_polishing_a_large_injective_map)
{
  SMP::Hierarchical_options options;
  options.injective = true;
  options.polish = true;
  options.polish_options.time_limit = 0;
  Scene scene(test_meshes::bump<Mesh>(145));
  const auto report = SMP::flatten_surface(scene.mesh, scene.uv, Hierarchical(options));
  BOOST_TEST(bool(report));
  BOOST_TEST(report.injective);
  BOOST_TEST(report.polishing_timed_out);
  BOOST_TEST(!report.polished);
  BOOST_TEST(report.polish_iterations == 0);
  BOOST_TEST(report.energy > 0);
}

BOOST_AUTO_TEST_SUITE_END()
