// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_JSON_H
#define FLATTEN_MESH_REPORT_JSON_H

#include "Json_object.h"
#include "Run_record.h"

#include <cstddef>
#include <string>

namespace flatten_mesh {

namespace internal {

inline void add_measures(Json_object& json, const Flattening& flattening)
{
  using Measures = SMP::Flattening_measures;
  const bool known = flattening.succeeded();
  const auto add = [&](const char* key, double Measures::*measure) {
    if(known) {
      json.add(key, flattening.measures.*measure);
    } else {
      json.add_null(key);
    }
  };
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
  json.add("flipped_triangles", static_cast<std::size_t>(known ? flattening.measures.flipped_triangles
                                                               : flattening.report.flipped_triangles));
  const bool simple = known ? flattening.measures.border_is_simple : flattening.report.border_is_simple;
  json.add("border", std::string(simple ? "simple" : "crosses itself"));
  add("smallest_angle", &Measures::smallest_angle);
}

} // namespace internal

// The report for programs. What is unknown after a failure is `null`.
inline std::string report_json(const Run_record& record)
{
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  Json_object json;
  json.add("status", status_name(report));
  json.add("message", report.message + record.flattening.place);
  json.add("input", record.input);
  json.add("vertices", record.vertices);
  json.add("triangles", record.triangles);
  json.add("borders", record.borders);
  json.add("components", record.components);
  json.add("method", record.flattening.method);
  json.add("iterations", static_cast<std::size_t>(report.iterations));
  json.add("constraint_residual", report.constraint_residual);
  json.add("energy", report.energy);
  json.add("layout", layout_name(report));
  json.add("rung", rung_name(report.rung));
  json.add("scale_range", report.scale_range);
  internal::add_measures(json, record.flattening);
  Json_object seconds;
  for(const auto& stage : seconds_of_stages(record)) {
    seconds.add(stage.first, stage.second);
  }
  json.add("seconds", seconds);
  if(const double memory = peak_memory_mb(report); memory > 0) {
    json.add("peak_memory_mb", memory);
  } else {
    json.add_null("peak_memory_mb");
  }
  return json.text() + "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_JSON_H
