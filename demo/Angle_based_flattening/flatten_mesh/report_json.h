// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_JSON_H
#define FLATTEN_MESH_REPORT_JSON_H

#include "Run_record.h"
#include "texts.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline std::string json_text(const std::string& value)
{
  std::string text = "\"";
  for(const char c : value) {
    if(static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(c));
      text += escape;
    } else {
      text += c == '"' || c == '\\' ? "\\" : "";
      text += c;
    }
  }
  return text + '"';
}

// JSON has finite numbers only.
template <class Number>
std::string json_number(const Number number)
{
  std::string text;
  if(!std::isfinite(static_cast<double>(number))) {
    return "null";
  }
  append_number(text, number);
  return text;
}

inline std::string json_texts(const std::vector<std::string>& values)
{
  std::string text;
  for(const std::string& value : values) {
    text += (text.empty() ? "" : ", ") + json_text(value);
  }
  return "[" + text + "]";
}

// Builds an object from members whose values are JSON.
class Json_object
{
public:
  void add(const std::string& key, const std::string& value)
  {
    m_members += (m_members.empty() ? "" : ", ") + json_text(key) + ": " + value;
  }

  std::string text() const { return "{" + m_members + "}"; }

private:
  std::string m_members;
};

inline void add_measures(Json_object& json, const Flattening& flattening)
{
  using Measures = SMP::Flattening_measures;
  const bool known = flattening.succeeded();
  const auto add = [&](const char* key, double Measures::*measure) {
    json.add(key, known ? json_number(flattening.measures.*measure) : "null");
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
  json.add("flipped_triangles",
           json_number(known ? flattening.measures.flipped_triangles : flattening.report.flipped_triangles));
  const bool simple = known ? flattening.measures.border_is_simple : flattening.report.border_is_simple;
  json.add("border", json_text(simple ? "simple" : "not simple"));
  add("smallest_angle", &Measures::smallest_angle);
}

inline std::string seams_json(const Seam_record& seams)
{
  Json_object json;
  json.add("cut", json_text(seams.cut));
  json.add("terminals", seams.terminals ? json_number(*seams.terminals) : "null");
  json.add("length", json_number(seams.length));
  json.add("stretch_bound", json_number(seams.stretch_bound));
  json.add("predicted_stretch", json_number(seams.predicted_stretch));
  json.add("scale_stretch", json_number(seams.scale_stretch));
  json.add("bound_reached", !seams.bound_reached ? "null" : *seams.bound_reached ? "true" : "false");
  json.add("rounds", json_number(seams.rounds));
  json.add("disks", json_number(seams.disks));
  return json.text();
}

inline void add_injectivity(Json_object& json, const SMP::Flattening_report& report)
{
  json.add("injective", report.injective ? "true" : "false");
  json.add("contact", report.injective ? json_number(report.contact) : "null");
  json.add("least_clearance", report.injective ? json_number(report.least_clearance) : "null");
  json.add("border_rejections", json_number(report.border_rejections));
}

inline std::string split_json(const Split_record& split)
{
  Json_object json;
  json.add("pieces", json_number(split.pieces));
  json.add("overlapping_triangles", json_number(split.overlapping_triangles));
  json.add("added_seam_length", json_number(split.added_length));
  json.add("extra_seam", json_number(split.extra_seam));
  return json.text();
}

} // namespace internal

// The report for programs. What is unknown after a failure is `null`.
inline std::string report_json(const Run_record& record)
{
  using internal::json_number;
  using internal::json_text;
  const SMP::ABF_plus_plus_report& report = record.flattening.report;
  const bool succeeds_without_area = record.flattening.succeeded() && !record.has_area;
  internal::Json_object json;
  json.add("status", json_text(succeeds_without_area ? "NO_AREA" : status_name(report)));
  json.add("message", json_text(succeeds_without_area ? "the surface has no area"
                                                      : report.message + record.flattening.place));
  json.add("notes", internal::json_texts(record.notes));
  json.add("input", json_text(record.input));
  json.add("vertices", json_number(record.vertices));
  json.add("triangles", json_number(record.triangles));
  json.add("borders", json_number(record.borders));
  json.add("components", json_number(record.components));
  json.add("seams", record.seams ? internal::seams_json(*record.seams) : "null");
  json.add("method", json_text(record.flattening.method));
  json.add("iterations", json_number(report.iterations));
  json.add("constraint_residual", json_number(report.constraint_residual));
  json.add("energy", json_number(report.energy));
  json.add("layout", json_text(layout_name(report)));
  json.add("strategy", json_text(strategy_name(report.strategy)));
  json.add("scale_range", json_number(report.scale_range));
  json.add("predicted_scale_range", json_number(report.predicted_scale_range));
  internal::add_measures(json, record.flattening);
  internal::add_injectivity(json, report);
  json.add("split", record.split ? internal::split_json(*record.split) : "null");
  internal::Json_object seconds;
  for(const auto& stage : seconds_of_stages(record)) {
    seconds.add(stage.first, json_number(stage.second));
  }
  json.add("seconds", seconds.text());
  const double memory = peak_memory_mb(report);
  json.add("peak_memory_mb", memory > 0 ? json_number(memory) : "null");
  return json.text() + "\n";
}

// The report for programs if a failure occurred before the flattening.
inline std::string failure_json(const std::string& status, const std::string& message,
                                const std::string& input)
{
  internal::Json_object json;
  json.add("status", internal::json_text(status));
  json.add("message", internal::json_text(message));
  json.add("input", internal::json_text(input));
  return json.text() + "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_JSON_H
