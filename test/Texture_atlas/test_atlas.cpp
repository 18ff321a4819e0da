// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of surfaces of several components, some of which cannot be flattened: every face has a chart or a reason,
// nothing overlaps, and what the report says is true.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"
#include "test_data.h"
#include "test_options.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_atlas)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::make_atlas_of;
using atlas_check::Wishes;
using atlas_surfaces::component;
using atlas_surfaces::Component;
using atlas_surfaces::random_union;
using atlas_surfaces::Union;
using TA::Atlas_options;
using TA::Atlas_report;
using SMP::Diagnosis;
using TA::Atlas_visitor;
using test_charts::uniform_int;
typedef CGAL::Surface_mesh<test_charts::Point_3> Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Face_index Face;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

unsigned number_of_unions(unsigned in_full, unsigned if_quick)
{
  return std::getenv("ABF_TEST_QUICK") == nullptr ? in_full : if_quick;
}

// Other seeds can be tried by hand.
unsigned first_seed()
{
  const char* text = std::getenv("ABF_TEST_SEED");
  return text == nullptr ? 0 : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

Mesh mesh_of(const std::vector<Component>& components)
{
  Union all;
  for(const Component& c : components)
    all.add(c);
  return all.mesh<Mesh>();
}

Mesh mesh_of(const seam_surfaces::Surface& surface)
{
  return mesh_of({component(surface)});
}

template <typename NamedParameters = parameters::Default_named_parameters>
Atlas_run make_with_seams(const Mesh& mesh, const std::function<bool(Edge)>& is_given,
                          const Atlas_options& options = few_charts(),
                          const NamedParameters& np = parameters::default_values())
{
  return make_atlas_of(mesh, options, np, is_given, mesh.points());
}

bool are_same(const Atlas_run& run, const Atlas_run& other)
{
  return run.uv == other.uv && run.is_seam == other.is_seam && run.chart == other.chart;
}

void check_diagnosis(const Atlas_run& run, Diagnosis diagnosis)
{
  BOOST_TEST((run.report.status == diagnosis), to_string(run.report.status));
  BOOST_TEST(run.report.message != "");
  BOOST_TEST(!run.report.has_atlas());
  BOOST_TEST(run.is_untouched());
}

// Good components have charts; the others are named with the reason.
void check_components(const Union& all, const Atlas_run& run)
{
  const std::vector<int> component_of_vertex = all.component_of_vertex();
  std::vector<int> charted(all.components.size(), 0);
  const auto component_of_face = [&](std::size_t f) {
    return component_of_vertex[run.vertex[run.first_corner[f]]];
  };
  for(std::size_t f = 0; f < run.number_of_faces(); ++f)
    charted[component_of_face(f)] += run.chart[f] >= 0 ? 1 : 0;
  for(std::size_t i = 0; i < all.components.size(); ++i)
    BOOST_TEST((charted[i] > 0) == all.components[i].is_good(), all.components[i].name);
  for(const Atlas_report::Skipped& skipped : run.report.skipped) {
    const Component& c = all.components[component_of_face(skipped.first_face)];
    BOOST_TEST(skipped.status == c.status, c.name << ": " << skipped.status);
  }
}

// A visitor that stops at a call
struct Stopping_visitor : Atlas_visitor
{
  int calls = 0, stop_at = -1;
  std::vector<Stage> stages;
  std::vector<double> shares;

  bool start(Stage stage) override
  {
    stages.push_back(stage);
    return ++calls != stop_at;
  }

  bool progress(double share) override
  {
    BOOST_TEST((stages.back() == CHARTS));
    shares.push_back(share);
    return ++calls != stop_at;
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(every_face_has_a_chart_or_a_reason)
{
  int skipped = 0, injective = 0, separated = 0;
  const unsigned unions = number_of_unions(200, 30);
  for(unsigned seed = first_seed(); seed < first_seed() + unions; ++seed) {
    const Union all = random_union(seed);
    const Mesh mesh = all.mesh<Mesh>();
    std::mt19937 random(seed);
    Wishes wishes;
    wishes.resolution = 64 << uniform_int(random, 0, 2);
    wishes.gutter = uniform_int(random, 0, 3);
    wishes.packs = uniform_int(random, 0, 3) > 0;
    if(!wishes.packs) {
      wishes.resolution = Atlas_options().resolution;
      wishes.gutter.reset();
    }
    wishes.stretch_bound = uniform_int(random, 0, 3) == 0 ? 1.02 : 1.1;
    const bool has_weights = wishes.packs && uniform_int(random, 0, 2) == 0;
    wishes.weight.assign(mesh.number_of_faces() + mesh.number_of_removed_faces(), 1);
    for(double& w : wishes.weight)
      w = has_weights ? uniform_int(random, 0, 3) + 0.01 : 1.;
    const auto weights = boost::make_function_property_map<Face>([&](Face f) { return wishes.weight[f]; });
    const bool separates = uniform_int(random, 0, 2) == 0, cuts = uniform_int(random, 0, 2) == 0,
               is_isometric = uniform_int(random, 0, 2) == 0;
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    const Atlas_run run =
        make_atlas_of(mesh,
                      few_charts(&Atlas_options::resolution, wishes.resolution, &Atlas_options::gutter,
                                 wishes.gutter, &Atlas_options::pack_into_square, wishes.packs,
                                 &Atlas_options::stretch_bound, wishes.stretch_bound,
                                 &Atlas_options::separate_overlaps, separates, &Atlas_options::seam_price,
                                 cuts ? 0.04 : infinity, &Atlas_options::isometric_charts, is_isometric),
                      parameters::face_size_map(weights));
    if(all.without_bad_components().components.empty()) {
      BOOST_TEST(run.report.skipped.size() == all.components.size());
      check_diagnosis(run, run.report.skipped.front().status);
      continue;
    }
    std::vector<double> weight_of_rank;
    for(Face f : mesh.faces())
      weight_of_rank.push_back(wishes.weight[f]);
    wishes.weight = weight_of_rank;
    check_atlas(run, wishes);
    check_components(all, run);
    skipped += !run.report.skipped.empty();
    for(const Atlas_report::Chart& chart : run.report.charts) {
      injective += chart.method == Atlas_report::INJECTIVE;
      separated += chart.method == Atlas_report::SEPARATED;
      if(separates && !is_isometric)
        BOOST_TEST((chart.method != Atlas_report::INJECTIVE));
    }
  }
  // all of that did come up
  BOOST_TEST(skipped > 0);
  BOOST_TEST(injective > 0);
  BOOST_TEST(separated > 0);
}

BOOST_AUTO_TEST_CASE(bad_components_change_nothing_of_the_others)
{
  int compared = 0;
  for(unsigned seed = 1000 + first_seed(); compared < static_cast<int>(number_of_unions(25, 5)); ++seed) {
    const Union all = random_union(seed), good = all.without_bad_components();
    if(good.components.empty() || all.is_good())
      continue;
    ++compared;
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    const Mesh mesh = all.mesh<Mesh>(), good_mesh = good.mesh<Mesh>();
    const Atlas_run run = make_atlas_of(mesh), alone = make_atlas_of(good_mesh);
    BOOST_TEST(alone.report.has_atlas(), alone.report.message);
    std::vector<atlas_check::Point_2> uv;
    for(std::size_t c = 0; c < run.uv.size(); ++c)
      if(run.chart[run.face[c]] >= 0)
        uv.push_back(run.uv[c]);
    BOOST_TEST((uv == alone.uv));
    std::vector<int> charts;
    for(int chart : run.chart)
      if(chart >= 0)
        charts.push_back(chart);
    BOOST_TEST(charts == alone.chart);
    BOOST_TEST(run.report.seam_length == alone.report.seam_length);
  }
}

BOOST_AUTO_TEST_CASE(components_are_flattened_as_if_they_were_alone)
{
  for(unsigned seed = 2000 + first_seed(); seed < 2000 + first_seed() + number_of_unions(20, 5); ++seed) {
    const Union all = random_union(seed).without_bad_components();
    if(all.components.empty())
      continue;
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    const Atlas_run run =
        make_atlas_of(all.mesh<Mesh>(), few_charts(&Atlas_options::pack_into_square, false));
    const std::vector<int> component_of_vertex = all.component_of_vertex();
    for(std::size_t i = 0; i < all.components.size(); ++i) {
      const Atlas_run alone =
          make_atlas_of(mesh_of({all.components[i]}), few_charts(&Atlas_options::pack_into_square, false));
      std::vector<atlas_check::Point_2> uv;
      for(std::size_t c = 0; c < run.uv.size(); ++c)
        if(component_of_vertex[run.vertex[c]] == static_cast<int>(i))
          uv.push_back(run.uv[c]);
      BOOST_TEST((uv == alone.uv), all.components[i].name);
    }
  }
}

// By a factor of 10^8: what is more than a billion times as far away as most vertices is left out.
BOOST_AUTO_TEST_CASE(sizes_may_be_very_different)
{
  for(unsigned seed = 3000 + first_seed(); seed < 3000 + first_seed() + number_of_unions(20, 5); ++seed) {
    const Union all = random_union(seed, 8, 4).without_bad_components();
    if(all.components.empty())
      continue;
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    Wishes wishes;
    wishes.resolution = 256;
    const Atlas_run run = make_atlas_of(all.mesh<Mesh>(), few_charts(&Atlas_options::resolution, 256));
    BOOST_TEST(run.report.has_atlas(), run.report.message);
    check_atlas(run, wishes);
  }
}

// Powers of two do not round.
BOOST_AUTO_TEST_CASE(the_unit_of_length_does_not_matter)
{
  const Union all = random_union(22, 8).without_bad_components();
  const Atlas_run run = make_atlas_of(all.mesh<Mesh>());
  BOOST_TEST_REQUIRE(run.report.has_atlas(), run.report.message);
  for(int exponent : {-400, -30, 400}) {
    BOOST_TEST_INFO_SCOPE("2^" << exponent);
    const double unit = std::ldexp(1, exponent);
    Mesh mesh = all.mesh<Mesh>();
    for(auto v : mesh.vertices()) {
      const auto p = mesh.point(v);
      mesh.point(v) = test_charts::Point_3(unit * p.x(), unit * p.y(), unit * p.z());
    }
    const Atlas_run other = make_atlas_of(mesh);
    BOOST_TEST(are_same(run, other));
    BOOST_TEST(other.report.seam_length == unit * run.report.seam_length);
    BOOST_TEST(other.report.relative_seam_length == run.report.relative_seam_length);
    BOOST_TEST(other.report.scale == run.report.scale / unit);
    BOOST_TEST(other.report.measures.l2_stretch == run.report.measures.l2_stretch);
    BOOST_TEST_REQUIRE(other.report.charts.size() == run.report.charts.size());
    for(std::size_t i = 0; i < run.report.charts.size(); ++i)
      BOOST_TEST(other.report.charts[i].area == unit * unit * run.report.charts[i].area);
  }
}

BOOST_AUTO_TEST_CASE(any_number_of_threads_gives_the_same_bits)
{
  for(unsigned seed = 4000 + first_seed(); seed < 4000 + first_seed() + number_of_unions(20, 5); ++seed) {
    const Union all = random_union(seed, 8);
    const Mesh mesh = all.mesh<Mesh>();
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    const Atlas_run one = make_atlas_of(mesh, few_charts(&Atlas_options::threads, 1));
    for(int threads : {0, 2, 3}) {
      const Atlas_run other = make_atlas_of(mesh, few_charts(&Atlas_options::threads, threads));
      BOOST_TEST(are_same(one, other));
      BOOST_TEST(one.report.message == other.report.message);
      BOOST_TEST(one.report.seam_length == other.report.seam_length);
      BOOST_TEST(one.report.covered_share == other.report.covered_share);
      BOOST_TEST(one.report.measures.l2_stretch == other.report.measures.l2_stretch);
      BOOST_TEST(one.report.measures.mean_angle_change == other.report.measures.mean_angle_change);
      BOOST_TEST_REQUIRE(one.report.charts.size() == other.report.charts.size());
      for(std::size_t i = 0; i < one.report.charts.size(); ++i)
        BOOST_TEST(one.report.charts[i].scale_stretch == other.report.charts[i].scale_stretch);
    }
  }
}

BOOST_AUTO_TEST_CASE(given_seams_stay_and_constrained_edges_never_become_seams)
{
  int forbidden = 0, charted = 0;
  const unsigned unions = number_of_unions(60, 10);
  for(unsigned i = 0; i <= unions; ++i) {
    // in the last one, the pieces of a map that overlaps itself cannot be separated
    const unsigned seed = i == unions ? 45033 : 5000 + first_seed() + i;
    const Union all = random_union(seed, 3);
    const Mesh mesh = all.mesh<Mesh>();
    std::mt19937 random(seed);
    std::vector<char> is_given(mesh.num_edges(), false), is_constrained(mesh.num_edges(), false);
    const int given = uniform_int(random, 0, 20), constrained = uniform_int(random, 0, 110);
    for(std::size_t e = 0; e < is_given.size(); ++e) {
      is_given[e] = uniform_int(random, 0, 99) < given;
      is_constrained[e] = uniform_int(random, 0, 99) < constrained;
    }
    BOOST_TEST_INFO_SCOPE("seed " << seed << ": " << all.names());
    const Atlas_run run = make_with_seams(
        mesh, [&](Edge e) { return bool(is_given[e]); }, few_charts(&Atlas_options::resolution, 256),
        parameters::edge_is_constrained_map(
            boost::make_function_property_map<Edge>([&](Edge e) { return bool(is_constrained[e]); })));
    if(!run.report.has_atlas()) {
      check_diagnosis(run, run.report.skipped.front().status);
      continue;
    }
    Wishes wishes;
    wishes.resolution = 256;
    check_atlas(run, wishes);
    std::size_t corner = 0;
    for(Face f : mesh.faces())
      for(auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        if(is_constrained[mesh.edge(h)] && !is_given[mesh.edge(h)])
          BOOST_TEST_REQUIRE(!run.is_seam[corner]);
        ++corner;
      }
    for(const Atlas_report::Skipped& skipped : run.report.skipped)
      forbidden += skipped.status == Diagnosis::NO_CUT_ALLOWED;
    charted += static_cast<int>(run.report.charts.size());
  }
  BOOST_TEST(forbidden > 0);
  BOOST_TEST(charted > 0);
}

BOOST_AUTO_TEST_CASE(a_seam_separates_a_bad_part_from_a_good_one)
{
  Mesh mesh = mesh_of(seam_surfaces::sphere(2));
  const auto is_above = [&](Face f) {
    for(auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      if(mesh.point(v).z() < -1e-9)
        return false;
    return true;
  };
  const auto is_given = [&](Edge e) {
    return is_above(mesh.face(mesh.halfedge(e, 0))) != is_above(mesh.face(mesh.halfedge(e, 1)));
  };
  std::vector<char> seams;
  for(Edge e : mesh.edges())
    seams.push_back(is_given(e));
  std::vector<char> above;
  for(Face f : mesh.faces())
    above.push_back(is_above(f));
  std::vector<char> is_wrong(above.size(), false);
  for(auto v : mesh.vertices())
    if(mesh.point(v).z() > 0.9) {
      mesh.point(v) = test_charts::Point_3(0, 0, infinity);
      for(Face f : mesh.faces_around_target(mesh.halfedge(v)))
        is_wrong[f] = true;
      break;
    }
  const Atlas_run run = make_with_seams(mesh, [&](Edge e) { return bool(seams[e]); });
  BOOST_TEST(run.report.number_of_parts == 3u); // above and below, and around the point
  BOOST_TEST_REQUIRE(run.report.skipped.size() == 1u);
  BOOST_TEST(run.report.skipped.front().status == Diagnosis::NON_FINITE_POINT);
  for(std::size_t f = 0; f < is_wrong.size(); ++f)
    BOOST_TEST_REQUIRE((run.chart[f] >= 0) == !is_wrong[f]);
}

// A terrain where some edges have a vertex on one side only, with a face without area between, and where one point may
// be not finite or far away
BOOST_AUTO_TEST_CASE(bad_faces_change_nothing_of_others)
{
  const int n = 14;
  for(unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    Mesh whole, part; // the same without bad faces
    std::vector<char> is_split;
    for(int v = 0; v < n * n; ++v) {
      const test_charts::Point_3 point(v % n, v / n, std::ldexp(uniform_int(random, -500, 500), -9));
      for(Mesh* mesh : {&whole, &part})
        mesh->add_vertex(point);
      is_split.push_back(v % n > 0 && v / n > 0 && v % n < n - 2 && v / n < n - 1 && random() % 6 == 0);
    }
    const auto is_wrong = [&](int v) { return seed % 2 == 0 && v == n * n / 2 + n / 2; };
    typedef Mesh::Vertex_index Vertex;
    std::vector<Face> partners; // of each face of the whole, in the part
    std::vector<std::array<Vertex, 3>> without_area;
    const auto add = [&](Vertex a, Vertex b, Vertex c) {
      BOOST_TEST_REQUIRE(whole.add_face(a, b, c) != Mesh::null_face());
      partners.push_back(is_wrong(a) || is_wrong(b) || is_wrong(c) ? Mesh::null_face()
                                                                   : part.add_face(a, b, c));
    };
    for(int j = 0; j + 1 < n; ++j)
      for(int i = 0; i + 1 < n; ++i) {
        const Vertex a(j * n + i), b(a + 1), c(a + n), d(c + 1);
        if(is_split[a] && !is_wrong(a) && !is_wrong(d)) { // its diagonal
          const Vertex m = whole.add_vertex(CGAL::midpoint(whole.point(a), whole.point(d)));
          part.add_vertex(whole.point(m));
          add(a, b, d);
          add(m, c, a);
          add(d, c, m);
          without_area.push_back({a, d, m});
        } else {
          add(a, b, d);
          add(a, d, c);
        }
      }
    for(const auto& [a, d, m] : without_area)
      BOOST_TEST_REQUIRE(whole.add_face(a, d, m) != Mesh::null_face());
    for(Mesh* mesh : {&whole, &part})
      for(Vertex v : mesh->vertices())
        if(is_wrong(static_cast<int>(v)))
          mesh->point(v) = test_charts::Point_3(0, seed % 4 == 0 ? infinity : -1e20, 0);
    const Atlas_run run = make_atlas_of(whole, Atlas_options::TEXTURE),
                    expected = make_atlas_of(part, Atlas_options::TEXTURE);
    BOOST_TEST(expected.report.skipped.empty());
    BOOST_TEST(run.report.skipped.size() == (seed % 2 == 0 ? 1u : 0u));
    for(const auto& skipped : run.report.skipped)
      BOOST_TEST(skipped.status == (seed % 4 == 0 ? Diagnosis::NON_FINITE_POINT : Diagnosis::FAR_POINT));
    BOOST_TEST(run.report.degenerate_triangles > 0u);
    BOOST_TEST(run.report.degenerate_triangles + partners.size() == whole.number_of_faces());
    std::size_t different = 0;
    for(std::size_t f = 0; f < whole.number_of_faces(); ++f) {
      const std::size_t c = run.first_corner[f];
      if(f >= partners.size()) { // without area: on a line
        BOOST_TEST(run.chart[f] >= 0);
        BOOST_TEST(std::abs(CGAL::area(run.uv[c], run.uv[c + 1], run.uv[c + 2])) < 1e-16);
      } else if(partners[f] == Mesh::null_face()) {
        BOOST_TEST(run.chart[f] == -1);
      } else {
        const std::size_t e = expected.first_corner[partners[f]];
        for(std::size_t k = 0; k < 3; ++k)
          different += run.uv[c + k] != expected.uv[e + k];
      }
    }
    BOOST_TEST(different == 0u);
    std::size_t torn = 0, beside_chart = 0; // where no seam is
    for(std::size_t c = 0; c < run.uv.size(); ++c)
      if(run.is_joined(c)) {
        const std::size_t across = run.across[c];
        const bool has_chart = run.chart[run.face[c]] >= 0;
        beside_chart += has_chart != (run.chart[run.face[across]] >= 0);
        torn += has_chart &&
                (run.uv[c] != run.uv[run.previous(across)] || run.uv[run.previous(c)] != run.uv[across]);
      }
    BOOST_TEST(torn == 0u);
    BOOST_TEST(beside_chart == 0u);
    Few_charts keep;
    keep.given_charts = Atlas_options::KEEP; // there are none
    BOOST_TEST(!make_atlas_of(whole, keep).report.has_atlas());
  }
}

BOOST_AUTO_TEST_CASE(surfaces_of_every_kind_become_one_chart)
{
  std::mt19937 random(7);
  std::vector<Component> components;
  for(const auto& solid : seam_surfaces::platonic_solids())
    components.push_back(component(solid));
  for(int handles = 0; handles < 6; ++handles)
    components.push_back(component(seam_surfaces::slab(handles)));
  components.push_back(component(seam_surfaces::torus(24, 12)));
  components.push_back(component(seam_surfaces::torus(3, 3)));
  components.push_back(component(seam_surfaces::tube(12, 30)));
  components.push_back(component(seam_surfaces::tube(3, 1)));
  components.push_back(component(seam_surfaces::sphere(3)));
  components.push_back(component(seam_surfaces::sphere_with_holes(20, 3)));
  components.push_back(atlas_surfaces::disk_with_holes(12, random));
  components.push_back(atlas_surfaces::single_triangle(random));
  components.push_back(atlas_surfaces::pillow());
  components.push_back(atlas_surfaces::staircase(60, 2.3));
  components.push_back(atlas_surfaces::bumpy_sphere(random));
  components.push_back(component("annulus", test_charts::annulus(12)));
  components.push_back(component("torus with hole", test_charts::torus_with_hole(12)));
  for(const Component& c : components) {
    BOOST_TEST_INFO_SCOPE(c.name);
    Wishes wishes;
    wishes.resolution = 256;
    const Atlas_run run = make_atlas_of(mesh_of({c}), few_charts(&Atlas_options::resolution, 256));
    BOOST_TEST(bool(run.report), run.report.message);
    check_atlas(run, wishes);
    BOOST_TEST(run.report.charts.size() == 1u);
  }
}

// Two triangles and more that have no more than a vertex in common
BOOST_AUTO_TEST_CASE(pinched_vertices_belong_to_several_charts)
{
  const Mesh mesh = mesh_of({{"bow tie",
                              {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                              {{0, 1, 2}, {0, 3, 4}, {2, 3, 5}}}});
  const Atlas_run run = make_atlas_of(mesh, few_charts(&Atlas_options::resolution, 64));
  Wishes wishes;
  wishes.resolution = 64;
  check_atlas(run, wishes);
  BOOST_TEST(run.report.charts.size() == 3u);
  BOOST_TEST(run.report.seam_length == 0);
}

BOOST_AUTO_TEST_CASE(a_smaller_bound_means_less_stretch_and_longer_seams)
{
  const Mesh mesh = mesh_of(seam_surfaces::sphere(3));
  double seam = infinity, stretch = 0;
  for(double bound : {1.02, 1.05, 1.1, 1.3}) {
    const Atlas_run run = make_atlas_of(mesh, few_charts(&Atlas_options::stretch_bound, bound));
    Wishes wishes;
    wishes.stretch_bound = bound;
    check_atlas(run, wishes);
    BOOST_TEST_REQUIRE(run.report.charts.size() == 1u);
    BOOST_TEST(run.report.charts[0].bound_reached);
    BOOST_TEST(run.report.seam_length < seam);
    BOOST_TEST(run.report.charts[0].scale_stretch > stretch);
    BOOST_TEST(run.report.number_of_terminals > 0u);
    seam = run.report.seam_length;
    stretch = run.report.charts[0].scale_stretch;
  }
}

BOOST_AUTO_TEST_CASE(without_terminals_surfaces_are_only_cut_to_disks)
{
  for(const Mesh& mesh :
      {mesh_of(seam_surfaces::torus(24, 12)), mesh_of(seam_surfaces::sphere_with_holes(3, 2)),
       mesh_of({component("bump", test_charts::bump(10, 1, 1))})}) {
    Wishes unbound;
    unbound.stretch_bound = infinity;
    const Atlas_run infinite = make_atlas_of(mesh, few_charts(&Atlas_options::stretch_bound, infinity)),
                    none = make_atlas_of(mesh, few_charts(&Atlas_options::maximum_number_of_terminals, 0));
    check_atlas(infinite, unbound);
    check_atlas(none, Wishes());
    for(const Atlas_run* run : {&infinite, &none}) {
      BOOST_TEST(run->report.number_of_terminals == 0u);
      BOOST_TEST(run->report.charts.size() == 1u);
      BOOST_TEST(run->report.charts[0].rounds == 0);
    }
    BOOST_TEST(infinite.report.charts[0].bound_reached);
    BOOST_TEST(infinite.is_seam == none.is_seam);
  }
  // a bound that is missed is not said to be reached
  const Atlas_run bumps = make_atlas_of(mesh_of({component("bump", test_charts::bump(20, 1, 3))}),
                                        few_charts(&Atlas_options::maximum_number_of_terminals, 0));
  BOOST_TEST(!bumps.report.charts[0].bound_reached);
  BOOST_TEST(bumps.report.seam_length == 0);
}

BOOST_AUTO_TEST_CASE(the_number_of_terminals_is_at_most_what_is_allowed)
{
  const Mesh mesh = mesh_of(seam_surfaces::sphere(3));
  double stretch = infinity;
  for(int most : {2, 4, 8}) {
    const Atlas_run run = make_atlas_of(mesh, few_charts(&Atlas_options::maximum_number_of_terminals, most,
                                                         &Atlas_options::stretch_bound, 1.001));
    BOOST_TEST(run.report.number_of_terminals <= static_cast<std::size_t>(most));
    BOOST_TEST(!run.report.charts[0].bound_reached);
    BOOST_TEST(run.report.charts[0].scale_stretch < stretch);
    stretch = run.report.charts[0].scale_stretch;
  }
}

BOOST_AUTO_TEST_CASE(overlaps_become_injective_or_are_separated)
{
  const Mesh mesh = mesh_of({atlas_surfaces::staircase(60, 2.3)});
  const Atlas_run injective = make_atlas_of(mesh),
                  separated = make_atlas_of(mesh, few_charts(&Atlas_options::separate_overlaps, true));
  check_atlas(injective, Wishes());
  check_atlas(separated, Wishes());
  BOOST_TEST_REQUIRE(injective.report.charts.size() == 1u);
  BOOST_TEST((injective.report.charts[0].method == Atlas_report::INJECTIVE));
  BOOST_TEST(injective.report.seam_length == 0);
  BOOST_TEST(separated.report.charts.size() > 1u);
  BOOST_TEST(separated.report.seam_length > 0);
  for(const auto& chart : separated.report.charts) {
    BOOST_TEST((chart.method == Atlas_report::SEPARATED));
    BOOST_TEST(chart.part == 0u);
  }
  // what ABF++ leaves without overlap is as ABF++ made it
  BOOST_TEST(separated.report.measures.rms_angle_change < injective.report.measures.rms_angle_change);
}

BOOST_AUTO_TEST_CASE(overlaps_of_larger_charts_are_predicted)
{
  const bool is_quick = std::getenv("ABF_TEST_QUICK") != nullptr;
  for(double turns :
      is_quick ? std::vector{0.95, 1.15, 2.} : std::vector{0.4, 0.8, 0.95, 1.15, 1.4, 2., 2.6}) {
    const Mesh mesh = mesh_of({component("staircase", test_charts::staircase(120, 24, turns, 0.1))});
    const Atlas_run run = make_atlas_of(mesh),
                    separated = make_atlas_of(mesh, few_charts(&Atlas_options::separate_overlaps, true));
    check_atlas(run, Wishes());
    BOOST_TEST_REQUIRE(run.report.charts.size() == 1u);
    const Atlas_report::Chart& chart = run.report.charts[0];
    const bool overlaps = separated.report.charts.size() > 1;
    BOOST_TEST(overlaps == (turns > 1));
    BOOST_TEST(chart.overlap_is_predicted == overlaps);
    BOOST_TEST((chart.method == (overlaps ? Atlas_report::INJECTIVE : Atlas_report::ABF_PLUS_PLUS)));
  }
}

BOOST_AUTO_TEST_CASE(a_larger_weight_of_areas_stretches_them_less)
{
  const Mesh mesh = mesh_of({atlas_surfaces::staircase(60, 2.3)});
  double area_distortion = infinity;
  std::vector<double> angle_changes;
  for(double weight : {0.005, 0.05, 0.5}) {
    const Atlas_run run = make_atlas_of(mesh, few_charts(&Atlas_options::area_weight, weight));
    check_atlas(run, Wishes());
    BOOST_TEST_REQUIRE((run.report.charts[0].method == Atlas_report::INJECTIVE));
    BOOST_TEST(run.report.measures.l2_area_distortion < area_distortion);
    area_distortion = run.report.measures.l2_area_distortion;
    angle_changes.push_back(run.report.measures.rms_angle_change);
  }
  // Between these weights, it depends on rounding in which local minimum the steps lock.
  BOOST_TEST(angle_changes.back() > 1.1 * angle_changes.front());
}

BOOST_AUTO_TEST_CASE(resolution_and_gutter_are_kept)
{
  const Mesh mesh = random_union(11, 8).without_bad_components().mesh<Mesh>();
  for(int resolution : {32, 64, 256}) {
    double covered = 1;
    for(int gutter : {0, 1, 2, 5}) {
      Wishes wishes;
      wishes.resolution = resolution;
      wishes.gutter = gutter;
      const Atlas_run run = make_atlas_of(
          mesh, few_charts(&Atlas_options::resolution, resolution, &Atlas_options::gutter, gutter));
      check_atlas(run, wishes);
      BOOST_TEST(run.report.covered_share < covered);
      covered = run.report.covered_share * 1.05;
    }
  }
}

BOOST_AUTO_TEST_CASE(measures_are_those_of_measure_flattening)
{
  const Mesh mesh = mesh_of(seam_surfaces::slab(2));
  const auto uv = get(CGAL::dynamic_halfedge_property_t<CGAL::Simple_cartesian<double>::Point_2>(), mesh);
  const auto seams = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  for(Edge e : mesh.edges())
    put(seams, e, false);
  const auto charts = get(CGAL::dynamic_face_property_t<int>(), mesh);
  const auto report =
      TA::make_atlas(mesh, seams, uv, charts, few_charts(&Atlas_options::pack_into_square, false));
  BOOST_TEST_REQUIRE(bool(report));
  const auto seam_mesh = TA::make_seam_mesh(mesh, seams).mesh;
  typedef std::decay_t<decltype(seam_mesh)> Seam_mesh;
  const auto vertex_uv = boost::make_function_property_map<boost::graph_traits<Seam_mesh>::vertex_descriptor>(
      [&](const auto& v) { return get(uv, static_cast<Mesh::Halfedge_index>(v)); });
  const SMP::Flattening_measures expected =
      SMP::measure_flattening(seam_mesh, TA::border_halfedge(seam_mesh), vertex_uv);
  const auto check = [&](auto member) {
    BOOST_TEST((report.measures.*member) == (expected.*member), boost::test_tools::tolerance(1e-9));
  };
  for(auto member :
      {&SMP::Flattening_measures::mean_angle_change, &SMP::Flattening_measures::rms_angle_change,
       &SMP::Flattening_measures::mean_corner_angle_change,
       &SMP::Flattening_measures::rms_corner_angle_change, &SMP::Flattening_measures::angular_distortion,
       &SMP::Flattening_measures::l2_stretch, &SMP::Flattening_measures::linf_stretch,
       &SMP::Flattening_measures::mean_quasi_conformal_ratio,
       &SMP::Flattening_measures::quasi_conformal_ratio_95, &SMP::Flattening_measures::min_scale,
       &SMP::Flattening_measures::max_scale, &SMP::Flattening_measures::max_quasi_conformal_ratio,
       &SMP::Flattening_measures::l2_area_distortion, &SMP::Flattening_measures::symmetric_dirichlet_energy,
       &SMP::Flattening_measures::smallest_angle, &SMP::Flattening_measures::l2_principal_shear})
    check(member);
  BOOST_TEST(report.measures.flipped_triangles == expected.flipped_triangles);
  BOOST_TEST(report.measures.border_is_simple == expected.border_is_simple);
  BOOST_TEST(report.charts[0].l2_stretch == expected.l2_stretch, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(wrong_options_name_themselves_and_change_nothing)
{
  const Mesh mesh = mesh_of(seam_surfaces::tetrahedron());
  const auto check = [&](const std::string& name, const Atlas_options& options) {
    const Atlas_run run = make_atlas_of(mesh, options);
    BOOST_TEST_CONTEXT(name) check_diagnosis(run, Diagnosis::WRONG_OPTION);
    BOOST_TEST(run.report.message.find(name) != std::string::npos, run.report.message);
  };
  for(double bound : {0.99, -infinity, std::nan("")})
    check("stretch", few_charts(&Atlas_options::stretch_bound, bound));
  check("terminals", few_charts(&Atlas_options::maximum_number_of_terminals, -1));
  for(double weight : {-0.1, 1.1, std::nan("")})
    check("area_weight", few_charts(&Atlas_options::area_weight, weight));
  for(int resolution : {0, -5, 1 << 20})
    check("resolution", few_charts(&Atlas_options::resolution, resolution));
  for(int gutter : {-1, 1 << 20})
    check("gutter", few_charts(&Atlas_options::gutter, gutter));
  for(int rotations : {0, 1 << 20})
    check("rotations", few_charts(&Atlas_options::number_of_rotations, rotations));
  check("threads", few_charts(&Atlas_options::threads, -1));
}

BOOST_AUTO_TEST_CASE(wrong_weights_name_the_edge_or_face_and_change_nothing)
{
  const Mesh mesh =
      mesh_of({component(seam_surfaces::tetrahedron()), component(seam_surfaces::octahedron())});
  for(double wrong : {-1., std::nan(""), -infinity}) {
    const Face face(6);
    const Atlas_run faces = make_atlas_of(mesh, few_charts(),
                                          parameters::face_size_map(boost::make_function_property_map<Face>(
                                              [&](Face f) { return f == face ? wrong : 2.; })));
    check_diagnosis(faces, Diagnosis::WRONG_WEIGHT);
    BOOST_TEST(faces.report.message.find("face 6 ") != std::string::npos, faces.report.message);

    const Edge edge(8);
    const Atlas_run edges = make_atlas_of(mesh, few_charts(),
                                          parameters::edge_weight_map(boost::make_function_property_map<Edge>(
                                              [&](Edge e) { return e == edge ? wrong : 2.; })));
    check_diagnosis(edges, Diagnosis::WRONG_WEIGHT);
    for(auto v : {mesh.vertex(edge, 0), mesh.vertex(edge, 1)}) {
      std::ostringstream point;
      point << '(' << mesh.point(v).x() << ", " << mesh.point(v).y() << ", " << mesh.point(v).z() << ')';
      BOOST_TEST(edges.report.message.find(point.str()) != std::string::npos,
                 edges.report.message << " without " << point.str());
    }
  }
  const Atlas_run infinite = make_atlas_of(mesh, few_charts(),
                                           parameters::face_size_map(boost::make_function_property_map<Face>(
                                               [](Face f) { return f == Face(3) ? infinity : 1.; })));
  check_diagnosis(infinite, Diagnosis::WRONG_WEIGHT);
  const Atlas_run zero = make_atlas_of(
      mesh, few_charts(),
      parameters::face_size_map(boost::make_function_property_map<Face>([](Face) { return 0.; })));
  check_diagnosis(zero, Diagnosis::PACKING_FAILED);
}

// Whatever the unit of weights is
BOOST_AUTO_TEST_CASE(weights_of_faces_count_in_proportion)
{
  const Mesh mesh =
      mesh_of({component(seam_surfaces::tetrahedron()), component(seam_surfaces::octahedron())});
  std::vector<std::vector<atlas_check::Point_2>> uv;
  for(double unit : {1., 1e-100, 1e-200, 1e100, 1e200}) {
    BOOST_TEST_INFO_SCOPE("unit " << unit);
    const auto weights =
        boost::make_function_property_map<Face>([&](Face f) { return f < Face(4) ? 3 * unit : unit; });
    const Atlas_run run =
        make_atlas_of(mesh, few_charts(&Atlas_options::resolution, 128), parameters::face_size_map(weights));
    BOOST_TEST_REQUIRE(bool(run.report), run.report.message);
    std::vector<double> density(2, 0);
    const auto sums = atlas_check::chart_sums(run, {});
    for(std::size_t i = 0; i < 2; ++i)
      density[i] = std::sqrt(sums[i].plane / sums[i].surface);
    BOOST_TEST(density[0] == 3 * density[1], boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(seams_avoid_heavy_edges)
{
  const Mesh mesh = mesh_of(seam_surfaces::torus(24, 12));
  const auto is_heavy = [&](Edge e) { return mesh.point(mesh.vertex(e, 0)).z() > 0.3; };
  const auto heavy_seams = [&](const Atlas_run& run) {
    int number = 0;
    std::size_t corner = 0;
    for(Face f : mesh.faces())
      for(auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
        number += run.is_seam[corner++] && is_heavy(mesh.edge(h));
    return number;
  };
  const auto weights =
      boost::make_function_property_map<Edge>([&](Edge e) { return is_heavy(e) ? 1000. : 1.; });
  const Atlas_run weighted = make_atlas_of(mesh, few_charts(&Atlas_options::stretch_bound, infinity),
                                           parameters::edge_weight_map(weights));
  const Atlas_run plain = make_atlas_of(mesh, few_charts(&Atlas_options::stretch_bound, infinity));
  // a closed curve around the tube has to cross what is heavy
  BOOST_TEST(heavy_seams(weighted) > 0);
  BOOST_TEST(heavy_seams(weighted) <= heavy_seams(plain));
}

BOOST_AUTO_TEST_CASE(a_visitor_follows_and_may_stop_it_anywhere)
{
  const Mesh mesh = random_union(21, 6).mesh<Mesh>();
  const std::vector<Atlas_visitor::Stage> stages{Atlas_visitor::READ,    Atlas_visitor::CHARTS,
                                                 Atlas_visitor::PACK,    Atlas_visitor::CERTIFY,
                                                 Atlas_visitor::MEASURE, Atlas_visitor::WRITE};
  for(int threads : {1, 2}) {
    Stopping_visitor all;
    const auto options = [&](Stopping_visitor& visitor) {
      return few_charts(&Atlas_options::threads, threads, &Atlas_options::visitor, &visitor);
    };
    const Atlas_run run = make_atlas_of(mesh, options(all));
    BOOST_TEST(run.report.has_atlas());
    BOOST_TEST((all.stages == stages));
    BOOST_TEST(std::is_sorted(all.shares.begin(), all.shares.end()));
    BOOST_TEST_REQUIRE(all.shares.size() > 3u);
    BOOST_TEST(all.shares.front() >= 0);
    BOOST_TEST(all.shares.back() == 1);
    for(int k = 1; k <= (threads == 1 ? all.calls : 5); ++k) {
      Stopping_visitor visitor;
      visitor.stop_at = k;
      const Atlas_run stopped = make_atlas_of(mesh, options(visitor));
      BOOST_TEST_CONTEXT("call " << k) check_diagnosis(stopped, Diagnosis::CANCELLED);
      BOOST_TEST(visitor.calls == k); // and is left alone then
    }
  }
}

BOOST_AUTO_TEST_CASE(stages_that_are_not_needed_are_not_announced)
{
  Stopping_visitor visitor;
  make_atlas_of(mesh_of(seam_surfaces::octahedron()),
                few_charts(&Atlas_options::pack_into_square, false, &Atlas_options::visitor, &visitor));
  const std::vector<Atlas_visitor::Stage> stages{Atlas_visitor::READ, Atlas_visitor::CHARTS,
                                                 Atlas_visitor::CERTIFY, Atlas_visitor::MEASURE,
                                                 Atlas_visitor::WRITE};
  BOOST_TEST((visitor.stages == stages));
}

BOOST_AUTO_TEST_CASE(without_faces_there_is_no_atlas)
{
  Mesh mesh;
  check_diagnosis(make_atlas_of(mesh), Diagnosis::EMPTY_MESH);
  for(int i = 0; i < 3; ++i)
    mesh.add_vertex(test_charts::Point_3(i, 0, 0));
  check_diagnosis(make_atlas_of(mesh), Diagnosis::EMPTY_MESH);
}

BOOST_AUTO_TEST_CASE(too_many_charts_do_not_fit)
{
  Union all;
  for(int i = 0; i < 40; ++i)
    all.add(component(seam_surfaces::tetrahedron()));
  const Mesh mesh = all.mesh<Mesh>();
  const Atlas_run run =
      make_atlas_of(mesh, few_charts(&Atlas_options::resolution, 16, &Atlas_options::gutter, 2));
  check_diagnosis(run, Diagnosis::PACKING_FAILED);
  BOOST_TEST(run.report.message.find("40 charts") != std::string::npos, run.report.message);
  BOOST_TEST(bool(make_atlas_of(mesh, few_charts(&Atlas_options::resolution, 256)).report));
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

// Longer seams and more stretch than these would be noticed.
BOOST_AUTO_TEST_CASE(real_surfaces_become_one_chart_with_short_seams)
{
  struct Target
  {
    std::string name;
    double seam, stretch;
  };
  std::vector<Target> targets{{"elephant.off", 4.97, 1.066}, {"homer.off", 3.83, 1.068}};
  if(std::getenv("ABF_TEST_QUICK") == nullptr)
    targets.insert(targets.end(), {{"cow.off", 4.34, 1.076},
                                   {"camel.off", 4.52, 1.108},
                                   {"fandisk.off", 2.3 / 1.05, 1.1 / 1.02},
                                   {"man.off", 5.14, 1.064}});
  for(const Target& target : targets) {
    BOOST_TEST_INFO_SCOPE(target.name);
    Mesh mesh;
    BOOST_TEST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::CGAL_meshes / target.name, mesh));
    const Atlas_run run = make_atlas_of(mesh);
    BOOST_TEST(bool(run.report), run.report.message);
    check_atlas(run, Wishes());
    BOOST_TEST_REQUIRE(run.report.charts.size() == 1u);
    // a few crushed triangles, as of man.off, are no reason to make another map of the whole chart
    BOOST_TEST((run.report.charts[0].strategy == Atlas_report::USUAL));
    BOOST_TEST(run.report.relative_seam_length < 1.05 * target.seam);
    BOOST_TEST(run.report.measures.l2_stretch < 1.02 * target.stretch);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
