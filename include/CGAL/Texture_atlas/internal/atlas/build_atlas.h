// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `build_atlas()` makes an atlas without the caller's types, so that it can be compiled once in the library. Here is
// also what its stages share: options for charts, and each part of the surface, opened along its seams, with its map.
// `Mesh_atlas_builder` calls it; the definition is in `build_atlas_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The options of `make_atlas()`, and settings that it changes for some parts.
struct Chart_options : Atlas_options
{
  Chart_options(const Atlas_options& options) : Atlas_options(options) {}

  double longest_chart = std::numeric_limits<double>::infinity(); // longer ones are divided
  bool is_isometric = false;   // injective maps preserve areas, because conformal maps were bad
  bool keeps_distance = false; // all maps are injective, with some clearance between parts of their borders
};

// The weight of areas for maps that are as isometric as possible
inline constexpr double isometric_weight = 1;

// Charts of more triangles are flattened hierarchically.
inline constexpr int largest_direct_chart = 20000;

inline Flattening_options flattening_options(const Chart_options& options)
{
  Flattening_options result;
  result.area_weight = options.area_weight;
  result.threads = options.threads;
  return result;
}

inline ABF_plus_plus_options direct_options(const Chart_options& options)
{
  ABF_plus_plus_options result;
  static_cast<Flattening_options&>(result) = flattening_options(options);
  return result;
}

inline Hierarchical_options hierarchical_options(const Chart_options& options, bool injective)
{
  Hierarchical_options result;
  static_cast<Flattening_options&>(result) = flattening_options(options);
  result.injective = injective;
  if(!injective) { // they come close to the energy of the direct method, unless other maps replace them
    result.angle_sweeps = options.isometric_charts ? 6 : 20;
    result.energy_tolerance = 0.01;
  }
  return result;
}

// The charts of one connected part of a surface
struct Part_atlas
{
  Diagnosis status = Diagnosis::NOTHING_WRONG; // or why there are no charts
  std::string message;
  int wrong_corner = -1; // where the chart could not be kept or certified; -1 if that is no single one
  Chart chart;           // the part, opened along the seams; its triangles and corners are those of the part
  std::vector<Chart::Point_2> uv;          // of each vertex of the chart, in the units of the surface
  std::vector<int> piece;                  // of each triangle: the chart of the atlas that it is in
  std::vector<Atlas_report::Chart> pieces; // by their numbers: how they were made
  std::size_t number_of_terminals = 0;

  bool succeeded() const { return status == Diagnosis::NOTHING_WRONG; }

  int corner_at(int vertex) const
  {
    return static_cast<int>(std::find(chart.vertex.begin(), chart.vertex.end(), vertex) -
                            chart.vertex.begin());
  }
};

// The charts of all parts of a surface, with their final coordinates
struct Atlas
{
  std::vector<Part_atlas> parts;
  std::vector<std::size_t> first_chart; // of each part: the number of its first chart
  bool has_no_charts = false;           // because no part could be flattened
  Atlas_report report;                  // without the lengths of seams and the measures of the caller
};

// Numbers the pieces anew after the chart was opened along further seams. Each new piece inherits how its old piece was
// made.
inline void renumber_pieces(Part_atlas& atlas)
{
  const std::vector<int> before =
      std::exchange(atlas.piece, connected_triangles(atlas.chart, [](int) { return true; }));
  std::vector<Atlas_report::Chart> pieces;
  for(std::size_t t = 0; t < before.size(); ++t)
    if(atlas.piece[t] == static_cast<int>(pieces.size())) // they are numbered by their first triangles
      pieces.push_back(atlas.pieces[before[t]]);
  atlas.pieces = std::move(pieces);
}

// Opens the charts along further seams. Their maps stay as they are. `cost` is that of the edge that each corner faces.
inline void open_along(const std::vector<char>& is_seam, const std::vector<double>& cost, Part_atlas& atlas)
{
  Piece piece = opened_along_seams(atlas.chart, cost, is_seam);
  atlas.uv = piece.map_from(atlas.uv);
  atlas.chart = std::move(piece.chart);
  renumber_pieces(atlas);
}

// The stretch of each piece
inline std::vector<Stretch_sums> stretch_of_pieces(const Part_atlas& atlas)
{
  std::vector<Stretch_sums> sums(atlas.pieces.size());
  for(int t = 0; t < atlas.chart.number_of_triangles(); ++t)
    sums[atlas.piece[t]].add(atlas.chart, atlas.uv, t);
  return sums;
}

// The triangles of maps as packing takes them
struct Planar_triangles
{
  std::vector<Planar_point> corners; // three for each triangle
  std::vector<double> areas;         // on the surface, times the squares of the weights

  // Appends those of a part. `weight` multiplies the lengths of each triangle in the plane; empty if all are 1.
  void add(const Surface_part& part, const std::vector<double>& weight, const Part_atlas& atlas)
  {
    for(int t = 0; t < atlas.chart.number_of_triangles(); ++t) {
      for(int c = 3 * t; c < 3 * t + 3; ++c) {
        const Chart::Point_2& p = atlas.uv[atlas.chart.vertex[c]];
        corners.emplace_back(p.x(), p.y());
      }
      const double factor = weight.empty() ? 1 : weight[part.first_triangle + t];
      areas.push_back(surface_area(atlas.chart, t) * factor * factor);
    }
  }
};

// Makes the atlas of a surface. `weight` multiplies the lengths of each triangle in the plane; empty if all are 1. A
// part that cannot be flattened is skipped. If something else is wrong, the report says so.
CGAL_ANGLE_BASED_FLATTENING_INLINE Atlas build_atlas(const std::vector<Surface_part>& parts,
                                                     const std::vector<double>& weight,
                                                     const Chart_options& options,
                                                     const Linear_solvers& solvers, Rounding round);

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_H
