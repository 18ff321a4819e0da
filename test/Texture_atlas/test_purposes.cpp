// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What atlases for textures have more of than others: texels, evenly spread. And what that costs: seams.

#include <boost/test/unit_test.hpp>

#include "atlas_check.h"
#include "atlas_surfaces.h"

#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_purposes)

namespace {

using atlas_check::Atlas_options;
using atlas_check::Atlas_report;
using atlas_check::Atlas_run;
using atlas_check::check_atlas;
using atlas_check::make_atlas_of;
using atlas_check::Wishes;
using CGAL::Surface_mesh_parameterization::Diagnosis;
typedef CGAL::Surface_mesh<atlas_check::Point_3> Mesh;

// A sphere with bumps
Mesh surface(unsigned seed)
{
  std::mt19937 random(seed);
  atlas_surfaces::Union all;
  all.add(atlas_surfaces::bumpy_sphere(random));
  return all.mesh<Mesh>();
}

Atlas_run atlas(const Mesh& mesh, const Atlas_options& options, double bound)
{
  const Atlas_run run = make_atlas_of(mesh, options);
  Wishes wishes;
  wishes.stretch_bound = bound;
  check_atlas(run, wishes);
  return run;
}

// The density of texels in the worst direction of each face, and its area
std::vector<std::pair<double, double>> densities(const Atlas_run& run)
{
  std::vector<std::pair<double, double>> result;
  double area = 0;
  for(std::size_t f = 0; f < run.number_of_faces(); ++f) {
    const std::size_t c = run.first_corner[f];
    Eigen::Matrix<double, 3, 2> surface;
    Eigen::Matrix2d plane;
    for(int k = 0; k < 2; ++k) {
      const auto s = run.point[c + 1 + k] - run.point[c];
      const auto p = run.uv[c + 1 + k] - run.uv[c];
      surface.col(k) << s.x(), s.y(), s.z();
      plane.col(k) << p.x(), p.y();
    }
    const Eigen::Matrix<double, 3, 2> stretch = surface * plane.inverse();
    const double largest = Eigen::JacobiSVD<Eigen::MatrixXd>(stretch).singularValues()[0];
    result.emplace_back(1 / (largest * largest), run.surface_area(f));
    area += run.surface_area(f);
  }
  for(auto& [density, part] : result) {
    density *= area;
    part /= area;
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(textures_have_more_and_more_even_texels)
{
  double few = 0, texture = 0, few_low = 0, texture_low = 0; // sums of logarithms
  for(unsigned seed = 0; seed < 8; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    const Mesh mesh = surface(seed);
    const Atlas_run one = atlas(mesh, Atlas_options::FEW_CHARTS, 1.1),
                    many = atlas(mesh, Atlas_options::TEXTURE, 1.07);
    BOOST_TEST(many.report.measures.l2_stretch <= 1.05);
    BOOST_TEST(many.report.measures.l2_stretch <= one.report.measures.l2_stretch + 1e-3);
    few += std::log(one.report.texel_density);
    texture += std::log(many.report.texel_density);
    few_low += std::log(one.report.low_texel_density);
    texture_low += std::log(many.report.low_texel_density);
  }
  BOOST_TEST(texture > few + 8 * std::log(1.2));
  BOOST_TEST(texture_low > few_low + 8 * std::log(1.3));
}

BOOST_AUTO_TEST_CASE(densities_are_those_of_the_coordinates)
{
  for(const Atlas_options options : {Atlas_options::FEW_CHARTS, Atlas_options::TEXTURE}) {
    const Atlas_run run = atlas(surface(3), options, options.stretch_bound);
    std::vector<std::pair<double, double>> faces = densities(run);
    std::sort(faces.begin(), faces.end());
    double sum = 0, low = 0;
    for(std::size_t i = 0; sum < 0.05; ++i) {
      sum += faces[i].second;
      low = faces[i].first;
    }
    BOOST_TEST(run.report.low_texel_density == low, boost::test_tools::tolerance(0.01));
    BOOST_TEST(run.report.texel_density ==
                   run.report.covered_share / std::pow(run.report.measures.l2_stretch, 2),
               boost::test_tools::tolerance(1e-9));
    BOOST_TEST(run.report.texel_density <= 1);
  }
}

// On the same charts, maps that keep areas have more of the energy that ABF++ minimizes. Charts are not cut for the page:
// ABF++ does not map the pieces anew.
BOOST_AUTO_TEST_CASE(conformal_charts_keep_the_angles)
{
  for(unsigned seed = 0; seed < 4; ++seed) {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Atlas_options options(Atlas_options::CONFORMAL);
    options.equal_seam_lengths = false;
    options.seam_price = std::numeric_limits<double>::infinity();
    const Atlas_run conformal = atlas(surface(seed), options, 1.1);
    options.isometric_charts = true;
    const Atlas_run isometric = atlas(surface(seed), options, 1.1);
    BOOST_TEST((conformal.chart == isometric.chart));
    BOOST_TEST(conformal.report.measures.angular_distortion < isometric.report.measures.angular_distortion);
    BOOST_TEST(conformal.report.measures.l2_stretch > isometric.report.measures.l2_stretch);
    for(const Atlas_report::Chart& chart : conformal.report.charts)
      BOOST_TEST((chart.method == Atlas_report::ABF_PLUS_PLUS || chart.method == Atlas_report::SEPARATED));
  }
}

BOOST_AUTO_TEST_CASE(cheaper_seams_cover_more)
{
  const double prices[] = {std::numeric_limits<double>::infinity(), 0.3, 0.03};
  std::vector<double> covered(3, 0), seams(3, 0); // sums
  for(unsigned seed = 0; seed < 6; ++seed)
    for(int i = 0; i < 3; ++i) {
      Atlas_options options(Atlas_options::CONFORMAL);
      options.seam_price = prices[i];
      const Atlas_run run = atlas(surface(seed), options, options.stretch_bound);
      covered[i] += std::log(run.report.covered_share);
      seams[i] += run.report.relative_seam_length;
    }
  BOOST_TEST(covered[1] >= covered[0] - 0.06); // the share on the coarse page is a little different
  BOOST_TEST(covered[2] > covered[0] + 6 * std::log(1.05));
  BOOST_TEST(seams[1] <= seams[2]);
  BOOST_TEST(seams[0] < seams[2]);
}

BOOST_AUTO_TEST_CASE(the_name_of_a_purpose_is_an_argument)
{
  namespace TA = CGAL::Texture_atlas;
  Mesh mesh = surface(1);
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, atlas_check::Point_2>("h:uv").first;
  const auto report = TA::make_atlas(mesh, uv, Atlas_options::TEXTURE);
  BOOST_TEST(bool(report));
  BOOST_TEST(report.texel_density == make_atlas_of(mesh, Atlas_options::TEXTURE).report.texel_density,
             boost::test_tools::tolerance(1e-6));
}

// Until the last chart is isometric
BOOST_AUTO_TEST_CASE(progress_reaches_the_end_and_can_be_cancelled)
{
  struct Visitor : CGAL::Texture_atlas::Atlas_visitor
  {
    double last = 0, end = 2;
    bool is_rising = true;

    bool progress(double share) override
    {
      is_rising = is_rising && share >= last;
      last = share;
      return share < end;
    }
  };
  Atlas_options options(Atlas_options::TEXTURE);
  Visitor visitor, other;
  options.visitor = &visitor;
  BOOST_TEST(bool(make_atlas_of(surface(2), options).report));
  BOOST_TEST(visitor.last == 1);
  BOOST_TEST(visitor.is_rising);
  other.end = 0.8; // all charts are made then, and some of them isometric
  options.visitor = &other;
  const Atlas_run run = make_atlas_of(surface(2), options);
  BOOST_TEST(run.report.status == Diagnosis::CANCELLED);
  BOOST_TEST(run.is_untouched());
}

BOOST_AUTO_TEST_CASE(a_price_is_at_least_0)
{
  for(const double price : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    Atlas_options options;
    options.seam_price = price;
    const Atlas_run run = make_atlas_of(surface(0), options);
    BOOST_TEST(run.report.status == Diagnosis::WRONG_OPTION);
    BOOST_TEST(run.report.message.find("seam_price is ") != std::string::npos);
    BOOST_TEST(run.is_untouched());
  }
}

BOOST_AUTO_TEST_SUITE_END()
