// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of any meshes

#include "failures.h"
#include "interface.h"
#include "progress.h"
#include "results.h"
#include "soups.h"
#include "surfaces.h"
#include "take_options.h"

#include <CGAL/Texture_atlas/make_atlas_of_soup.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

namespace {

struct Atlas_choices
{
  TA::Soup_options options;
  std::string purpose;
};

// `options` are those of `make_atlas()`.
Atlas_choices choices_of(const Json& choices, const Json& options)
{
  TA::Atlas_options::Purpose purpose = TA::Atlas_options::TEXTURE;
  take(Given_value("purpose", choices.at("purpose")), purpose, abf::words_of_purposes());
  TA::Atlas_options given;
  take_options(options, "atlases", given);
  Atlas_choices result{TA::Soup_options(purpose), abf::words_of_purposes().value_text(purpose)};
  if(given.given_charts == TA::Atlas_options::KEEP) {
    result.options.stretch_bound = 2;
  }
  take_options(options, "atlases", static_cast<TA::Atlas_options&>(result.options));
  const std::string seams = choices.at("seams").at(1);
  check_value(abf::wrong_seams(seams));
  const auto is_on = [&choices](const char* const name) { return choices.at(name).at(1) == "1"; };
  abf::set_seams(seams, purpose == TA::Atlas_options::TEXTURE, result.options);
  result.options.symmetric = is_on("symmetric");
  result.options.weld = is_on("weld");
  result.options.repair = is_on("repair");
  return result;
}

// The failure of an atlas without charts, about the first mesh that something is wrong with
[[noreturn]] void fail(const TA::Soup_report& report)
{
  if(is_of_argument(report.status)) {
    throw Wrong_value(report.message);
  }
  throw Mesh_failure(to_string(report.status), report.message,
                     {report.offending_polygons.begin(), report.offending_polygons.end()},
                     {report.offending_points.begin(), report.offending_points.end()},
                     static_cast<int>(report.offending_soup));
}

std::string json_of(const TA::Soup_report& report, const Atlas_choices& choices,
                    const std::vector<Surface_soup>& soups, const bool is_shared)
{
  std::vector<std::string> names;
  for(const Surface_soup& soup : soups) {
    names.push_back(soup.name);
  }
  const std::string units = choices.options.pack_into_square ? "square" : "world";
  const TA::Atlas_report::Seconds& seconds = report.seconds;
  return abf::json_text(
      {{"status", report ? "OK" : to_string(report.status)},
       {"message", report.message},
       {"notes", report.notes},
       {"vertices", report.number_of_vertices},
       {"triangles", report.number_of_triangles},
       {"components", report.number_of_components},
       {"left_out", report.number_of_ignored},
       {"skipped", abf::skipped_json(report.skipped, is_shared ? names : decltype(names)())},
       {"atlas", abf::atlas_json(report, choices.options, choices.purpose, units)},
       {"seconds",
        {{"read", seconds.read},
         {"charts", seconds.charts},
         {"pack", seconds.pack},
         {"certify", seconds.certify},
         {"measure", seconds.measure},
         {"write", seconds.write}}}});
}

struct Result
{
  std::vector<TA::Soup_atlas> atlases;
  std::string json;
};

Result make_atlases(const std::vector<Surface_soup>& soups, const bool is_shared, Atlas_choices choices,
                    abf_progress& state)
{
  return with_failures([&] {
    Atlas_watcher watcher(state);
    choices.options.visitor = &watcher;
    Result result;
    TA::Soup_report report;
    if(is_shared) {
      report = TA::make_common_atlas(soups, result.atlases, choices.options);
    } else {
      result.atlases.resize(1);
      report = TA::make_atlas(soups.front(), result.atlases.front(), choices.options);
    }
    if(!report.has_atlas()) {
      fail(report);
    }
    result.json = json_of(report, choices, soups, is_shared);
    return result;
  });
}

} // namespace

} // namespace abf_python

abf_result* abf_atlas(const abf_mesh* const meshes, const int number, const int is_shared,
                      const char* const given_choices, const char* const options,
                      abf_progress* const progress)
{
  using namespace abf_python;
  return result_of([&](abf_result& result) {
    const Atlas_choices choices = choices_of(Json::parse(given_choices), Json::parse(options));
    std::vector<Surface_soup> soups;
    for(int i = 0; i < number; ++i) {
      soups.push_back(soup_of(meshes[i], is_shared ? "mesh " + std::to_string(i) : ""));
    }
    Result made = make_atlases(soups, is_shared, choices, *progress);
    result.text = std::move(made.json);
    for(TA::Soup_atlas& each : made.atlases) {
      result.add_points(each.uv);
      result.add(std::move(each.charts));
      result.add_pairs(each.seams);
    }
  });
}
