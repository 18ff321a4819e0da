// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// With `Hierarchical_options::injective`, every chart gets a map without overlaps, or an error that leaves everything
// as it was. Small maps are checked pair by pair of their triangles, and all maps by the public certificate.

#include <boost/test/unit_test.hpp>

#include "charts_with_holes.h"
#include "cut_spheres.h"
#include "injectivity_check.h"
#include "mesh_of_chart.h"
#include "overlapping_charts.h"
#include "random_charts.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/polygon_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/objectives.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/injective_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/tutte_map.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_injective)

namespace SMP = CGAL::Surface_mesh_parameterization;
using namespace test_charts;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex;
typedef SMP::ABF_plus_plus_parameterizer_3<Surface_mesh> Direct;
typedef SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Surface_mesh> Parameterizer;
typedef SMP::Hierarchical_options Options;
typedef SMP::Hierarchical_report Report;

namespace {

const bool is_quick = std::getenv("ABF_TEST_QUICK") != nullptr,
           is_long = std::getenv("ABF_TEST_LONG") != nullptr;
const std::vector<double> area_weights =
    is_quick ? std::vector<double>{0.005} : std::vector<double>{0, 0.005, 1};
// Only the last one where tests have to be quick
template <typename T>
std::vector<T> some(const std::vector<T>& all)
{
  return is_quick ? std::vector<T>{all.back()} : all;
}

const int largest_for_all_pairs = 5000; // triangles

Options injective(double area_weight = 0.005)
{
  Options options;
  options.injective = true;
  options.area_weight = area_weight;
  options.holes = Options::SOLVE;
  return options;
}

Options isometric()
{
  return injective(1);
}

// A chart as a mesh, and what a parameterizer makes of it
template <typename Planar_point = Point_2>
struct Run
{
  explicit Run(const Chart& flattened) : chart(flattened), mesh(mesh_of_chart<Surface_mesh>(flattened))
  {
    uv = mesh.add_property_map<Vertex, Planar_point>("v:uv", untouched).first;
    done = mesh.add_property_map<Vertex, bool>("v:done", false).first;
    const int c = chart.borders[0][0];
    border = mesh.halfedge(vertex(chart.edge_target(c)), vertex(chart.edge_source(c)));
  }

  template <typename Parameterizer_>
  Run(const Chart& flattened, Parameterizer_&& parameterizer) : Run(flattened)
  {
    flatten(parameterizer);
  }

  static Vertex vertex(int v) { return Vertex(static_cast<unsigned>(v)); }

  template <typename Parameterizer_>
  void flatten(Parameterizer_& parameterizer)
  {
    code = parameterizer.parameterize(mesh, border, uv, get(boost::vertex_index, mesh), done);
  }

  std::vector<Point_2> points() const
  {
    std::vector<Point_2> result;
    for(Vertex v : mesh.vertices())
      result.emplace_back(uv[v].x(), uv[v].y());
    return result;
  }

  bool is_untouched() const
  {
    for(Vertex v : mesh.vertices())
      if(uv[v] != untouched || done[v] || mesh.point(v) != chart.points[v])
        return false;
    return true;
  }

  // An overlap, by a check that may be slow; empty if there is none.
  std::string overlap() const
  {
    const std::vector<Point_2> planar = points();
    for(const Point_2& p : planar)
      if(!CGAL::is_finite(p.x()) || !CGAL::is_finite(p.y()))
        return "a coordinate is not finite";
    if(!SMP::is_injective(mesh, uv))
      return "the certificate refuses the map";
    if(chart.number_of_triangles() > largest_for_all_pairs)
      return "";
    const auto pairs = overlapping_pairs_by_brute_force(chart, planar);
    return pairs.empty() ? ""
                         : "triangles " + std::to_string(pairs[0].first) + " and " +
                               std::to_string(pairs[0].second) + " overlap";
  }

  const Planar_point untouched{-17, 42};
  Chart chart;
  Surface_mesh mesh;
  Surface_mesh::Property_map<Vertex, Planar_point> uv;
  Surface_mesh::Property_map<Vertex, bool> done;
  Surface_mesh::Halfedge_index border;
  SMP::Error_code code = SMP::OK;
};

// What contradicts the promises of an injective map, or of an error; empty if nothing does.
template <typename Planar_point>
std::string contradiction(const Run<Planar_point>& run, const Report& report)
{
  if(error_code(report.status) != run.code || report.message.empty() != (run.code == SMP::OK))
    return "the report contradicts the error code";
  if(run.code != SMP::OK)
    return run.is_untouched() ? "" : "an error, and something was changed";
  const std::string overlap = run.overlap();
  if(!overlap.empty())
    return overlap;
  if(!report.injective || !report.border_is_simple || report.flipped_triangles != 0)
    return "the report does not say that the map is injective";
  if(!(report.contact >= 0 && report.contact <= 1 && report.least_clearance > 0) ||
     report.border_rejections < 0)
    return "a number in the report is out of its range";
  return "";
}

// The same where an error is a fault too
std::string fault(const Chart& chart, const Options& options = injective())
{
  Parameterizer parameterizer(options);
  const Run<> run(chart, parameterizer);
  const std::string found = contradiction(run, parameterizer.report());
  return found.empty() ? parameterizer.report().message : found;
}

// Runs a generator with several seeds, and lists those that fail.
template <typename Generator>
void check_all(const std::string& name, unsigned seeds, const Generator& generate)
{
  std::string failures;
  for(unsigned seed = 1; seed <= seeds; ++seed) {
    BOOST_TEST_CHECKPOINT(name << ", seed " << seed); // reported if a run crashes
    std::mt19937 random(seed);
    const std::string failure = fault(generate(random), injective(seed % 4 == 0 ? 1 : 0.005));
    if(!failure.empty())
      failures += "\n  seed " + std::to_string(seed) + ": " + failure;
  }
  BOOST_TEST(failures.empty(), name << " fails:" << failures);
}

double energy(const Run<>& run)
{
  return SMP::measure_flattening(run.mesh, run.border, run.uv).angular_distortion;
}

} // namespace

BOOST_AUTO_TEST_SUITE(charts)

BOOST_AUTO_TEST_CASE(pairs_by_brute_force_find_what_overlaps)
{
  const Chart flat = hilbert_strip(2, 2), winding = winding_strip(2, 2, 1);
  BOOST_TEST(overlapping_pairs_by_brute_force(flat, projected(flat)).empty());
  BOOST_TEST(!overlapping_pairs_by_brute_force(winding, projected(winding)).empty());
  BOOST_TEST(symmetric_dirichlet_energy(flat, projected(flat)) == 4, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(hilbert_curves_become_injective)
{
  for(int order = 1; order <= (is_quick ? 3 : 5); ++order) {
    BOOST_TEST_INFO_SCOPE("order " << order);
    BOOST_TEST(fault(hilbert_strip(order, 2)) == "");
    BOOST_TEST(fault(hilbert_strip(order, 1, 0.2)) == "");
  }
}

BOOST_AUTO_TEST_CASE(strips_that_run_into_themselves_become_injective)
{
  check_all("random strip", is_quick ? 3 : 12, [](auto& random) {
    const int squares = uniform_int(random, 2, 120);
    return random_strip(squares, uniform_int(random, 1, 3), random);
  });
  check_all("broken Hilbert curve", is_quick ? 1 : 4,
            [](auto& random) { return broken_hilbert_strip(4, 1, uniform_int(random, 1, 20), random); });
}

BOOST_AUTO_TEST_CASE(spirals_become_injective)
{
  for(int rounds : some<int>({1, 2, 5})) {
    BOOST_TEST(fault(winding_strip(rounds, 1, 2)) == "");
    BOOST_TEST(fault(winding_strip(rounds, 3, 2)) == "");
    BOOST_TEST(fault(square_spiral(rounds, 2)) == "");
    BOOST_TEST(fault(spiral(48 * rounds)) == "");
  }
}

BOOST_AUTO_TEST_CASE(staircases_become_injective)
{
  for(double turns : some<double>({0.9, 1., 7., 1.1, 2.5}))
    for(double rise : some<double>({0., 0.3})) {
      BOOST_TEST_INFO_SCOPE("turns " << turns << ", rise " << rise);
      BOOST_TEST(fault(staircase(static_cast<int>(30 * turns), 4, turns, rise)) == "");
      BOOST_TEST(fault(staircase(static_cast<int>(30 * turns), 2, turns, rise, 1.05)) == "");
    }
}

BOOST_AUTO_TEST_CASE(combs_become_injective)
{
  for(int teeth : some<int>({1, 20, 3}))
    for(int length : some<int>({1, 30}))
      for(double hills : some<double>({0., 1.})) {
        BOOST_TEST_INFO_SCOPE(teeth << " teeth of length " << length << ", hills " << hills);
        BOOST_TEST(fault(comb(teeth, length, hills)) == "");
      }
}

BOOST_AUTO_TEST_CASE(spheres_cut_along_trees_become_injective)
{
  for(int branches : {1, 2, 5, 10, 20, 50, 100}) {
    if(is_quick && branches > 10)
      break;
    std::mt19937 random(static_cast<unsigned>(branches));
    const Chart chart = tree_cut_sphere(branches < 20 ? 4 : 5, branches, 1.5, random);
    BOOST_TEST_INFO_SCOPE(branches << " branches");
    BOOST_TEST(fault(chart) == "");
  }
}

BOOST_AUTO_TEST_CASE(random_cuts_of_bumpy_spheres_become_injective)
{
  check_all("cut sphere", is_quick ? 3 : 12, [](auto& random) {
    const int subdivisions = uniform_int(random, 1, 4);
    return tree_cut_sphere(subdivisions, uniform_int(random, 1, 30), uniform(random, 1, 30), random);
  });
  check_all("cut bumps", is_quick ? 3 : 9, [](auto& random) {
    const double height = std::exp(uniform(random, 0, std::log(100.)));
    return tree_cut_bumps(3, uniform_int(random, 1, 30), height, uniform(random, 5, 50), random);
  });
}

// Conformal maps of these would have a range of scale of up to 1e10.
BOOST_AUTO_TEST_CASE(surfaces_with_a_large_range_of_scale_become_injective)
{
  for(double length : some<double>({1., 10., 23.}))
    for(double area_weight : area_weights) {
      BOOST_TEST_INFO_SCOPE("length " << length << ", area weight " << area_weight);
      BOOST_TEST(fault(finger(12, static_cast<int>(3 * length), length), injective(area_weight)) == "");
    }
  std::mt19937 random(1);
  const auto [points, triangles] = sphere(4);
  BOOST_TEST(fault(tree_cut(with_bumps(points, 4, 30, 100, random), triangles, 1, 1, random)) == "");
}

// What lies before rounding may be injective, and what can be stored is not.
BOOST_AUTO_TEST_CASE(a_map_that_doubles_cannot_hold_is_an_error_that_says_so)
{
  const auto check = [](const Chart& chart) {
    Parameterizer parameterizer(injective(0));
    const Run<> run(chart, parameterizer);
    BOOST_TEST(contradiction(run, parameterizer.report()) == "");
    BOOST_TEST((run.code == SMP::OK || parameterizer.report().status == SMP::Diagnosis::PRECISION_EXCEEDED),
               parameterizer.report().message);
  };
  for(double length : {40., 100.})
    check(finger(12, static_cast<int>(3 * length), length));
  for(unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    const double height = std::pow(10, seed);
    check(tree_cut_bumps(2, 5, height, 100, random));
  }
}

// The longest edge of the border is 1e10 times as long as the shortest one.
BOOST_AUTO_TEST_CASE(borders_with_edges_of_all_sizes_become_injective)
{
  for(double width : some<double>({0.3, 1., 2.5}))
    for(double area_weight : area_weights) {
      BOOST_TEST_INFO_SCOPE("width " << width << ", area weight " << area_weight);
      const Chart chart = logarithmic_spiral(90, 3, 3, std::pow(1e10, 1 / 3.), width);
      BOOST_TEST(fault(chart, injective(area_weight)) == "");
    }
  if(!is_quick)
    BOOST_TEST(fault(logarithmic_spiral(300, 3, 10, 10, 1)) == "");
}

BOOST_AUTO_TEST_CASE(bulbs_joined_by_single_edges_become_injective)
{
  for(int bulbs : some<int>({2, 3, 10}))
    for(int subdivisions : some<int>({0, 2}))
      for(double area_weight : area_weights) {
        BOOST_TEST_INFO_SCOPE(bulbs << " bulbs, " << subdivisions << " subdivisions, area weight "
                                    << area_weight);
        BOOST_TEST(fault(chain_of_bulbs(bulbs, subdivisions), injective(area_weight)) == "");
      }
}

BOOST_AUTO_TEST_CASE(a_border_of_three_vertices_is_enough)
{
  for(int subdivisions : some<int>({0, 1, 3}))
    for(double stretch : some<double>({1., 10.}))
      for(const Options& options : {injective(), isometric()}) {
        BOOST_TEST_INFO_SCOPE(subdivisions << " subdivisions, stretch " << stretch << ", area weight "
                                           << options.area_weight);
        BOOST_TEST(fault(sphere_without_triangle(subdivisions, stretch), options) == "");
      }
}

BOOST_AUTO_TEST_CASE(a_triangle_and_other_small_charts_are_flattened)
{
  const std::vector<Point_3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
  BOOST_TEST(fault(make_chart(points, {{0, 1, 2}})) == "");
  BOOST_TEST(fault(make_chart(points, {{0, 1, 2}, {1, 3, 2}})) == "");
  BOOST_TEST(fault(pyramid(3, 100)) == "");
  BOOST_TEST(fault(pyramid(1000, 100)) == "");
  BOOST_TEST(fault(strip(100)) == "");
}

BOOST_AUTO_TEST_CASE(random_charts_become_injective)
{
  const unsigned seeds = is_quick ? 5 : is_long ? 200 : 60;
  check_all("random chart", seeds,
            [](auto& random) { return random_chart(uniform_int(random, 0, 200), random); });
  check_all("slivers", seeds, [](auto& random) {
    const int n = uniform_int(random, 2, 9);
    return slivers(bump(n, random(), 1), uniform_int(random, 1, n * n),
                   std::pow(10, -uniform_int(random, 1, 12)), random);
  });
  check_all("duplicated points", seeds, [](auto& random) {
    const int n = uniform_int(random, 2, 9);
    return duplicated_points(bump(n, random(), 1), uniform_int(random, 1, n), random);
  });
  check_all("terrain", seeds, [](auto& random) {
    return noisy_terrain(uniform_int(random, 2, 12), uniform(random, 0, 10), random);
  });
  check_all("scaled", seeds,
            [](auto& random) { return scaled(comb(3, 4, 1), std::pow(10, uniform_int(random, -150, 150))); });
}

BOOST_AUTO_TEST_CASE(charts_without_any_area_are_refused)
{
  for(const Chart& chart : {hilbert_strip(2, 1), comb(4, 4, 1), disk(4, [](double, double) { return 0; })}) {
    const std::string wrong = "the surface has no area: all " + std::to_string(chart.number_of_triangles()) +
                              " triangles are degenerate, with the vertices on a line or at a point";
    BOOST_TEST(fault(in_a_line(chart)) == wrong);
    BOOST_TEST(fault(in_a_point(chart)) == wrong);
  }
}

BOOST_AUTO_TEST_CASE(holes_stay_simple_and_inside_and_apart)
{
  check_all("punched sphere", is_quick ? 2 : 8,
            [](auto& random) { return sphere_without_caps(3, uniform_int(random, 2, 6), 1, random); });
  check_all("punched strip", is_quick ? 2 : 8, [](auto& random) {
    return punched(winding_strip(2, 2, 6), uniform_int(random, 1, 4), 1, random);
  });
  check_all("punched bumps", is_quick ? 2 : 8, [](auto& random) {
    return punched(tree_cut_bumps(4, 3, 3, 20, random), uniform_int(random, 1, 6), 1, random);
  });
  BOOST_TEST(fault(tube(24, 6, 1, 1, 2)) == "");
  BOOST_TEST(fault(tube(24, 2, 1, 1.05, 0)) == "");
}

// The direct method's own map where that is injective, and a polished one where it overlaps itself
BOOST_AUTO_TEST_CASE(the_direct_method_gives_injective_maps_too)
{
  std::mt19937 random(4);
  int overlapping = 0, own = 0;
  for(const Chart& chart : {bump(8, 1), staircase(40, 4, 1.6, 0.2), tree_cut_sphere(3, 12, 3, random),
                            winding_strip(2, 2, 2), saddle(6, 1)}) {
    const auto flatten = [&](bool injective) {
      SMP::ABF_plus_plus_options options;
      options.injective = injective;
      Direct direct(options);
      const Run<> run(chart, direct);
      BOOST_TEST(run.code == SMP::OK);
      BOOST_TEST((!injective || run.overlap() == ""));
      return direct.report();
    };
    const auto free = flatten(false), injective = flatten(true);
    BOOST_TEST(!free.injective); // was not asked for
    BOOST_TEST(injective.injective);
    if(free.border_is_simple) {
      ++own;
      BOOST_TEST(injective.strategy == SMP::ABF_plus_plus_report::FROM_TARGET_ANGLES);
      BOOST_TEST(injective.energy == free.energy);
    } else {
      ++overlapping;
      BOOST_TEST(injective.strategy == SMP::ABF_plus_plus_report::INJECTIVE_DESCENT);
      BOOST_REQUIRE(!injective.failed_strategies.empty());
      BOOST_TEST(injective.failed_strategies.back().status == SMP::Diagnosis::OVERLAPPING);
      BOOST_TEST(injective.triangles == chart.number_of_triangles());
    }
  }
  BOOST_TEST(own > 0);
  BOOST_TEST(overlapping > 0);
}

// Also where its own map does not overlap itself: both methods give one map then.
BOOST_AUTO_TEST_CASE(the_direct_method_preserves_areas_if_asked)
{
  SMP::ABF_plus_plus_options options;
  options.injective = true;
  options.area_weight = 1;
  for(const Chart& chart : {bump(12, 7, 1), comb(6, 8, 1), finger(12, 20, 5)}) {
    Direct direct(options);
    Parameterizer hierarchical(isometric());
    const Run<> run(chart, direct), expected(chart, hierarchical);
    BOOST_TEST(run.code == SMP::OK);
    BOOST_TEST((run.points() == expected.points()));
    BOOST_TEST((direct.report().strategy == SMP::ABF_plus_plus_report::INJECTIVE_DESCENT));
  }
}

BOOST_AUTO_TEST_CASE(prescribed_angles_go_with_small_area_weights)
{
  SMP::ABF_plus_plus_options options;
  options.injective = true;
  options.area_weight = 1;
  Direct direct(options);
  const Chart chart = bump(8, 1);
  Run<> run(chart);
  SMP::Vertex_angles<Surface_mesh> angles;
  angles.set(run.mesh.target(run.border), 3);
  direct.set_angle_sums(angles);
  run.flatten(direct);
  BOOST_TEST((direct.report().status == SMP::Diagnosis::WRONG_OPTION));
  BOOST_TEST(direct.report().message.find("area_weight") != std::string::npos);
  BOOST_TEST(direct.report().triangles == chart.number_of_triangles());
  BOOST_TEST(run.is_untouched());
}

BOOST_AUTO_TEST_CASE(polishing_does_not_undo_area_weights)
{
  Options polished = isometric();
  polished.polish = true;
  Parameterizer parameterizer(polished);
  const Run<> run(comb(2, 2, 0), parameterizer);
  BOOST_TEST((parameterizer.report().status == SMP::Diagnosis::WRONG_OPTION));
  BOOST_TEST(parameterizer.report().message.find("area_weight") != std::string::npos);
  BOOST_TEST(run.is_untouched());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(options)

BOOST_AUTO_TEST_CASE(any_options_give_an_injective_map)
{
  const auto any_options = [](std::mt19937& random) {
    Options options = injective(random() % 3 / 2.);
    options.clearance = random() % 4 == 0 ? 1 : uniform(random, 1e-6, 1);
    options.sweeps = uniform_int(random, 0, 4);
    options.angle_sweeps = uniform_int(random, 0, 3);
    options.barrier = random() % 2 * 0.1;
    options.extreme_angle = uniform(random, 0, 0.5);
    options.max_retries = uniform_int(random, 0, 3);
    options.polish = random() % 2 == 0 && options.area_weight <= 0.1;
    return options;
  };
  for(unsigned seed = 1; seed <= (is_quick ? 3u : 12u); ++seed) {
    std::mt19937 random(seed);
    const Chart chart = seed % 3 == 0   ? random_strip(100, 2, random)
                        : seed % 3 == 1 ? tree_cut_bumps(3, 5, 2, 10, random)
                                        : random_chart(300, random);
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    BOOST_TEST(fault(chart, any_options(random)) == "");
  }
}

BOOST_AUTO_TEST_CASE(wrong_options_are_refused_by_name)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const auto check = [](const Options& options, const std::string& name) {
    Parameterizer parameterizer(options);
    const Run<> run(comb(2, 2, 0), parameterizer);
    BOOST_TEST(run.code == SMP::ERROR_WRONG_PARAMETER);
    BOOST_TEST((parameterizer.report().status == SMP::Diagnosis::WRONG_OPTION));
    BOOST_TEST(parameterizer.report().message.find(name) != std::string::npos,
               parameterizer.report().message);
    BOOST_TEST(run.is_untouched());
  };
  for(double wrong : {-1e-300, -1., 1.0000001, infinity, nan})
    check(injective(wrong), "area_weight");
  for(double wrong : {0., -0.25, 1.0000001, infinity, nan}) {
    Options options = injective();
    options.clearance = wrong;
    check(options, "clearance");
  }
}

BOOST_AUTO_TEST_CASE(without_the_option_maps_may_overlap_and_say_so)
{
  Parameterizer parameterizer;
  const Run<> run(winding_strip(2, 3, 2), parameterizer);
  BOOST_TEST(run.code == SMP::OK);
  BOOST_TEST(!parameterizer.report().injective);
  BOOST_TEST(!run.overlap().empty());
}

// Where a smaller clearance is asked for, parts of the border may come closer to one another.
BOOST_AUTO_TEST_CASE(clearance_is_kept_in_proportion)
{
  double before = 0;
  for(double clearance : {0.01, 0.1, 1.}) {
    Options options = injective();
    options.clearance = clearance;
    Parameterizer parameterizer(options);
    const Run<> run(winding_strip(2, 2, 3), parameterizer);
    BOOST_TEST(run.code == SMP::OK);
    BOOST_TEST(parameterizer.report().least_clearance > before);
    before = parameterizer.report().least_clearance;
  }
}

BOOST_AUTO_TEST_CASE(contact_is_reported_where_the_border_touches)
{
  for(const Chart& convex : {flat_grid(12, 3), disk(8, [](double, double) { return 0; }), strip(60)}) {
    Parameterizer parameterizer(injective());
    const Run<> run(convex, parameterizer);
    BOOST_TEST(run.code == SMP::OK);
    BOOST_TEST(parameterizer.report().contact == 0);
    BOOST_TEST(parameterizer.report().least_clearance > Options().clearance);
  }
  double some_contact = 0;
  for(const Chart& touching : {winding_strip(3, 2, 2), staircase(80, 4, 2, 0)}) {
    Parameterizer parameterizer(injective());
    const Run<> run(touching, parameterizer);
    const Report& report = parameterizer.report();
    BOOST_TEST(run.code == SMP::OK);
    BOOST_TEST((report.contact > 0) == (report.least_clearance < Options().clearance));
    BOOST_TEST(report.contact < 1);
    some_contact += report.contact;
    // Whatever edges count as local
    const auto [in_longer, in_shorter] = least_border_distances(touching, run.points());
    BOOST_TEST(report.least_clearance > in_longer / 3);
    BOOST_TEST(report.least_clearance < 3 * in_shorter);
  }
  BOOST_TEST(some_contact > 0);
}

// The two sides of the cut, which have the same lengths, are the whole border.
BOOST_AUTO_TEST_CASE(a_border_that_is_in_contact_all_along_becomes_injective)
{
  std::vector<Chart> charts{slit_sphere(3), slit_sphere(4), staircase(60, 8, 1, 0), cut_annulus(40, 4, 0)};
  for(double area_weight : area_weights)
    for(const Chart& chart : charts)
      BOOST_TEST(fault(chart, injective(area_weight)) == "");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(quality)

namespace {

Run<> flattened(const Chart& chart, const Options& options)
{
  Parameterizer parameterizer(options);
  Run<> run(chart, parameterizer);
  BOOST_TEST(parameterizer.report().message == "");
  return run;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_result_has_the_size_and_the_place_of_all_results)
{
  const Chart chart = hilbert_strip(3, 2);
  const std::vector<Point_2> uv = flattened(chart, injective()).points();
  double area = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    area += CGAL::area(uv[chart.vertex[3 * t]], uv[chart.vertex[3 * t + 1]], uv[chart.vertex[3 * t + 2]]);
  CGAL::Bbox_2 box;
  for(const Point_2& p : uv)
    box += p.bbox();
  BOOST_TEST(area == 2 * std::pow(4, 3) - 1, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(box.xmin()) < 1e-9);
  BOOST_TEST(std::abs(box.ymin()) < 1e-9);
}

BOOST_AUTO_TEST_CASE(isometric_maps_have_the_lower_symmetric_dirichlet_energy)
{
  std::mt19937 random(5);
  std::vector<Chart> charts{winding_strip(2, 3, 3), staircase(80, 4, 2, 0.2), comb(6, 8, 1),
                            slit_sphere(3),         bump(12, 7, 1),           finger(12, 20, 5)};
  for(int branches : {1, 4, 16})
    charts.push_back(tree_cut_bumps(3, branches, 1, 10, random));
  double lower = 0, higher = 0;
  for(const Chart& chart : some(charts)) {
    const double low = symmetric_dirichlet_energy(chart, flattened(chart, isometric()).points());
    const double high = symmetric_dirichlet_energy(chart, flattened(chart, injective()).points());
    BOOST_TEST(low <= (1 + 1e-6) * high);
    BOOST_TEST(low >= 4 * (1 - 1e-12));
    lower += low;
    higher += high;
  }
  BOOST_TEST((is_quick || lower < 0.8 * higher));
}

// They have a map without any distortion, which does not overlap.
BOOST_AUTO_TEST_CASE(strips_of_squares_unroll_isometrically)
{
  for(int order : some<int>({1, 4, 2})) {
    const Chart chart = hilbert_strip(order, 2);
    BOOST_TEST(symmetric_dirichlet_energy(chart, flattened(chart, isometric()).points()) < 4.01);
  }
  const Chart coil = square_spiral(4, 2);
  BOOST_TEST(symmetric_dirichlet_energy(coil, flattened(coil, isometric()).points()) < 4.01);
}

BOOST_AUTO_TEST_CASE(a_map_that_does_not_overlap_keeps_nearly_its_energy)
{
  for(const Chart& chart : {bump(30, 9, 0.5), saddle(14, 1), round_bump(14, 1), staircase(30, 8, 0.4, 1)}) {
    Direct direct;
    const Run<> best(chart, direct);
    BOOST_REQUIRE(best.overlap() == "");
    BOOST_TEST(energy(flattened(chart, injective(0))) < 1.6 * energy(best));
    BOOST_TEST(energy(flattened(chart, injective())) < 1.6 * energy(best));
    Options polished = injective();
    polished.polish = true;
    BOOST_TEST(energy(flattened(chart, polished)) < 1.02 * energy(best));
  }
}

// Also where the least energy without the constraint belongs to a map that overlaps
BOOST_AUTO_TEST_CASE(polishing_lowers_the_energy_and_keeps_the_map_injective)
{
  std::mt19937 random(3);
  for(const Chart& chart :
      {tree_cut_sphere(3, 20, 5, random), tree_cut_bumps(3, 3, 1, 10, random), staircase(60, 5, 1.5, 0.3)}) {
    Options polished = injective();
    polished.polish = true;
    const Run<> run = flattened(chart, polished);
    BOOST_TEST(run.overlap() == "");
    BOOST_TEST(energy(run) <= energy(flattened(chart, injective())));
  }
}

BOOST_AUTO_TEST_CASE(the_same_bits_on_any_number_of_threads)
{
  std::mt19937 random(11);
  std::vector<Chart> charts{hilbert_strip(4, 2), winding_strip(3, 3, 4), tree_cut_sphere(5, 30, 1.5, random)};
  charts.push_back(punched(tree_cut_bumps(4, 3, 2, 20, random), 4, 1, random));
  for(const Chart& chart : some(charts)) {
    std::vector<Point_2> first;
    for(int threads : {1, 2, 3}) {
      Options options = injective();
      options.threads = threads;
      const std::vector<Point_2> points = flattened(chart, options).points();
      BOOST_TEST((first.empty() || points == first), threads << " threads");
      first = points;
      if(is_quick && threads == 2)
        break;
    }
  }
}

// On a rough surface, parts of the border get stuck while they grow. The energy then rises from step to step, and the
// 120 steps of one of these charts would be for nothing. How many there are depends on rounding: fewer than 80 with
// Eigen 3.4, and 82 with Eigen 5.
BOOST_AUTO_TEST_CASE(a_descent_ends_where_the_energy_does_not_fall_any_more)
{
  for(double roughness : {0.5, 1.})
    for(double area_weight : {0.01, 0.2}) {
      std::mt19937 random(4);
      std::uniform_real_distribution<double> height(-roughness, roughness);
      const Chart chart = grid(32, 4, [&](double, double) { return height(random); });
      const abf::Linear_solvers solvers = CGAL::SuperLU_solver_traits<>();
      std::vector<abf::Planar_point> uv = abf::Tutte_map(chart).run(solvers).value();
      const abf::Area_objective objective(chart, area_weight);
      abf::Injective_descent<abf::Area_objective> descent(chart, objective, 0.1, solvers);
      BOOST_TEST(descent.run(uv, {1e-3, 200}));
      // The second chart takes 31 or 32 steps with each kernel of OpenBLAS that was tried, and 73 to 91 if the descent
      // goes on where the energy falls no more. How many the others take depends on the kernel.
      BOOST_TEST(descent.steps() < (roughness == 0.5 && area_weight == 0.2 ? 50 : 200));
      std::vector<Point_2> points;
      for(const abf::Planar_point& p : uv)
        points.emplace_back(p.x(), p.y());
      BOOST_TEST(overlapping_pairs_by_brute_force(chart, points).empty());
      BOOST_TEST(abf::flipped_triangles(chart, points).empty());
    }
}

// Less precise coordinates hold fewer maps.
BOOST_AUTO_TEST_CASE(coordinates_that_are_rounded_stay_injective)
{
  typedef CGAL::Simple_cartesian<float>::Point_2 Float_point;
  int written = 0;
  const std::vector<Chart> charts{hilbert_strip(3, 2), winding_strip(3, 2, 2), slit_sphere(3),
                                  finger(12, 30, 10), finger(12, 70, 23)};
  for(const Chart& chart : charts) {
    Parameterizer parameterizer(injective());
    const Run<Float_point> run(chart, parameterizer);
    BOOST_TEST(contradiction(run, parameterizer.report()) == "");
    written += run.code == SMP::OK;
    if(run.code != SMP::OK)
      BOOST_TEST((parameterizer.report().status == SMP::Diagnosis::PRECISION_EXCEEDED));
  }
  BOOST_TEST(written >= 2);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(faults)

namespace {

enum Behaviour
{
  FAIL,
  OVERLAP,
  NOT_A_NUMBER,
  THROW
};

// As a coarse parameterizer it may do anything.
struct Bad_parameterizer
{
  typedef Surface_mesh Triangle_mesh;
  typedef Surface_mesh TriangleMesh;
  typedef CGAL::SuperLU_solver_traits<> Solver_traits;

  Behaviour behaviour;

  template <typename UV, typename Indices, typename Parameterized>
  SMP::Error_code parameterize(Surface_mesh& mesh, Surface_mesh::Halfedge_index, UV uv, Indices,
                               Parameterized)
  {
    if(behaviour == THROW)
      throw std::runtime_error("coarse parameterizer");
    if(behaviour == FAIL)
      return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for(Vertex v : mesh.vertices())
      put(uv, v, behaviour == OVERLAP ? Point_2(mesh.point(v).x(), mesh.point(v).y()) : Point_2(nan, 0));
    return SMP::OK;
  }
};

// Counts calls, and fails or gives a wrong solution at one of them.
class Faulty_traits : public CGAL::SuperLU_solver_traits<>
{
  typedef CGAL::SuperLU_solver_traits<> Base;

public:
  explicit Faulty_traits(int* calls, bool lies) : m_calls(calls), m_lies(lies) {}

  bool factor(const Matrix& A, NT& D) { return (m_lies || --*m_calls != 0) && Base::factor(A, D); }

  bool linear_solver(const Vector& B, Vector& X)
  {
    if(--*m_calls != 0)
      return Base::linear_solver(B, X);
    for(int i = 0; i < X.dimension(); ++i)
      X[i] = i % 3 - 1;
    return m_lies;
  }

private:
  int* m_calls;
  bool m_lies;
};

} // namespace

// Its map is a start at most: an exception passes, and nothing else does harm.
BOOST_AUTO_TEST_CASE(a_bad_coarse_parameterizer_does_no_harm)
{
  typedef SMP::Hierarchical_parameterizer_3<Surface_mesh, Bad_parameterizer> Injective;
  for(Behaviour behaviour : {FAIL, OVERLAP, NOT_A_NUMBER, THROW}) {
    Injective parameterizer(injective(), Bad_parameterizer{behaviour});
    Run<> run(winding_strip(3, 3, 3));
    try {
      run.flatten(parameterizer);
      BOOST_TEST(run.code == SMP::OK);
      BOOST_TEST(contradiction(run, parameterizer.report()) == "");
    } catch(const std::runtime_error&) {
      BOOST_TEST(behaviour == THROW);
      BOOST_TEST(run.is_untouched());
    }
  }
}

BOOST_AUTO_TEST_CASE(a_faulty_solver_never_leads_to_an_overlap)
{
  typedef SMP::Hierarchical_parameterizer_3<Surface_mesh, CGAL::Default, Faulty_traits> Injective;
  const Chart chart = winding_strip(2, 2, 2);
  for(bool lies : {false, true})
    for(int call = 1, is_hit = true; is_hit && call <= (is_quick ? 5 : 100); call += 1 + call / 5) {
      int calls = call;
      Options options = injective();
      options.polish = true;
      Injective parameterizer(options, Injective::Coarse_parameterizer(), Faulty_traits(&calls, lies));
      const Run<> run(chart, parameterizer);
      is_hit = calls <= 0;
      BOOST_TEST_INFO_SCOPE("call " << call << (lies ? " lies" : " fails"));
      BOOST_TEST(contradiction(run, parameterizer.report()) == "");
      BOOST_TEST((is_hit || run.code == SMP::OK));
    }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
