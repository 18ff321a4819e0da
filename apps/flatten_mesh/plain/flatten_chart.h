// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FLATTEN_CHART_H
#define FLATTEN_MESH_FLATTEN_CHART_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/Run_record.h"

namespace flatten_mesh {

// Measures the map of a chart.
void measure(Mesh& mesh, const Chart& chart, Flattening& flattening);

Flattening flatten_chart(Mesh& mesh, const Chart& chart, const Command_line& command, Progress& progress);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FLATTEN_CHART_H
