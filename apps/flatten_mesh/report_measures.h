// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_MEASURES_H
#define FLATTEN_MESH_REPORT_MEASURES_H

#include "flatten_mesh/Json.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/number_utils.h>

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

// All are `null` if there are none.
inline void add_measures(Json& json, const SMP::Flattening_measures* measures)
{
  using Measures = SMP::Flattening_measures;
  const auto add = [&](const char* key, double Measures::*measure) {
    json[key] = measures != nullptr ? Json(measures->*measure) : Json();
  };
  add("mean_angle_change", &Measures::mean_angle_change);
  add("rms_angle_change", &Measures::rms_angle_change);
  add("mean_corner_angle_change", &Measures::mean_corner_angle_change);
  add("rms_corner_angle_change", &Measures::rms_corner_angle_change);
  add("quasi_conformal_ratio_95", &Measures::quasi_conformal_ratio_95);
  add("min_scale", &Measures::min_scale);
  add("max_scale", &Measures::max_scale);
  add("angular_distortion", &Measures::angular_distortion);
  add("l2_stretch", &Measures::l2_stretch);
  add("linf_stretch", &Measures::linf_stretch);
  add("l2_shear", &Measures::l2_shear);
  add("l2_principal_shear", &Measures::l2_principal_shear);
  add("l2_equal_stretch_error", &Measures::l2_equal_stretch_error);
  add("mean_quasi_conformal_ratio", &Measures::mean_quasi_conformal_ratio);
  add("max_quasi_conformal_ratio", &Measures::max_quasi_conformal_ratio);
  add("l2_area_distortion", &Measures::l2_area_distortion);
  add("symmetric_dirichlet_energy", &Measures::symmetric_dirichlet_energy);
  add("smallest_angle", &Measures::smallest_angle);
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_MEASURES_H
