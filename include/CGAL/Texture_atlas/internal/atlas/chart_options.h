// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How charts of an atlas are made: the user's options, and what follows from them for the direct and the hierarchical
// method. The stages of `atlas/` that flatten charts take their options from here.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CHART_OPTIONS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CHART_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/options/wrong_option.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <limits>
#include <string>

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
  if(!injective) { // they come close to the energy of the direct method
    result.angle_sweeps = 20;
    result.energy_tolerance = 0.01;
  }
  return result;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CHART_OPTIONS_H
