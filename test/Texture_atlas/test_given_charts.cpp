// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts that a mesh has already: they keep their shapes, or it is said which cannot be kept.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_given_charts)

namespace {

using atlas_check::Atlas_options;
using atlas_check::Atlas_report;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::Point_2;
using atlas_check::Wishes;
using CGAL::Surface_mesh_parameterization::Diagnosis;
namespace TA = CGAL::Texture_atlas;
typedef CGAL::Surface_mesh<atlas_check::Point_3> Mesh;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Face_index Face;

// A mesh with the charts that it has
struct Charted_mesh
{
  Mesh mesh;
  Mesh::Property_map<Halfedge, Point_2> uv;
  Mesh::Property_map<Face, int> chart;
  Mesh::Property_map<Mesh::Edge_index, bool> seams;
  std::size_t number_of_charts = 0;

  explicit Charted_mesh(Mesh input) : mesh(std::move(input))
  {
    uv = mesh.add_property_map<Halfedge, Point_2>("h:uv", atlas_check::untouched).first;
    chart = mesh.add_property_map<Face, int>("f:chart", -1).first;
    seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  }

  // Those of an atlas, each turned, scaled and moved at random, so that they lie over one another
  static Charted_mesh random(unsigned seed)
  {
    std::mt19937 random(seed);
    atlas_surfaces::Union all;
    all.add(atlas_surfaces::bumpy_sphere(random));
    all.add(atlas_surfaces::bumpy_sphere(random));
    Charted_mesh result(all.mesh<Mesh>());
    Atlas_options options(Atlas_options::TEXTURE);
    options.isometric_charts = false;
    const auto report = TA::make_atlas(result.mesh, result.seams, result.uv, result.chart, options);
    BOOST_TEST_REQUIRE(report.has_atlas(), report.message);
    result.number_of_charts = report.charts.size();
    for(int c = 0; c < static_cast<int>(report.charts.size()); ++c) {
      const double angle = atlas_surfaces::uniform(random, 0, 7),
                   scale = atlas_surfaces::uniform(random, 0.1, 9);
      result.transform(c, [=](const Point_2& p) {
        const double x = scale * std::cos(angle), y = scale * std::sin(angle);
        return Point_2(x * p.x() - y * p.y(), y * p.x() + x * p.y());
      });
    }
    return result;
  }

  template <typename Function>
  void transform(int c, const Function& f)
  {
    for(const Halfedge h : mesh.halfedges())
      if(!mesh.is_border(h) && chart[mesh.face(h)] == c)
        uv[h] = f(uv[h]);
  }

  int largest_chart() const
  {
    std::vector<int> size(number_of_charts, 0);
    for(const Face f : mesh.faces())
      ++size[static_cast<std::size_t>(chart[f])];
    return static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  }

  // Those of the vertices within a chart
  std::vector<Point_2> interior_points(int c) const
  {
    std::vector<Point_2> points;
    for(const Halfedge h : mesh.halfedges()) {
      bool is_interior = true;
      for(const Halfedge g : mesh.halfedges_around_target(h))
        is_interior =
            is_interior && !mesh.is_border(mesh.edge(g)) && !seams[mesh.edge(g)] && chart[mesh.face(g)] == c;
      if(is_interior)
        points.push_back(uv[h]);
    }
    return points;
  }

  bool has_flipped_face() const
  {
    const auto faces = mesh.faces();
    return std::any_of(faces.begin(), faces.end(), [this](Face f) {
      const Halfedge h = mesh.halfedge(f), next = mesh.next(h);
      return CGAL::orientation(uv[h], uv[next], uv[mesh.next(next)]) != CGAL::LEFT_TURN;
    });
  }

  // Packs the charts, without knowing their seams.
  Atlas_run pack(const Atlas_options& options)
  {
    Atlas_run before, run;
    read_run(mesh, mesh.points(), uv, chart, seams, before);
    run.was_seam = before.is_seam;
    auto found = mesh.add_property_map<Mesh::Edge_index, bool>("e:found", false).first;
    run.report = TA::make_atlas(mesh, found, uv, chart, options);
    read_run(mesh, mesh.points(), uv, chart, found, run);
    mesh.remove_property_map(found);
    return run;
  }
};

Atlas_options options_of(Atlas_options::Given_charts given)
{
  Atlas_options options(Atlas_options::TEXTURE);
  options.given_charts = given;
  options.resolution = 256;
  return options;
}

// The greatest difference between the logarithms of how much the edges of a chart were scaled
double change_of_shape(const Atlas_run& before, const Atlas_run& after, int chart)
{
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for(std::size_t c = 0; c < after.uv.size(); ++c)
    if(before.chart[before.face[c]] == chart) {
      const double change = std::log(after.planar_length(c) / before.planar_length(c));
      least = (std::min)(least, change);
      largest = (std::max)(largest, change);
    }
  return largest - least;
}

Atlas_run as_given(const Charted_mesh& charts)
{
  Atlas_run run;
  read_run(charts.mesh, charts.mesh.points(), charts.uv, charts.chart, charts.seams, run);
  return run;
}

} // namespace

BOOST_AUTO_TEST_CASE(shapes_are_kept)
{
  for(unsigned seed = 0; seed < 6; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Charted_mesh charts = Charted_mesh::random(seed);
    const Atlas_run before = as_given(charts), after = charts.pack(options_of(Atlas_options::KEEP));
    Wishes wishes;
    wishes.resolution = 256;
    wishes.stretch_bound = 2;
    check_atlas(after, wishes);
    BOOST_TEST(after.is_seam == before.is_seam, boost::test_tools::per_element());
    BOOST_TEST_REQUIRE(after.report.charts.size() == charts.number_of_charts);
    for(int c = 0; c < static_cast<int>(charts.number_of_charts); ++c) {
      BOOST_TEST(change_of_shape(before, after, c) < 1e-9);
      BOOST_TEST((after.report.charts[static_cast<std::size_t>(c)].method == Atlas_report::GIVEN));
    }
  }
}

// On pages that are twice as wide as high, shapes are those in texels.
BOOST_AUTO_TEST_CASE(shapes_are_kept_on_rectangles)
{
  Charted_mesh charts = Charted_mesh::random(5);
  Atlas_options options = options_of(Atlas_options::KEEP);
  options.height = 128;
  const auto in_texels = [](Atlas_run run) {
    for(Point_2& p : run.uv)
      p = Point_2(p.x(), p.y() / 2);
    return run;
  };
  const Atlas_run before = in_texels(as_given(charts)), after = in_texels(charts.pack(options));
  BOOST_TEST_REQUIRE(after.report.has_atlas(), after.report.message);
  for(int c = 0; c < static_cast<int>(charts.number_of_charts); ++c)
    BOOST_TEST(change_of_shape(before, after, c) < 1e-9);
}

BOOST_AUTO_TEST_CASE(bad_stretch_is_told)
{
  Charted_mesh charts = Charted_mesh::random(5);
  const int wrong = charts.largest_chart();
  charts.transform(wrong, [](const Point_2& p) { return Point_2(10 * p.x(), p.y()); });
  const Atlas_run run = charts.pack(options_of(Atlas_options::KEEP));
  BOOST_TEST(run.report.status == Diagnosis::STRETCH_BOUND_MISSED);
  for(std::size_t c = 0; c < run.report.charts.size(); ++c) {
    BOOST_TEST(run.report.charts[c].is_good == (run.report.charts[c].skewed_share < 0.5));
    BOOST_TEST((run.report.charts[c].method == Atlas_report::GIVEN));
  }
  BOOST_TEST(std::count_if(run.report.charts.begin(), run.report.charts.end(),
                           [](const Atlas_report::Chart& chart) { return !chart.is_good; }) == 1);
}

BOOST_AUTO_TEST_CASE(not_packed_they_have_their_size_in_space)
{
  Charted_mesh charts = Charted_mesh::random(9);
  Atlas_options options = options_of(Atlas_options::KEEP);
  options.pack_into_square = false;
  options.resolution = Atlas_options().resolution;
  Wishes wishes;
  wishes.packs = false;
  wishes.stretch_bound = 2;
  check_atlas(charts.pack(options), wishes);
}

namespace {

struct Defect
{
  std::string name;
  Diagnosis status;
};

const Defect defects[] = {{"mirrored", Diagnosis::FLIPPED_TRIANGLES},
                          {"flipped", Diagnosis::FLIPPED_TRIANGLES},
                          {"wound twice", Diagnosis::OVERLAPPING},
                          {"without coordinates", Diagnosis::NO_TEXTURE_COORDINATES}};

// Winds a chart twice around one of its vertices, so that no triangle is flipped.
void wind(Charted_mesh& charts, int c)
{
  std::vector<Point_2> coordinates;
  for(const Halfedge h : charts.mesh.halfedges())
    coordinates.push_back(charts.uv[h]);
  for(const Point_2& center : charts.interior_points(c)) {
    charts.transform(c, [&](const Point_2& p) {
      const double x = p.x() - center.x(), y = p.y() - center.y();
      return Point_2(x * x - y * y, 2 * x * y); // the square of a complex number
    });
    if(!charts.has_flipped_face())
      return;
    for(const Halfedge h : charts.mesh.halfedges())
      charts.uv[h] = coordinates[h.idx()];
  }
  BOOST_FAIL("each vertex has an obtuse angle");
}

void spoil(Charted_mesh& charts, int c, const std::string& how)
{
  if(how == "mirrored")
    charts.transform(c, [](const Point_2& p) { return Point_2(-p.x(), p.y()); });
  else if(how == "wound twice")
    wind(charts, c);
  else {
    const Point_2 p = charts.interior_points(c).front();
    const double shift = how == "flipped" ? 1e3 : std::numeric_limits<double>::quiet_NaN();
    charts.transform(c, [&](const Point_2& q) { return q == p ? Point_2(p.x() + shift, p.y()) : q; });
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(wrong_charts_are_named)
{
  for(const Defect& defect : defects) {
    BOOST_TEST_INFO_SCOPE(defect.name);
    Charted_mesh charts = Charted_mesh::random(3);
    const int wrong = charts.largest_chart();
    spoil(charts, wrong, defect.name);
    const Atlas_run before = as_given(charts), after = charts.pack(options_of(Atlas_options::KEEP));
    BOOST_TEST(after.report.status == defect.status);
    BOOST_TEST(!after.report.has_atlas());
    BOOST_TEST(after.report.message.find("1 of ") == 0u, after.report.message);
    BOOST_TEST(after.report.message.find("vertex ") != std::string::npos, after.report.message);
    BOOST_TEST_REQUIRE(after.report.skipped.size() == 1u);
    const std::size_t first = after.report.skipped.front().first_face;
    BOOST_TEST(before.chart[first] == wrong);
    BOOST_TEST(after.number_of_marked_edges == 0u);
    BOOST_TEST(after.chart == before.chart, boost::test_tools::per_element());
    bool are_unchanged = true;
    for(std::size_t c = 0; c < before.uv.size(); ++c)
      are_unchanged = are_unchanged && (before.uv[c] == after.uv[c] || std::isnan(before.uv[c].x()));
    BOOST_TEST(are_unchanged);
  }
}

BOOST_AUTO_TEST_CASE(wrong_charts_are_repaired)
{
  for(const Defect& defect : defects) {
    BOOST_TEST_INFO_SCOPE(defect.name);
    Charted_mesh charts = Charted_mesh::random(3);
    const int wrong = charts.largest_chart();
    spoil(charts, wrong, defect.name);
    const Atlas_run before = as_given(charts), after = charts.pack(options_of(Atlas_options::REPAIR));
    Wishes wishes;
    wishes.resolution = 256;
    wishes.stretch_bound = 1.07;
    check_atlas(after, wishes);
    for(std::size_t f = 0; f < after.number_of_faces(); ++f) {
      const Atlas_report::Chart& chart = after.report.charts[static_cast<std::size_t>(after.chart[f])];
      BOOST_TEST_REQUIRE((chart.method == Atlas_report::GIVEN) == (before.chart[f] != wrong));
    }
    for(int c = 0; c < static_cast<int>(charts.number_of_charts); ++c)
      BOOST_TEST((change_of_shape(before, after, c) < 1e-9) == (c != wrong));
  }
}

namespace {

struct Written_only
{
  typedef Halfedge key_type;
  typedef Point_2 value_type;
  typedef Point_2 reference;
  typedef boost::writable_property_map_tag category;
  friend void put(const Written_only&, Halfedge, const Point_2&) {}
};

} // namespace

BOOST_AUTO_TEST_CASE(coordinates_must_be_readable)
{
  const Charted_mesh charts = Charted_mesh::random(1);
  for(const auto given : {Atlas_options::KEEP, Atlas_options::REPAIR}) {
    const auto report = TA::make_atlas(charts.mesh, Written_only(), options_of(given));
    BOOST_TEST(report.status == Diagnosis::WRONG_OPTION);
    BOOST_TEST(report.message.find("can be read") != std::string::npos);
  }
  BOOST_TEST(bool(TA::make_atlas(charts.mesh, Written_only(), options_of(Atlas_options::REPLACE))));
}

BOOST_AUTO_TEST_SUITE_END()
