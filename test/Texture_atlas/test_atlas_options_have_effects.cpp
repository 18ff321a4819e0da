// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Each option of seams, packing, atlases and baking has an effect, or is refused by name (see `option_effects.h`). A new
// option needs another value here, and perhaps a situation.

#include <boost/test/unit_test.hpp>

#include "baked_surfaces.h"
#include "option_effects.h"

#include <CGAL/Texture_atlas/bake_surface.h>
#include <CGAL/Texture_atlas/internal/options/option_table.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_atlas_of_soup.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_atlas_options_have_effects)

namespace {

namespace TA = CGAL::Texture_atlas;
using option_effects::add_values;
using option_effects::Changes;
using option_effects::Outcome;
using option_effects::set;
using TA::Atlas_options;
using TA::Soup_options;
using TA::Surface_soup;
using Index = Surface_soup::Index;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <typename Options>
std::map<std::string, std::string> values_in_table(const Options& options)
{
  std::map<std::string, std::string> values;
  add_values(options, "", values);
  return values;
}

bool always_matters(const std::string&, const std::string&)
{
  return false;
}

// Squares in rows, with `point(i, j)`
template <typename Point>
void add_sheet(Index columns, Index rows, const Point& point, Surface_soup& soup)
{
  const auto first = static_cast<Index>(soup.points.size());
  for(Index j = 0; j <= rows; ++j)
    for(Index i = 0; i <= columns; ++i)
      soup.points.push_back(point(i, j));
  for(Index j = 0; j < rows; ++j)
    for(Index i = 0; i < columns; ++i) {
      const Index a = first + j * (columns + 1) + i, b = a + columns + 1;
      soup.add_polygon({a, a + 1, b + 1, b});
    }
}

// A steep hill of two materials, with coordinates in two charts; one of them is folded if that is asked for.
Surface_soup hill(bool is_folded)
{
  const Index n = 10;
  Surface_soup soup;
  add_sheet(
      n, n,
      [&](Index i, Index j) {
        const double x = 1. * i / n, y = 1. * j / n;
        return Surface_soup::Kernel::Point_3(
            x, y, 2 * std::exp(-20 * ((x - 0.4) * (x - 0.4) + (y - 0.5) * (y - 0.5))));
      },
      soup);
  soup.material_names = {"stone", "grass"};
  for(Index p = 0; p < soup.number_of_polygons(); ++p)
    soup.materials.push_back(p / n < 5 ? 0 : 1);
  for(Index c = 0; c < soup.number_of_corners(); ++c) {
    const auto& p = soup.points[soup.vertices[c]];
    const bool is_right = soup.polygon_of_corner(c) % n >= n / 2;
    const double u = is_folded && is_right ? std::abs(p.x() - 0.7) : 0.4 * p.x();
    soup.texture.emplace_back(u + (is_right ? 0.55 : 0), 0.9 * p.y());
    soup.corner_texture.push_back(c);
  }
  return soup;
}

// Two halves of a tube with corners, with the same points on one side and a gap on the other, two faces that lie over
// one another, and a square apart
Surface_soup torn_tube()
{
  Surface_soup soup;
  for(int half : {0, 1})
    add_sheet(
        8, 6,
        [&](Index i, Index j) {
          const double angle = half == 1 && i == 8 ? 0 : CGAL_PI * (half + i / 8.),
                       radius = 1 + (i % 4 == 0 ? 0.4 : 0);
          return Surface_soup::Kernel::Point_3(radius * std::cos(angle), radius * std::sin(angle),
                                               0.5 * j + (half == 1 && i == 0 ? 1e-4 : 0));
        },
        soup);
  add_sheet(
      2, 2, [](Index i, Index j) { return Surface_soup::Kernel::Point_3(4. + i, j, 0); }, soup);
  soup.add_polygon({0, 1, 10, 9});
  soup.add_polygon({1, 2, 130});
  return soup;
}

// A flat ramp of one and a half turns, which overlaps itself in the plane
Surface_soup ramp()
{
  Surface_soup soup;
  add_sheet(
      36, 2,
      [](Index i, Index j) {
        const double angle = CGAL_PI * i / 12, radius = 0.5 + 0.25 * j;
        return Surface_soup::Kernel::Point_3(radius * std::cos(angle), radius * std::sin(angle), 0.02 * i);
      },
      soup);
  return soup;
}

const std::vector<Surface_soup>& soups()
{
  static const std::vector<Surface_soup> all{hill(false), hill(true), torn_tube(), ramp()};
  return all;
}

Outcome outcome_of(const Surface_soup& soup, const Soup_options& options)
{
  TA::Soup_atlas atlas;
  const TA::Soup_report report = make_atlas(soup, atlas, options);
  std::ostringstream text;
  text.precision(17);
  for(const auto& p : atlas.uv)
    text << p << ' ';
  for(const int chart : atlas.charts)
    text << chart << ' ';
  for(const std::string& note : report.notes)
    text << note << '\n';
  text << report.number_of_pages;
  return {report.status, report.message, text.str()};
}

std::map<std::string, std::string> values_of(const Soup_options& options)
{
  std::map<std::string, std::string> values = values_in_table(options);
  // These have other types than numbers, words and switches, or other words.
  values["seams"] = std::to_string(options.seams);
  values["symmetric"] = std::to_string(options.symmetric);
  values["texture_seams"] = std::to_string(options.texture_seams);
  values["material_seams"] = std::to_string(options.material_seams);
  values["weld"] = std::to_string(options.weld);
  values["repair"] = std::to_string(options.repair);
  values["component"] = options.component ? std::to_string(*options.component) : "";
  return values;
}

Changes<Soup_options> changed_atlas()
{
  typedef Soup_options O;
  return {{"stretch_bound", set<O>(&O::stretch_bound, 1.005)},
          {"maximum_number_of_terminals", set<O>(&O::maximum_number_of_terminals, 0)},
          {"time_limit", set<O>(&O::time_limit, 0.)},
          {"resolution", set<O>(&O::resolution, 64)},
          {"height", set<O>(&O::height, std::optional<int>(512))},
          {"gutter", set<O>(&O::gutter, std::optional<int>(20))},
          {"block", set<O>(&O::block, 64)},
          {"texels_per_unit", set<O>(&O::texels_per_unit, 500.)},
          {"number_of_rotations", set<O>(&O::number_of_rotations, 1)},
          {"quantization_bits", set<O>(&O::quantization_bits, std::optional<int>(12))},
          {"given_charts", set<O>(&O::given_charts, O::REPAIR)},
          {"given_charts", set<O>(&O::given_charts, O::KEEP)},
          {"area_weight", set<O>(&O::area_weight, 0.3)},
          {"separate_overlaps", set<O>(&O::separate_overlaps, false)},
          {"isometric_charts", set<O>(&O::isometric_charts, false)},
          {"seam_price", set<O>(&O::seam_price, 0.001)},
          {"equal_seam_lengths", set<O>(&O::equal_seam_lengths, true)},
          {"pack_into_square", set<O>(&O::pack_into_square, false)},
          {"float_coordinates", set<O>(&O::float_coordinates, true)},
          {"threads", set<O>(&O::threads, -1)}, // other numbers never change anything
          {"crease_angle", set<O>(&O::crease_angle, 1.5)},
          {"weld_tolerance", set<O>(&O::weld_tolerance, 0.01)},
          {"seams", set<O>(&O::seams, O::CREASES)},
          {"symmetric", set<O>(&O::symmetric, true)},
          {"texture_seams", set<O>(&O::texture_seams, true)},
          {"material_seams", set<O>(&O::material_seams, true)},
          {"weld", set<O>(&O::weld, false)},
          {"repair", set<O>(&O::repair, false)},
          {"component", set<O>(&O::component, std::optional<std::size_t>(1))}};
}

// What depends on the maps that are found
bool may_be_idle(const std::string& option, const std::string& situation)
{
  const std::set<std::string> of_maps = {"separate_overlaps", "equal_seam_lengths",          "area_weight",
                                         "isometric_charts",  "maximum_number_of_terminals", "symmetric",
                                         "seam_price"};
  return of_maps.count(option) > 0 || (situation == "not packed" && option == "block");
}

typedef baked_surfaces::Surface Mesh;

Mesh bumpy_sphere()
{
  Mesh mesh = baked_surfaces::sphere(2);
  for(const auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    const double r = 1 + 0.8 * std::exp(4 * (p.z() - 1));
    mesh.point(v) = {r * p.x(), r * p.y(), 2 * r * p.z()};
  }
  return mesh;
}

} // namespace

BOOST_AUTO_TEST_CASE(of_atlases)
{
  typedef Soup_options O;
  option_effects::Checks<O>{changed_atlas(),
                            {{"a texture", [](O&) {}},
                             {"few charts", [](O& o) { o = O(O::FEW_CHARTS); }},
                             {"conformal", [](O& o) { o = O(O::CONFORMAL); }},
                             {"creases", [](O& o) { o.seams = O::CREASES; }},
                             {"cuts to disks alone", [](O& o) { o.stretch_bound = infinity; }},
                             {"not packed", [](O& o) { o.pack_into_square = false; }},
                             {"charts that are kept", [](O& o) { o.given_charts = O::KEEP; }},
                             {"charts that are repaired", [](O& o) { o.given_charts = O::REPAIR; }}},
                            [](const O& options) {
                              std::vector<Outcome> all;
                              for(const Surface_soup& soup : soups())
                                all.push_back(outcome_of(soup, options));
                              return all;
                            },
                            values_of,
                            may_be_idle,
                            {},
                            {"threads"}}
      .check();
}

BOOST_AUTO_TEST_CASE(of_seams)
{
  typedef TA::Seam_options O;
  option_effects::Checks<O>{
      {{"stretch_bound", set<O>(&O::stretch_bound, 1.01)},
       {"maximum_number_of_terminals", set<O>(&O::maximum_number_of_terminals, 1)},
       {"time_limit", set<O>(&O::time_limit, 0.)}},
      {{"default", [](O&) {}}, {"cuts to disks", [](O& o) { o.stretch_bound = infinity; }}},
      [](const O& options) {
        Mesh mesh = bumpy_sphere();
        const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:s", false).first;
        const auto report = TA::select_seams(mesh, seams, options);
        std::string text;
        for(const auto e : mesh.edges())
          text += seams[e] ? '1' : '0';
        return std::vector<Outcome>{{report.status, report.message, text}};
      },
      values_in_table<O>,
      always_matters,
      {},
      {}}
      .check();
}

BOOST_AUTO_TEST_CASE(of_baking)
{
  typedef TA::Baking_options O;
  option_effects::Checks<O>{
      {{"resolution", set<O>(&O::resolution, 48)},
       {"height", set<O>(&O::height, std::optional<int>(48))},
       {"gutter", set<O>(&O::gutter, 0)},
       {"ray_length", set<O>(&O::ray_length, std::optional<double>(1e-3))},
       {"normals_in_object_space", set<O>(&O::normals_in_object_space, true)},
       {"threads", set<O>(&O::threads, -1)}}, // other numbers never change anything
      {{"small", [](O& o) { o.resolution = 64; }},
       {"in the space of the object",
        [](O& o) {
          o.resolution = 64;
          o.normals_in_object_space = true;
        }}},
      [](const O& options) {
        Mesh simple = baked_surfaces::sheet(3, [](double, double) { return 0.; });
        const Mesh fine =
            baked_surfaces::sheet(12, [](double x, double y) { return 0.02 * std::sin(9 * x + y); });
        const auto uv = baked_surfaces::uv_map(simple);
        for(const auto h : simple.halfedges()) {
          const auto p = simple.point(simple.target(h));
          uv[h] = {0.2 + 0.6 * p.y(), 0.8 - 0.5 * p.x()}; // tangents are not along the axis x
        }
        const auto baked = TA::bake_surface(simple, uv, fine, options);
        std::ostringstream text;
        for(const auto texel : baked.texels)
          text << int(texel);
        for(const auto* numbers : {&baked.normals, &baked.displacements})
          for(const float number : *numbers)
            text << ' ' << number;
        return std::vector<Outcome>{{baked.status, baked.message, text.str()}};
      },
      values_in_table<O>,
      always_matters,
      {},
      {"threads"}}
      .check();
}

BOOST_AUTO_TEST_CASE(of_packing)
{
  typedef TA::Packing_options O;
  option_effects::Checks<O>{{{"resolution", set<O>(&O::resolution, 64)},
                             {"height", set<O>(&O::height, std::optional<int>(512))},
                             {"gutter", set<O>(&O::gutter, std::optional<int>(20))},
                             {"block", set<O>(&O::block, 64)},
                             {"texels_per_unit", set<O>(&O::texels_per_unit, 300.)},
                             {"number_of_rotations", set<O>(&O::number_of_rotations, 1)},
                             {"quantization_bits", set<O>(&O::quantization_bits, std::optional<int>(12))}},
                            {{"one page", [](O&) {}}, {"pages", [](O& o) { o.texels_per_unit = 100; }}},
                            [](const O& options) {
                              Mesh mesh = bumpy_sphere();
                              const auto uv = baked_surfaces::uv_map(mesh);
                              const auto charts =
                                  mesh.add_property_map<Mesh::Face_index, int>("f:c", -1).first;
                              const auto seams =
                                  mesh.add_property_map<Mesh::Edge_index, bool>("e:s", false).first;
                              BOOST_TEST_REQUIRE(bool(TA::make_atlas(mesh, seams, uv, charts)));
                              const auto report = TA::pack_charts(mesh, charts, uv, options);
                              std::ostringstream text;
                              text.precision(17);
                              for(const auto h : mesh.halfedges())
                                text << uv[h] << ' ';
                              return std::vector<Outcome>{{report.status, report.message, text.str()}};
                            },
                            values_in_table<O>,
                            always_matters,
                            {},
                            {}}
      .check();
}

BOOST_AUTO_TEST_SUITE_END()
