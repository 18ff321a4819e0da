// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Options and results of packing, with the similarity that each chart gets, and the outcome of the check.
// `pack.h` has them in its interface, `scaled_charts.h` reads the options.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PACKING_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PACKING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

inline constexpr int largest_resolution = 1 << 15, largest_gutter = 1 << 10, most_rotations = 1 << 10;

// What is wrong with the options, or nothing
inline std::string wrong_option(const Packing_options& options)
{
  const auto text = [](const char* what, int value, int least, int most) {
    return value >= least && value <= most
               ? std::string()
               : std::string("the ") + what + " is " + std::to_string(value) + ", and must be from " +
                     std::to_string(least) + " to " + std::to_string(most);
  };
  std::string wrong = text("resolution", options.resolution, 1, largest_resolution);
  if(wrong.empty())
    wrong = text("gutter", options.number_of_gutter_texels(), 0, largest_gutter);
  if(wrong.empty())
    wrong = text("number of rotations", options.number_of_rotations, 1, most_rotations);
  return wrong;
}

// A rotation, scaled, without a reflection. Small charts far from the origin lose no digits: `origin` is subtracted
// first.
struct Similarity
{
  double cosine = 1, sine = 0;                                              // times the scale
  Planar_point origin = Planar_point::Zero(), image = Planar_point::Zero(); // of the origin

  Planar_point operator()(const Planar_point& p) const
  {
    const double x = p.x() - origin.x(), y = p.y() - origin.y();
    return {cosine * x - sine * y + image.x(), sine * x + cosine * y + image.y()};
  }
};

struct Packing
{
  enum Status
  {
    DONE,
    WRONG_OPTION,
    NON_FINITE,       // a coordinate or an area is infinite or not a number, or an area is negative
    DEGENERATE_CHART, // it has no area in the plane
    NO_AREA,          // all triangles should have the area 0
    TOO_MANY_CHARTS   // they do not fit even where each is as large as one texel
  };

  Status status = DONE;
  int chart = -1;                    // the first that is wrong
  std::vector<Similarity> placement; // of each chart

  double covered_share = 0;     // the sum of the areas of the triangles in the unit square
  double texels_per_length = 0; // texels along the side of a square whose area should be 1
  int number_of_turned = 0;     // charts for which all directions were tried
  int number_of_small = 0;      // charts for which places were not looked for where alike ones found none
  int number_of_enlarged =
      0; // charts that would be smaller than a sixteenth of a texel, and have that size now
  int number_of_attempts = 0; // scales that were tried
};

struct Packing_check
{
  enum Status
  {
    CERTIFIED,
    OUTSIDE,     // a triangle is not in the unit square, or too near to its border
    SHARED_TEXEL // a triangle is too near to another chart
  };

  Status status = CERTIFIED;
  int triangle = -1; // the first that is wrong
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PACKING_H
