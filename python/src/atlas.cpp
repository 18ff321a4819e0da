// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases of any meshes

#include "bindings.h"
#include "failures.h"
#include "interruptible.h"
#include "option_taker.h"
#include "soups.h"
#include "surfaces.h"

#include <CGAL/Texture_atlas/internal/json/report_json.h>
#include <CGAL/Texture_atlas/internal/options/option_table.h>
#include <CGAL/Texture_atlas/make_atlas_of_soup.h>

#include <pybind11/stl.h>

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
Atlas_choices choices_of(const py::dict& choices, const py::dict& options)
{
  TA::Atlas_options::Purpose purpose = TA::Atlas_options::TEXTURE;
  take("purpose", choices["purpose"], purpose, abf::words_of_purposes());
  TA::Atlas_options given;
  take_options(options, "atlases", given);
  Atlas_choices result{TA::Soup_options(purpose), abf::words_of_purposes().value_text(purpose)};
  if(given.given_charts == TA::Atlas_options::KEEP) {
    result.options.stretch_bound = 2;
  }
  take_options(options, "atlases", static_cast<TA::Atlas_options&>(result.options));
  const std::string seams = choices["seams"].cast<std::string>();
  check_value(abf::wrong_seams(seams));
  abf::set_seams(seams, purpose == TA::Atlas_options::TEXTURE, result.options);
  result.options.symmetric = choices["symmetric"].cast<bool>();
  result.options.weld = choices["weld"].cast<bool>();
  result.options.repair = choices["repair"].cast<bool>();
  return result;
}

// The failure of an atlas without charts, about the first mesh that something is wrong with
[[noreturn]] void fail(const TA::Soup_report& report)
{
  if(is_of_argument(report.status)) {
    throw py::value_error(report.message);
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

// All that needs no interpreter
Result make_atlases(const std::vector<Surface_soup>& soups, const bool is_shared, Atlas_choices choices,
                    Progress_state& state)
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

py::tuple atlas(const std::vector<Given_mesh>& meshes, const bool is_shared, const py::dict& choices,
                const py::dict& options, const Watch& watch)
{
  const Atlas_choices given = choices_of(choices, options);
  std::vector<Surface_soup> soups;
  for(std::size_t i = 0; i < meshes.size(); ++i) {
    soups.push_back(soup_of(meshes[i], is_shared ? "mesh " + std::to_string(i) : ""));
  }
  Result result = run_interruptibly(
      watch, [&](Progress_state& state) { return make_atlases(soups, is_shared, given, state); });
  py::list atlases;
  for(TA::Soup_atlas& each : result.atlases) {
    const auto faces = static_cast<py::ssize_t>(each.charts.size());
    atlases.append(py::make_tuple(array_of_points(each.uv), array_of(std::move(each.charts), {faces}),
                                  array_of_pairs(each.seams)));
  }
  return py::make_tuple(atlases, result.json);
}

} // namespace

void bind_atlas(py::module_& module)
{
  py::class_<Given_mesh>(module, "GivenMesh")
      .def(py::init<py::array, py::object, py::array, py::object, py::object, py::object>());
  module.def("atlas", &atlas);
}

} // namespace abf_python
