// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_MEASURES_H
#define FLATTEN_MESH_REPORT_MEASURES_H

#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/texts.h"

#include <CGAL/number_utils.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>

#include <string>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;

namespace internal {

inline std::string degrees_text(const double radians)
{
  return format_number("%.4g", radians * 180. / CGAL_PI) + " degrees";
}

inline Report_rows quality_rows(const SMP::Flattening_measures& measures)
{
  const auto number = [](const double value) { return format_number("%.5g", value); };
  return {
      {"angle change", degrees_text(measures.mean_angle_change),
       "mean by area; root mean square " + degrees_text(measures.rms_angle_change)},
      {"  per corner", degrees_text(measures.mean_corner_angle_change),
       "mean; root mean square " + degrees_text(measures.rms_corner_angle_change)},
      {"quasi-conformal ratio", number(measures.mean_quasi_conformal_ratio),
       "mean; on 95 % of the area at most " + number(measures.quasi_conformal_ratio_95) + "; largest " +
           number(measures.max_quasi_conformal_ratio) + "; best 1"},
      {"scale", number(measures.min_scale),
       "of lengths, least; largest " + number(measures.max_scale) + "; best 1"},
      {"energy", format_number("%.4e", measures.angular_distortion),
       "mean square relative change of the target angles, Equation 1; best 0"},
      {"L2 stretch", number(measures.l2_stretch), "of lengths, root mean square; best 1"},
      {"L-infinity stretch", number(measures.linf_stretch), "of lengths, largest; best 1"},
      {"L2 shear", number(measures.l2_shear), "of the axes, Equation 24; best 0"},
      {"L2 principal shear", number(measures.l2_principal_shear),
       "for the worst axes of each triangle; best 0"},
      {"equal-stretch error", number(measures.l2_equal_stretch_error),
       "one axis stretched more than the other; best 0"},
      {"area distortion", number(measures.l2_area_distortion),
       "logarithm of the factor of areas, root mean square; best 0"},
      {"symmetric Dirichlet", number(measures.symmetric_dirichlet_energy), "energy per area; best 4"},
      {"flipped triangles", std::to_string(measures.flipped_triangles), "must be 0"},
      {"border", measures.border_is_simple ? "simple" : "not simple",
       measures.border_is_simple ? "the map is injective" : "parts of the layout overlap or touch"},
      {"smallest angle", degrees_text(measures.smallest_angle)},
  };
}

using CGAL::Texture_atlas::internal::add_measures;

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_MEASURES_H
