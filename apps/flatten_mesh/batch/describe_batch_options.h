// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DESCRIBE_BATCH_OPTIONS_H
#define FLATTEN_MESH_DESCRIBE_BATCH_OPTIONS_H

#include "flatten_mesh/Option_table.h"
#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/batch/Child_processes.h"

namespace flatten_mesh {

namespace internal {

inline void describe_batch_options(Batch_options& batch, Option_table& table)
{
  table.begin("Many models");
  table.text("list", batch.list, "FILE",
             "further inputs: one name on each line of FILE; '-' is standard input");
  table.changes_no_result();
  table.flag("null,0", batch.is_null_separated,
             "the names of --list have null characters between them, as from 'find -print0'");
  table.changes_no_result();
  table.text("shard", batch.shard, "I/N",
             "only each N-th of the inputs, from the I-th on: N runs, on any machines, do all of them");
  table.changes_no_result();
  table.number_with_default(
      "jobs,j", batch.jobs, "N", abf::Option_range{1, double(Child_processes::largest_number)},
      "number of inputs that are flattened at once. Each of several inputs has a process of its own: if one "
      "crashes, its status is CRASHED, and the others go on. By default, the processors are shared out among "
      "these processes; see --threads");
  table.changes_no_result();
  table.text(
      "output-folder", batch.output_folder, "FOLDER",
      "outputs are below this folder, which is made. A '%' in their names then stands for the name of the "
      "input with its folders, from the folder on that all inputs have in common");
  table.flag(
      "resume", batch.resumes,
      "skip inputs whose --json is newer than they are, and of a run with the same version and options; "
      "those "
      "that ran out of time or memory, crashed, or could not be written are tried again");
  table.changes_no_result();
  table.number("timeout", batch.timeout, "SECONDS", abf::Option_range{0, abf::no_bound, false},
               "bound for the time of each input, whose status is then TIMED_OUT");
  table.changes_no_result();
  table.text(
      "memory", batch.memory, "BYTES",
      "bound for the memory that the process of each input holds, as in 500M or 4G; its status is then "
      "OUT_OF_MEMORY");
  table.changes_no_result();
  table.text(
      "summary", batch.summary, "FOLDER",
      "instead of flattening: a table (CSV) with a line for each --json below this folder, on standard "
      "output or in --output FILE.csv, and on standard error how many have which status. --report FILE.html "
      "writes the same as a page for browsers, with the worst charts and with plots; a table is then written "
      "only with --output");
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DESCRIBE_BATCH_OPTIONS_H
