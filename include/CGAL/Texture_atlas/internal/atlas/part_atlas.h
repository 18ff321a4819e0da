// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The data that the stages of an atlas pass on: a part of the surface, opened along its seams, its map, and how each of
// its charts was made. `part_atlas_builder.h` and `divided_part_atlas.h` make it; the builder, the certificate and the
// measures read it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_PART_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_PART_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/overlaps/minimum_cut.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// How a chart of the atlas was made
struct Atlas_piece
{
  Atlas_report::Method method = Atlas_report::ABF_PLUS_PLUS;
  Atlas_report::Strategy strategy = Atlas_report::USUAL;
  Atlas_report::Seam_lengths seam_lengths = Atlas_report::NO_SEAMS;
  bool overlap_is_predicted = false;
  double contact = 0;
  int rounds = 0; // in which seams were added
};

// The charts of one connected part of a surface
struct Part_atlas
{
  Diagnosis status = Diagnosis::NOTHING_WRONG; // or why there are no charts
  std::string message;
  Chart chart; // the part, opened along the seams; its triangles and corners are those of the part
  std::vector<Chart::Point_2> uv;  // of each vertex of the chart, in the units of the surface
  std::vector<int> piece;          // of each triangle: the chart of the atlas that it is in
  std::vector<Atlas_piece> pieces; // by their numbers
  std::size_t number_of_terminals = 0;

  bool succeeded() const { return status == Diagnosis::NOTHING_WRONG; }
};

// The charts of all parts of a surface, with their final coordinates
struct Atlas
{
  std::vector<Part_atlas> parts;
  std::vector<std::size_t> first_chart; // of each part: the number of its first chart
  Atlas_report report;                  // without the lengths of seams and the measures of the caller
};

// Numbers the pieces anew after the chart was opened along further seams. Each new piece inherits how its old piece was
// made.
inline void renumber_pieces(Part_atlas& atlas)
{
  const std::vector<int> before =
      std::exchange(atlas.piece, connected_triangles(atlas.chart, [](int) { return true; }));
  std::vector<Atlas_piece> pieces;
  for(std::size_t t = 0; t < before.size(); ++t)
    if(atlas.piece[t] == static_cast<int>(pieces.size())) // they are numbered by their first triangles
      pieces.push_back(atlas.pieces[before[t]]);
  atlas.pieces = std::move(pieces);
}

// Opens the charts along further seams. Their maps stay as they are. `cost` is that of the edge that each corner faces.
inline void open_along(const std::vector<char>& is_seam, const std::vector<double>& cost, Part_atlas& atlas)
{
  std::vector<int> all(atlas.piece.size());
  std::iota(all.begin(), all.end(), 0);
  Dual_patch patch = Patch_cutter(atlas.chart, cost).cut_out(std::move(all), is_seam);
  std::vector<Chart::Point_2> uv;
  for(int v : patch.origin)
    uv.push_back(atlas.uv[v]);
  atlas.chart = std::move(patch.chart);
  atlas.uv = std::move(uv);
  renumber_pieces(atlas);
}

// The triangles of each piece
inline std::vector<std::vector<int>> triangles_of_pieces(const Part_atlas& atlas)
{
  std::vector<std::vector<int>> triangles(atlas.pieces.size());
  for(std::size_t t = 0; t < atlas.piece.size(); ++t)
    triangles[atlas.piece[t]].push_back(static_cast<int>(t));
  return triangles;
}

// The stretch of each piece
inline std::vector<Stretch_sums> stretch_of_pieces(const Part_atlas& atlas)
{
  std::vector<Stretch_sums> sums(atlas.pieces.size());
  for(int t = 0; t < atlas.chart.number_of_triangles(); ++t)
    sums[atlas.piece[t]].add(atlas.chart, atlas.uv, t);
  return sums;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_PART_ATLAS_H
