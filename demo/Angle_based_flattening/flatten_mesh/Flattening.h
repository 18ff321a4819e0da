// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FLATTENING_H
#define FLATTEN_MESH_FLATTENING_H

#include "Chart.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/measure_flattening.h>

#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;

using UV_map = Mesh::Property_map<Vertex, Kernel::Point_2>;

// What came out of the parameterizer.
struct Flattening
{
  UV_map uv;
  Mesh::Property_map<Face, double> distortion; // angular, of each face of the chart
  SMP::ABF_plus_plus_report report;            // of the hierarchical method: what both have in common
  std::string method;                          // direct or hierarchical
  int levels = 0;                              // of the hierarchical method
  int coarse_triangles = 0;
  std::vector<std::pair<std::string, double>> stages; // of the parameterizer, with their seconds
  SMP::Flattening_measures measures;                  // only if it succeeded
  std::string place;                                  // the vertices and faces at fault, if it failed
  double parameterize_seconds = 0;
  double measure_seconds = 0;

  bool succeeded() const { return report.status == SMP::OK && report.flipped_triangles == 0; }
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FLATTENING_H
