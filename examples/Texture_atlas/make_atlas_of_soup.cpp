// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Texture_atlas/make_atlas_of_soup.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace TA = CGAL::Texture_atlas;

int main(int argc, char* argv[])
{
  TA::Surface_soup soup;
  std::vector<std::vector<TA::Surface_soup::Index>> polygons;
  if(!CGAL::IO::read_polygon_soup(argc > 1 ? argv[1] : "data/egg.off", soup.points, polygons)) {
    std::cerr << "Cannot read the polygons.\n";
    return 1;
  }
  for(const auto& polygon : polygons)
    soup.add_polygon(polygon);

  TA::Soup_atlas atlas;
  const TA::Soup_report report = TA::make_atlas(soup, atlas);
  for(const std::string& note : report.notes)
    std::cerr << note << "\n";
  for(const auto& part : report.skipped)
    std::cerr << part.number_of_faces << " polygons have no chart: " << part.message << "\n";
  if(!report.has_atlas()) {
    std::cerr << report.message << "\n";
    return 1;
  }
  std::cout << soup.number_of_polygons() << " polygons, " << report.charts.size() << " chart(s), "
            << atlas.seams.size() << " edges of seams, covered " << 100 * report.covered_share << " %\n";

  std::ofstream file("make_atlas_of_soup.obj");
  file.precision(17);
  for(const auto& p : soup.points)
    file << "v " << p << "\n";
  for(const auto& p : atlas.uv)
    file << "vt " << p << "\n"; // of each corner
  for(TA::Surface_soup::Index polygon = 0; polygon < soup.number_of_polygons(); ++polygon) {
    file << "f";
    for(auto corner = soup.first_corners[polygon]; corner < soup.first_corners[polygon + 1]; ++corner)
      file << " " << soup.vertices[corner] + 1 << "/" << corner + 1;
    file << "\n";
  }
  return file.good() ? 0 : 1;
}
