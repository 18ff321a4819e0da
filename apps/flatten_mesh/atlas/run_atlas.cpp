// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/atlas/run_atlas.h"

#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/atlas/Atlas_progress.h"
#include "flatten_mesh/atlas/Recorded_atlas.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/face_options.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/Output_files.h"
#include "flatten_mesh/atlas/join_models.h"
#include "flatten_mesh/atlas/report_atlas_text.h"
#include "flatten_mesh/report_skipped.h"
#include "flatten_mesh/texts.h"
#include "flatten_mesh/atlas/write_atlas.h"
#include "flatten_mesh/bake/bake_textures.h"
#include "flatten_mesh/bake/simplify_input.h"

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace {

// What is wrong with the atlas as a whole, if anything. Parts without charts are told elsewhere.
void tell_message(const Command_line& command, const Atlas_record& record)
{
  const std::vector<TA::Atlas_report::Skipped>& skipped = record.report.skipped;
  const bool is_about_parts =
      !skipped.empty() && (record.report.has_atlas() || record.report.status == skipped.front().status);
  if(!record.report && !is_about_parts) {
    std::cerr << "flatten_mesh: " << command.title << ": " << status_name(record) << ": "
              << record.report.message << std::endl;
  }
}

// Throws an `Input_error` if no model has a name that the command gives, or nothing remains.
void check_left_out(const Command_line& command, const Atlas_input& input)
{
  std::vector<const Model*> models = {&input.model};
  for(const Joined_model& model : input.joined) {
    models.push_back(&model.input.model);
  }
  std::size_t faces = 0;
  for(const Model* model : models) {
    faces += model->number_of_polygons();
  }
  try {
    check_choice(face_choice_of(command.atlas), models);
    if(input.left_out == faces) {
      throw Input_error("--only-material and --ignore leave no face");
    }
  } catch(const Input_error& error) {
    throw Input_error(command.title + ": " + error.what());
  }
}

} // namespace

Exit_status run_atlas(const Command_line& command)
{
  check_writable(command);
  CGAL::Real_timer timer;
  timer.start();
  Atlas_progress progress(command);
  Notes notes = notes_of(command, [&progress] { progress.clear_line(); });
  progress.stage("reading");
  Atlas_input input =
      command.atlas.is_shared ? read_joined_models(command, notes) : read_atlas_input(command, notes);
  check_left_out(command, input);
  const double read_seconds = timer.time();
  if(command.atlas.simplified_triangles > 0 && !input.mesh.is_empty()) {
    progress.stage("simplifying");
    simplify_input(static_cast<std::size_t>(command.atlas.simplified_triangles), input, notes);
  }
  const double simplify_seconds = timer.time() - read_seconds;
  Recorded_atlas made = make_recorded_atlas(command, input, notes, progress);
  const Atlas& atlas = made.atlas;
  Atlas_record& record = made.record;
  record.read_seconds = read_seconds;
  record.simplify_seconds = command.atlas.simplified_triangles > 0 ? simplify_seconds : 0;
  Baked_surface baked;
  if(record.report.has_atlas() && !command.atlas.bake_from.empty()) {
    if(record.report.number_of_pages > 1) {
      throw Usage_error("--bake-from needs one page, and the charts take " +
                        count_text(record.report.number_of_pages, "page") +
                        ": give a larger --resolution or a smaller --texels-per-unit");
    }
    progress.stage("baking");
    baked = bake_textures(command, input, atlas, notes);
    record.baking = baked.record;
  }
  const std::vector<Written_model> models = models_to_write(command, input, atlas, record.report);
  tell_changed_polygons(models, record.report, notes);
  tell_moved_origins(models, notes);
  if(record.report.has_atlas()) {
    tell_outputs(models, notes);
  }
  record.notes = notes.texts();
  progress.stage("writing");
  Output_files files;
  files.keep(input.model.files_beside);
  for(const Joined_model& model : input.joined) {
    files.keep(model.input.model.files_beside);
  }
  write_files(command, input, atlas, baked, models, record, files);
  progress.end();
  tell_skipped_parts(command, record.report.skipped);
  tell_message(command, record);
  if(record.report.has_atlas()) {
    tell_report(command, report_text(record));
  }
  files.publish();
  return exit_status(record);
}

} // namespace flatten_mesh
