// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/plain/split_chart.h"

#include "flatten_mesh/model/Edge_marks.h"
#include "flatten_mesh/plain/seam_chains.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/split_overlaps.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>

namespace flatten_mesh {

namespace {

// The seams that the chart had, and the new ones, with numbers behind theirs.
std::vector<int> numbers_of_seams(const Chart& chart, const Cut_mesh& alone, const Edge_marks& new_seams)
{
  std::vector<int> numbers = seam_chains(alone.mesh, new_seams);
  const int count = chart.seams.empty() ? 0 : *std::max_element(chart.seams.begin(), chart.seams.end()) + 1;
  for(std::size_t e = 0; e < numbers.size(); ++e) {
    numbers[e] = numbers[e] < 0 ? chart.seam(alone.edge_origins[e]) : count + numbers[e];
  }
  return numbers;
}

// `alone` is the mesh of the chart, without anything else, and `result.cut` what is made of it.
void take_over(const Chart& chart, const Flattening& flattening, const Cut_mesh& alone,
               const std::vector<int>& numbers, Split_chart& result)
{
  Mesh& mesh = result.cut.mesh;
  result.chart.faces.assign(mesh.faces().begin(), mesh.faces().end());
  result.chart.vertices.assign(mesh.vertices().begin(), mesh.vertices().end());
  result.chart.number = chart.number;
  result.chart.components = chart.components;
  result.chart.borders = internal::borders_by_length(mesh, result.chart.vertices);
  result.chart.border = result.chart.borders.front();
  for(const Edge e : result.cut.edge_origins) {
    result.chart.seams.push_back(numbers[e.idx()]);
  }
  result.flattening = flattening;
  result.flattening.uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  result.flattening.distortion = mesh.add_property_map<Face, double>("f:distortion").first;
  for(const Vertex v : mesh.vertices()) {
    const Vertex before = alone.origins[result.cut.origins[v.idx()].idx()];
    result.chart.input_vertices.push_back(chart.input_vertex(before));
    result.flattening.uv[v] = flattening.uv[before];
    if(const auto mark = chart.marks.find(before); mark != chart.marks.end()) {
      result.chart.marks[v] = mark->second;
    }
  }
  for(const Face f : mesh.faces()) {
    result.flattening.distortion[f] = flattening.distortion[chart.faces[f.idx()]];
  }
}

} // namespace

Split_chart split_chart(const Mesh& mesh, const Chart& chart, const Flattening& flattening,
                        const std::function<bool(Edge)>& is_forbidden, Split_record& record)
{
  Split_chart result;
  const CGAL::Constant_property_map<Edge, bool> uncut(false);
  Cut_mesh alone = cut_open(mesh, chart.faces, chart.vertices, uncut);
  const Edge_marks seams = seam_marks(alone.mesh);
  const auto piece = alone.mesh.add_property_map<Face, std::size_t>("f:piece").first;
  const auto uv = boost::make_function_property_map<Vertex>(
      [&](const Vertex v) { return flattening.uv[alone.origins[v.idx()]]; });
  const auto forbidden = boost::make_function_property_map<Edge>(
      [&](const Edge e) { return is_forbidden(alone.edge_origins[e.idx()]); });
  const TA::Overlap_split_report report =
      TA::split_overlaps(alone.mesh, uv, seams, piece, CGAL::parameters::edge_is_constrained_map(forbidden));
  if(!report) {
    throw Seams_failed("cannot split overlaps: " + report.message);
  }
  record.pieces = report.number_of_pieces;
  record.overlapping_triangles = report.number_of_overlapping_faces;
  record.added_length = report.added_seam_length;
  record.extra_seam = report.extra_seam;
  if(report.number_of_pieces == 1) {
    return result;
  }
  for(const Edge e : alone.mesh.edges()) {
    if(seams[e]) {
      result.new_seams.push_back(alone.edge_origins[e.idx()]);
    }
  }
  result.cut = cut_open(alone.mesh, {alone.mesh.faces().begin(), alone.mesh.faces().end()},
                        {alone.mesh.vertices().begin(), alone.mesh.vertices().end()}, seams);
  take_over(chart, flattening, alone, numbers_of_seams(chart, alone, seams), result);
  return result;
}

} // namespace flatten_mesh
