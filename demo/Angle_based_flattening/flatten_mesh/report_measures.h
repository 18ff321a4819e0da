// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_MEASURES_H
#define FLATTEN_MESH_REPORT_MEASURES_H

#include "flatten_mesh/json.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;

namespace internal {

inline std::string report_line(std::string label, const std::string& value, const std::string& remark = "")
{
  label.resize(22, ' ');
  std::string line = label + value;
  if(!remark.empty()) {
    line.resize((std::max)(line.size() + 2, std::size_t(36)), ' ');
    line += "(" + remark + ")";
  }
  return line + "\n";
}

inline std::string degrees_text(const double radians)
{
  return format_number("%.4g", radians * 180. / CGAL_PI) + " degrees";
}

inline std::string quality_text(const SMP::Flattening_measures& measures)
{
  const auto line = [](const char* label, const double value, const std::string& remark) {
    return report_line(label, format_number("%.5g", value), remark);
  };
  return report_line("angle change", degrees_text(measures.mean_angle_change),
                     "mean by area; root mean square " + degrees_text(measures.rms_angle_change)) +
         report_line("  per corner", degrees_text(measures.mean_corner_angle_change),
                     "mean; root mean square " + degrees_text(measures.rms_corner_angle_change)) +
         line("quasi-conformal ratio", measures.mean_quasi_conformal_ratio,
              "mean; on 95 % of the area at most " +
                  format_number("%.5g", measures.quasi_conformal_ratio_95) + "; largest " +
                  format_number("%.5g", measures.max_quasi_conformal_ratio) + "; best 1") +
         report_line("scale", format_number("%.5g", measures.min_scale),
                     "of lengths, least; largest " + format_number("%.5g", measures.max_scale) + "; best 1") +
         report_line("energy", format_number("%.4e", measures.angular_distortion),
                     "mean square relative change of the target angles, Equation 1; best 0") +
         line("L2 stretch", measures.l2_stretch, "of lengths, root mean square; best 1") +
         line("L-infinity stretch", measures.linf_stretch, "of lengths, largest; best 1") +
         line("L2 shear", measures.l2_shear, "of the axes, Equation 24; best 0") +
         line("L2 principal shear", measures.l2_principal_shear,
              "for the worst axes of each triangle; best 0") +
         line("equal-stretch error", measures.l2_equal_stretch_error,
              "one axis stretched more than the other; best 0") +
         line("area distortion", measures.l2_area_distortion,
              "logarithm of the factor of areas, root mean square; best 0") +
         line("symmetric Dirichlet", measures.symmetric_dirichlet_energy, "energy per area; best 4") +
         report_line("flipped triangles", std::to_string(measures.flipped_triangles), "must be 0") +
         report_line("border", measures.border_is_simple ? "simple" : "not simple",
                     measures.border_is_simple ? "the map is injective"
                                               : "parts of the layout overlap or touch") +
         report_line("smallest angle", degrees_text(measures.smallest_angle));
}

// All are `null` if there are none.
inline void add_measures(Json_object& json, const SMP::Flattening_measures* measures)
{
  using Measures = SMP::Flattening_measures;
  const auto add = [&](const char* key, double Measures::*measure) {
    json.add(key, measures != nullptr ? json_number(measures->*measure) : "null");
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
