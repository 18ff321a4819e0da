// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Results, the table of options, and the program flatten_mesh, which the library contains

#include "interface.h"
#include "progress.h"
#include "results.h"
#include "take_options.h"

#include <flatten_mesh/run_program.h>

#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>

#include <string>

namespace abf_python {

namespace {

std::string description()
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // prints nothing
  CGAL::set_warning_handler([](const char*, const char*, const char*, int, const char*) {});
  const Json options = {{"atlas", rows_of_options<TA::Atlas_options>()},
                        {"direct", rows_of_options<SMP::ABF_plus_plus_options>()},
                        {"hierarchical", rows_of_options<SMP::Hierarchical_options>()},
                        {"packing", rows_of_options<TA::Packing_options>()},
                        {"seams", rows_of_options<TA::Seam_options>()},
                        {"baking", rows_of_options<TA::Baking_options>()}};
  return abf::json_text({{"version", ABF_VERSION}, {"options", options}});
}

} // namespace

} // namespace abf_python

const char* abf_description()
{
  static const std::string text = abf_python::description();
  return text.c_str();
}

int abf_run_program(const int argc, char** const argv)
{
  return flatten_mesh::run_program(argc, argv);
}

int abf_kind(const abf_result* const result)
{
  return result->kind;
}

const char* abf_text(const abf_result* const result)
{
  return result->text.c_str();
}

void* abf_take_array(abf_result* const result, abf_array* const array)
{
  if(result->taken == result->arrays.size()) {
    return nullptr;
  }
  abf_python::Result_array& next = result->arrays[result->taken++];
  *array = next.view;
  return next.owned.release();
}

void abf_free_array(void* const array)
{
  delete static_cast<abf_python::Owned_numbers*>(array);
}

void abf_free_result(abf_result* const result)
{
  delete result;
}
