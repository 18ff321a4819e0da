// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/make_atlas.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Surface::Property_map<Surface::Halfedge_index, Kernel::Point_2>;
namespace TA = CGAL::Texture_atlas;

int main(int argc, char* argv[])
{
  Surface surface;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/egg.off", surface)) {
    std::cerr << "Cannot read the mesh.\n";
    return 1;
  }

  const UV_map uv = surface.add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv", {0, 0}).first;
  const auto report = TA::make_atlas(surface, uv);
  for(const auto& part : report.skipped)
    std::cerr << part.number_of_faces << " faces have no chart: " << part.message << "\n";
  if(!report.has_atlas()) {
    std::cerr << report.message << "\n";
    return 1;
  }
  for(const auto& chart : report.charts)
    std::cout << "chart of " << chart.number_of_faces << " faces: " << to_string(chart.method) << ", stretch "
              << chart.l2_stretch << "\n";
  std::cout << report.charts.size() << " chart(s), seams of length " << report.relative_seam_length
            << ", stretch " << report.measures.l2_stretch << ", covered " << 100 * report.covered_share
            << " %\n";

  return TA::IO::write_OBJ("make_atlas.obj", surface, uv) && report ? 0 : 1;
}
