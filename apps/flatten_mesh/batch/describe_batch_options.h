// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DESCRIBE_BATCH_OPTIONS_H
#define FLATTEN_MESH_DESCRIBE_BATCH_OPTIONS_H

#include "flatten_mesh/batch/Batch_options.h"

#include <boost/program_options.hpp>

namespace flatten_mesh {

namespace internal {

inline boost::program_options::options_description describe_batch_options(Batch_options& batch)
{
  namespace po = boost::program_options;
  po::options_description options("Many models", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("list", po::value(&batch.list)->value_name("FILE"),
      "further inputs: one name on each line of FILE; '-' is standard input");
  add("null,0", po::bool_switch(&batch.is_null_separated),
      "the names of --list have null characters between them, as from 'find -print0'");
  add("shard", po::value(&batch.shard)->value_name("I/N"),
      "only each N-th of the inputs, from the I-th on: N runs, on any machines, do all of them");
  add("jobs,j", po::value(&batch.jobs)->value_name("N")->default_value(batch.jobs),
      "number of inputs that are flattened at once. Each of several inputs has a process of its own: if one "
      "crashes, its status is CRASHED, and the others go on. By default, the processors are shared out among "
      "these processes; see --threads");
  add("output-folder", po::value(&batch.output_folder)->value_name("FOLDER"),
      "outputs are below this folder, which is made. A '%' in their names then stands for the name of the "
      "input with its folders, from the folder on that all inputs have in common");
  add("resume", po::bool_switch(&batch.resumes),
      "skip inputs whose --json is newer than they are, and of a run with the same version and options; "
      "those "
      "that ran out of time or memory, crashed, or could not be written are tried again");
  add("timeout", po::value(&batch.timeout)->value_name("SECONDS"),
      "bound for the time of each input, whose status is then TIMED_OUT");
  add("memory", po::value(&batch.memory)->value_name("BYTES"),
      "bound for the memory that the process of each input holds, as in 500M or 4G; its status is then "
      "OUT_OF_MEMORY");
  add("summary", po::value(&batch.summary)->value_name("FOLDER"),
      "instead of flattening: a table (CSV) with a line for each --json below this folder, on standard "
      "output or in --output FILE.csv, and on standard error how many have which status. --report FILE.html "
      "writes the same as a page for browsers, with the worst charts and with plots; a table is then written "
      "only with --output");
  return options;
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DESCRIBE_BATCH_OPTIONS_H
