// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_METHODS_H
#define ABF_BENCHMARK_METHODS_H

#include "../measure/Measurement.h"
#include "../measure/read_mesh.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>

#include <map>
#include <string>

namespace ABF_benchmark {

namespace SMP = CGAL::Surface_mesh_parameterization;

// A method of flattening, by default as it is by default; the options are for hierarchical ones. Adds seconds, bytes, and what
// the method reports to the measurement, or the reason why there is no map.
typedef void (*Method)(Surface&, const SMP::Hierarchical_options&, Measurement&);
typedef std::map<std::string, Method> Methods; // by their names on command lines

// The parameterizers of our package and hierarchical ones, those of CGAL, and the methods that are implemented here: each in a
// file of its own, for they take long to compile.
Methods package_methods();
Methods cgal_methods();
Methods chart_methods();

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_METHODS_H
