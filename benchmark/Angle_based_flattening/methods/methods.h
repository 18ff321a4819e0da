// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_METHODS_H
#define ABF_BENCHMARK_METHODS_H

#include "../measure/Measurement.h"
#include "../measure/read_mesh.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>

#include <map>
#include <string>

namespace ABF_benchmark {

namespace SMP = CGAL::Surface_mesh_parameterization;

// A method of flattening with its default options; only hierarchical methods use the given ones. Adds the seconds,
// the bytes and the report of the method to the measurement, or the reason why there is no map.
typedef void (*Method)(Surface&, const SMP::Hierarchical_options&, Measurement&);
typedef std::map<std::string, Method> Methods; // by their names on command lines

Methods parameterizer_methods(); // of CGAL and of our package
Methods chart_methods();         // that are implemented here

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_METHODS_H
