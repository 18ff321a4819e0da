// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "subcommands.h"

#include <CGAL/Texture_atlas/is_disk_cut.h>
#include <CGAL/Texture_atlas/make_seam_mesh.h>
#include <CGAL/Texture_atlas/select_seams.h>
#include <CGAL/Texture_atlas/split_overlaps.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <vector>

namespace ABF_benchmark {

void overlaps(const std::string& file, double bound, Measurement& m)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  namespace TA = CGAL::Texture_atlas;
  Mesh mesh;
  read_mesh(file, mesh);
  const auto seams = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  m.add("triangles", mesh.number_of_faces());
  if(!TA::is_disk_cut(mesh, seams)) {
    TA::Seam_options options;
    options.stretch_bound = bound;
    const auto report = TA::select_seams(mesh, seams, options);
    if(!report)
      return m.fail(report.message);
  }

  Surface surface;
  CGAL::copy_face_graph(TA::make_seam_mesh(mesh, seams).mesh, surface.mesh);
  surface.border = CGAL::Polygon_mesh_processing::longest_border(surface.mesh).first;
  surface.uv = surface.mesh.add_property_map<Mesh::Vertex_index, abf::Chart::Point_2>("v:uv", {0, 0}).first;
  flatten("abf++", surface, SMP::Hierarchical_options(), m);

  const auto cuts = surface.mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;
  const auto piece = surface.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece", 0).first;
  TA::Overlap_split_report report;
  m.add("split_seconds",
        seconds_of([&] { report = TA::split_overlaps(surface.mesh, surface.uv, cuts, piece); }));
  if(!report)
    return m.fail(report.message);
  std::vector<std::size_t> sizes(report.number_of_pieces, 0);
  for(const auto f : surface.mesh.faces())
    ++sizes[piece[f]];
  m.add("overlapping", report.number_of_overlapping_faces);
  m.add("pieces", report.number_of_pieces);
  m.add("largest", static_cast<double>(*std::max_element(sizes.begin(), sizes.end())) /
                       static_cast<double>(mesh.number_of_faces()));
  m.add("extra_seam", 100 * report.extra_seam);
}

} // namespace ABF_benchmark
