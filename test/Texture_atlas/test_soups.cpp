// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of points and polygons that are no mesh yet

#include <boost/test/unit_test.hpp>

#include <CGAL/number_type_config.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/make_atlas_of_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_soups)

namespace {

using CGAL::Texture_atlas::Diagnosis;
using CGAL::Texture_atlas::make_atlas;
using CGAL::Texture_atlas::make_common_atlas;
using CGAL::Texture_atlas::Soup_atlas;
using CGAL::Texture_atlas::Soup_options;
using CGAL::Texture_atlas::Soup_report;
using CGAL::Texture_atlas::Surface_soup;
using Index = Surface_soup::Index;
using Point_2 = Surface_soup::Kernel::Point_2;
using Point_3 = Surface_soup::Kernel::Point_3;

// Six squares
Surface_soup cube(const double x = 0)
{
  Surface_soup soup;
  for(const int i : {0, 1, 2, 3, 4, 5, 6, 7})
    soup.points.emplace_back(x + ((i & 1) ^ ((i >> 1) & 1)), (i >> 1) & 1, i >> 2);
  for(const std::vector<Index>& polygon : std::vector<std::vector<Index>>{
          {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    soup.add_polygon(polygon);
  return soup;
}

// Quads, and triangles at the poles
Surface_soup sphere(const Index columns, const Index rows)
{
  Surface_soup soup;
  for(Index r = 1; r < rows; ++r)
    for(Index c = 0; c < columns; ++c) {
      const double a = r * CGAL_PI / rows, b = c * 2 * CGAL_PI / columns;
      soup.points.emplace_back(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
    }
  const Index north = (rows - 1) * columns, south = north + 1;
  soup.points.emplace_back(0, 0, 1);
  soup.points.emplace_back(0, 0, -1);
  for(Index c = 0; c < columns; ++c) {
    const Index d = (c + 1) % columns;
    soup.add_polygon({north, c, d});
    for(Index r = 1; r + 1 < rows; ++r)
      soup.add_polygon({(r - 1) * columns + c, r * columns + c, r * columns + d, (r - 1) * columns + d});
    soup.add_polygon({south, (rows - 2) * columns + d, (rows - 2) * columns + c});
  }
  return soup;
}

std::vector<Index> polygon_of(const Surface_soup& soup, const Index p)
{
  return {soup.vertices.begin() + soup.first_corners[p], soup.vertices.begin() + soup.first_corners[p + 1]};
}

// The same polygons in another order, some turned around, with other first corners, and some with points of their own
Surface_soup shuffled(const Surface_soup& given, const unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Index> order(given.number_of_polygons());
  for(Index p = 0; p < order.size(); ++p)
    order[p] = p;
  std::shuffle(order.begin(), order.end(), random);
  Surface_soup soup;
  soup.points = given.points;
  for(const Index p : order) {
    std::vector<Index> polygon = polygon_of(given, p);
    std::rotate(polygon.begin(), polygon.begin() + random() % polygon.size(), polygon.end());
    if(random() % 4 == 0)
      std::reverse(polygon.begin(), polygon.end());
    if(random() % 2 == 0)
      for(Index& v : polygon) {
        soup.points.push_back(soup.points[v]);
        v = static_cast<Index>(soup.points.size() - 1);
      }
    soup.add_polygon(polygon);
  }
  return soup;
}

double length(const Point_2& p, const Point_2& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// Whether a polygon has coordinates at all corners, in the square, and runs around its area as `is_turned` says
void check_polygon(const Soup_atlas& atlas, const Surface_soup& soup, const Index p)
{
  double area = 0;
  for(Index c = soup.first_corners[p]; c < soup.first_corners[p + 1]; ++c) {
    const Point_2 &a = atlas.uv[c],
                  &b = atlas.uv[c + 1 < soup.first_corners[p + 1] ? c + 1 : soup.first_corners[p]];
    area += a.x() * b.y() - a.y() * b.x();
    BOOST_TEST((a.x() >= 0 && a.x() <= 1 && a.y() >= 0 && a.y() <= 1));
  }
  BOOST_TEST((atlas.is_turned[p] ? area < 0 : area > 0), "polygon " << p << ": area " << area);
}

// Whether lengths are those of the surface times the scale, up to a factor, and all polygons beside one another that no
// seam separates agree
void check_lengths(const Soup_atlas& atlas, const Soup_report& report, const Surface_soup& soup,
                   const double factor)
{
  std::map<std::pair<Index, Index>, std::map<Index, Point_2>> of_edge; // the coordinates at each of its ends
  for(Index p = 0; p < soup.number_of_polygons(); ++p)
    for(Index c = soup.first_corners[p]; c < soup.first_corners[p + 1] && atlas.charts[p] >= 0; ++c) {
      const Index d = c + 1 < soup.first_corners[p + 1] ? c + 1 : soup.first_corners[p];
      const Index v = soup.vertices[c], w = soup.vertices[d];
      const double on_surface = std::sqrt(CGAL::squared_distance(soup.points[v], soup.points[w]));
      const double ratio = length(atlas.uv[c], atlas.uv[d]) / (on_surface * report.scale);
      BOOST_TEST((ratio > 1 / factor && ratio < factor), "corner " << c << ": ratio " << ratio);
      const std::pair<Index, Index> edge = std::minmax(v, w);
      if(!std::binary_search(atlas.seams.begin(), atlas.seams.end(), edge))
        for(const auto& [end, uv] : {std::pair(v, atlas.uv[c]), std::pair(w, atlas.uv[d])}) {
          const auto [place, is_new] = of_edge[edge].emplace(end, uv);
          BOOST_TEST((is_new || place->second == uv));
        }
    }
}

void check_whole(const Soup_atlas& atlas, const Soup_report& report, const Surface_soup& soup,
                 const double factor)
{
  BOOST_TEST(bool(report), report.message);
  BOOST_TEST_REQUIRE(atlas.uv.size() == soup.number_of_corners());
  BOOST_TEST_REQUIRE(atlas.charts.size() == soup.number_of_polygons());
  BOOST_TEST_REQUIRE(atlas.is_turned.size() == soup.number_of_polygons());
  std::set<int> charts;
  for(Index p = 0; p < soup.number_of_polygons(); ++p) {
    charts.insert(atlas.charts[p]);
    check_polygon(atlas, soup, p);
  }
  BOOST_TEST(*charts.begin() == 0);
  BOOST_TEST(charts.size() == report.charts.size());
  check_lengths(atlas, report, soup, factor);
}

bool is_told(const Soup_report& report, const std::string& text)
{
  return std::any_of(report.notes.begin(), report.notes.end(),
                     [&text](const std::string& note) { return note.find(text) != std::string::npos; });
}

void check_refused(const Surface_soup& soup, const Diagnosis status, const std::string& text,
                   const Soup_options& options = Soup_options())
{
  Soup_atlas atlas;
  atlas.charts = {17};
  const Soup_report report = make_atlas(soup, atlas, options);
  BOOST_TEST(report.status == status);
  BOOST_TEST(report.message.find(text) != std::string::npos, report.message);
  BOOST_TEST(!report.has_atlas());
  BOOST_TEST((atlas.charts == std::vector<int>{17} && atlas.uv.empty())); // nothing is written
}

} // namespace

BOOST_AUTO_TEST_CASE(polygons_get_coordinates_of_their_corners)
{
  Soup_atlas atlas;
  const Soup_report report = make_atlas(cube(), atlas);
  check_whole(atlas, report, cube(), 1.0001);
  BOOST_TEST(report.number_of_components == 1u);
  BOOST_TEST(report.number_of_vertices == 8u);
  BOOST_TEST(report.number_of_triangles == 12u);
  BOOST_TEST(report.notes.empty());
}

BOOST_AUTO_TEST_CASE(the_order_and_orientation_of_polygons_do_not_matter)
{
  const Surface_soup whole = sphere(12, 8);
  for(unsigned seed = 0; seed < 8; ++seed) {
    const Surface_soup soup = shuffled(whole, seed);
    Soup_atlas atlas;
    const Soup_report report = make_atlas(soup, atlas);
    check_whole(atlas, report, soup, 1.6);
    BOOST_TEST(report.number_of_components == 1u);
    BOOST_TEST(report.number_of_vertices == whole.points.size());
    BOOST_TEST(is_told(report, "merged"));
    BOOST_TEST(is_told(report, "turned"));
  }
}

// Of triangles that are a mesh, the atlas is the one of the mesh, bit by bit.
BOOST_AUTO_TEST_CASE(an_atlas_of_triangles_is_that_of_their_mesh)
{
  const Surface_soup quads = sphere(10, 7);
  CGAL::Surface_mesh<Point_3> mesh;
  Surface_soup soup;
  soup.points = quads.points;
  for(const Point_3& p : quads.points)
    mesh.add_vertex(p);
  for(Index p = 0; p < quads.number_of_polygons(); ++p) {
    const std::vector<Index> polygon = polygon_of(quads, p);
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      using Vertex = CGAL::Surface_mesh<Point_3>::Vertex_index;
      soup.add_polygon({polygon[0], polygon[i - 1], polygon[i]});
      mesh.add_face(Vertex(polygon[0]), Vertex(polygon[i - 1]), Vertex(polygon[i]));
    }
  }
  Soup_options options;
  options.seams = Soup_options::LENGTH;
  Soup_atlas atlas;
  BOOST_TEST(bool(make_atlas(soup, atlas, options)));
  const auto uv = mesh.add_property_map<CGAL::SM_Halfedge_index, Point_2>("h:uv").first;
  BOOST_TEST(bool(make_atlas(mesh, uv)));
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
      for(Index c = 3 * mesh.face(h); c < 3 * mesh.face(h) + 3; ++c)
        BOOST_TEST((soup.vertices[c] != mesh.target(h).idx() || atlas.uv[c] == uv[h]));
}

BOOST_AUTO_TEST_CASE(bad_polygons_condemn_no_others)
{
  Surface_soup soup = sphere(8, 6);
  const Index sound = static_cast<Index>(soup.number_of_polygons());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  soup.points.emplace_back(nan, 0, 0);
  soup.points.emplace_back(1e30, 0, 0);
  const Index n = static_cast<Index>(soup.points.size());
  soup.add_polygon({0, 1, n - 2});
  soup.add_polygon({0, 1, n - 1});
  soup.add_polygon({0, 1});
  soup.add_polygon(polygon_of(soup, 3));
  Soup_atlas atlas;
  const Soup_report report = make_atlas(soup, atlas);
  BOOST_TEST(report.status == Diagnosis::SOMETHING_SKIPPED);
  BOOST_TEST(report.has_atlas());
  const std::vector<Diagnosis> expected = {Diagnosis::NON_FINITE_POINT, Diagnosis::FAR_POINT,
                                           Diagnosis::DEGENERATE_FACE, Diagnosis::DUPLICATE_FACE};
  BOOST_TEST_REQUIRE(report.skipped.size() == expected.size());
  for(std::size_t i = 0; i < expected.size(); ++i) {
    BOOST_TEST(report.skipped[i].status == expected[i]);
    BOOST_TEST(report.skipped[i].first_face == sound + i);
    BOOST_TEST(report.skipped[i].number_of_faces == 1u);
    BOOST_TEST(atlas.charts[sound + i] == -1);
    BOOST_TEST(std::isnan(atlas.uv[soup.first_corners[sound + i]].x()));
  }
  BOOST_TEST((report.offending_polygons == std::vector<std::size_t>{sound, sound + 1, sound + 2, sound + 3}));
  BOOST_TEST((report.offending_points == std::vector<std::size_t>{n - 2u, n - 1u}));
  for(Index p = 0; p < sound; ++p)
    check_polygon(atlas, soup, p);
}

BOOST_AUTO_TEST_CASE(arrays_that_do_not_fit_together_are_refused)
{
  check_refused(Surface_soup(), Diagnosis::EMPTY_MESH, "no vertices");
  Surface_soup soup = cube();
  soup.add_polygon({0, 1, 8});
  check_refused(soup, Diagnosis::NUMBER_OUT_OF_RANGE, "face 7 names a vertex that does not exist");
  soup = cube();
  soup.first_corners[2] = 3;
  check_refused(soup, Diagnosis::WRONG_INPUT, "first_corners[2] is less than the one before");
  soup = cube();
  soup.vertices.pop_back();
  check_refused(soup, Diagnosis::WRONG_INPUT, "first_corners must begin with 0 and end with");
  soup = cube();
  soup.materials = {0};
  check_refused(soup, Diagnosis::WRONG_INPUT, "materials has 1 elements, and must have 6");
  soup.materials = {0, 0, 0, 0, 0, 1};
  soup.material_names = {"paint"};
  check_refused(soup, Diagnosis::NUMBER_OUT_OF_RANGE, "materials[5] is 1, and there are only 1");
  soup = cube();
  soup.corner_texture.assign(24, 2);
  check_refused(soup, Diagnosis::NUMBER_OUT_OF_RANGE, "corner_texture[0] is 2, and there are only 0");
  soup = cube();
  soup.has_point_texture = true;
  check_refused(soup, Diagnosis::WRONG_INPUT, "texture has 0 elements, and must have 8");
  soup = cube();
  soup.is_ignored = {true};
  check_refused(soup, Diagnosis::WRONG_INPUT, "is_ignored has 1 elements, and must have 6");
  soup = cube();
  soup.marked_seams = {{0, 1}, {0, 6}};
  check_refused(soup, Diagnosis::NO_SUCH_EDGE,
                "marked_seams[1]: vertices 0 and 6 are not the ends of an edge");
  soup = cube();
  for(Point_3& p : soup.points)
    p = Point_3(std::numeric_limits<double>::infinity(), 0, 0);
  check_refused(soup, Diagnosis::NON_FINITE_POINT, "vertex 1 (inf, 0, 0) and 7 others");
  soup = cube();
  soup.is_ignored.assign(6, true);
  check_refused(soup, Diagnosis::EMPTY_MESH, "no face is left");
}

BOOST_AUTO_TEST_CASE(wrong_options_are_refused)
{
  const auto check = [](const std::string& text, const auto& change) {
    Soup_options options;
    change(options);
    check_refused(cube(), Diagnosis::WRONG_OPTION, text, options);
  };
  check("crease_angle", [](Soup_options& options) { options.crease_angle = 4; });
  check("weld_tolerance", [](Soup_options& options) { options.weld_tolerance = -1; });
  check("component is 1, and there are only 1", [](Soup_options& options) { options.component = 1; });
  check("gutter", [](Soup_options& options) { options.gutter = 512; });
  check("stretch_bound", [](Soup_options& options) { options.stretch_bound = 0; });
  check("symmetric", [](Soup_options& options) { options.symmetric = options.texture_seams = true; });
  check("no materials", [](Soup_options& options) { options.material_seams = true; });
  Soup_options options;
  options.given_charts = Soup_options::KEEP;
  check_refused(cube(), Diagnosis::NO_TEXTURE_COORDINATES, "no texture coordinates", options);
}

BOOST_AUTO_TEST_CASE(given_seams_and_materials_divide_charts)
{
  Surface_soup soup = sphere(12, 8);
  soup.material_names = {"above", "below"};
  for(Index p = 0; p < soup.number_of_polygons(); ++p) {
    const double z = soup.points[soup.vertices[soup.first_corners[p]]].z() +
                     soup.points[soup.vertices[soup.first_corners[p] + 1]].z();
    soup.materials.push_back(z < 0);
  }
  soup.marked_seams = {{13, 1}};
  Soup_options options;
  options.material_seams = true;
  Soup_atlas atlas;
  const Soup_report report = make_atlas(soup, atlas, options);
  check_whole(atlas, report, soup, 1.6);
  std::map<int, std::set<Index>> materials;
  for(Index p = 0; p < soup.number_of_polygons(); ++p)
    materials[atlas.charts[p]].insert(soup.materials[p]);
  for(const auto& [chart, names] : materials)
    BOOST_TEST(names.size() == 1u, "chart " << chart);
  BOOST_TEST(std::binary_search(atlas.seams.begin(), atlas.seams.end(), std::pair<Index, Index>(1, 13)));
}

BOOST_AUTO_TEST_CASE(given_coordinates_are_kept)
{
  Soup_atlas first, again;
  BOOST_TEST(bool(make_atlas(cube(), first)));
  Surface_soup soup = cube();
  soup.texture = first.uv;
  for(Index c = 0; c < soup.number_of_corners(); ++c)
    soup.corner_texture.push_back(c);
  Soup_options options;
  options.given_charts = Soup_options::KEEP;
  const Soup_report report = make_atlas(soup, again, options);
  check_whole(again, report, soup, 1.0001);
  BOOST_TEST(report.seams.name == "given");
  BOOST_TEST((again.seams == first.seams));

  soup.is_ignored = {false, false, true, false, false, false};
  const Soup_report rest = make_atlas(soup, again);
  BOOST_TEST(bool(rest));
  BOOST_TEST(rest.number_of_ignored == 1u);
  BOOST_TEST(again.charts[2] == -1);
  for(Index c = 8; c < 12; ++c)
    BOOST_TEST((again.uv[c] == first.uv[c]));
}

BOOST_AUTO_TEST_CASE(one_component_gets_charts)
{
  Surface_soup soup = sphere(8, 6);
  const Index polygons = static_cast<Index>(soup.number_of_polygons());
  const Surface_soup other = cube(5);
  for(Index p = 0; p < 6; ++p) {
    std::vector<Index> polygon = polygon_of(other, p);
    for(Index& v : polygon)
      v += static_cast<Index>(soup.points.size());
    soup.add_polygon(polygon);
  }
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  Soup_options options;
  options.component = 1; // the smaller one
  Soup_atlas atlas;
  const Soup_report report = make_atlas(soup, atlas, options);
  BOOST_TEST(report.has_atlas());
  BOOST_TEST(report.number_of_components == 2u);
  for(Index p = 0; p < soup.number_of_polygons(); ++p)
    BOOST_TEST((atlas.charts[p] >= 0) == (p >= polygons));
}

BOOST_AUTO_TEST_CASE(seams_are_symmetric_where_the_surface_is)
{
  Soup_options options;
  options.symmetric = true;
  Soup_atlas atlas;
  const Soup_report report = make_atlas(sphere(16, 10), atlas, options);
  BOOST_TEST(report.has_atlas());
  BOOST_TEST_REQUIRE(report.seams.symmetry.has_value());
  BOOST_TEST(report.seams.symmetry->has_symmetric_surface);
}

BOOST_AUTO_TEST_CASE(charts_that_are_not_packed_lie_in_rows)
{
  Soup_options options;
  options.pack_into_square = false;
  options.seams = Soup_options::CREASES;
  Soup_atlas atlas;
  const Soup_report report = make_atlas(sphere(12, 8), atlas, options);
  BOOST_TEST(report.has_atlas());
  std::map<int, CGAL::Bbox_2> boxes;
  const Surface_soup soup = sphere(12, 8);
  for(Index c = 0; c < soup.number_of_corners(); ++c)
    boxes[atlas.charts[soup.polygon_of_corner(c)]] += atlas.uv[c].bbox();
  for(const auto& [chart, box] : boxes)
    for(const auto& [other, other_box] : boxes)
      BOOST_TEST((chart == other || !CGAL::do_overlap(box, other_box)));
}

// All others are as large as without it.
BOOST_AUTO_TEST_CASE(a_long_needle_is_scaled_down_alone_and_told)
{
  Soup_atlas atlas;
  const Soup_report alone = make_atlas(cube(), atlas);
  Surface_soup soup = cube();
  for(const Point_3& p : {Point_3(0, 0, 5), Point_3(9, 0, 5), Point_3(4, 5e-4, 5)})
    soup.points.push_back(p);
  soup.add_polygon({8, 9, 10});
  const Soup_report report = make_atlas(soup, atlas);
  BOOST_TEST_REQUIRE(bool(report), report.message);
  const std::string needle = std::to_string(atlas.charts[6]);
  for(const auto& chart : report.charts)
    BOOST_TEST((chart.scale < 1) == (&chart == &report.charts[static_cast<std::size_t>(atlas.charts[6])]));
  BOOST_TEST(report.scale > 0.97 * alone.scale);
  BOOST_TEST(std::any_of(report.notes.begin(), report.notes.end(), [&needle](const std::string& note) {
    return note.find("the first is chart " + needle + ":") != std::string::npos;
  }));
}

BOOST_AUTO_TEST_CASE(several_soups_share_an_atlas)
{
  std::vector<Surface_soup> soups = {cube(), shuffled(sphere(8, 6), 3), cube(9)};
  std::vector<Soup_atlas> atlases;
  const Soup_report report = make_common_atlas(soups, atlases);
  BOOST_TEST(bool(report), report.message);
  BOOST_TEST_REQUIRE(atlases.size() == 3u);
  int next = 0;
  for(std::size_t i = 0; i < soups.size(); ++i) {
    const std::set<int> charts(atlases[i].charts.begin(), atlases[i].charts.end());
    BOOST_TEST(*charts.begin() == next);
    next = *charts.rbegin() + 1;
    check_lengths(atlases[i], report, soups[i], 1.6);
  }
  BOOST_TEST(report.charts.size() == static_cast<std::size_t>(next));

  soups[2].name = "the box";
  soups[2].marked_seams = {{0, 6}};
  const Soup_report refused = make_common_atlas(soups, atlases);
  BOOST_TEST(refused.status == Diagnosis::NO_SUCH_EDGE);
  BOOST_TEST(refused.offending_soup == 2u);
  BOOST_TEST(refused.message.find("the box") != std::string::npos, refused.message);
  BOOST_TEST((refused.offending_points == std::vector<std::size_t>{0, 6}));
  soups[2] = Surface_soup();
  const Soup_report empty = make_common_atlas(soups, atlases);
  BOOST_TEST(empty.status == Diagnosis::EMPTY_MESH);
  BOOST_TEST(empty.offending_soup == 2u);
  BOOST_TEST(make_common_atlas({}, atlases).status == Diagnosis::EMPTY_MESH);
}

BOOST_AUTO_TEST_SUITE_END()
