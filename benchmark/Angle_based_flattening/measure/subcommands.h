// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_SUBCOMMANDS_H
#define ABF_BENCHMARK_SUBCOMMANDS_H

#include "Measurement.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>

#include <cstddef>
#include <string>

namespace ABF_benchmark {

// Reads a mesh, makes one of about that many triangles of it (unless that is 0), adds noise, writes it (if `output` is
// not empty), and tells its triangles. Fails if it is no disk.
void make_mesh(const std::string& file, std::size_t triangles, bool noise, const std::string& output,
               Measurement& m);

// Runs a method on a mesh, and measures the map.
void flatten(const std::string& method, const std::string& file,
             const CGAL::Surface_mesh_parameterization::Hierarchical_options& options, Measurement& m);

// Runs a linear solver on the matrix of the first Newton step: `full`, or the `block` of planarity.
void solve(const std::string& solver, const std::string& file, const std::string& matrix, Measurement& m);

// Lays out the same angles, solved up to a gradient of that norm, in three ways.
void lay_out(const std::string& file, double tolerance, Measurement& m);

// Flattens all components with a border, `direct`ly or `hierarchical`ly, but for the first runs, those with several
// borders twice, the second time with holes allowed. Prints a measurement before each run, too: what it was at is known
// if it crashes.
void sweep(const std::string& file, const std::string& method, int first_run, Measurement& m);

// What this program was made of
void describe_software(Measurement& m);

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_SUBCOMMANDS_H
