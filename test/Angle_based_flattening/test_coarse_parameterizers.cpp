// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Coarse parameterizers of the hierarchical method that fail: what is reported, and what takes their place.

#include <boost/test/unit_test.hpp>

#include "hard_charts.h"
#include "mesh_of_chart.h"
#include "test_data.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/SuperLU_solver_traits.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_coarse_parameterizers)

using namespace test_charts;
namespace SMP = CGAL::Surface_mesh_parameterization;
typedef SMP::Hierarchical_options Options;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Simple_cartesian<double>::Point_2 UV;
typedef SMP::Mesh_report<Mesh, SMP::Hierarchical_report> Report;

namespace {

enum Deed
{
  SERVE,
  RETURN_ERROR,
  FLIP,           // all triangles
  RETURN_NUMBERS, // that are not finite
  VIOLATE_PRECONDITION,
  THROW
};

// Does one deed after the other, and the last one again and again.
struct Scripted_parameterizer
{
  typedef SMP::Hierarchical_coarse_mesh Triangle_mesh;
  typedef Triangle_mesh TriangleMesh;
  typedef CGAL::SuperLU_solver_traits<> Solver_traits;

  std::vector<Deed> script;
  std::shared_ptr<std::size_t> calls = std::make_shared<std::size_t>(0);

  template <typename Halfedge, typename UVmap, typename Index, typename Parameterized>
  SMP::Error_code parameterize(Triangle_mesh& mesh, Halfedge bhd, UVmap uv, Index vimap, Parameterized vpmap)
  {
    const Deed deed = script[(std::min)((*calls)++, script.size() - 1)];
    if(deed == RETURN_ERROR)
      return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    if(deed == VIOLATE_PRECONDITION)
      throw CGAL::Precondition_exception("a library", "x > 0", "a file", 1, "the coarse chart is not liked");
    if(deed == THROW)
      throw std::runtime_error("stop");
    const SMP::Error_code code =
        SMP::ABF_plus_plus_parameterizer_3<Triangle_mesh>().parameterize(mesh, bhd, uv, vimap, vpmap);
    for(const auto v : mesh.vertices())
      if(deed == FLIP)
        put(uv, v, UV(-get(uv, v).x(), get(uv, v).y()));
      else if(deed == RETURN_NUMBERS)
        put(uv, v, UV(std::numeric_limits<double>::quiet_NaN(), 0));
    return code;
  }
};

// A mesh with its map
struct Surface
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, UV> uv;

  explicit Surface(const Chart& chart)
  {
    make_mesh(chart, mesh);
    uv = mesh.add_property_map<Mesh::Vertex_index, UV>("v:uv", UV(7, 7)).first;
  }

  template <typename Parameterizer>
  SMP::Error_code run(Parameterizer& parameterizer)
  {
    const auto parameterized = mesh.add_property_map<Mesh::Vertex_index, bool>("v:done", false).first;
    return parameterizer.parameterize(mesh, CGAL::Polygon_mesh_processing::longest_border(mesh).first, uv,
                                      get(boost::vertex_index, mesh), parameterized);
  }

  Report flatten(const std::vector<Deed>& script, const Options& options = Options())
  {
    SMP::Hierarchical_parameterizer_3<Mesh, Scripted_parameterizer> parameterizer(
        options, Scripted_parameterizer{script});
    const SMP::Error_code code = run(parameterizer);
    BOOST_TEST(code == SMP::error_code(parameterizer.report().status));
    return parameterizer.report();
  }

  bool has_map() const
  {
    return std::any_of(uv.begin(), uv.end(), [](const UV& p) { return p != UV(7, 7); });
  }
};

Surface large_bump()
{
  return Surface(bump(50, 3));
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// Everything in a report that does not depend on the clock
std::string text_of(const Report& report)
{
  std::string text = to_string(report.status) + report.message + to_string(report.start) + report.note;
  for(const Report::Failed_coarse_chart& failed : report.failed_coarse_charts)
    text += " " + std::to_string(failed.vertices) + " " + std::to_string(failed.triangles) + " " +
            std::to_string(failed.error.value_or(SMP::Error_code(99))) + " " +
            std::to_string(failed.flipped_triangles) + failed.message;
  return text;
}

void check_last_resort(const Report& report, std::size_t failures)
{
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(report.message == "");
  BOOST_TEST(report.start == Report::PROGRESSIVE_EMBEDDING);
  BOOST_TEST(contains(report.note, "started from one triangle"));
  BOOST_TEST_REQUIRE(report.failed_coarse_charts.size() == failures);
  BOOST_TEST(contains(report.note, report.failed_coarse_charts.back().message));
  int last_size = 0;
  for(const Report::Failed_coarse_chart& failed : report.failed_coarse_charts) {
    BOOST_TEST(failed.vertices > last_size);
    BOOST_TEST(failed.triangles > failed.vertices);
    last_size = failed.vertices;
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(one_that_returns_an_error)
{
  Surface surface = large_bump();
  const Report report = surface.flatten({RETURN_ERROR});
  check_last_resort(report, 4);
  for(const Report::Failed_coarse_chart& failed : report.failed_coarse_charts) {
    BOOST_TEST((failed.error == SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM));
    BOOST_TEST(failed.flipped_triangles == 0);
    BOOST_TEST(contains(failed.message, "ERROR_CANNOT_SOLVE_LINEAR_SYSTEM"));
  }
  BOOST_TEST(surface.has_map());
}

BOOST_AUTO_TEST_CASE(one_that_flips_triangles)
{
  for(Deed deed : {FLIP, RETURN_NUMBERS}) {
    const Report report = large_bump().flatten({deed});
    check_last_resort(report, 4);
    for(const Report::Failed_coarse_chart& failed : report.failed_coarse_charts) {
      BOOST_TEST((failed.error == SMP::OK));
      BOOST_TEST(failed.flipped_triangles == failed.triangles);
      BOOST_TEST(contains(failed.message, std::to_string(failed.triangles) + " flipped"));
    }
  }
}

BOOST_AUTO_TEST_CASE(one_that_violates_a_precondition)
{
  const Report report = large_bump().flatten({VIOLATE_PRECONDITION});
  check_last_resort(report, 4);
  for(const Report::Failed_coarse_chart& failed : report.failed_coarse_charts) {
    BOOST_TEST(!failed.error.has_value());
    BOOST_TEST(contains(failed.message, "the coarse chart is not liked"));
    BOOST_TEST(!contains(failed.message, "\n"));
  }
}

// Such as a visitor's
BOOST_AUTO_TEST_CASE(other_exceptions_pass_through)
{
  Surface surface = large_bump();
  BOOST_CHECK_THROW(surface.flatten({THROW}), std::runtime_error);
  BOOST_TEST(!surface.has_map());
}

BOOST_AUTO_TEST_CASE(one_that_fails_at_first)
{
  Surface surface = large_bump();
  const Report report = surface.flatten({RETURN_ERROR, FLIP, SERVE});
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(report.start == Report::COARSE_PARAMETERIZER);
  BOOST_TEST(report.note == "");
  BOOST_TEST_REQUIRE(report.failed_coarse_charts.size() == 2);
  BOOST_TEST((report.failed_coarse_charts[0].error == SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM));
  BOOST_TEST((report.failed_coarse_charts[1].error == SMP::OK));
  BOOST_TEST(report.failed_coarse_charts[1].triangles < report.coarse_triangles);

  const Report served = large_bump().flatten({SERVE});
  BOOST_TEST(served.failed_coarse_charts.empty());
  BOOST_TEST(served.note == "");
}

BOOST_AUTO_TEST_CASE(without_fallbacks_it_is_an_error)
{
  Options options;
  options.fallbacks = false;
  for(int retries : {0, 1, 3})
    for(Deed deed : {RETURN_ERROR, FLIP, VIOLATE_PRECONDITION}) {
      options.max_retries = retries;
      Surface surface = large_bump();
      const Report report = surface.flatten({deed}, options);
      BOOST_TEST(report.status == SMP::Diagnosis::COARSE_CHART_FAILED);
      BOOST_TEST_REQUIRE(report.failed_coarse_charts.size() == retries + 1u);
      BOOST_TEST(contains(report.message, report.failed_coarse_charts.back().message));
      BOOST_TEST(report.note == "");
      BOOST_TEST(!surface.has_map());
    }
  options.max_retries = 3;
  Surface surface = large_bump();
  const Report report = surface.flatten({FLIP, FLIP, FLIP, SERVE}, options);
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(surface.has_map());
}

// The map with holes fails, and that of the filled chart does not.
BOOST_AUTO_TEST_CASE(holes_that_are_filled_instead_of_solved)
{
  Chart chart = bump(60, 3);
  const int middle = chart.number_of_triangles() / 2 + 61;
  chart = make_chart(chart.points, [&] {
    Triangles triangles;
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      if(t != middle)
        triangles.push_back({chart.vertex[3 * t], chart.vertex[3 * t + 1], chart.vertex[3 * t + 2]});
    return triangles;
  }());
  BOOST_TEST_REQUIRE(chart.borders.size() == 2);
  const std::vector<Deed> script{RETURN_ERROR, RETURN_ERROR, RETURN_ERROR, RETURN_ERROR, SERVE};
  const Report report = Surface(chart).flatten(script);
  BOOST_TEST(report.status == SMP::Diagnosis::NOTHING_WRONG);
  BOOST_TEST(report.holes_filled);
  BOOST_TEST(report.failed_coarse_charts.size() == 4);
  BOOST_TEST(contains(report.note, "holes were filled instead of solved: the coarse parameterizer returned"));
  Options options;
  options.fallbacks = false;
  Surface surface(chart);
  BOOST_TEST(surface.flatten(script, options).status == SMP::Diagnosis::COARSE_CHART_FAILED);
  BOOST_TEST(!surface.has_map());
}

BOOST_AUTO_TEST_CASE(same_report_and_map_each_time)
{
  for(const std::vector<Deed>& script :
      {std::vector<Deed>{FLIP}, {VIOLATE_PRECONDITION}, {RETURN_ERROR, SERVE}}) {
    Surface first = large_bump();
    const std::string text = text_of(first.flatten(script));
    for(int threads : {1, 2, 0}) {
      Options options;
      options.threads = threads;
      Surface again = large_bump();
      BOOST_TEST(text_of(again.flatten(script, options)) == text);
      BOOST_TEST(std::equal(first.uv.begin(), first.uv.end(), again.uv.begin()));
    }
  }
}

// The default parameterizer of coarse charts has fallbacks of its own, and tells of them.
BOOST_AUTO_TEST_CASE(direct_method_that_fails)
{
  typedef SMP::Hierarchical_parameterizer_3<Mesh> Parameterizer;
  SMP::ABF_plus_plus_options coarse;
  coarse.max_iterations = 0;
  for(bool fallbacks : {true, false}) {
    std::mt19937 random(4);
    Surface surface(noisy_terrain(12, 60, random));
    coarse.fallbacks = fallbacks;
    Parameterizer parameterizer{Options(), Parameterizer::Coarse_parameterizer(coarse)};
    BOOST_TEST(surface.run(parameterizer) == SMP::OK);
    const Report& report = parameterizer.report();
    const SMP::ABF_plus_plus_report& of_coarse = parameterizer.coarse_parameterizer().report();
    if(fallbacks) {
      BOOST_TEST(of_coarse.strategy == SMP::ABF_plus_plus_report::PROGRESSIVE_EMBEDDING);
      BOOST_TEST(report.start == Report::COARSE_PARAMETERIZER);
      BOOST_TEST(contains(report.note, "the map of the coarse chart is a progressive embedding"));
      continue;
    }
    check_last_resort(report, report.failed_coarse_charts.size());
    const Report::Failed_coarse_chart& failed = report.failed_coarse_charts.back();
    BOOST_TEST((failed.error == SMP::ERROR_NO_1_TO_1_MAPPING));
    BOOST_TEST(failed.flipped_triangles == of_coarse.flipped_triangles);
    BOOST_TEST(failed.flipped_triangles > 0);
    BOOST_TEST(contains(failed.message, of_coarse.message));
  }
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

// LSCM flips triangles of all four coarse charts of the lion's head.
BOOST_AUTO_TEST_CASE(lscm_on_the_head_of_a_lion)
{
  typedef SMP::LSCM_parameterizer_3<SMP::Hierarchical_coarse_mesh> LSCM;
  for(bool fallbacks : {true, false}) {
    Surface surface{Chart()};
    BOOST_TEST_REQUIRE(bool(std::ifstream(test_data::CGAL_meshes / "lion-head.off") >> surface.mesh));
    Options options;
    options.fallbacks = fallbacks;
    SMP::Hierarchical_parameterizer_3<Mesh, LSCM> hierarchical(options);
    const SMP::Error_code code = surface.run(hierarchical);
    const Report& report = hierarchical.report();
    BOOST_TEST(code == (fallbacks ? SMP::OK : SMP::ERROR_NO_1_TO_1_MAPPING));
    BOOST_TEST(report.failed_coarse_charts.size() == 4);
    for(const Report::Failed_coarse_chart& failed : report.failed_coarse_charts)
      BOOST_TEST(failed.flipped_triangles > 0);
    BOOST_TEST(report.note.empty() != fallbacks);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
