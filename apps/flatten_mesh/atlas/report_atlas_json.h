// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_ATLAS_JSON_H
#define FLATTEN_MESH_REPORT_ATLAS_JSON_H

#include "flatten_mesh/atlas/Atlas_record.h"
#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/batch/add_run.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/report_measures.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline Json chart_json(const TA::Atlas_report::Chart& chart, const double share)
{
  return {{"part", chart.part},
          {"page", chart.page},
          {"triangles", chart.number_of_faces},
          {"share_of_area", share},
          {"method", to_string(chart.method)},
          {"overlap_is_predicted", chart.overlap_is_predicted},
          {"strategy", to_string(chart.strategy)},
          {"scale_stretch", chart.scale_stretch},
          {"l2_stretch", chart.l2_stretch},
          {"crushed_faces", chart.crushed_faces},
          {"skewed_share", chart.skewed_share},
          {"bound_reached", chart.bound_reached},
          {"is_good", chart.is_good},
          {"contact", chart.contact},
          {"border_length", chart.border_length},
          {"rounds", chart.rounds},
          {"seam_lengths", to_string(chart.seam_lengths)},
          {"has_equal_seams", chart.has_equal_seams},
          {"largest_seam_jump", chart.largest_seam_jump}};
}

inline Json packing_json(const Atlas_record& record)
{
  return {{"resolution", record.options.resolution},
          {"height", record.options.number_of_rows()},
          {"block", record.options.block},
          {"gutter", record.options.number_of_gutter_texels()},
          {"pages", record.report.number_of_pages},
          {"texels_per_unit", record.report.scale * record.options.resolution},
          {"covered_share", record.report.covered_share},
          {"texel_density", record.report.texel_density},
          {"low_texel_density", record.report.low_texel_density}};
}

inline Json symmetry_json(const Symmetry& symmetry)
{
  const auto& [x, y, z] = symmetry.plane.normal;
  return {{"plane", {x, y, z, -symmetry.plane.offset}},
          {"deviation", symmetry.plane.deviation},
          {"has_symmetric_surface", symmetry.has_symmetric_surface},
          {"has_symmetric_seams", symmetry.has_symmetric_seams},
          {"asymmetry", symmetry.asymmetry},
          {"extra_length", symmetry.extra_length}};
}

inline Json atlas_json(const Atlas_record& record)
{
  const TA::Atlas_report& report = record.report;
  const Seam_way& way = record.seam_way;
  Json charts = Json::array();
  for(std::size_t i = 0; i < report.charts.size(); ++i) {
    charts.push_back(chart_json(report.charts[i], record.share_of_area[i]));
  }
  Json json = {{"parts", report.number_of_parts},
               {"charts", std::move(charts)},
               {"seams",
                {{"way", way.name},
                 {"crease_angle", json_optional(way.crease_angle)},
                 {"is_hard_surface", json_optional(way.is_hard_surface)},
                 {"symmetry", way.symmetry ? symmetry_json(*way.symmetry) : Json()},
                 {"length", report.seam_length},
                 {"relative_length", report.relative_seam_length},
                 {"terminals", report.number_of_terminals},
                 {"stretch_bound", record.stretch_bound},
                 {"largest_equal_jump", report.largest_equal_seam_jump}}},
               {"purpose", record.options.keeps_all_charts() ? Json() : Json(record.options.purpose)},
               {"repacked", record.options.repacks},
               {"units", record.options.units},
               {"packing", record.options.pack_into_square ? packing_json(record) : Json()},
               {"flipped_triangles", report.measures.flipped_triangles},
               {"injective", report.measures.border_is_simple}};
  add_measures(json, &report.measures);
  return json;
}

inline Json models_json(const Atlas_record& record)
{
  Json models = Json::array();
  for(std::size_t i = 0; i < record.models.size(); ++i) {
    const Atlas_record::Model& model = record.models[i];
    models.push_back({{"input", model.input},
                      {"output", model.output.empty() ? Json() : Json(model.output)},
                      {"vertices", model.vertices},
                      {"triangles", model.triangles},
                      {"first_chart", model.first_chart},
                      {"charts", model.charts},
                      {"skipped", skipped_json(skipped_of_model(record, i))}});
  }
  return models;
}

inline std::vector<std::string> names_of_models(const Atlas_record& record)
{
  std::vector<std::string> names;
  for(const Atlas_record::Model& model : record.models) {
    names.push_back(model.input);
  }
  return names;
}

} // namespace internal

// The report for programs. Without an atlas, `atlas` is `null`. Faces are counted from 1, charts and parts from 0.
inline std::string report_json(const Atlas_record& record, const Batch_options& batch)
{
  const std::string& message =
      record.skipped.empty() ? record.report.message : record.skipped.front().message;
  Json json = {{"status", status_name(record)},
               {"message", message},
               {"notes", record.notes},
               {"input", record.input}};
  internal::add_run(json, exit_status(record), batch.recorded);
  if(!record.models.empty()) {
    json["models"] = internal::models_json(record);
  }
  json["vertices"] = record.vertices;
  json["triangles"] = record.triangles;
  json["components"] = record.components;
  json["left_out"] = record.left_out;
  json["skipped"] = internal::skipped_json(record.skipped, internal::names_of_models(record));
  json["atlas"] = record.report.has_atlas() ? internal::atlas_json(record) : Json();
  json["baking"] = record.baking.from.empty() ? Json() : baking_json(record.baking);
  for(const auto& [stage, time] : seconds_of_stages(record)) {
    json["seconds"][stage] = time;
  }
  json["peak_memory_mb"] = record.peak_memory_mb > 0 ? Json(record.peak_memory_mb) : Json();
  return json_report_text(json);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_ATLAS_JSON_H
