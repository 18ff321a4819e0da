// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_REPORT_ON_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_REPORT_ON_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Given_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>
#include <CGAL/Texture_atlas/Soup_options.h>
#include <CGAL/Texture_atlas/Soup_report.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <locale>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// For people, rounded to so many digits
inline std::string rounded_text(const double number, const int digits)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << number;
  return text.str();
}

// Tells of the polygons of a soup that have no area, and lists those that no neighbor gives coordinates. If only one
// component is to be flattened, it is not known whether they belong to it.
inline void report_polygons_without_area(const Given_surface& given, const Atlas& atlas,
                                         const std::size_t number, const bool is_whole,
                                         std::vector<Skipped_part>& skipped, Notes& notes)
{
  const Prepared_surface& surface = given.surface;
  const std::vector<bool>& has_no_area = surface.origins.has_no_area;
  const Model_texture texture = texture_of(given.soup, surface.mesh, surface.origins, atlas);
  std::vector<std::size_t> with, without;
  for(std::size_t p = 0; p < has_no_area.size(); ++p) {
    if(has_no_area[p]) {
      (texture.charts[p] == no_index ? without : with).push_back(p);
    }
  }
  if(!with.empty()) {
    notes.add(count_text(with.size(), "face") + " without area, the first is " + face_name(with.front()) +
              ": coordinates on an edge of a neighbor");
  }
  if(!without.empty() && is_whole) {
    skipped.push_back(skipped_part(Diagnosis::NO_AREA, face_name(without.front()) +
                                                           " has no area, and no neighbor with a chart"));
    skipped.back().first_face = without.front();
    skipped.back().number_of_faces = without.size();
    skipped.back().mesh = number;
  }
}

// Lists all polygons without chart. The parts of `report` are those of the mesh before.
inline void report_skipped(const Soup_options& options, std::vector<Given_surface>& given, Mesh& mesh,
                           const Atlas& atlas, Soup_report& report, Notes& notes)
{
  const Soup_numbers numbers = soup_numbers(mesh);
  std::vector<Skipped_part> skipped;
  for(std::size_t i = 0; i < given.size(); ++i) {
    if(!given[i].surface.origins.has_no_area.empty()) {
      if(given.size() > 1) {
        notes.set_subject(given[i].name);
      }
      report_polygons_without_area(given[i], atlas_of_surface(atlas, given[i]), i, !options.component,
                                   skipped, notes);
    }
  }
  notes.set_subject("");
  for(std::size_t i = 0; i < given.size(); ++i) {
    for(Skipped_part part : given[i].surface.set_aside) {
      part.mesh = i;
      skipped.push_back(std::move(part));
    }
  }
  for(Skipped_part part : report.skipped) {
    const Face first(static_cast<Mesh::size_type>(part.first_face));
    part.first_face = polygon_of_face(given, first);
    part.number_of_faces = polygons_of_part(mesh, atlas.seams, atlas.chart, first, [&given](const Face f) {
                             return polygon_of_face(given, f);
                           }).size();
    part.mesh = surface_of_face(given, first);
    for(std::size_t& v : part.vertices) {
      v = numbers.points[Vertex(static_cast<Mesh::size_type>(v))] - 1;
    }
    skipped.push_back(std::move(part));
  }
  std::stable_sort(skipped.begin(), skipped.end(), [](const auto& a, const auto& b) {
    return std::pair(a.mesh, a.first_face) < std::pair(b.mesh, b.first_face);
  });
  report.skipped = std::move(skipped);
}

// Names the elements of a soup that the diagnosis is about: of the first part without chart, or of the mesh.
inline void report_offending(const std::vector<Given_surface>& given, const Mesh& mesh,
                             const Report_on_atlas& of_mesh, Soup_report& report)
{
  const std::vector<Face>& faces = of_mesh.offending_faces;
  report.offending_soup = !report.skipped.empty() ? report.skipped.front().mesh
                          : !faces.empty()        ? surface_of_face(given, faces.front())
                                                  : 0;
  std::set<std::size_t> polygons, points;
  for(const Skipped_part& part : report.skipped) {
    if(part.mesh == report.offending_soup) {
      polygons.insert(part.first_face);
      points.insert(part.vertices.begin(), part.vertices.end());
    }
  }
  for(const Face f : faces) {
    if(surface_of_face(given, f) == report.offending_soup) {
      polygons.insert(polygon_of_face(given, f));
    }
  }
  std::vector<Vertex> ends = of_mesh.offending_vertices;
  for(const Edge e : of_mesh.offending_edges) {
    ends.insert(ends.end(), {mesh.vertex(e, 0), mesh.vertex(e, 1)});
  }
  for(const Vertex v : ends) {
    for(const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v))) {
      if(!mesh.is_border(h) && surface_of_face(given, mesh.face(h)) == report.offending_soup) {
        points.insert(point_of_corner(given[report.offending_soup], h));
      }
    }
  }
  report.offending_polygons.assign(polygons.begin(), polygons.end());
  report.offending_points.assign(points.begin(), points.end());
}

// Names the polygons with a corner that found no place on the grid of coordinates. Those of several soups are counted
// through.
inline void report_off_grid(const Soup_options& options, const std::vector<Given_surface>& given,
                            Soup_report& report, Notes& notes)
{
  std::set<std::size_t> polygons;
  std::string first;
  for(const std::size_t f : report.faces_off_grid) {
    const Face face(static_cast<Mesh::size_type>(f));
    const std::size_t surface = surface_of_face(given, face);
    std::size_t polygon = polygon_of_face(given, face);
    if(first.empty()) {
      first = (given.size() > 1 ? given[surface].name + ": " : "") + face_name(polygon);
    }
    for(std::size_t i = 0; i < surface; ++i) {
      polygon += given[i].soup.number_of_polygons();
    }
    polygons.insert(polygon);
  }
  report.faces_off_grid.assign(polygons.begin(), polygons.end());
  if(!polygons.empty()) {
    notes.add(count_text(polygons.size(), "face") + " with a corner that found no place on the grid of " +
              std::to_string(*options.quantization_bits) + " bits, the first is " + first +
              ": quantization may turn triangles over there; more bits help");
  }
}

// Says what was not reached, and what became of charts that were given.
inline void tell_of_charts(const Soup_options& options, const Soup_report& report, Notes& notes)
{
  const Soup_report::Seams& seams = report.seams;
  if(seams.mirror_edges > 0) {
    notes.add("the given coordinates are mirrored along " + count_text(seams.mirror_edges, "edge") +
              (seams.mirror_edges == 1 ? ", which is a seam now" : ", which are seams now"));
  }
  if(seams.turned_charts > 0) {
    notes.add(count_text(seams.turned_charts, "given chart") + " turned over, because " +
              (seams.turned_charts == 1 ? "it is" : "they are") + " mirrored as a whole");
  }
  if(seams.lacks_creases) {
    notes.add("no creases divide the surface where faces differ by more than " +
              rounded_text(*seams.crease_angle * 180 / CGAL_PI, 4) +
              " degrees, so all seams are chosen to be short");
  }
  if(seams.symmetry && !seams.symmetry->has_symmetric_seams) {
    notes.add((seams.symmetry->has_symmetric_surface
                   ? "no symmetric seams were found that are at most 5 % longer than others"
                   : "the surface is not symmetric: in the best plane, its mirror image is " +
                         rounded_text(100 * seams.symmetry->plane.deviation, 2) +
                         " % of the diagonal of the bounding box away from it, and not at most 1.5 %") +
              std::string(", so the seams are not made symmetric"));
  }
  const auto is_reduced = [](const Atlas_report::Chart& chart) { return chart.scale < 1; };
  const auto first = std::find_if(report.charts.begin(), report.charts.end(), is_reduced);
  if(const auto reduced = std::count_if(first, report.charts.end(), is_reduced); reduced > 0) {
    notes.add(count_text(static_cast<std::size_t>(reduced), "long chart") +
              " with hardly any area, the first is chart " + std::to_string(first - report.charts.begin()) +
              ": scaled down alone, so that all others have more texels");
  }
  std::size_t missed = 0;
  double worst = 1;
  for(const Atlas_report::Chart& chart : report.charts) {
    missed += !chart.bound_reached;
    worst = (std::max)(worst, chart.scale_stretch);
  }
  if(missed > 0) {
    notes.add("the scale stretch of " + count_text(missed, "chart") + ", at most " + rounded_text(worst, 4) +
              ", misses the bound of " + rounded_text(options.stretch_bound, 4) + " by more than 3 %");
  }
}

// The report on an atlas of surfaces, from the report on their mesh
inline Soup_report report_on_soups(const Soup_options& options, std::vector<Given_surface>& given, Mesh& mesh,
                                   const Atlas& atlas, Report_on_atlas of_mesh,
                                   const Soup_report::Seams& seams, Notes& notes)
{
  Soup_report report;
  static_cast<Atlas_report&>(report) = std::move(static_cast<Atlas_report&>(of_mesh));
  report.seams = seams;
  for(const Given_surface& each : given) {
    report.number_of_ignored += each.surface.left_out;
  }
  const bool has_no_charts = mesh.is_empty() || (report.charts.empty() && !report.skipped.empty());
  report_skipped(options, given, mesh, atlas, report, notes);
  if(!report.skipped.empty() && (report.has_atlas() || has_no_charts)) {
    const Skipped_part& first = report.skipped.front();
    report.status = report.has_atlas() ? Diagnosis::SOMETHING_SKIPPED : first.status;
    report.message = (given.size() > 1 ? given[first.mesh].name + ": " : "") + first.message;
  }
  if(!report) {
    report_offending(given, mesh, of_mesh, report);
  }
  tell_of_charts(options, report, notes);
  report_off_grid(options, given, report, notes);
  return report;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_REPORT_ON_SOUP_H
