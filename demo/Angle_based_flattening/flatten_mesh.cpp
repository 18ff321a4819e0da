// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flattens a surface from a file: `flatten_mesh scan.ply --output flat.obj --svg flat.svg`. See `--help`.

#include "flatten_mesh/Chart.h"
#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/Polygon_soup.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/Run_record.h"
#include "flatten_mesh/build_mesh.h"
#include "flatten_mesh/components.h"
#include "flatten_mesh/flatten_chart.h"
#include "flatten_mesh/parse_command_line.h"
#include "flatten_mesh/read_polygon_soup.h"
#include "flatten_mesh/report_json.h"
#include "flatten_mesh/report_text.h"
#include "flatten_mesh/texts.h"
#include "flatten_mesh/write_obj.h"
#include "flatten_mesh/write_svg.h"

#ifdef ABF_WITH_PNG
#include "flatten_mesh/draw_surface.h"
#endif

#include <CGAL/Real_timer.h>
#include <CGAL/assertions_behaviour.h>

#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

enum Exit_status
{
  SUCCESS = 0,
  COMPUTATION_FAILED = 1,
  WRONG_INPUT = 2
};

// The surface as it was in the file, and as it is flattened.
struct Surface
{
  Polygon_soup soup;
  Mesh mesh;
  Chart chart;
};

Surface read_surface(const Command_line& command, Notes& notes)
{
  Surface surface;
  surface.soup = read_polygon_soup(command.input, notes);
  try {
    surface.mesh = build_mesh(surface.soup, command.repair == "on", notes);
    surface.chart = choose_chart(surface.mesh, static_cast<std::size_t>(command.component),
                                 static_cast<std::size_t>(command.border));
  } catch(const Input_error& error) {
    throw Input_error("'" + command.input + "': " + error.what());
  }
  return surface;
}

// Writes what is asked for. All files appear together, and only when all of them are complete.
void write_files(const Command_line& command, const Surface& surface, Run_record& record)
{
  std::vector<std::unique_ptr<Output_file>> files;
  const auto open = [&files, &record](const std::string& name) -> Output_file& {
    files.push_back(std::make_unique<Output_file>(name));
    record.written.push_back(name);
    return *files.back();
  };
  CGAL::Real_timer timer;
  timer.start();
  if(!command.output.empty() && record.flattening.succeeded()) {
    write_obj(open(command.output), surface.soup, surface.chart, record.flattening);
  }
  if(!command.svg.empty() && record.flattening.succeeded()) {
    write_svg(open(command.svg), surface.mesh, surface.chart, record.flattening);
  }
#ifdef ABF_WITH_PNG
  if(!command.picture.empty() && record.flattening.succeeded()) {
    open(command.picture)
        .write(checkerboard_picture(surface.mesh, surface.chart.faces, record.flattening.uv));
  }
#endif
  record.write_seconds = timer.time();
  if(!command.json.empty()) {
    open(command.json).write(report_json(record));
  }
  for(const std::unique_ptr<Output_file>& file : files) {
    file->publish();
  }
}

void tell_stages(const Run_record& record, const Progress& progress)
{
  for(const auto& stage : seconds_of_stages(record)) {
    if(stage.first != "read" && stage.first != "write") {
      progress.stage(stage.first, stage.second,
                     stage.first == "layout" ? layout_name(record.flattening.report) : "");
    }
  }
}

Exit_status tell_failure(const Command_line& command, const Flattening& flattening)
{
  std::cerr << "flatten_mesh: '" << command.input << "': " << status_name(flattening.report) << ": "
            << flattening.report.message << flattening.place << std::endl;
  return is_failure_of_computation(flattening.report) ? COMPUTATION_FAILED : WRONG_INPUT;
}

Exit_status run(const Command_line& command)
{
  Progress progress(command.verbose);
  for(const std::string& name : {command.output, command.svg, command.picture, command.json}) {
    Output_file::check(name);
  }

  CGAL::Real_timer timer;
  timer.start();
  Notes notes;
  Surface surface = read_surface(command, notes);
  Run_record record;
  record.notes = notes.texts();
  record.read_seconds = timer.time();
  record.input = command.input;
  record.vertices = surface.chart.vertices.size();
  record.triangles = surface.chart.faces.size();
  record.borders = surface.chart.borders.size();
  record.components = surface.chart.components;
  progress.stage("read", record.read_seconds, std::to_string(record.triangles) + " triangles to flatten");

  record.flattening = flatten_chart(surface.mesh, surface.chart, command, progress);
  if(!record.flattening.succeeded()) {
    record.flattening.place +=
        other_component_text(surface.mesh, static_cast<std::size_t>(command.component));
  }
  tell_stages(record, progress);
  write_files(command, surface, record);
  progress.stage("write", record.write_seconds);
  if(!record.flattening.succeeded()) {
    return tell_failure(command, record.flattening);
  }
  std::cout << report_text(record) << std::flush;
  return SUCCESS;
}

} // namespace flatten_mesh

int main(int argc, char* argv[])
{
  using namespace flatten_mesh;
  // Failed assertions of debug builds throw; the catch below tells about them, in one line.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  try {
    const Command_line command = parse_command_line(argc, argv);
    if(command.help) {
      std::cout << help_text();
      return SUCCESS;
    }
    return run(command);
  } catch(const Input_error& error) {
    std::cerr << "flatten_mesh: " << error.what() << std::endl;
    return WRONG_INPUT;
  } catch(const std::bad_alloc&) {
    std::cerr
        << "flatten_mesh: the memory does not suffice for this mesh; simplify it or take a larger machine"
        << std::endl;
  } catch(const std::exception& error) {
    std::cerr << "flatten_mesh: internal error: " << error.what() << std::endl;
  }
  return COMPUTATION_FAILED;
}
