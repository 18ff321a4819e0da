// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Rounds the charges of cones to whole quanta, with a given total on closed surfaces. `choose_cones_impl.h` calls it,
// for example for patterns that a quarter turn does not change.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_CONES_ROUND_CHARGES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_CONES_ROUND_CHARGES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The charge of a cone, in quanta: a full turn minus its angle, with its bounds
struct Quantized_charge
{
  double wanted;
  int least, largest;
};

// Rounds charges to whole numbers between the bounds: each to the nearest, or, given their total, those with the
// largest remainders up. Returns nothing if this is not possible.
inline std::optional<std::vector<int>> round_charges(const std::vector<Quantized_charge>& charges,
                                                     const std::optional<int>& total)
{
  std::vector<int> rounded;
  int missing = total.value_or(0);
  for(const Quantized_charge& charge : charges) {
    if(charge.least > charge.largest)
      return std::nullopt;
    const double whole = total ? std::floor(charge.wanted) : std::round(charge.wanted);
    rounded.push_back(static_cast<int>(
        std::clamp(whole, static_cast<double>(charge.least), static_cast<double>(charge.largest))));
    missing -= rounded.back();
  }
  while(total && missing != 0) {
    const int step = missing > 0 ? 1 : -1;
    int best = -1;
    double best_remainder = 0;
    for(std::size_t i = 0; i < charges.size(); ++i) {
      const int next = rounded[i] + step;
      const double remainder = step * (charges[i].wanted - rounded[i]);
      if(next >= charges[i].least && next <= charges[i].largest && (best < 0 || remainder > best_remainder)) {
        best = static_cast<int>(i);
        best_remainder = remainder;
      }
    }
    if(best < 0)
      return std::nullopt;
    rounded[best] += step;
    missing -= step;
  }
  return rounded;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_CONES_ROUND_CHARGES_H
