// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DISPLAYED_SURFACE_H
#define FLATTEN_MESH_DISPLAYED_SURFACE_H

#include "flatten_mesh/report/Measure_summary.h"
#include "flatten_mesh/report/Thinning.h"
#include "flatten_mesh/report/Wedge_mesh.h"
#include "flatten_mesh/report/measure_triangles.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace flatten_mesh {

// The measures in the order of the page
inline std::array<Measure_of_triangles, 3> measures_of_page(const Triangle_measures& measures)
{
  return {{{"angle_change", "change of angles", "degrees", 0, false, 0.1, measures.angle_change},
           {"area_change", "change of areas", "doublings", 0, true, 0.1, measures.area_change},
           {"stretch_ratio", "quasi-conformal ratio", "", 1, false, 0.01, measures.stretch_ratio}}};
}

// What the page draws
struct Displayed_surface
{
  Wedge_mesh mesh;
  Triangle_measures measures;
  std::vector<std::size_t> origins; // of each triangle: its number on the whole surface, rising
};

namespace internal {

// The part of a mesh that consists of some of its triangles, whose wedges are given, and has all borders
inline Wedge_mesh part_of_mesh(const Wedge_mesh& mesh, const std::vector<std::size_t>& triangles,
                               const Thinning& thinning)
{
  using Index = Wedge_mesh::Index;
  Wedge_mesh part;
  std::vector<Index> wedge_numbers(mesh.wedge_points.size(), no_wedge),
      point_numbers(mesh.points.size(), no_wedge);
  const auto number = [&](const Index wedge) {
    if(wedge_numbers[wedge] == no_wedge) {
      const Index point = mesh.wedge_points[wedge];
      if(point_numbers[point] == no_wedge) {
        point_numbers[point] = static_cast<Index>(part.points.size());
        part.points.push_back(mesh.points[point]);
      }
      wedge_numbers[wedge] = static_cast<Index>(part.wedge_points.size());
      part.wedge_points.push_back(point_numbers[point]);
      part.wedge_uv.push_back(mesh.wedge_uv[wedge]);
    }
    return wedge_numbers[wedge];
  };
  for(const std::size_t t : triangles) {
    const std::array<Index, 3> wedges = thinning.wedges(t);
    part.triangles.push_back({number(wedges[0]), number(wedges[1]), number(wedges[2])});
    part.charts.push_back(mesh.charts[t]);
  }
  for(const Wedge_mesh::Side& side : mesh.borders) {
    part.borders.push_back({{number(side.wedges[0]), number(side.wedges[1])}, side.seam});
  }
  return part;
}

// The means over all that became part of each remaining triangle, by area on the surface. The triangles `kept` have
// their own values.
inline std::vector<double> merged_values(const std::vector<double>& values, const std::vector<double>& areas,
                                         const std::vector<std::size_t>& heirs,
                                         const std::vector<std::size_t>& kept,
                                         const std::vector<std::size_t>& remaining)
{
  std::vector<double> sums(values.size(), 0), weights(values.size(), 0), result;
  for(std::size_t t = 0; t < values.size(); ++t) {
    if(areas[t] > 0 && std::isfinite(values[t])) {
      sums[heirs[t]] += areas[t] * values[t];
      weights[heirs[t]] += areas[t];
    }
  }
  for(const std::size_t t : kept) {
    weights[t] = 0;
  }
  for(const std::size_t t : remaining) {
    result.push_back(weights[t] > 0 ? sums[t] / weights[t] : values[t]);
  }
  return result;
}

} // namespace internal

inline Displayed_surface whole_surface(const Wedge_mesh& mesh, const Triangle_measures& measures)
{
  std::vector<std::size_t> origins(mesh.triangles.size());
  std::iota(origins.begin(), origins.end(), std::size_t(0));
  return {mesh, measures, origins};
}

// At most that many triangles, if borders do not have too many vertices for that. The triangles `kept` are among them,
// unchanged.
inline Displayed_surface thinned_surface(const Wedge_mesh& mesh, const Triangle_measures& measures,
                                         const std::vector<std::size_t>& kept, const std::size_t most)
{
  Thinning thinning(mesh, kept);
  thinning.thin(most);
  const std::vector<std::size_t> heirs = thinning.heirs();
  Displayed_surface surface;
  for(std::size_t t = 0; t < heirs.size(); ++t) {
    if(heirs[t] == t) {
      surface.origins.push_back(t);
    }
  }
  surface.mesh = internal::part_of_mesh(mesh, surface.origins, thinning);
  surface.measures.scale = measures.scale;
  for(std::vector<double> Triangle_measures::*values :
      {&Triangle_measures::angle_change, &Triangle_measures::area_change,
       &Triangle_measures::stretch_ratio}) {
    surface.measures.*values =
        internal::merged_values(measures.*values, measures.areas, heirs, kept, surface.origins);
  }
  return surface;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DISPLAYED_SURFACE_H
