// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FLATTEN_ALONG_SEAMS_H
#define FLATTEN_MESH_FLATTEN_ALONG_SEAMS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/plain/Seamed_component.h"
#include "flatten_mesh/plain/add_terminals.h"
#include "flatten_mesh/plain/flatten_chart.h"
#include "flatten_mesh/plain/scale_stretch.h"
#include "flatten_mesh/plain/seam_chains.h"

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace flatten_mesh {

// A surface that was cut open, and its map.
struct Flat_surface
{
  Cut_mesh cut;
  Chart chart;
  Flattening flattening;
  std::size_t disks = 0;
  double stretch = 0;
};

namespace internal {

// All copies of a cone have the sum of the angles around it.
inline void prescribe_cones(const Cut_mesh& cut, const std::map<Vertex, double>& cones, Chart& chart)
{
  chart.angles.emplace();
  for(const Vertex v : cut.mesh.vertices()) {
    if(const auto cone = cones.find(cut.origins[v.idx()]); cone != cones.end()) {
      chart.angles->set(v, cone->second);
      chart.marks[v] = cone->second;
    }
  }
}

// The largest disk.
inline Chart chart_of_cut(Cut_mesh& cut, const Seamed_component& component, const std::size_t border)
{
  Chart chart = choose_border(cut.mesh, choose_component(cut.mesh, 0), border);
  for(const Vertex v : cut.origins) {
    chart.input_vertices.push_back(component.part.origins[v.idx()]);
  }
  const std::vector<int> chains = seam_chains(component.part.mesh, component.seams);
  for(const Edge e : cut.edge_origins) {
    chart.seams.push_back(chains[e.idx()]);
  }
  if(component.cones) {
    prescribe_cones(cut, *component.cones, chart);
  }
  return chart;
}

// Both sides of a seam are copies of one edge.
inline std::vector<Halfedge> seam_sides(const Cut_mesh& cut)
{
  std::vector<Halfedge> sides(cut.mesh.number_of_halfedges());
  std::map<Edge, Halfedge> first;
  for(const Halfedge h : cut.mesh.halfedges()) {
    if(cut.mesh.is_border(h)) {
      const auto [other, is_new] = first.emplace(cut.edge_origins[cut.mesh.edge(h).idx()], h);
      if(!is_new) {
        sides[h.idx()] = other->second;
        sides[other->second.idx()] = h;
      }
    }
  }
  return sides;
}

inline Flat_surface flatten_once(const Command_line& command, const Seamed_component& component,
                                 Progress& progress)
{
  Flat_surface result;
  const Mesh& mesh = component.part.mesh;
  result.cut = cut_open(mesh, {mesh.faces().begin(), mesh.faces().end()},
                        {mesh.vertices().begin(), mesh.vertices().end()}, component.seams);
  result.chart = chart_of_cut(result.cut, component, static_cast<std::size_t>(command.border));
  result.chart.seam_sides = seam_sides(result.cut);
  result.disks = result.chart.components;
  result.flattening = flatten_chart(result.cut.mesh, result.chart, command, progress);
  if(result.flattening.succeeded()) {
    result.stretch = scale_stretch(result.cut.mesh, result.chart, result.flattening.uv);
  }
  return result;
}

// Two rounds in a row that gain less are the last ones. One alone says little: the next has twice as many terminals.
inline constexpr double least_gain = 0.02;

// How to tell which vertices add most to the stretch
enum class Badness
{
  LOG_SCALE,     // finds tips, however small their triangles are
  AREA_OF_SCALE, // weighted by the area around a vertex: finds what large triangles hide
};

// The vertices, at most `count`, that are worse than all their neighbours, the worst first.
inline std::vector<Vertex> worst_vertices(const Flat_surface& flat, const Seamed_component& component,
                                          const Badness kind, const std::size_t count)
{
  const Mesh& mesh = component.part.mesh;
  std::vector<double> badness;
  for(const Vertex_scale& scale : vertex_scales(flat.cut.mesh, flat.chart, flat.flattening.uv,
                                                flat.cut.origins, mesh.number_of_vertices())) {
    badness.push_back(kind == Badness::LOG_SCALE ? std::abs(scale.log_scale)
                                                 : scale.area * (std::cosh(2 * scale.log_scale) - 1));
  }
  const auto is_worse = [&badness](const Vertex v, const Vertex w) {
    const double a = badness[v.idx()], b = badness[w.idx()];
    return a > b || (a == b && v < w);
  };
  std::vector<Vertex> worst;
  for(const Vertex v : mesh.vertices()) {
    const auto neighbors = mesh.vertices_around_target(mesh.halfedge(v));
    if(!is_on_seam(mesh, component.seams, v) &&
       std::all_of(neighbors.begin(), neighbors.end(), [&](const Vertex w) { return is_worse(v, w); })) {
      worst.push_back(v);
    }
  }
  std::sort(worst.begin(), worst.end(), is_worse);
  worst.resize((std::min)(worst.size(), count));
  return worst;
}

// Adds seams and flattens again. Returns whether the map is better; if not, nothing has changed.
inline bool improve(const Command_line& command, Seamed_component& component, Flat_surface& flat,
                    Seam_record& record, Progress& progress, const Badness kind, const std::size_t count)
{
  const Mesh& mesh = component.part.mesh;
  std::vector<bool> before;
  for(const Edge e : mesh.edges()) {
    before.push_back(component.seams[e]);
  }
  const std::size_t added =
      add_terminals(mesh, component.seams, component.forbidden, worst_vertices(flat, component, kind, count));
  if(added == 0) {
    return false;
  }
  Flat_surface next = flatten_once(command, component, progress);
  if(!(next.flattening.succeeded() && next.stretch < flat.stretch)) {
    for(const Edge e : mesh.edges()) {
      component.seams[e] = before[e.idx()];
    }
    flat.flattening.add_attempt(next.flattening);
    return false;
  }
  next.flattening.add_attempt(flat.flattening);
  flat = std::move(next);
  record.terminals = *record.terminals + added;
  return true;
}

// Returns the part of the stretch that is gained. The number of new terminals doubles with each round.
inline double improve_in_round(const Command_line& command, Seamed_component& component, Flat_surface& flat,
                               Seam_record& record, Progress& progress)
{
  const std::size_t count = std::size_t(3) << record.rounds;
  const double before = flat.stretch;
  ++record.rounds;
  progress.round(before);
  for(const Badness kind : {Badness::LOG_SCALE, Badness::AREA_OF_SCALE}) {
    if(flat.stretch > (1 - least_gain) * before) {
      improve(command, component, flat, record, progress, kind, count);
    }
  }
  return 1 - flat.stretch / before;
}

// Whether a map has more stretch than `--cut auto` was asked for. A little more is let pass.
inline bool misses_bound(const Seam_record& record, const double stretch)
{
  const double tolerance = 1.03;
  return record.terminals && stretch > tolerance * record.stretch_bound;
}

} // namespace internal

// Flattens the largest disk that the seams leave. If `--cut auto` chose them, then the scale stretch of the map is
// compared with the bound, and seams are added where it is missed.
inline Flat_surface flatten_along_seams(const Command_line& command, Seamed_component& component,
                                        Seam_record& record, Progress& progress)
{
  const int max_rounds = 5;
  Flat_surface flat = internal::flatten_once(command, component, progress);
  int weak_rounds = 0;
  while(flat.flattening.succeeded() && internal::misses_bound(record, flat.stretch) && weak_rounds < 2 &&
        record.rounds < max_rounds) {
    const double gain = internal::improve_in_round(command, component, flat, record, progress);
    weak_rounds = gain < internal::least_gain ? weak_rounds + 1 : 0;
  }
  record.disks = flat.disks;
  record.length = length_of_seams(component);
  if(flat.flattening.succeeded()) {
    record.scale_stretch = flat.stretch;
    if(record.terminals) {
      record.bound_reached = !internal::misses_bound(record, flat.stretch);
    }
  }
  return flat;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FLATTEN_ALONG_SEAMS_H
