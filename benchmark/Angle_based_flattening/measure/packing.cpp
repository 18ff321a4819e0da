// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pack_rectangles.h"
#include "read_mesh.h"
#include "subcommands.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Texture_atlas/split_overlaps.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace ABF_benchmark {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
typedef Mesh::Face_index Face;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Edge_index Edge;

// The faces nearest to each of some faces, in steps across edges. Each of these faces is one that is farthest from
// those before.
std::vector<int> regions(const Mesh& mesh, const int number)
{
  std::vector<int> region(mesh.number_of_faces(), 0), steps(mesh.number_of_faces(), 1 << 30);
  Face seed(0);
  for(int r = 0; r < number; ++r) {
    std::vector<Face> front{seed};
    steps[seed] = 0;
    region[seed] = r;
    for(std::size_t i = 0; i < front.size(); ++i)
      for(const Face g : mesh.faces_around_face(mesh.halfedge(front[i])))
        if(g != Mesh::null_face() && steps[g] > steps[front[i]] + 1) {
          steps[g] = steps[front[i]] + 1;
          region[g] = r;
          front.push_back(g);
        }
    seed = *std::max_element(mesh.faces().begin(), mesh.faces().end(),
                             [&](const Face f, const Face g) { return steps[f] < steps[g]; });
  }
  return region;
}

// Cuts the surface to disks: that many, or as few as flatten well if the number is 0.
template <class Seam_map>
SMP::Mesh_report<Mesh, TA::Seam_report> cut(const Mesh& mesh, const Seam_map& seams, const int number)
{
  if(number == 0)
    return TA::is_disk_cut(mesh, seams) ? SMP::Mesh_report<Mesh, TA::Seam_report>()
                                        : TA::select_seams(mesh, seams);
  const std::vector<int> region = regions(mesh, number);
  for(const Edge e : mesh.edges())
    if(!mesh.is_border(e) && region[mesh.face(mesh.halfedge(e, 0))] != region[mesh.face(mesh.halfedge(e, 1))])
      seams[e] = true;
  return TA::cut_to_disks(mesh, seams);
}

double triangle_area(const Mesh& mesh, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                      mesh.point(mesh.target(mesh.next(h)))));
}

// The smallest rectangles around the charts, as large as their areas on the surface say
template <class UV_map, class Chart_map>
std::vector<std::pair<double, double>> rectangles(const Mesh& mesh, const UV_map& uv, const Chart_map& chart,
                                                  const std::size_t number)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 Point;
  std::vector<std::vector<Point>> points(number);
  std::vector<double> area(number, 0), area_in_plane(number, 0);
  for(const Face f : mesh.faces()) {
    Point p[3];
    int k = 0;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      points[chart[f]].push_back(p[k++] = Point(uv[h].x(), uv[h].y()));
    area[chart[f]] += triangle_area(mesh, f);
    area_in_plane[chart[f]] += std::abs(CGAL::area(p[0], p[1], p[2]));
  }
  std::vector<std::pair<double, double>> result;
  for(std::size_t c = 0; c < number; ++c) {
    std::vector<Point> hull, corners;
    CGAL::convex_hull_2(points[c].begin(), points[c].end(), std::back_inserter(hull));
    CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(corners));
    const double scale = std::sqrt(area[c] / area_in_plane[c]);
    result.emplace_back(scale * std::sqrt(CGAL::squared_distance(corners[0], corners[1])),
                        scale * std::sqrt(CGAL::squared_distance(corners[1], corners[2])));
  }
  return result;
}

} // namespace

void packing(const std::string& file, const Packing_choice& choice, Measurement& m)
{
  Mesh whole;
  read_mesh(file, whole);
  const auto seams = whole.add_property_map<Edge, bool>("e:seam", false).first;
  const auto cut_report = cut(whole, seams, choice.regions);
  if(!cut_report)
    return m.fail(cut_report.message);

  Mesh mesh;
  CGAL::copy_face_graph(TA::make_seam_mesh(whole, seams).mesh, mesh);
  const auto uv_of_vertices =
      mesh.add_property_map<Mesh::Vertex_index, abf::Chart::Point_2>("v:uv", {0, 0}).first;
  std::vector<Halfedge> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  for(const Halfedge border : borders) {
    SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer;
    if(SMP::parameterize(mesh, parameterizer, border, uv_of_vertices) != SMP::OK)
      return m.fail(parameterizer.report().message);
  }
  const auto cuts = mesh.add_property_map<Edge, bool>("e:cut", false).first;
  const auto chart = mesh.add_property_map<Face, int>("f:chart", 0).first;
  const auto split = TA::split_overlaps(mesh, uv_of_vertices, cuts, chart);
  if(!split)
    return m.fail(split.message);
  const auto uv = mesh.add_property_map<Halfedge, abf::Chart::Point_2>("h:uv", {0, 0}).first;
  double area = 0;
  for(const Face f : mesh.faces()) {
    area += triangle_area(mesh, f);
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      uv[h] = uv_of_vertices[mesh.target(h)];
  }

  double scale = 0;
  m.add("rectangle_seconds", seconds_of([&] {
          scale = Rectangle_packer(rectangles(mesh, uv, chart, split.number_of_pieces), choice.resolution,
                                   choice.gutter)
                      .scale();
        }));
  m.add("rectangle_share", area * scale * scale / choice.resolution / choice.resolution);
  TA::Packing_report report;
  TA::Packing_options options;
  options.resolution = choice.resolution;
  options.gutter = choice.gutter;
  options.texels_per_unit = choice.resolution * std::sqrt(choice.pages / area);
  m.add("seconds", seconds_of([&] { report = TA::pack_charts(mesh, chart, uv, options); }));
  if(!report)
    return m.fail(report.message);
  m.add("triangles", mesh.number_of_faces());
  m.add("charts", report.number_of_charts);
  m.add("share", report.covered_share);
  m.add("pages", report.number_of_pages);
  m.add("attempts", report.number_of_attempts);
  m.add("ratio", report.covered_share * choice.resolution * choice.resolution / area / scale / scale);
}

} // namespace ABF_benchmark
