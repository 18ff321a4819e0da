// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_JSON_REPORT_JSON_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_JSON_REPORT_JSON_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/Soup_report.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

using Json = nlohmann::ordered_json;

template <class Value>
Json json_optional(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json();
}

// The JSON of each value, by a function
template <class Values, class Function>
Json json_array(const Values& values, const Function& json_of)
{
  Json array = Json::array();
  for(const auto& value : values) {
    array.push_back(json_of(value));
  }
  return array;
}

// Bytes that are no UTF-8, as names of files may have, become the replacement character U+FFFD.
inline std::string json_text(const Json& json, const int indentation = -1)
{
  return json.dump(indentation, ' ', false, Json::error_handler_t::replace);
}

// All are `null` if there are none.
inline void add_measures(Json& json, const Flattening_measures* measures)
{
  using Measures = Flattening_measures;
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

// Where the refinement of a map started, and what failed before
inline void add_coarse_charts(Json& json, const Surface_mesh_parameterization::Hierarchical_report& report)
{
  using Surface_mesh_parameterization::internal::ABF::name_of_error;
  json["start"] = to_string(report.start);
  json["holes_filled"] = report.holes_filled;
  json["failed_coarse_charts"] = json_array(report.failed_coarse_charts, [](const auto& chart) -> Json {
    return {{"vertices", chart.vertices},
            {"triangles", chart.triangles},
            {"error", chart.error ? Json(name_of_error(*chart.error)) : Json()},
            {"flipped_triangles", chart.flipped_triangles},
            {"message", chart.message}};
  });
}

// Of each chart: its share of the area of all charts, on the surface
inline std::vector<double> shares_of_area(const Atlas_report& report)
{
  double area = 0;
  for(const Atlas_report::Chart& chart : report.charts) {
    area += chart.area;
  }
  std::vector<double> shares;
  for(const Atlas_report::Chart& chart : report.charts) {
    shares.push_back(chart.area / area);
  }
  return shares;
}

inline Json chart_json(const Atlas_report::Chart& chart, const double share)
{
  return {{"part", chart.part},
          {"page", chart.page},
          {"scale", chart.scale},
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

inline Json packing_json(const Atlas_report& report, const Packing_options& options)
{
  return {{"resolution", options.resolution},
          {"height", options.number_of_rows()},
          {"block", options.block},
          {"gutter", options.number_of_gutter_texels()},
          {"quantization_bits", json_optional(options.quantization_bits)},
          {"faces_off_grid", json_array(report.faces_off_grid, [](const std::size_t f) { return f + 1; })},
          {"pages", report.number_of_pages},
          {"texels_per_unit", report.scale * options.resolution},
          {"covered_share", report.covered_share},
          {"texel_density", report.texel_density},
          {"low_texel_density", report.low_texel_density}};
}

inline Json symmetry_json(const Soup_report::Symmetry& symmetry)
{
  const auto& [x, y, z] = symmetry.plane.normal;
  return {{"plane", {x, y, z, -symmetry.plane.offset}},
          {"deviation", symmetry.plane.deviation},
          {"has_symmetric_surface", symmetry.has_symmetric_surface},
          {"has_symmetric_seams", symmetry.has_symmetric_seams},
          {"asymmetry", symmetry.asymmetry},
          {"extra_length", symmetry.extra_length}};
}

// `purpose` and `units` are words.
inline Json atlas_json(const Soup_report& report, const Atlas_options& options, const std::string& purpose,
                       const std::string& units)
{
  const Soup_report::Seams& way = report.seams;
  const std::vector<double> shares = shares_of_area(report);
  Json charts = Json::array();
  for(std::size_t i = 0; i < report.charts.size(); ++i) {
    charts.push_back(chart_json(report.charts[i], shares[i]));
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
                 {"stretch_bound", options.stretch_bound},
                 {"largest_equal_jump", report.largest_equal_seam_jump}}},
               {"purpose", options.given_charts == Atlas_options::KEEP ? Json() : Json(purpose)},
               {"repacked", options.given_charts != Atlas_options::REPLACE},
               {"units", units},
               {"packing", options.pack_into_square ? packing_json(report, options) : Json()},
               {"flipped_triangles", report.measures.flipped_triangles},
               {"injective", report.measures.border_is_simple}};
  add_measures(json, &report.measures);
  return json;
}

// Faces and vertices are counted from 1. Without names of meshes, there is only one.
inline Json skipped_json(const std::vector<Atlas_report::Skipped>& parts,
                         const std::vector<std::string>& names_of_meshes = {})
{
  return json_array(parts, [&](const Atlas_report::Skipped& part) {
    Json json;
    if(!names_of_meshes.empty()) {
      json["input"] = names_of_meshes[part.mesh];
    }
    json["first_face"] = part.first_face + 1;
    json["faces"] = part.number_of_faces;
    json["vertices"] = json_array(part.vertices, [](const std::size_t v) { return v + 1; });
    json["diagnosis"] = to_string(part.status);
    json["message"] = part.message;
    return json;
  });
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_JSON_REPORT_JSON_H
