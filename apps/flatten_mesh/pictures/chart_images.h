// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHART_IMAGES_H
#define FLATTEN_MESH_CHART_IMAGES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Output_files.h"
#include "flatten_mesh/check_outputs.h"
#include "pictures/chart_colors.h"
#include "flatten_mesh/pictures/png_of_pixels.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/packing/visit_texels.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace pictures;
using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// Red, green, blue and opacity of the texels of a page
class Chart_image
{
public:
  Chart_image(const int width, const int height)
      : m_width(width), m_height(height),
        m_pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0)
  {}

  // The corners are in texels.
  void draw(const std::array<CGAL::Texture_atlas::internal::Planar_point, 3>& corners, const int chart)
  {
    std::array<unsigned char, 4> color = {0, 0, 0, 255};
    const Color light = light_color_of_chart(chart);
    std::transform(light.begin(), light.end(), color.begin(),
                   [](const double part) { return static_cast<unsigned char>(std::lround(255 * part)); });
    CGAL::Texture_atlas::internal::visit_texels(
        corners, CGAL::Texture_atlas::internal::rounding_tolerance,
        [&](const int y, const int first, const int last) {
          for(int x = (std::max)(first, 0); y >= 0 && y < m_height && x <= last && x < m_width; ++x) {
            std::copy(color.begin(), color.end(), m_pixels.begin() + place(x, y));
          }
        });
  }

  std::string png() const { return png_of_pixels(m_width, m_height, PNG_FORMAT_RGBA, m_pixels.data()); }

private:
  // Rows begin above.
  std::ptrdiff_t place(const int x, const int y) const
  {
    return 4 * (static_cast<std::ptrdiff_t>(m_height - 1 - y) * m_width + x);
  }

  int m_width, m_height;
  std::vector<unsigned char> m_pixels;
};

inline std::string name_of_page(const Command_line& command, const std::size_t page)
{
  const std::string name =
      boost::replace_all_copy(command.chart_image, udim_placeholder, std::to_string(1001 + page));
  for(const Output_option& option : output_options()) {
    if(option.file != &Command_line::chart_image && !(command.*option.file).empty()) {
      check_different({"chart-image", &Command_line::chart_image, {}}, option, name, command.*option.file);
    }
  }
  return name;
}

} // namespace internal

// Writes an image of each page, in which texels have the colours of their charts.
inline void write_chart_images(const Command_line& command, const Mesh& mesh, const Atlas& atlas,
                               const TA::Atlas_report& report, Output_files& files)
{
  if(report.number_of_pages > 1 && command.chart_image.find(udim_placeholder) == std::string::npos) {
    throw Usage_error("--chart-image '" + command.chart_image + "' names one file for " +
                      count_text(report.number_of_pages, "page") +
                      ": put <UDIM> into it, which stands for the number of each page");
  }
  std::vector<std::vector<Face>> faces_of_pages(report.number_of_pages);
  for(const Face f : mesh.faces()) {
    if(atlas.chart[f] >= 0) {
      const auto chart = static_cast<std::size_t>(atlas.chart[f]);
      faces_of_pages[static_cast<std::size_t>(report.charts[chart].page)].push_back(f);
    }
  }
  const CGAL::Texture_atlas::internal::Planar_point size(command.atlas.resolution,
                                                         command.atlas.number_of_rows());
  for(std::size_t i = 0; i < faces_of_pages.size(); ++i) {
    const auto page = CGAL::Texture_atlas::internal::corner_of_page(static_cast<int>(i));
    internal::Chart_image image(command.atlas.resolution, command.atlas.number_of_rows());
    for(const Face f : faces_of_pages[i]) {
      std::array<CGAL::Texture_atlas::internal::Planar_point, 3> corners;
      Halfedge h = mesh.halfedge(f);
      for(auto& corner : corners) {
        corner = (CGAL::Texture_atlas::internal::Planar_point(atlas.uv[h].x(), atlas.uv[h].y()) - page)
                     .cwiseProduct(size);
        h = mesh.next(h);
      }
      image.draw(corners, atlas.chart[f]);
    }
    files.open(internal::name_of_page(command, i)).write(image.png());
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHART_IMAGES_H
