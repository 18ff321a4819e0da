// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_ATLAS_CHECK_H
#define ANGLE_BASED_FLATTENING_ATLAS_CHECK_H

#include "overlaps.h"
#include "test_options.h"

#include <CGAL/Texture_atlas/make_atlas.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

// Atlases and what must be true of them, without any code of the library's own.
namespace atlas_check {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
namespace parameters = CGAL::parameters;
using TA::Atlas_options;
using TA::Atlas_report;
using SMP::Diagnosis;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> Undirected_graph;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;

// The number of the component of each vertex, in the order of their first vertices
inline std::vector<std::size_t> component_numbers(const Undirected_graph& graph)
{
  std::vector<std::size_t> result(num_vertices(graph));
  boost::connected_components(
      graph, boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, graph)));
  return result;
}

const Point_2 untouched(-7, 5); // in the map of coordinates beforehand
const int no_number = -2;       // in that of charts

// A mesh with its atlas. Each halfedge of a face is a corner, at its target. Faces come one after another.
struct Atlas_run
{
  Atlas_report report;
  std::vector<std::size_t> first_corner; // of each face, and the number of corners
  std::vector<std::size_t> face;         // of each corner
  std::vector<int> vertex;               // of each corner
  std::vector<Point_3> point;            // of each corner
  std::vector<std::size_t> across; // of each corner: that of the opposite halfedge, or itself on the border
  std::vector<char> was_seam, is_seam; // of each corner: the edge of its halfedge
  std::vector<Point_2> uv;             // of each corner
  std::vector<int> chart;              // of each face
  bool are_borders_untouched = true;
  std::size_t number_of_marked_edges = 0; // also border edges

  std::size_t number_of_faces() const { return chart.size(); }

  std::size_t previous(std::size_t c) const
  {
    return c == first_corner[face[c]] ? first_corner[face[c] + 1] - 1 : c - 1;
  }

  bool is_border(std::size_t c) const { return across[c] == c; }

  // Whether there is neither a border nor a seam
  bool is_joined(std::size_t c) const { return !is_border(c) && !is_seam[c]; }

  // Whether both sides of a seam are in the same chart
  bool is_inner_seam(std::size_t c) const
  {
    return !is_border(c) && is_seam[c] && chart[face[c]] >= 0 && chart[face[c]] == chart[face[across[c]]];
  }

  double planar_length(std::size_t c) const
  {
    const auto side = uv[c] - uv[previous(c)];
    return std::hypot(side.x(), side.y());
  }

  double seam_jump(std::size_t c) const
  {
    return std::abs(std::log(planar_length(c) / planar_length(across[c])));
  }

  double edge_length(std::size_t c) const
  {
    return std::sqrt(CGAL::squared_distance(point[previous(c)], point[c]));
  }

  double surface_area(std::size_t f) const
  {
    const std::size_t c = first_corner[f];
    const auto n = CGAL::cross_product(point[c + 1] - point[c], point[c + 2] - point[c]);
    return std::hypot(n.x(), n.y(), n.z()) / 2;
  }

  double planar_area(std::size_t f) const
  {
    const std::size_t c = first_corner[f];
    return CGAL::determinant(uv[c + 1] - uv[c], uv[c + 2] - uv[c]) / 2;
  }

  // Nothing was written.
  bool is_untouched() const
  {
    return are_borders_untouched && is_seam == was_seam &&
           std::all_of(uv.begin(), uv.end(), [](const Point_2& p) { return p == untouched; }) &&
           std::all_of(chart.begin(), chart.end(), [](int c) { return c == no_number; });
  }

  // The number of the connected part of each face, in the order of their first faces
  template <typename IsJoined>
  std::vector<std::size_t> parts(const IsJoined& is_joined) const
  {
    Undirected_graph graph(number_of_faces());
    for(std::size_t c = 0; c < across.size(); ++c)
      if(is_joined(c))
        add_edge(face[c], face[across[c]], graph);
    return component_numbers(graph);
  }
};

// What was asked for
struct Wishes
{
  int resolution = 1024;
  std::optional<int> gutter; // by default, 4 texels of 1024
  bool packs = true;
  double stretch_bound = 1.1;
  std::vector<double> weight; // of each face; empty if all are 1

  int gutter_texels() const { return gutter ? *gutter : resolution < 256 ? 1 : resolution / 256; }
};

template <typename Mesh, typename VertexPointMap, typename UVMap, typename ChartMap, typename SeamMap>
void read_run(const Mesh& mesh, VertexPointMap points, UVMap uv, ChartMap charts, SeamMap seams,
              Atlas_run& run)
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor Halfedge;
  const auto vertex_number = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  int number = 0;
  for(auto v : vertices(mesh))
    put(vertex_number, v, number++);
  const auto corner = get(CGAL::dynamic_halfedge_property_t<std::size_t>(), mesh);
  const auto as_point = [](const auto& p) { return Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y())); };
  std::vector<Halfedge> halfedges_of_corners;
  for(auto f : faces(mesh)) {
    run.first_corner.push_back(halfedges_of_corners.size());
    run.chart.push_back(static_cast<int>(get(charts, f)));
    for(Halfedge h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      put(corner, h, halfedges_of_corners.size());
      halfedges_of_corners.push_back(h);
      run.face.push_back(run.chart.size() - 1);
      run.vertex.push_back(get(vertex_number, target(h, mesh)));
      const auto& p = get(points, target(h, mesh));
      run.point.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      run.uv.push_back(as_point(get(uv, h)));
      run.is_seam.push_back(get(seams, edge(h, mesh)));
    }
  }
  run.first_corner.push_back(halfedges_of_corners.size());
  for(std::size_t c = 0; c < halfedges_of_corners.size(); ++c) {
    const Halfedge across = opposite(halfedges_of_corners[c], mesh);
    run.across.push_back(CGAL::is_border(across, mesh) ? c : get(corner, across));
  }
  for(Halfedge h : halfedges(mesh))
    if(CGAL::is_border(h, mesh))
      run.are_borders_untouched = run.are_borders_untouched && as_point(get(uv, h)) == untouched;
  for(auto e : edges(mesh))
    run.number_of_marked_edges += get(seams, e) ? 1 : 0;
}

// Makes the atlas of a mesh with maps of its own; `is_given(e)` tells the seams that are there before.
template <typename Point = CGAL::Simple_cartesian<double>::Point_2, typename Mesh, typename NamedParameters,
          typename IsGiven, typename VertexPointMap>
Atlas_run make_atlas_of(const Mesh& mesh, const Atlas_options& options, const NamedParameters& np,
                        const IsGiven& is_given, VertexPointMap points)
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel::FT FT;
  const auto uv = get(CGAL::dynamic_halfedge_property_t<Point>(), mesh);
  const auto charts = get(CGAL::dynamic_face_property_t<int>(), mesh);
  const auto seams = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  for(auto h : halfedges(mesh))
    put(uv, h, Point(FT(untouched.x()), FT(untouched.y())));
  for(auto f : faces(mesh))
    put(charts, f, no_number);
  for(auto e : edges(mesh))
    put(seams, e, bool(is_given(e)));
  Atlas_run before, run;
  read_run(mesh, points, uv, charts, seams, before);
  run.was_seam = before.is_seam;
  run.report = TA::make_atlas(mesh, seams, uv, charts, options, np);
  read_run(mesh, points, uv, charts, seams, run);
  return run;
}

template <typename Point = CGAL::Simple_cartesian<double>::Point_2, typename Mesh,
          typename NamedParameters = parameters::Default_named_parameters>
Atlas_run make_atlas_of(const Mesh& mesh, const Atlas_options& options = few_charts(),
                        const NamedParameters& np = parameters::default_values())
{
  return make_atlas_of<Point>(
      mesh, options, np, [](auto) { return false; }, get(CGAL::vertex_point, mesh));
}

// Each part of the surface has charts, or is named, and neither is both.
inline void check_parts(const Atlas_run& run)
{
  const Atlas_report& report = run.report;
  const std::vector<std::size_t> part =
      run.parts([&](std::size_t c) { return !run.is_border(c) && !run.was_seam[c]; });
  const std::size_t number = part.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
  BOOST_TEST(report.number_of_parts == number);
  std::vector<std::size_t> size(number, 0), first(number, 0);
  for(std::size_t f = run.number_of_faces(); f-- > 0;) {
    ++size[part[f]];
    first[part[f]] = f;
  }
  std::vector<char> is_skipped(number, false);
  for(const Atlas_report::Skipped& skipped : report.skipped) {
    BOOST_TEST_REQUIRE(skipped.part < number);
    BOOST_TEST(!is_skipped[skipped.part]);
    is_skipped[skipped.part] = true;
    BOOST_TEST(skipped.first_face == first[skipped.part]);
    BOOST_TEST(skipped.number_of_faces == size[skipped.part]);
    const std::set<Diagnosis> known{Diagnosis::NON_FINITE_POINT, Diagnosis::NO_AREA,
                                    Diagnosis::NO_CUT_ALLOWED, Diagnosis::LINEAR_SYSTEM_FAILED,
                                    Diagnosis::PRECISION_EXCEEDED};
    BOOST_TEST(known.count(skipped.status) == 1u, skipped.status);
    BOOST_TEST(skipped.message != "");
  }
  const bool are_good = std::all_of(report.charts.begin(), report.charts.end(),
                                    [](const Atlas_report::Chart& chart) { return chart.is_good; });
  BOOST_TEST((report.status == (!report.skipped.empty() ? Diagnosis::SOMETHING_SKIPPED
                                : are_good              ? Diagnosis::NOTHING_WRONG
                                                        : Diagnosis::STRETCH_BOUND_MISSED)));
  BOOST_TEST((report.message == "") == (report.status == Diagnosis::NOTHING_WRONG));
  bool are_named = true, are_unchanged = run.are_borders_untouched;
  for(std::size_t f = 0; f < run.number_of_faces(); ++f) {
    are_named = are_named && (is_skipped[part[f]] ? run.chart[f] == -1 : run.chart[f] >= 0);
    for(std::size_t c = run.first_corner[f]; is_skipped[part[f]] && c < run.first_corner[f + 1]; ++c)
      are_unchanged = are_unchanged && run.uv[c] == untouched &&
                      (run.is_seam[c] == run.was_seam[c] || !is_skipped[part[run.face[run.across[c]]]]);
  }
  BOOST_TEST(are_named);
  BOOST_TEST(are_unchanged);
  for(std::size_t f = 0; f < run.number_of_faces(); ++f)
    if(run.chart[f] >= 0 && report.charts[static_cast<std::size_t>(run.chart[f])].part != part[f]) {
      BOOST_ERROR("chart " << run.chart[f] << " is of another part");
      break;
    }
}

// Charts are what the seams leave, and numbered from 0 on.
inline void check_charts(const Atlas_run& run)
{
  const std::vector<std::size_t> piece = run.parts([&](std::size_t c) { return run.is_joined(c); });
  std::map<std::size_t, int> chart_of_piece;
  std::map<int, std::size_t> piece_of_chart;
  std::vector<std::size_t> size(run.report.charts.size(), 0);
  bool are_consistent = true;
  for(std::size_t f = 0; f < run.number_of_faces(); ++f)
    if(const int chart = run.chart[f]; chart >= 0) {
      BOOST_TEST_REQUIRE(static_cast<std::size_t>(chart) < size.size());
      ++size[static_cast<std::size_t>(chart)];
      are_consistent = are_consistent && chart_of_piece.emplace(piece[f], chart).first->second == chart &&
                       piece_of_chart.emplace(chart, piece[f]).first->second == piece[f];
    }
  BOOST_TEST(are_consistent);
  for(std::size_t i = 0; i < size.size(); ++i) {
    BOOST_TEST(size[i] > 0u);
    BOOST_TEST(run.report.charts[i].number_of_faces == size[i]);
  }
}

// Given seams stay, new ones are within charted parts, and the lengths are those in the report.
inline void check_seams(const Atlas_run& run)
{
  double sides = 0, area = 0;
  std::vector<double> border(run.report.charts.size(), 0);
  for(std::size_t c = 0; c < run.across.size(); ++c) {
    const int chart = run.chart[run.face[c]];
    BOOST_TEST_REQUIRE(run.is_seam[c] >= run.was_seam[c]);
    BOOST_TEST_REQUIRE(run.is_seam[c] == run.is_seam[run.across[c]]);
    if(run.is_border(c) || chart < 0)
      BOOST_TEST_REQUIRE(run.is_seam[c] == run.was_seam[c]);
    if(chart >= 0 && !run.is_joined(c))
      border[static_cast<std::size_t>(chart)] += run.edge_length(c);
    if(chart >= 0 && run.is_seam[c] && !run.is_border(c))
      sides += run.edge_length(c);
  }
  for(std::size_t f = 0; f < run.number_of_faces(); ++f)
    if(run.chart[f] >= 0)
      area += run.surface_area(f);
  const auto tolerance = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(run.report.seam_length == sides / 2, tolerance);
  BOOST_TEST(run.report.relative_seam_length == sides / 2 / std::sqrt(area), tolerance);
  for(std::size_t i = 0; i < border.size(); ++i)
    BOOST_TEST(run.report.charts[i].border_length == border[i], tolerance);
}

// Of each corner, the first corner at the same vertex of its chart: corners are the same vertex only if no seam is
// between them.
inline std::vector<int> chart_vertices(const Atlas_run& run)
{
  Undirected_graph graph(run.across.size());
  for(std::size_t c = 0; c < run.across.size(); ++c)
    if(run.is_joined(c))
      add_edge(c, run.previous(run.across[c]), graph);
  std::map<std::size_t, int> first_corner; // of each vertex
  std::vector<int> result;
  for(const std::size_t vertex : component_numbers(graph))
    result.push_back(first_corner.emplace(vertex, static_cast<int>(result.size())).first->second);
  return result;
}

inline void check_vertices(const Atlas_run& run, const std::vector<int>& vertex)
{
  bool are_equal = true;
  for(std::size_t c = 0; c < vertex.size(); ++c)
    are_equal = are_equal && run.uv[c] == run.uv[static_cast<std::size_t>(vertex[c])];
  BOOST_TEST(are_equal);
}

// Whether the normals of all faces of a chart are the same
inline bool is_flat(const Atlas_run& run, int chart)
{
  Kernel::Vector_3 first = CGAL::NULL_VECTOR;
  for(std::size_t f = 0; f < run.number_of_faces(); ++f) {
    if(run.chart[f] != chart)
      continue;
    const std::size_t c = run.first_corner[f];
    auto normal = CGAL::cross_product(run.point[c + 1] - run.point[c], run.point[c + 2] - run.point[c]);
    normal = normal / std::sqrt(normal.squared_length());
    if(first == CGAL::NULL_VECTOR)
      first = normal;
    if(!(first * normal > 0.999))
      return false;
  }
  return true;
}

// Each chart is a disk, or flat and has holes.
inline void check_disks(const Atlas_run& run, const std::vector<int>& vertex)
{
  std::vector<std::set<int>> vertices(run.report.charts.size());
  std::vector<long> twice(run.report.charts.size(), 0); // the Euler characteristic
  for(std::size_t c = 0; c < vertex.size(); ++c)
    if(const int chart = run.chart[run.face[c]]; chart >= 0) {
      vertices[static_cast<std::size_t>(chart)].insert(vertex[c]);
      twice[static_cast<std::size_t>(chart)] -= run.is_joined(c) ? 1 : 2;
    }
  for(std::size_t i = 0; i < twice.size(); ++i) {
    const long characteristic =
        twice[i] / 2 + static_cast<long>(vertices[i].size() + run.report.charts[i].number_of_faces);
    BOOST_TEST((characteristic == 1 || (characteristic < 1 && is_flat(run, static_cast<int>(i)))));
  }
}

// No two triangles of the same chart, or of all charts if they are packed, have a point in common that is not a common
// vertex or on a common edge, by exact predicates on all pairs. No triangle is flipped.
inline void check_overlaps(const Atlas_run& run, const std::vector<int>& vertex, bool packs)
{
  std::vector<std::size_t> charted;
  std::vector<CGAL::Bbox_2> boxes;
  for(std::size_t f = 0; f < run.number_of_faces(); ++f)
    if(run.chart[f] >= 0) {
      const std::size_t c = run.first_corner[f];
      BOOST_TEST_REQUIRE((CGAL::orientation(run.uv[c], run.uv[c + 1], run.uv[c + 2]) == CGAL::LEFT_TURN));
      charted.push_back(f);
      boxes.push_back(run.uv[c].bbox() + run.uv[c + 1].bbox() + run.uv[c + 2].bbox());
    }
  const auto are_overlapping = [&](std::size_t f, std::size_t g) {
    std::vector<test_charts::Point_3> points;
    test_charts::Triangles triangles(2);
    std::map<int, int> number;
    for(std::size_t k = 0; k < 6; ++k) {
      const std::size_t c = run.first_corner[k < 3 ? f : g] + k % 3;
      const auto [it, is_new] = number.emplace(vertex[c], static_cast<int>(points.size()));
      if(is_new)
        points.emplace_back(run.uv[c].x(), run.uv[c].y(), 0);
      triangles[k / 3][k % 3] = it->second;
    }
    return !test_charts::Overlaps(points, triangles).is_injective();
  };
  for(std::size_t i = 0; i < charted.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(CGAL::do_overlap(boxes[i], boxes[j]) && (packs || run.chart[charted[i]] == run.chart[charted[j]]) &&
         are_overlapping(charted[i], charted[j])) {
        BOOST_ERROR("faces " << charted[j] << " and " << charted[i] << " overlap, of charts "
                             << run.chart[charted[j]] << " and " << run.chart[charted[i]]);
        return;
      }
}

// Marks the texels, closed squares, that each chart touches, by exact predicates. Two charts have the gutter between
// them in a row or column.
inline void check_texels(const Atlas_run& run, int resolution, int gutter)
{
  typedef Kernel::Triangle_2 Triangle;
  std::vector<int> taken(static_cast<std::size_t>(resolution * resolution), -1);
  const auto texel = [&](int x, int y) -> int& {
    return taken[static_cast<std::size_t>(y * resolution + x)];
  };
  const double size = resolution; // a power of two: products are exact
  const int margin = (gutter + 1) / 2;
  for(std::size_t f = 0; f < run.number_of_faces(); ++f) {
    if(run.chart[f] < 0)
      continue;
    std::array<Point_2, 3> p;
    for(std::size_t k = 0; k < 3; ++k) {
      const Point_2& q = run.uv[run.first_corner[f] + k];
      p[k] = Point_2(size * q.x(), size * q.y());
    }
    const Triangle triangle(p[0], p[1], p[2]);
    const CGAL::Bbox_2 box = triangle.bbox();
    BOOST_TEST_REQUIRE((box.xmin() > margin && box.ymin() > margin && box.xmax() < size - margin &&
                        box.ymax() < size - margin));
    for(int y = static_cast<int>(std::ceil(box.ymin())) - 1; y <= box.ymax(); ++y)
      for(int x = static_cast<int>(std::ceil(box.xmin())) - 1; x <= box.xmax(); ++x) {
        if(texel(x, y) == run.chart[f])
          continue;
        const Point_2 a(x, y), b(x + 1, y), c(x + 1, y + 1), d(x, y + 1);
        if(!CGAL::do_intersect(triangle, Triangle(a, b, c)) &&
           !CGAL::do_intersect(triangle, Triangle(a, c, d)))
          continue;
        BOOST_TEST_REQUIRE(texel(x, y) == -1);
        texel(x, y) = run.chart[f];
      }
  }
  for(int y = 0; y < resolution; ++y)
    for(int x = 0; x < resolution; ++x)
      for(int v = y; texel(x, y) >= 0 && v <= (std::min)(y + gutter, resolution - 1); ++v)
        for(int u = (std::max)(0, x - gutter); u <= (std::min)(x + gutter, resolution - 1); ++u)
          if(texel(u, v) >= 0 && texel(u, v) != texel(x, y)) {
            BOOST_ERROR("charts " << texel(x, y) << " and " << texel(u, v) << " are too near at texel " << x
                                  << ", " << y);
            return;
          }
}

// Areas and stretch of each chart, from the coordinates
struct Chart_sums
{
  double surface = 0, weighted = 0, plane = 0, scale = 0, stretch = 0;
  double extent = 0; // squared lengths of edges
  std::size_t crushed = 0, nearly_crushed = 0;
  double skewed = 0, nearly_skewed = 0; // the area of such faces

  // Whether rounding changes the area of the surface by less than the tolerance
  bool has_area() const { return surface > 1e-9 * extent; }
};

inline std::vector<Chart_sums> chart_sums(const Atlas_run& run, const std::vector<double>& weight)
{
  std::vector<Chart_sums> sums(run.report.charts.size());
  for(std::size_t f = 0; f < run.number_of_faces(); ++f) {
    if(run.chart[f] < 0)
      continue;
    Chart_sums& sum = sums[static_cast<std::size_t>(run.chart[f])];
    const double surface = run.surface_area(f), plane = run.planar_area(f);
    const double w = weight.empty() ? 1 : weight[f];
    sum.surface += surface;
    sum.weighted += w * w * surface;
    sum.plane += plane;
    const std::size_t c = run.first_corner[f];
    const auto p = run.point[c + 1] - run.point[c], q = run.point[c + 2] - run.point[c];
    sum.extent += p.squared_length() + q.squared_length();
    if(!(surface > 0))
      continue;
    sum.scale += surface * surface / plane;
    // the squared singular values of the map from the plane to the surface: its Dirichlet energy
    const auto a = run.uv[c + 1] - run.uv[c], b = run.uv[c + 2] - run.uv[c];
    const auto d = b.x() * p - a.x() * q, e = b.y() * p - a.y() * q;
    sum.stretch += surface * (d * d + e * e) / (8 * plane * plane);
    // of a map, the sum of the quasi-conformal ratio and its inverse
    const double of_map = (d * d + e * e) / (4 * plane * surface);
    const double of_shape =
        (p.squared_length() + q.squared_length() + (q - p).squared_length()) / (2 * std::sqrt(3.) * surface);
    sum.crushed += of_map > 1010 && of_shape < 990;
    sum.nearly_crushed += of_map > 990 && of_shape < 1010;
    sum.skewed += of_map > 5.2 * (1 + 1e-6) && of_shape < 990 ? surface : 0;
    sum.nearly_skewed += of_map > 5.2 * (1 - 1e-6) && of_shape < 1010 ? surface : 0;
  }
  return sums;
}

// All charts have the same scale, apart from those that would be smaller than a sixteenth of a texel, and from those
// with hardly any area that are reduced.
inline void check_scale(const Atlas_run& run, const std::vector<Chart_sums>& sums, const Wishes& wishes)
{
  double covered = 0, weighted = 0;
  for(const Chart_sums& sum : sums)
    weighted += sum.weighted;
  const auto tolerance = boost::test_tools::tolerance(1e-6);
  for(const Chart_sums& sum : sums) {
    covered += sum.plane;
    const double scale = run.report.charts[static_cast<std::size_t>(&sum - sums.data())].scale;
    BOOST_TEST((scale == 1 || (wishes.packs && scale < 1 && sum.weighted < 0.001 * weighted)));
    const double wished = run.report.scale * run.report.scale * scale * scale * sum.weighted;
    const double side = std::sqrt(wished) * wishes.resolution;
    if(!wishes.packs || side > 0.0626)
      BOOST_TEST(sum.plane == wished, tolerance);
    else
      BOOST_TEST(std::sqrt(sum.plane) * wishes.resolution < 0.0626);
  }
  if(wishes.packs)
    BOOST_TEST(run.report.covered_share == covered, tolerance);
  else {
    BOOST_TEST(run.report.covered_share == 0);
    BOOST_TEST(run.report.scale == 1);
  }
}

inline void check_stretch(const Atlas_run& run, const std::vector<Chart_sums>& sums, double bound)
{
  double surface = 0, stretch = 0;
  const auto tolerance = boost::test_tools::tolerance(1e-6);
  for(std::size_t i = 0; i < sums.size(); ++i) {
    const Atlas_report::Chart& chart = run.report.charts[i];
    const Chart_sums& sum = sums[i];
    if(sum.has_area()) {
      BOOST_TEST(chart.area == sum.surface, tolerance);
      const double scale_stretch = std::sqrt(sum.scale * sum.plane) / sum.surface;
      BOOST_TEST(chart.scale_stretch == scale_stretch, tolerance);
      const double l2_stretch = std::sqrt(sum.stretch * sum.plane) / sum.surface;
      BOOST_TEST(chart.l2_stretch == l2_stretch, tolerance);
    }
    BOOST_TEST(chart.bound_reached == (chart.scale_stretch <= 1.03 * bound));
    BOOST_TEST(sum.crushed <= chart.crushed_faces);
    BOOST_TEST(chart.crushed_faces <= sum.nearly_crushed);
    BOOST_TEST(sum.skewed <= (chart.skewed_share + 1e-9) * sum.surface);
    BOOST_TEST((chart.skewed_share - 1e-9) * sum.surface <= sum.nearly_skewed);
    BOOST_TEST(chart.is_good ==
               (std::isinf(bound) || (chart.l2_stretch <= (std::max)(2., bound) && chart.crushed_faces == 0 &&
                                      chart.skewed_share <= 0.01)));
    surface += chart.area; // compared above, but for what is mostly rounding
    stretch += chart.area * chart.l2_stretch * chart.l2_stretch;
  }
  BOOST_TEST(run.report.measures.l2_stretch == std::sqrt(stretch / surface), tolerance);
  BOOST_TEST(run.report.measures.flipped_triangles == 0);
  BOOST_TEST(run.report.measures.border_is_simple);
}

// What the report says of seams within charts
inline void check_seam_lengths(const Atlas_run& run)
{
  std::vector<double> jump(run.report.charts.size(), 0);
  std::vector<char> has_seams(jump.size(), false);
  for(std::size_t c = 0; c < run.across.size(); ++c)
    if(run.is_inner_seam(c)) {
      const auto i = static_cast<std::size_t>(run.chart[run.face[c]]);
      has_seams[i] = true;
      jump[i] = (std::max)(jump[i], run.seam_jump(c));
    }
  double largest = 0;
  for(std::size_t i = 0; i < jump.size(); ++i) {
    const Atlas_report::Chart& chart = run.report.charts[i];
    BOOST_TEST(std::abs(chart.largest_seam_jump - jump[i]) <= 1e-12);
    BOOST_TEST((chart.seam_lengths == Atlas_report::NO_SEAMS) == !has_seams[i]);
    BOOST_TEST(chart.has_equal_seams == (chart.seam_lengths == Atlas_report::EQUAL_LENGTHS));
    if(!chart.has_equal_seams)
      continue;
    BOOST_TEST((chart.method == Atlas_report::ABF_PLUS_PLUS || chart.method == Atlas_report::SEPARATED));
    BOOST_TEST(jump[i] <= 1e-5);
    largest = (std::max)(largest, chart.largest_seam_jump);
  }
  BOOST_TEST(run.report.largest_equal_seam_jump == largest);
}

// Not packed, each chart has its lower left corner at the origin.
inline void check_corners(const Atlas_run& run)
{
  std::vector<CGAL::Bbox_2> boxes(run.report.charts.size());
  for(std::size_t c = 0; c < run.uv.size(); ++c)
    if(const int chart = run.chart[run.face[c]]; chart >= 0)
      boxes[static_cast<std::size_t>(chart)] += run.uv[c].bbox();
  for(const CGAL::Bbox_2& box : boxes) {
    BOOST_TEST(box.xmin() == 0);
    BOOST_TEST(box.ymin() == 0);
  }
}

// All of that. Pairs of triangles and texels are compared if there are not too many.
inline void check_atlas(const Atlas_run& run, const Wishes& wishes)
{
  BOOST_TEST_REQUIRE(run.report.has_atlas(), run.report.message);
  check_parts(run);
  check_charts(run);
  check_seams(run);
  const std::vector<int> vertex = chart_vertices(run);
  check_vertices(run, vertex);
  check_disks(run, vertex);
  const std::size_t most_faces = 6000;
  if(run.number_of_faces() <= most_faces)
    check_overlaps(run, vertex, wishes.packs);
  const int largest_resolution = 256;
  if(wishes.packs && wishes.resolution <= largest_resolution)
    check_texels(run, wishes.resolution, wishes.gutter_texels());
  if(!wishes.packs)
    check_corners(run);
  const std::vector<Chart_sums> sums = chart_sums(run, wishes.weight);
  check_scale(run, sums, wishes);
  check_stretch(run, sums, wishes.stretch_bound);
  check_seam_lengths(run);
}

} // namespace atlas_check

#endif // ANGLE_BASED_FLATTENING_ATLAS_CHECK_H
