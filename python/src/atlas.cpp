// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Atlases, made as the program `flatten_mesh` makes them

#include "bindings.h"
#include "failures.h"
#include "interruptible.h"
#include "marked_edges.h"
#include "models.h"
#include "option_taker.h"
#include "surfaces.h"

#include "flatten_mesh/atlas/Recorded_atlas.h"
#include "flatten_mesh/atlas/join_models.h"
#include "flatten_mesh/atlas/report_atlas_json.h"
#include "flatten_mesh/crease_option.h"
#include "flatten_mesh/face_options.h"
#include "flatten_mesh/page_options.h"
#include "flatten_mesh/process_memory.h"
#include "flatten_mesh/weld_option.h"

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/internal/prepare/texture_of_atlas.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abf_python {

using namespace flatten_mesh;

namespace {

// The command that asks the program for the same. `options` are those of `make_atlas()`.
Command_line command_of(const py::dict& choices, const py::dict& options)
{
  Command_line command;
  Atlas_command& atlas = command.atlas;
  TA::Atlas_options::Purpose purpose = TA::Atlas_options::TEXTURE;
  take("purpose", choices["purpose"], purpose, TA::internal::words_of_purposes());
  TA::Atlas_options given;
  take_options(options, "atlases", given);
  command.quiet = true;
  command.weld = choices["weld"].cast<bool>() ? "" : "off";
  command.repair = choices["repair"].cast<bool>() ? "on" : "off";
  command.options.threads = given.threads;
  atlas.purpose = TA::internal::words_of_purposes().value_text(purpose);
  atlas.seams = choices["seams"].cast<std::string>();
  check_value(wrong_way_of_seams(atlas.seams));
  atlas.is_symmetric = choices["symmetric"].cast<bool>();
  atlas.repacks = given.given_charts != TA::Atlas_options::REPLACE;
  atlas.repairs_charts = given.given_charts == TA::Atlas_options::REPAIR;
  atlas.ignored = ignored_material;
  atlas.set_defaults();
  take_options(options, "atlases", static_cast<TA::Atlas_options&>(atlas));
  check_value(flatten_mesh::internal::wrong_gutter(atlas));
  atlas.units = atlas.pack_into_square ? "square" : "world";
  return command;
}

// An input of which the models are known, in order; without a part of it if there is one only
Atlas_input input_of(std::vector<Model>&& models, const Command_line& command, Notes& notes)
{
  const auto read = [&](Model& model) {
    return atlas_input_of(std::move(model), command.repair == "on", notes, welding_of(command),
                          face_choice_of(command.atlas));
  };
  if(!command.atlas.is_shared) {
    return read(models.front());
  }
  Atlas_input whole;
  for(Model& model : models) {
    Joined_model joined;
    joined.command = command;
    joined.command.title = model.file;
    notes.set_subject("'" + model.file + "'");
    joined.input = read(model);
    join_model(std::move(joined), whole);
  }
  notes.set_subject("");
  return whole;
}

// The edges of seams, as vertices of the model
std::vector<std::pair<Index, Index>> seams_of(const Atlas_input& input, const Edge_marks& seams)
{
  std::vector<std::pair<Index, Index>> pairs;
  for(const Edge e : input.mesh.edges()) {
    for(const Halfedge h : {input.mesh.halfedge(e, 0), input.mesh.halfedge(e, 1)}) {
      if(seams[e] && !input.mesh.is_border(h)) {
        pairs.push_back(vertices_in_model(input, h));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// The atlas of one mesh
struct Mesh_atlas
{
  std::vector<Kernel::Point_2> uv; // of each corner
  std::vector<std::int32_t> charts;
  std::vector<std::pair<Index, Index>> seams;
};

Mesh_atlas atlas_of(const Atlas_input& input, const Atlas& atlas)
{
  Model_texture texture = texture_of(input.model, input.mesh, input.origins, atlas);
  keep_left_out_texture({{}, {ignored_material}}, input.model, texture);
  Mesh_atlas result{std::move(texture.uv), {}, seams_of(input, atlas.seams)};
  for(const Index chart : texture.charts) {
    result.charts.push_back(chart == no_index ? -1 : static_cast<std::int32_t>(chart));
  }
  return result;
}

// The failure of an atlas without charts, about the first mesh that something is wrong with
Mesh_failure failure_of(const Atlas_input& input, const Atlas_record& record)
{
  const bool is_set_aside = !record.skipped.empty();
  const std::string message = is_set_aside ? record.skipped.front().message : record.report.message;
  const auto mesh_of = [&](const Face f) { return model_of_face(input, f.idx()); };
  const std::vector<Face>& offending = record.report.offending_faces;
  const std::size_t mesh = is_set_aside        ? record.skipped.front().model
                           : offending.empty() ? 0
                                               : mesh_of(offending.front());
  std::vector<std::int64_t> faces;
  for(const Skipped_part& part : skipped_of_model(record, mesh)) {
    faces.push_back(static_cast<std::int64_t>(part.first_face));
  }
  for(const Face f : offending) {
    if(mesh_of(f) == mesh) {
      faces.push_back(static_cast<std::int64_t>(face_in_file(input, f)));
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  const Model& model = input.joined.empty() ? input.model : input.joined[mesh].input.model;
  return {status_name(record), message, faces, non_finite_vertices(model), static_cast<int>(mesh)};
}

struct Result
{
  std::vector<Mesh_atlas> atlases;
  std::string json;
};

Result result_of(Atlas_input& input, Recorded_atlas& made, const Notes& notes)
{
  made.record.notes = notes.texts();
  made.record.peak_memory_mb = peak_memory_mb();
  if(made.record.report.status == SMP::Diagnosis::WRONG_OPTION) {
    throw py::value_error(made.record.report.message);
  }
  if(!made.record.report.has_atlas()) {
    throw failure_of(input, made.record);
  }
  Result result{{}, report_json(made.record, Batch_options())};
  if(input.joined.empty()) {
    result.atlases.push_back(atlas_of(input, made.atlas));
  }
  for(Joined_model& model : input.joined) {
    result.atlases.push_back(atlas_of(model.input, atlas_of_model(made.atlas, model)));
  }
  return result;
}

// All that needs no interpreter
Result make_atlases(const Command_line& command, std::vector<Model>&& models,
                    const std::vector<Vertex_pairs>& seams, Progress_state& state)
{
  return with_failures([&] {
    Atlas_watcher watcher(state);
    Notes notes = notes_of(command);
    Atlas_input input = input_of(std::move(models), command, notes);
    if(input.joined.empty()) {
      mark_edges(seams.front(), "", input);
    }
    for(std::size_t i = 0; i < input.joined.size(); ++i) {
      mark_edges(seams[i], input.joined[i].command.title, input.joined[i].input);
    }
    Recorded_atlas made = make_recorded_atlas(command, input, notes, watcher);
    return result_of(input, made, notes);
  });
}

py::tuple atlas(const std::vector<Given_mesh>& meshes, const bool is_shared, const py::dict& choices,
                const py::dict& options, const Watch& watch)
{
  Command_line command = command_of(choices, options);
  command.atlas.is_shared = is_shared;
  command.title = is_shared ? std::to_string(meshes.size()) + " meshes" : "mesh";
  std::vector<Model> models;
  std::vector<Vertex_pairs> seams;
  for(std::size_t i = 0; i < meshes.size(); ++i) {
    const std::string name = is_shared ? "mesh " + std::to_string(i) : "";
    models.push_back(model_of(meshes[i], name));
    seams.push_back(pairs_of(meshes[i].marked_seams, models.back().points.size(), name));
  }
  Result result = run_interruptibly(
      watch, [&](Progress_state& state) { return make_atlases(command, std::move(models), seams, state); });
  py::list atlases;
  for(Mesh_atlas& each : result.atlases) {
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
