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
  if(flattening.succeeded()) {
    json.add("angular_distortion", flattening.measures.angular_distortion);
    json.add("l2_stretch", flattening.measures.l2_stretch);
    json.add("l2_shear", flattening.measures.l2_shear);
    json.add("flipped_triangles", static_cast<std::size_t>(flattening.measures.flipped_triangles));
    json.add("smallest_angle", flattening.measures.smallest_angle);
  } else {
    for(const char* key : {"angular_distortion", "l2_stretch", "l2_shear"}) {
      json.add_null(key);
    }
    json.add("flipped_triangles", static_cast<std::size_t>(flattening.report.flipped_triangles));
    json.add_null("smallest_angle");
  }
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
  internal::add_measures(json, record.flattening);
  Json_object seconds;
  for(const auto& stage : seconds_of_stages(record)) {
    seconds.add(stage.first, stage.second);
  }
  json.add("seconds", seconds);
  const double memory = peak_memory_mb();
  if(memory >= 0) {
    json.add("peak_memory_mb", memory);
  } else {
    json.add_null("peak_memory_mb");
  }
  return json.text() + "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_JSON_H
