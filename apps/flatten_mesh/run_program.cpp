// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flatten_mesh/run_program.h"

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Failure.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/Unfinished_files.h"
#include "flatten_mesh/batch/run_batch.h"
#include "flatten_mesh/batch/summarize_reports.h"
#include "flatten_mesh/help_text.h"
#include "flatten_mesh/parse_command_line.h"
#include "flatten_mesh/atlas/run_atlas.h"
#include "flatten_mesh/parts/check_parts.h"
#include "flatten_mesh/plain/run_plain.h"
#include "flatten_mesh/process_memory.h"

#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>

#include <iostream>

namespace flatten_mesh {

namespace {

Exit_status run(const Command_line& command)
{
  try {
    return command.is_plain ? run_plain(command) : run_atlas(command);
  } catch(...) {
    return tell_failure(command, current_failure());
  }
}

Exit_status understand_and_run(const int argc, char* argv[])
{
  Command_line command;
  try {
    parse_command_line(argc, argv, command);
    if(command.help || command.version) {
      Output_file(standard_output).write(command.help ? help_text() : version_text());
      return SUCCESS;
    }
    check_parts(command);
  } catch(...) {
    return tell_failure(command, current_failure());
  }
  try {
    if(!command.batch.summary.empty()) {
      return summarize_reports(command);
    }
    return needs_processes(command) ? run_batch(command, run) : run(command);
  } catch(...) {
    return tell_failure(command, current_failure());
  }
}

} // namespace

Exit_status run_program(int argc, char* argv[])
{
  // Failed assertions in debug builds throw. The catch below reports them in one line.
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  keep_freed_memory();
  Unfinished_files::remove_when_interrupted();
  const Exit_status status = understand_and_run(argc, argv);
  std::cout.flush();
  std::cerr.flush();
  return status;
}

} // namespace flatten_mesh
