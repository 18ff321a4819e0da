// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SPLIT_CHART_H
#define FLATTEN_MESH_SPLIT_CHART_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/Cut_mesh.h"
#include "flatten_mesh/plain/Run_record.h"

#include <functional>
#include <vector>

namespace flatten_mesh {

// A chart that was split, with the same coordinates.
struct Split_chart
{
  Cut_mesh cut;
  Chart chart;
  Flattening flattening;
  std::vector<Edge> new_seams; // in the mesh before
};

// Splits a chart into pieces whose maps are injective. `is_forbidden(e)` tells which edges must not become seams.
// Without overlap, nothing is split, and the result is empty.
Split_chart split_chart(const Mesh& mesh, const Chart& chart, const Flattening& flattening,
                        const std::function<bool(Edge)>& is_forbidden, Split_record& record);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SPLIT_CHART_H
