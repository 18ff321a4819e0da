// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Texture_atlas/IO/OBJ.h>
#include <CGAL/Texture_atlas/make_atlas.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Surface::Property_map<Surface::Halfedge_index, Kernel::Point_2>;
namespace TA = CGAL::Texture_atlas;

int main(int argc, char* argv[])
{
  std::vector<std::string> names(argv + 1, argv + argc);
  if(names.empty())
    names = {"data/egg.off", "data/mask.off"};
  std::vector<Surface> surfaces(names.size());
  std::vector<UV_map> uv;
  for(std::size_t i = 0; i < names.size(); ++i) {
    if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(names[i], surfaces[i])) {
      std::cerr << "Cannot read " << names[i] << ".\n";
      return 1;
    }
    uv.push_back(
        surfaces[i].add_property_map<Surface::Halfedge_index, Kernel::Point_2>("h:uv", {0, 0}).first);
  }

  const auto report = TA::make_common_atlas(surfaces, uv, TA::Atlas_options::TEXTURE);
  for(const auto& part : report.skipped)
    std::cerr << names[part.mesh] << ": " << part.message << "\n";
  if(!report.has_atlas()) {
    std::cerr << report.message << "\n";
    return 1;
  }
  bool is_written = true;
  for(std::size_t i = 0; i < names.size(); ++i) {
    std::size_t faces = 0;
    for(const auto& chart : report.charts)
      faces += chart.mesh == i ? chart.number_of_faces : 0;
    std::cout << names[i] << ": " << faces << " faces in charts\n";
    is_written =
        TA::IO::write_OBJ("common_atlas_" + std::to_string(i) + ".obj", surfaces[i], uv[i]) && is_written;
  }
  std::cout << "covered " << 100 * report.covered_share << " %\n";
  return is_written && report ? 0 : 1;
}
