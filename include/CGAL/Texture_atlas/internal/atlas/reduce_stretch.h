// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Adds seams in rounds as long as a map stretches too much. `part_atlas_builder.h` does so for the parts of an atlas,
// and the program `flatten_mesh` for a mesh that becomes a single chart.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_REDUCE_STRETCH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_REDUCE_STRETCH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Texture_atlas/internal/atlas/add_terminals.h>
#include <CGAL/Texture_atlas/internal/atlas/map_stretch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/seams/apply_seams.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline bool misses_stretch_bound(double stretch, double bound)
{
  return stretch > stretch_tolerance * bound;
}

// How often seams were added, and how often this reduced the stretch
struct Seam_rounds
{
  int all = 0;
  int successful = 0;
};

// Calls `improve(criterion, count)`, which adds at most that many terminals and takes the new map if it stretches less,
// until `stretch()` meets the bound. The number of terminals doubles with each round, so that only two rounds in a row
// that gain little tell that more will not help.
template <typename Stretch, typename Improve>
Seam_rounds add_seams_in_rounds(double bound, const Stretch& stretch, const Improve& improve)
{
  const int max_rounds = 5;
  const double least_gain = 0.02;
  Seam_rounds rounds;
  int weak_rounds = 0;
  while(misses_stretch_bound(stretch(), bound) && weak_rounds < 2 && rounds.all < max_rounds) {
    const double before = stretch();
    const std::size_t count = std::size_t(3) << rounds.all++;
    for(Stretch_criterion criterion : {Stretch_criterion::LOG_SCALE, Stretch_criterion::AREA})
      if(stretch() > (1 - least_gain) * before)
        improve(criterion, count);
    rounds.successful += stretch() < before;
    weak_rounds = stretch() > (1 - least_gain) * before ? weak_rounds + 1 : 0;
  }
  return rounds;
}

// Joins vertices of a mesh where its map stretches most to the seams that leave disks, and returns how many.
// `uv_of(h)` is the place of the halfedge's target in its face.
template <typename TriangleMesh, typename UvOf, typename EdgeIsSeamMap, typename NamedParameters>
std::size_t add_terminals(const TriangleMesh& mesh, const UvOf& uv_of, EdgeIsSeamMap seams,
                          Stretch_criterion criterion, std::size_t count, const NamedParameters& np)
{
  std::size_t added = 0;
  Seam_application<TriangleMesh, EdgeIsSeamMap, NamedParameters> application(mesh, seams, np, false);
  application.run([&](const Surface_part& part) {
    Chart triangles; // each with vertices of its own, because those on seams have several places
    std::vector<Chart::Point_2> uv;
    for(int c = 0; c < part.chart.number_of_corners(); ++c) {
      const auto& p = uv_of(application.halfedge_to(part, c));
      triangles.vertex.push_back(c);
      triangles.points.push_back(part.chart.points[part.chart.vertex[c]]);
      uv.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    }
    Terminal_adder adder(part.chart, part.cost, application.seams_of(part));
    added += static_cast<std::size_t>(adder.add(
        vertex_scales(triangles, uv, part.chart.vertex, part.chart.number_of_vertices()), criterion, count));
    Seams result;
    result.is_seam = adder.seams();
    return result;
  });
  return added;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_REDUCE_STRETCH_H
