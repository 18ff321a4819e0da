// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Seams along creases: boxes unfold, cylinders are cut around their rims, flat faces stay whole, with their holes.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "seam_surfaces.h"
#include "test_data.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Texture_atlas/seam_weights.h>
#include <CGAL/Texture_atlas/select_crease_seams.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_crease_seams)

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::Wishes;
using seam_surfaces::Point_3;
using seam_surfaces::Surface;
typedef seam_surfaces::Surface_mesh Mesh;
typedef Mesh::Edge_index Edge;
typedef Mesh::Property_map<Edge, bool> Marks;
typedef std::vector<std::array<double, 2>> Outline;

namespace {

const double degree = CGAL_PI / 180;

// A star-shaped outline, extruded along z by several layers
Surface prism(const Outline& outline, double height, std::size_t layers)
{
  Surface result;
  const std::size_t n = outline.size();
  for(std::size_t k = 0; k <= layers; ++k)
    for(const auto& [x, y] : outline)
      result.points.emplace_back(x, y, height * static_cast<double>(k) / static_cast<double>(layers));
  const std::size_t middle = result.points.size();
  result.points.emplace_back(0, 0, 0);
  result.points.emplace_back(0, 0, height);
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    for(std::size_t k = 0; k < layers * n; k += n)
      result.faces.push_back({i + k, j + k, j + k + n, i + k + n});
    result.faces.push_back({middle, j, i});
    result.faces.push_back({middle + 1, i + layers * n, j + layers * n});
  }
  triangulate(result);
  return result;
}

Outline circle(int n)
{
  Outline result;
  for(int i = 0; i < n; ++i)
    result.push_back({std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n)});
  return result;
}

Outline gear(int teeth)
{
  Outline result;
  for(int i = 0; i < teeth; ++i)
    for(const auto& [step, radius] :
        {std::pair(0., 1.), std::pair(0.4, 1.), std::pair(0.5, 1.3), std::pair(0.9, 1.3)}) {
      const double angle = 2 * CGAL_PI * (i + step) / teeth;
      result.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  return result;
}

Outline rectangle(double x, double y, int parts)
{
  const std::array<std::array<double, 2>, 4> corners = {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
  Outline result;
  for(int side = 0; side < 4; ++side)
    for(int i = 0; i < parts; ++i) {
      const auto &p = corners[side], &q = corners[(side + 1) % 4];
      const double t = static_cast<double>(i) / parts;
      result.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
    }
  return result;
}

double bend(const Mesh& mesh, Edge e)
{
  const auto normal = [&](Mesh::Halfedge_index h) {
    const Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                  &r = mesh.point(mesh.target(mesh.next(h)));
    const auto n = CGAL::cross_product(q - p, r - p);
    return n / std::sqrt(n.squared_length());
  };
  return mesh.is_border(e)
             ? 0
             : std::acos(std::clamp(normal(mesh.halfedge(e, 0)) * normal(mesh.halfedge(e, 1)), -1., 1.));
}

double length(const Mesh& mesh, Edge e)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

struct Crease_atlas
{
  SMP::Mesh_report<Mesh, TA::Crease_report> creases;
  Atlas_run run;
};

Crease_atlas make_crease_atlas(Mesh& mesh)
{
  const Marks seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
  const auto weights = mesh.add_property_map<Edge, double>("e:weight", 0).first;
  Crease_atlas result{TA::select_crease_seams(mesh, seams), {}};
  TA::compute_crease_weights(mesh, weights);
  result.run = atlas_check::make_atlas_of(
      mesh, few_charts(), parameters::edge_weight_map(weights), [&](Edge e) { return seams[e]; },
      get(CGAL::vertex_point, mesh));
  BOOST_TEST(bool(result.run.report), result.run.report.message);
  check_atlas(result.run, Wishes());
  return result;
}

double angle_change(const Crease_atlas& atlas)
{
  return atlas.run.report.measures.mean_angle_change / degree;
}

// Whether all edges of the outlines of charts are parallel to the axes
bool has_axes(const Atlas_run& run)
{
  for(std::size_t c = 0; c < run.across.size(); ++c) {
    if(run.is_joined(c))
      continue;
    const auto side = run.uv[c] - run.uv[run.previous(c)];
    if((std::min)(std::abs(side.x()), std::abs(side.y())) > 1e-3 * std::sqrt(side.squared_length()))
      return false;
  }
  return true;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_cube_becomes_a_cross)
{
  for(int parts : {1, 2, 5}) {
    Mesh mesh = prism(rectangle(1, 1, parts), 2, static_cast<std::size_t>(parts)).mesh();
    const Crease_atlas atlas = make_crease_atlas(mesh);
    BOOST_TEST(atlas.creases.number_of_patches == 6u);
    BOOST_TEST(atlas.creases.number_of_parts == 1u);
    BOOST_TEST(atlas.creases.flat_share == 1, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(atlas.run.report.charts.size() == 1u);
    BOOST_TEST(atlas.run.report.relative_seam_length == 7 / std::sqrt(6.),
               boost::test_tools::tolerance(1e-9));
    BOOST_TEST(angle_change(atlas) < 0.01);
    BOOST_TEST(has_axes(atlas.run));
  }
}

BOOST_AUTO_TEST_CASE(boxes_unfold_without_stretch)
{
  for(unsigned seed = 0; seed < 20; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<> size(0.2, 5);
    const double x = size(random), y = size(random), z = size(random);
    const int parts = 1 + static_cast<int>(seed % 4);
    Mesh mesh = prism(rectangle(x, y, parts), z, 1 + seed % 3).mesh();
    const Crease_atlas atlas = make_crease_atlas(mesh);
    BOOST_TEST(atlas.creases.is_hard_surface());
    BOOST_TEST(atlas.creases.is_developable);
    BOOST_TEST(atlas.creases.number_of_parts <= 6u);
    BOOST_TEST(angle_change(atlas) < 0.01);
    BOOST_TEST(atlas.run.report.measures.l2_stretch < 1.001);
    const auto [shortest, longest] = std::minmax({2 * x, 2 * y, z});
    BOOST_TEST((has_axes(atlas.run) || longest > 2 * shortest)); // long strips may lie diagonally
  }
}

BOOST_AUTO_TEST_CASE(cylinders_are_cut_around_their_rims)
{
  for(int n : {12, 32, 100}) {
    BOOST_TEST_INFO_SCOPE(n << " sides");
    Mesh mesh = prism(circle(n), 3, 4).mesh();
    const Crease_atlas atlas = make_crease_atlas(mesh);
    BOOST_TEST(atlas.creases.is_hard_surface());
    BOOST_TEST(atlas.creases.is_developable);
    BOOST_TEST(atlas.run.report.charts.size() == 3u);
    BOOST_TEST(angle_change(atlas) < 1);
    double rims = 0;
    for(const Edge e : mesh.edges())
      rims += bend(mesh, e) > 80 * degree ? length(mesh, e) : 0;
    // the mantle is cut once, straight
    BOOST_TEST(atlas.run.report.seam_length == rims + 3, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(gears_do_not_stretch)
{
  for(int teeth : {6, 12, 30}) {
    BOOST_TEST_INFO_SCOPE(teeth << " teeth");
    Mesh mesh = prism(gear(teeth), 0.5, 2).mesh();
    const Crease_atlas atlas = make_crease_atlas(mesh);
    BOOST_TEST(atlas.creases.number_of_patches == 4u * static_cast<std::size_t>(teeth) + 2);
    BOOST_TEST(atlas.run.report.measures.l2_stretch < 1.05);
    BOOST_TEST(angle_change(atlas) < 0.01);
    BOOST_TEST(atlas.run.report.charts.size() <= 12u);
  }
}

BOOST_AUTO_TEST_CASE(flat_faces_keep_their_holes)
{
  for(int holes : {1, 2, 3}) {
    BOOST_TEST_INFO_SCOPE(holes << " holes");
    Mesh mesh = seam_surfaces::slab(holes).mesh();
    const Crease_atlas atlas = make_crease_atlas(mesh);
    BOOST_TEST(angle_change(atlas) < 0.01);
    BOOST_TEST(atlas.run.report.seam_length == atlas.creases.seam_length, boost::test_tools::tolerance(1e-9));
  }
}

// Whatever the surface, new seams lie on creases, and allowed ones; old ones stay.
BOOST_AUTO_TEST_CASE(seams_lie_on_creases)
{
  for(unsigned seed = 0; seed < 60; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    std::mt19937 random(seed);
    Mesh mesh = seam_surfaces::random_surface(seed).mesh();
    TA::Crease_options options;
    options.angle = std::uniform_real_distribution<>(0.1, 1.5)(random);
    const Marks given = mesh.add_property_map<Edge, bool>("e:given", false).first,
                seams = mesh.add_property_map<Edge, bool>("e:seam", false).first,
                forbidden = mesh.add_property_map<Edge, bool>("e:forbidden", false).first;
    for(const Edge e : mesh.edges()) {
      given[e] = seams[e] = !mesh.is_border(e) && random() % 20 == 0;
      forbidden[e] = random() % 5 == 0;
    }
    const auto report =
        TA::select_crease_seams(mesh, seams, options, parameters::edge_is_constrained_map(forbidden));
    BOOST_TEST_REQUIRE(bool(report), report.message);
    for(const Edge e : mesh.edges())
      BOOST_TEST(
          (given[e] ? seams[e] : !seams[e] || (!forbidden[e] && bend(mesh, e) > options.angle * (1 - 1e-9))));
    BOOST_TEST(report.number_of_parts <= report.number_of_patches);
    // again, there is nothing to do but to join what would be another part now
    const auto again =
        TA::select_crease_seams(mesh, seams, options, parameters::edge_is_constrained_map(forbidden));
    BOOST_TEST(again.number_of_parts >= report.number_of_parts);
  }
}

BOOST_AUTO_TEST_CASE(smooth_surfaces_have_no_creases)
{
  for(const auto& [surface, is_developable] : {std::pair(seam_surfaces::sphere(3), false),
                                               {seam_surfaces::torus(40, 20), false},
                                               {seam_surfaces::tube(30, 4), true}}) {
    Mesh mesh = surface.mesh();
    const Marks seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
    const auto report = TA::select_crease_seams(mesh, seams);
    BOOST_TEST(bool(report));
    BOOST_TEST(report.number_of_patches == 1u);
    BOOST_TEST(report.number_of_parts == 1u);
    BOOST_TEST(report.seam_length == 0);
    BOOST_TEST(!report.is_hard_surface());
    BOOST_TEST(report.is_developable == is_developable);
  }
}

// Spikes on a sphere have creases, but are no patches of their own.
BOOST_AUTO_TEST_CASE(rough_places_stay_whole)
{
  for(unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    Surface surface = seam_surfaces::sphere(4);
    for(int i = 0; i < 5; ++i) {
      Point_3& p = surface.points[random() % surface.points.size()];
      p = CGAL::ORIGIN + 1.3 * (p - CGAL::ORIGIN);
    }
    Mesh mesh = surface.mesh();
    std::size_t creases = 0;
    for(const Edge e : mesh.edges())
      creases += bend(mesh, e) > 40 * degree;
    BOOST_TEST(creases >= 10u);
    const auto report =
        TA::select_crease_seams(mesh, mesh.add_property_map<Edge, bool>("e:seam", false).first);
    BOOST_TEST(report.number_of_parts == 1u);
    BOOST_TEST(report.seam_length == 0);
  }
}

BOOST_AUTO_TEST_CASE(wrong_angles_are_refused)
{
  Mesh mesh = seam_surfaces::tetrahedron().mesh();
  const Marks seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
  for(const double angle : {0., -1., CGAL_PI, std::numeric_limits<double>::quiet_NaN()}) {
    TA::Crease_options options;
    options.angle = angle;
    const auto report = TA::select_crease_seams(mesh, seams, options);
    BOOST_TEST((report.status == SMP::Diagnosis::WRONG_OPTION));
    BOOST_TEST(report.message.find("angle of a crease") != std::string::npos);
    for(const Edge e : mesh.edges())
      BOOST_TEST(!seams[e]);
  }
}

BOOST_AUTO_TEST_CASE(wrong_meshes_are_named)
{
  Mesh square;
  square.add_face(square.add_vertex(Point_3(0, 0, 0)), square.add_vertex(Point_3(1, 0, 0)),
                  square.add_vertex(Point_3(1, 1, 0)), square.add_vertex(Point_3(0, 1, 0)));
  const auto report =
      TA::select_crease_seams(square, square.add_property_map<Edge, bool>("e:seam", false).first);
  BOOST_TEST((report.status == SMP::Diagnosis::NOT_TRIANGULATED));
  BOOST_TEST(report.offending_faces.size() == 1u);
}

// Weights of visibility make seams less visible.
BOOST_AUTO_TEST_CASE(seams_hide)
{
  double hidden = 0, shortest = 0;
  for(int holes : {1, 2, 3}) {
    Surface surface = seam_surfaces::slab(holes);
    seam_surfaces::subdivide(surface, 2);
    Mesh mesh = surface.mesh();
    const auto weights = mesh.add_property_map<Edge, double>("e:weight", 0).first;
    TA::compute_visibility_weights(mesh, weights);
    const auto cost = [&](const auto& np) {
      const Marks seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
      for(const Edge e : mesh.edges())
        seams[e] = false;
      const auto uv = get(CGAL::dynamic_halfedge_property_t<CGAL::Simple_cartesian<double>::Point_2>(), mesh);
      const auto charts = get(CGAL::dynamic_face_property_t<int>(), mesh);
      BOOST_TEST(TA::make_atlas(mesh, seams, uv, charts, few_charts(), np).has_atlas());
      double sum = 0;
      for(const Edge e : mesh.edges())
        sum += seams[e] ? weights[e] : 0;
      return sum;
    };
    hidden += cost(parameters::edge_weight_map(weights));
    shortest += cost(parameters::default_values());
  }
  BOOST_TEST(hidden < 0.97 * shortest);
}

BOOST_AUTO_TEST_SUITE(of_CGAL_meshes, *test_data::needs(test_data::CGAL_meshes))

BOOST_AUTO_TEST_CASE(machine_parts_keep_their_angles)
{
  for(const char* name :
      {"fandisk.off", "anchor.off", "joint.off", "part.off", "dragknob.off", "cross.off"}) {
    BOOST_TEST_INFO_SCOPE(name);
    Mesh mesh;
    BOOST_TEST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::CGAL_meshes / name, mesh));
    const Crease_atlas atlas = make_crease_atlas(mesh);
    BOOST_TEST(atlas.creases.is_hard_surface());
    BOOST_TEST(atlas.creases.is_developable ==
               (name == std::string("joint.off") || name == std::string("cross.off")));
    BOOST_TEST(angle_change(atlas) < 1);
    BOOST_TEST(atlas.creases.seam_length >= 0.8 * atlas.run.report.seam_length);
    if(name == std::string("fandisk.off"))
      BOOST_TEST(atlas.creases.seam_length >= 0.9 * atlas.run.report.seam_length);
  }
}

BOOST_AUTO_TEST_CASE(figures_are_no_hard_surfaces)
{
  for(const char* name : {"cow.off", "homer.off", "elephant.off", "pig.off", "man.off", "hand.off"}) {
    Mesh mesh;
    BOOST_TEST_REQUIRE(CGAL::IO::read_polygon_mesh(test_data::CGAL_meshes / name, mesh));
    const auto report =
        TA::select_crease_seams(mesh, mesh.add_property_map<Edge, bool>("e:seam", false).first);
    BOOST_TEST(bool(report));
    BOOST_TEST(!report.is_hard_surface(), name);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
