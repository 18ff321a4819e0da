// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FAILURE_H
#define FLATTEN_MESH_FAILURE_H

#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/batch/add_run.h"
#include "flatten_mesh/check_outputs.h"
#include "flatten_mesh/texts.h"

#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace flatten_mesh {

// A failure outside of the parameterizer, which therefore has no report.
struct Failure
{
  Exit_status exit_status;
  std::string name; // for programs
  std::string message;
};

// The failure of the exception that is being handled.
inline Failure current_failure()
{
  try {
    throw;
  } catch(const Usage_error& error) {
    return {WRONG_INPUT, "WRONG_USAGE", error.what()};
  } catch(const Output_error& error) {
    return {WRONG_INPUT, "CANNOT_WRITE", error.what()};
  } catch(const Input_error& error) {
    return {WRONG_INPUT, "WRONG_INPUT", error.what()};
  } catch(const Seams_failed& error) {
    return {COMPUTATION_FAILED, "SEAMS_FAILED", error.what()};
  } catch(const Precision_exceeded& error) {
    return {WRONG_INPUT, "PRECISION_EXCEEDED", error.what()};
  } catch(const std::bad_alloc&) {
    return {OUT_OF_MEMORY, "OUT_OF_MEMORY", memory_text};
  } catch(const std::exception& error) {
    return {COMPUTATION_FAILED, "INTERNAL_ERROR", std::string("internal error: ") + error.what()};
  }
}

// Prints one line for people, and writes the report for programs if requested.
inline Exit_status tell_failure(const Command_line& command, Failure failure)
{
  failure.message = with_title(command, failure.message);
  std::cerr << "flatten_mesh: " << in_one_line(failure.message) << std::endl;
  if(can_write_json(command)) {
    try {
      Output_file file(command.json);
      file.write(failure_json(failure.name, failure.exit_status, failure.message, name_of_input(command),
                              command.batch.recorded));
      file.publish();
    } catch(const std::exception& error) {
      if(error.what() != failure.message) { // already printed if this file failed
        std::cerr << "flatten_mesh: " << in_one_line(error.what()) << std::endl;
      }
    }
  }
  return failure.exit_status;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FAILURE_H
