// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of the choice of cones without the caller's types: options, and the chosen vertices with their angles.
// `select_cones_of_mesh.h` calls `choose_cones()`; the definition is in `choose_cones_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Cone_selection.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline constexpr std::size_t largest_number_of_cones = 1000;

// Vertices of a connected surface, and the sums of their planar angles, if nothing is wrong
struct Chosen_cones
{
  Diagnosis status = Diagnosis::NOTHING_WRONG;
  std::string message;
  std::vector<int> offending_vertices;
  std::vector<int> vertices;
  std::vector<double> angles; // of each of them
  double predicted_stretch = 1;
};

inline int euler_characteristic(const Chart& surface)
{
  const auto border_edges = std::count(surface.opposite.begin(), surface.opposite.end(), -1);
  return surface.number_of_vertices() - (surface.number_of_corners() + static_cast<int>(border_edges)) / 2 +
         surface.number_of_triangles();
}

// The number of quanta of a full turn, or 0 if it is no whole number
inline int quanta_of_turn(double quantum)
{
  const double quanta = std::round(2 * pi / quantum);
  return quanta >= 1 && quanta <= 1e6 && std::abs(quanta * quantum - 2 * pi) <= 1e-9
             ? static_cast<int>(quanta)
             : 0;
}

// What is wrong with the options, or nothing
inline std::string wrong_option(std::size_t number_of_cones, const Cone_options& options)
{
  if(number_of_cones > largest_number_of_cones)
    return std::to_string(number_of_cones) + " cones are too many: the limit is " +
           std::to_string(largest_number_of_cones);
  if(options.angle_multiple != 0 && quanta_of_turn(options.angle_multiple) == 0)
    return "2 pi is not a multiple of the angle " + std::to_string(options.angle_multiple);
  if(options.angle_multiple != 0 && options.angles == Cone_angles::FREE)
    return "free angles of cones cannot be multiples of an angle";
  return wrong_option(options.parameterizer);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Chosen_cones choose_cones(const Chart& surface,
                                                             std::size_t number_of_cones,
                                                             const Cone_options& options,
                                                             const Linear_solvers& solvers);

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CHOOSE_CONES_H
