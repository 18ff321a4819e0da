// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/atlas/Recorded_atlas.h"

#include "flatten_mesh/atlas/join_models.h"
#include "flatten_mesh/atlas/keep_seams.h"
#include "flatten_mesh/atlas/place_charts.h"
#include "flatten_mesh/atlas/round_charts.h"
#include "flatten_mesh/choose_component.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/texts.h"

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Texture_atlas/internal/json/report_json.h>
#include <CGAL/Texture_atlas/internal/options/option_table.h>
#include <CGAL/Texture_atlas/internal/prepare/surface_atlas.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace {

TA::Soup_options options_of_atlas(const Command_line& command)
{
  TA::Soup_options options;
  static_cast<TA::Atlas_options&>(options) = command.atlas;
  options.float_coordinates = !command.atlas.is_in_world_units() && writes_floats(command);
  options.threads = command.options.threads;
  CGAL::Texture_atlas::internal::set_seams(command.atlas.seams, command.atlas.purpose == "texture", options);
  options.symmetric = command.atlas.is_symmetric;
  options.texture_seams = command.atlas.seams_from == "uv";
  options.material_seams = command.atlas.charts_from_materials;
  return options;
}

void keep_seams_of(const Command_line& command, Mesh& mesh)
{
  try {
    if(!mesh.is_empty()) {
      keep_seams(command.atlas, mesh);
    }
  } catch(const Input_error& error) {
    throw Input_error(command.title + ": " + error.what());
  }
}

// The surfaces of the input, with the seams that files mark
std::vector<Given_surface> surfaces_of(const Command_line& command, Atlas_input& input)
{
  std::vector<Given_surface> given;
  for(Joined_model& model : input.joined) {
    keep_seams_of(model.command, model.input.mesh);
    given.push_back(given_surface(model));
  }
  if(given.empty()) {
    keep_seams_of(command, input.mesh);
    given.push_back({input.model, input, command.title});
  }
  return given;
}

void place_charts(const Command_line& command, const Mesh& mesh, const Atlas& atlas,
                  const TA::Atlas_report& report)
{
  const Atlas_command& options = command.atlas;
  if(!options.is_in_world_units()) {
    return;
  }
  if(options.pack_into_square) {
    scale_charts(mesh, atlas, 1 / report.scale, options.number_of_rows() / report.scale / options.resolution);
  }
  if(writes_floats(command)) {
    round_charts(mesh, atlas, report.charts.size(), grid_of_outputs(command));
  } else {
    check_orientation(mesh, atlas);
  }
}

// What the record says of several models
void list_models(const Atlas_input& input, const Atlas& atlas, Atlas_record& record)
{
  std::size_t first_chart = 0;
  for(const Joined_model& model : input.joined) {
    const Mesh& mesh = model.input.mesh;
    std::set<int> charts;
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      charts.insert(atlas.chart[Face(static_cast<Mesh::size_type>(model.first_face + f))]);
    }
    charts.erase(-1);
    record.models.push_back({model.command.input, record.report.has_atlas() ? model.command.output : "",
                             number_of_used_vertices(mesh), mesh.number_of_faces(), first_chart,
                             charts.size()});
    first_chart += charts.size();
  }
}

TA::Soup_report make_charts(const Command_line& command, Atlas_input& input, const Atlas& atlas, Notes& notes,
                            TA::Atlas_visitor& visitor)
{
  std::vector<Given_surface> given = surfaces_of(command, input);
  try {
    TA::Soup_options options = options_of_atlas(command);
    options.visitor = &visitor;
    if(command.asks_for_component && !input.mesh.is_empty()) {
      options.component = choose_component(input.mesh, static_cast<std::size_t>(command.component)).number;
    }
    TA::Soup_report report =
        make_atlas_of_surfaces({options, CGAL::SuperLU_solver_traits<>()}, given, input.mesh, atlas, notes);
    if(report.has_atlas()) {
      place_charts(command, input.mesh, atlas, report);
    }
    return report;
  } catch(const Input_error& error) {
    if(input.joined.empty()) {
      throw Input_error(command.title + ": " + error.what());
    }
    throw;
  }
}

} // namespace

Recorded_atlas make_recorded_atlas(const Command_line& command, Atlas_input& input, Notes& notes,
                                   TA::Atlas_visitor& visitor)
{
  Recorded_atlas made{empty_atlas(input.mesh), {}};
  made.record.input = name_of_input(command);
  made.record.options = command.atlas;
  made.record.report = make_charts(command, input, made.atlas, notes, visitor);
  list_models(input, made.atlas, made.record);
  made.record.share_of_area = CGAL::Texture_atlas::internal::shares_of_area(made.record.report);
  return made;
}

} // namespace flatten_mesh
